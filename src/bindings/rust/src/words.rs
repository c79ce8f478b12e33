// SPDX-License-Identifier: MIT
//! Enumerators, with the numbers of the library.
use crate::error::text_of;
use crate::ffi;
use std::fmt;
use std::str::FromStr;

/// An enumeration of C, with the words that the library has for it
macro_rules! words {
    ($(#[$about:meta])* $name:ident, $call:ident {
        $($(#[$each:meta])* $word:ident = $number:ident,)*
    }) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        #[repr(u32)]
        pub enum $name {
            $($(#[$each])* $word = ffi::$number,)*
        }

        impl $name {
            /// All that there are, in the order of their numbers
            pub const ALL: &'static [$name] = &[$($name::$word),*];

            /// The word of the library, as the program `scarp` takes it
            pub fn name(self) -> &'static str {
                // SAFETY: any number is allowed.
                text_of(unsafe { ffi::$call(self as u32) }).unwrap_or("")
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(self.name())
            }
        }

        impl FromStr for $name {
            type Err = crate::Error;

            fn from_str(word: &str) -> Result<$name, crate::Error> {
                $name::ALL.iter().copied().find(|each| each.name() == word).ok_or_else(|| {
                    crate::Error::of(ffi::SCARP_ERROR_ENUM, format!("{:?}", word))
                })
            }
        }
    };
}

words! {
    /// The noise of one octave, on a lattice that repeats after 2^32 cells along each axis
    ///
    /// ```
    /// use scarp::Basis;
    /// assert_eq!("cell-f1".parse::<Basis>()?, Basis::CellF1);
    /// assert_eq!(Basis::Simplex.to_string(), "simplex");
    /// # Ok::<(), scarp::Error>(())
    /// ```
    Basis, scarp_basis_name {
        /// Perlin's gradient noise
        Gradient = SCARP_GRADIENT,
        /// A value drawn on every lattice point
        Value = SCARP_VALUE,
        /// Gradients on triangles and tetrahedra; three times continuously differentiable
        Simplex = SCARP_SIMPLEX,
        /// The distance to the nearest feature
        CellF1 = SCARP_CELL_F1,
        /// The distance to the second nearest
        CellF2 = SCARP_CELL_F2,
        /// The second distance less the first: 0 on the borders between cells
        CellEdge = SCARP_CELL_EDGE,
        /// A smooth F1, whose Hessian is continuous
        CellSoft = SCARP_CELL_SOFT,
        /// A value for each cell
        CellValue = SCARP_CELL_VALUE,
    }
}

words! {
    /// The blend between lattice points, of gradient and value noise
    ///
    /// ```
    /// assert_eq!(scarp::Fade::ALL, [scarp::Fade::Quintic, scarp::Fade::Cubic]);
    /// ```
    Fade, scarp_fade_name {
        /// The Hessian is continuous.
        Quintic = SCARP_QUINTIC,
        /// The gradient is continuous, the Hessian jumps between cells.
        Cubic = SCARP_CUBIC,
    }
}

words! {
    /// How octaves are summed
    ///
    /// ```
    /// let fractals = [scarp::Fractal::Fbm, scarp::Fractal::Ridged, scarp::Fractal::Swiss];
    /// assert_eq!(fractals.map(|each| each.name()), ["fbm", "ridged", "swiss"]);
    /// ```
    Fractal, scarp_fractal_name {
        /// Fractional Brownian motion: the weighted sum
        Fbm = SCARP_FBM,
        /// The weighted sum of magnitudes
        Turbulence = SCARP_TURBULENCE,
        /// Ridged multifractal
        Ridged = SCARP_RIDGED,
        /// Octaves are damped where the sum of slopes is steep. No Hessian
        Erosion = SCARP_EROSION,
        /// Octaves are folded to and fro.
        Pingpong = SCARP_PINGPONG,
        /// Hybrid multifractal: smooth valleys and rough heights
        Hybrid = SCARP_HYBRID,
        /// Ridges whose octaves are bent downhill. No Hessian
        Swiss = SCARP_SWISS,
        /// Squared octaves that are bent, and damped where it is flat. No Hessian
        Jordan = SCARP_JORDAN,
    }
}

words! {
    /// Kernel sets, one of which serves all calls. Results do not depend on it.
    ///
    /// ```
    /// use scarp::Isa;
    /// let best = Isa::active();
    /// Isa::select(Some(Isa::Scalar))?;
    /// assert_eq!(Isa::active(), Some(Isa::Scalar));
    /// Isa::select(None)?; // the best one
    /// assert_eq!(Isa::active(), best);
    /// # Ok::<(), scarp::Error>(())
    /// ```
    Isa, scarp_isa_name {
        /// Plain C
        Scalar = SCARP_ISA_SCALAR,
        /// SSE4.1 of x86
        Sse41 = SCARP_ISA_SSE41,
        /// AVX2 and FMA of x86
        Avx2 = SCARP_ISA_AVX2,
        /// AVX-512 of x86
        Avx512 = SCARP_ISA_AVX512,
        /// Neon of AArch64
        Neon = SCARP_ISA_NEON,
        /// Portable vector code
        Generic = SCARP_ISA_GENERIC,
        /// The vectors of WebAssembly
        Wasm128 = SCARP_ISA_WASM128,
    }
}

impl Isa {
    /// The set in use. `None`: one that a later version of the library has added
    pub fn active() -> Option<Isa> {
        // SAFETY: the call takes nothing.
        let active = unsafe { ffi::scarp_isa_active() };
        Isa::ALL.iter().copied().find(|isa| *isa as u32 == active)
    }

    /// Whether the library has the set, and this processor can run it
    pub fn is_supported(self) -> bool {
        // SAFETY: any number is allowed.
        unsafe { ffi::scarp_isa_supported(self as u32) != 0 }
    }

    /// Uses a set from now on, in all threads; `None` is the best one. What cannot run here is
    /// `Status::Unsupported`.
    pub fn select(isa: Option<Isa>) -> Result<(), crate::Error> {
        let number = isa.map_or(ffi::SCARP_ISA_NONE, |isa| isa as u32);
        // SAFETY: any number is allowed.
        crate::error::check(unsafe { ffi::scarp_isa_select(number) })
    }
}

/// The languages of shaders: of `scarp.glsl`, `scarp.hlsl` and `scarp.wgsl`
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(u32)]
pub enum Language {
    /// Of OpenGL and Vulkan
    Glsl = ffi::SCARP_GLSL,
    /// Of Direct3D
    Hlsl = ffi::SCARP_HLSL,
    /// Of WebGPU
    Wgsl = ffi::SCARP_WGSL,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every enumerator of the library has a variant.
    #[test]
    fn complete() {
        macro_rules! complete {
            ($name:ident, $call:ident, $first:expr) => {
                for (i, each) in $name::ALL.iter().enumerate() {
                    assert_eq!(*each as usize, i + $first);
                    assert!(!each.name().is_empty());
                    assert_eq!(each.name().parse::<$name>(), Ok(*each));
                }
                let next = unsafe { ffi::$call(($name::ALL.len() + $first) as u32) };
                assert!(next.is_null(), "{:?} is not in {}", text_of(next), stringify!($name));
            };
        }
        complete!(Basis, scarp_basis_name, 0);
        complete!(Fade, scarp_fade_name, 0);
        complete!(Fractal, scarp_fractal_name, 0);
        complete!(Isa, scarp_isa_name, 1);
        let error = "perlin".parse::<Basis>().unwrap_err();
        assert_eq!(error.member(), Some("\"perlin\""));
    }
}
