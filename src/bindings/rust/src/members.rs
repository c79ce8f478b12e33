// SPDX-License-Identifier: MIT
//! The members of structures of arrays. Made by src/bindings/interface.py; do not change them by
//! hand.

/// Gives another macro what stands there, then the members of a structure of `scarp.h`.
#[rustfmt::skip]
macro_rules! members {
    (scarp_samples => $then:ident! { $($given:tt)* }) => {
        $then! { $($given)*
            /// The value
            value: f32,
            /// The gradient along x, per unit of input
            dx: f32,
            /// The gradient along y, per unit of input
            dy: f32,
            /// The gradient along z, per unit of input, in space
            dz: f32,
            /// The second derivative with respect to x, per unit of input squared
            dxx: f32,
            /// The derivative with respect to x and y, per unit of input squared
            dxy: f32,
            /// The derivative with respect to x and z, per unit of input squared, in space
            dxz: f32,
            /// The second derivative with respect to y, per unit of input squared
            dyy: f32,
            /// The derivative with respect to y and z, per unit of input squared, in space
            dyz: f32,
            /// The second derivative with respect to z, per unit of input squared, in space
            dzz: f32,
            /// The derivative with respect to the phase, per turn
            dphase: f32,
        }
    };
    (scarp_partials => $then:ident! { $($given:tt)* }) => {
        $then! { $($given)*
            /// The value
            f: f32,
            /// The derivative with respect to a
            fa: f32,
            /// The derivative with respect to b
            fb: f32,
            /// The second derivative with respect to a
            faa: f32,
            /// The derivative with respect to a and b
            fab: f32,
            /// The second derivative with respect to b
            fbb: f32,
        }
    };
    (scarp_cells => $then:ident! { $($given:tt)* }) => {
        $then! { $($given)*
            /// The distance to the nearest feature, in units of input
            f1: f32,
            /// The distance to the second nearest feature, in units of input
            f2: f32,
            /// A number drawn for the cell of the nearest feature
            id: u32,
            /// Where the nearest feature is along x
            x: f32,
            /// Where the nearest feature is along y
            y: f32,
            /// Where the nearest feature is along z, in space
            z: f32,
            /// The gradient of `f1` along x
            dx1: f32,
            /// The gradient of `f1` along y
            dy1: f32,
            /// The gradient of `f1` along z, in space
            dz1: f32,
            /// The gradient of `f2` along x
            dx2: f32,
            /// The gradient of `f2` along y
            dy2: f32,
            /// The gradient of `f2` along z, in space
            dz2: f32,
        }
    };
    (scarp_flow => $then:ident! { $($given:tt)* }) => {
        $then! { $($given)*
            /// The velocity along x
            vx: f32,
            /// The velocity along y
            vy: f32,
            /// The velocity along z, in space
            vz: f32,
            /// The derivative of `vx` with respect to x
            vxx: f32,
            /// The derivative of `vx` with respect to y
            vxy: f32,
            /// The derivative of `vx` with respect to z, in space
            vxz: f32,
            /// The derivative of `vy` with respect to x
            vyx: f32,
            /// The derivative of `vy` with respect to y
            vyy: f32,
            /// The derivative of `vy` with respect to z, in space
            vyz: f32,
            /// The derivative of `vz` with respect to x, in space
            vzx: f32,
            /// The derivative of `vz` with respect to y, in space
            vzy: f32,
            /// The derivative of `vz` with respect to z, in space
            vzz: f32,
        }
    };
    (scarp_eroded => $then:ident! { $($given:tt)* }) => {
        $then! { $($given)*
            /// The value
            value: f32,
            /// The gradient along x, per unit of input
            dx: f32,
            /// The gradient along y, per unit of input
            dy: f32,
            /// The displacement: a map of ridges and gullies
            displacement: f32,
            /// The gradient of the displacement along x
            displacement_dx: f32,
            /// The gradient of the displacement along y
            displacement_dy: f32,
        }
    };
}
