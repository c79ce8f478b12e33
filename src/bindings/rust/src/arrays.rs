// SPDX-License-Identifier: MIT
//! Slices that calls write to and read from, and the checks of their lengths.
use crate::error::{Error, Status};
use crate::ffi;

/// Gives the pointers of slices, and remembers those whose lengths are wrong.
pub(crate) struct Sizes {
    pub count: usize,
    is_grid: bool, // longer slices will do
    wrong: Vec<(&'static str, usize)>,
}

impl Sizes {
    #[inline]
    pub fn points(count: usize) -> Sizes {
        Sizes { count, is_grid: false, wrong: Vec::new() }
    }

    /// Of a grid that has so many elements from its first sample to its last
    #[inline]
    pub fn grid(count: usize) -> Sizes {
        Sizes { count, is_grid: true, wrong: Vec::new() }
    }

    /// The names of all slices that a function goes through: none is so long.
    #[cold]
    pub fn names<C>(through: impl FnOnce(&mut Sizes) -> C) -> Vec<&'static str> {
        let mut sizes = Sizes::points(usize::MAX);
        through(&mut sizes);
        sizes.wrong.into_iter().map(|(name, _)| name).collect()
    }

    #[inline]
    fn see(&mut self, length: usize, name: &'static str) {
        if length != self.count {
            self.doubt(length, name);
        }
    }

    /// A length other than the count: longer slices of grids are right.
    #[cold]
    fn doubt(&mut self, length: usize, name: &'static str) {
        if !(self.is_grid && length > self.count) {
            self.wrong.push((name, length));
        }
    }

    #[inline]
    pub fn input<T>(&mut self, slice: &[T], name: &'static str) -> *const T {
        self.see(slice.len(), name);
        slice.as_ptr()
    }

    #[inline]
    pub fn maybe_input<T>(&mut self, slice: &Option<&[T]>, name: &'static str) -> *const T {
        slice.map_or(std::ptr::null(), |slice| self.input(slice, name))
    }

    #[inline]
    pub fn output<T>(&mut self, slice: &mut Option<&mut [T]>, name: &'static str) -> *mut T {
        match slice {
            Some(slice) => {
                self.see(slice.len(), name);
                slice.as_mut_ptr()
            }
            None => std::ptr::null_mut(),
        }
    }

    /// To be asked after all slices, and before the call
    #[inline]
    pub fn check(&self) -> Result<(), Error> {
        match self.wrong.first() {
            None => Ok(()),
            Some((name, length)) => Err(self.complain(name, *length)),
        }
    }

    #[cold]
    fn complain(&self, name: &'static str, length: usize) -> Error {
        let text = if self.is_grid {
            format!("the slice has {} elements, the grid needs {}", length, self.count)
        } else {
            format!("the slice has {} elements, and there are {} points", length, self.count)
        };
        Error::new(Status::Size, name, text)
    }
}

/// Samples, or a view of them, of the members of another structure
macro_rules! every {
    ($name:ident, $of:ident, $($from:tt)+) => {
        $name {
            value: $of($($from)+.value),
            dx: $of($($from)+.dx),
            dy: $of($($from)+.dy),
            dz: $of($($from)+.dz),
            dxx: $of($($from)+.dxx),
            dxy: $of($($from)+.dxy),
            dxz: $of($($from)+.dxz),
            dyy: $of($($from)+.dyy),
            dyz: $of($($from)+.dyz),
            dzz: $of($($from)+.dzz),
            dphase: $of($($from)+.dphase),
        }
    };
}

/// A structure of slices that a call writes to
macro_rules! outputs {
    ($(#[$about:meta])* $name:ident: $c:ident {
        $($(#[$each:meta])* $member:ident: $type:ty,)*
    }) => {
        $(#[$about])*
        #[derive(Debug, Default)]
        pub struct $name<'a> {
            $($(#[$each])* pub $member: Option<&'a mut [$type]>,)*
        }

        impl<'a> $name<'a> {
            /// The same slices for a while, after which this structure has them again
            pub fn reborrow(&mut self) -> $name<'_> {
                $name { $($member: self.$member.as_deref_mut(),)* }
            }

            #[inline]
            pub(crate) fn c(&mut self, sizes: &mut Sizes) -> ffi::$c {
                ffi::$c {
                    $($member: sizes.output(&mut self.$member, stringify!($member)),)*
                    ..Default::default()
                }
            }
        }
    };
}

/// A structure of slices that a call reads
macro_rules! inputs {
    ($(#[$about:meta])* $name:ident: $c:ident { $($(#[$each:meta])* $member:ident,)* }) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, Default)]
        pub struct $name<'a> {
            $($(#[$each])* pub $member: Option<&'a [f32]>,)*
        }

        impl $name<'_> {
            #[inline]
            pub(crate) fn c(&self, sizes: &mut Sizes) -> ffi::$c {
                ffi::$c {
                    $($member: sizes.maybe_input(&self.$member, stringify!($member)) as _,)*
                    ..Default::default()
                }
            }
        }
    };
}

outputs! {
    /// Where samples go. What is `None` is not computed; a call that asks for no derivative does
    /// not pay for derivatives.
    ///
    /// Of points, each slice has as many elements as there are points; of a grid, at least as many
    /// as from its first sample to its last.
    ///
    /// ```
    /// use scarp::{Noise, Samples};
    /// let (mut value, mut dx) = ([0.0; 3], [0.0; 3]);
    /// let mut out = Samples { value: Some(&mut value), dx: Some(&mut dx), ..Samples::default() };
    /// Noise::default().sample2(&[0.5, 1.5, 2.5], &[0.25; 3], &mut out)?;
    /// # Ok::<(), scarp::Error>(())
    /// ```
    Samples: scarp_samples {
        /// The noise
        value: f32,
        /// The gradient, per unit of input
        dx: f32,
        /// The gradient along y
        dy: f32,
        /// The gradient along z, in space
        dz: f32,
        /// The Hessian, per unit of input squared
        dxx: f32,
        /// The Hessian: the derivative by x and y
        dxy: f32,
        /// The Hessian: the derivative by x and z, in space
        dxz: f32,
        /// The Hessian: the second derivative by y
        dyy: f32,
        /// The Hessian: the derivative by y and z, in space
        dyz: f32,
        /// The Hessian: the second derivative by z, in space
        dzz: f32,
        /// The derivative by the phase, per turn
        dphase: f32,
    }
}

impl<'a> Samples<'a> {
    /// To read what is there
    pub fn view(&self) -> View<'_> {
        fn of<'b>(slice: &'b Option<&mut [f32]>) -> Option<&'b [f32]> {
            slice.as_deref()
        }
        every!(View, of, &self)
    }

    pub(crate) fn each(&mut self) -> [&mut Option<&'a mut [f32]>; 11] {
        [
            &mut self.value,
            &mut self.dx,
            &mut self.dy,
            &mut self.dz,
            &mut self.dxx,
            &mut self.dxy,
            &mut self.dxz,
            &mut self.dyy,
            &mut self.dyz,
            &mut self.dzz,
            &mut self.dphase,
        ]
    }

    /// Takes so many elements from the front of each slice, or all that there are.
    pub(crate) fn take_front(&mut self, count: usize) -> Samples<'a> {
        let mut front = Samples::default();
        for (from, to) in self.each().into_iter().zip(front.each()) {
            if let Some(slice) = from.take() {
                let (head, tail) = slice.split_at_mut(count.min(slice.len()));
                *to = Some(head);
                *from = Some(tail);
            }
        }
        front
    }
}

inputs! {
    /// Samples that a call reads: inputs of the [chain rule](crate::chain), and the base of
    /// [gullies](crate::Gullies). All slices that are there have the same length. Fields are those
    /// of [`Samples`], of which [`Samples::view`] makes it.
    View: scarp_samples {
        /// The value
        value,
        /// The gradient
        dx,
        /// The gradient along y
        dy,
        /// The gradient along z
        dz,
        /// The Hessian
        dxx,
        /// The Hessian: the derivative by x and y
        dxy,
        /// The Hessian: the derivative by x and z
        dxz,
        /// The Hessian: the second derivative by y
        dyy,
        /// The Hessian: the derivative by y and z
        dyz,
        /// The Hessian: the second derivative by z
        dzz,
        /// The derivative by the phase
        dphase,
    }
}

impl View<'_> {
    /// The length of the first slice that is there
    pub(crate) fn count(&self) -> usize {
        let all = [
            self.value,
            self.dx,
            self.dy,
            self.dz,
            self.dxx,
            self.dxy,
            self.dxz,
            self.dyy,
            self.dyz,
            self.dzz,
            self.dphase,
        ];
        all.into_iter().flatten().next().map_or(0, <[f32]>::len)
    }
}

inputs! {
    /// A function at each point: its value, and its partial derivatives by one or two arguments.
    /// What [`chain::apply1`](crate::chain::apply1) and `apply2` take.
    Partials: scarp_partials {
        /// The value
        f,
        /// The derivative by the first argument
        fa,
        /// The derivative by the second argument
        fb,
        /// The second derivative by the first argument
        faa,
        /// The derivative by both
        fab,
        /// The second derivative by the second argument
        fbb,
    }
}

/// Samples that own their memory. A member that is not wanted is an empty vector.
///
/// ```
/// use scarp::{Arrays, Grid, Noise};
/// let grid = Grid { step: [0.01; 2], count: [64, 48], ..Grid::<2>::default() };
/// let mut tile = Arrays::plane(64 * 48, 1); // values and gradients
/// Noise { octaves: 6.0, ..Noise::default() }.grid2(&grid, &mut tile.samples())?;
/// assert_eq!(tile.dx.len(), 64 * 48);
/// assert!(tile.dxx.is_empty());
/// # Ok::<(), scarp::Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Arrays {
    /// The value
    pub value: Vec<f32>,
    /// The gradient
    pub dx: Vec<f32>,
    /// The gradient along y
    pub dy: Vec<f32>,
    /// The gradient along z
    pub dz: Vec<f32>,
    /// The Hessian
    pub dxx: Vec<f32>,
    /// The Hessian: the derivative by x and y
    pub dxy: Vec<f32>,
    /// The Hessian: the derivative by x and z
    pub dxz: Vec<f32>,
    /// The Hessian: the second derivative by y
    pub dyy: Vec<f32>,
    /// The Hessian: the derivative by y and z
    pub dyz: Vec<f32>,
    /// The Hessian: the second derivative by z
    pub dzz: Vec<f32>,
    /// The derivative by the phase
    pub dphase: Vec<f32>,
}

impl Arrays {
    /// For `count` samples of the plane, with derivatives up to `order`: 0 for values, 1 with the
    /// gradient, 2 or more with the Hessian. Zeros
    pub fn plane(count: usize, order: usize) -> Arrays {
        let of = |least| vec![0.0; if order >= least { count } else { 0 }];
        Arrays {
            value: of(0),
            dx: of(1),
            dy: of(1),
            dxx: of(2),
            dxy: of(2),
            dyy: of(2),
            ..Arrays::default()
        }
    }

    /// The same in space
    pub fn space(count: usize, order: usize) -> Arrays {
        let of = |least| vec![0.0; if order >= least { count } else { 0 }];
        let (dz, dxz, dyz, dzz) = (of(1), of(2), of(2), of(2));
        Arrays { dz, dxz, dyz, dzz, ..Arrays::plane(count, order) }
    }

    /// To write to
    pub fn samples(&mut self) -> Samples<'_> {
        fn of(vector: &mut [f32]) -> Option<&mut [f32]> {
            Some(vector).filter(|slice| !slice.is_empty())
        }
        every!(Samples, of, &mut self)
    }

    /// To read
    pub fn view(&self) -> View<'_> {
        fn of(vector: &[f32]) -> Option<&[f32]> {
            Some(vector).filter(|slice| !slice.is_empty())
        }
        every!(View, of, &self)
    }
}

outputs! {
    /// Where [`Noise::cells2`](crate::Noise::cells2) and `cells3` tell what is near each point.
    /// Distances and positions are in units of input.
    Cells: scarp_cells {
        /// The distance to the nearest feature
        f1: f32,
        /// The distance to the second nearest
        f2: f32,
        /// A number drawn for the cell of the nearest feature
        id: u32,
        /// Where the nearest feature is
        x: f32,
        /// Where it is along y
        y: f32,
        /// Where it is along z, in space
        z: f32,
        /// The gradient of `f1`
        dx1: f32,
        /// The gradient of `f1` along y
        dy1: f32,
        /// The gradient of `f1` along z, in space
        dz1: f32,
        /// The gradient of `f2`
        dx2: f32,
        /// The gradient of `f2` along y
        dy2: f32,
        /// The gradient of `f2` along z, in space
        dz2: f32,
    }
}

outputs! {
    /// Where [`Noise::curl2`](crate::Noise::curl2) and `curl3` put velocities and their Jacobian.
    Flow: scarp_flow {
        /// The velocity
        vx: f32,
        /// The velocity along y
        vy: f32,
        /// The velocity along z, in space
        vz: f32,
        /// The Jacobian: the derivative of `vx` by x
        vxx: f32,
        /// The derivative of `vx` by y
        vxy: f32,
        /// The derivative of `vx` by z, in space
        vxz: f32,
        /// The derivative of `vy` by x
        vyx: f32,
        /// The derivative of `vy` by y
        vyy: f32,
        /// The derivative of `vy` by z, in space
        vyz: f32,
        /// The derivative of `vz` by x, in space
        vzx: f32,
        /// The derivative of `vz` by y, in space
        vzy: f32,
        /// The derivative of `vz` by z, in space
        vzz: f32,
    }
}

outputs! {
    /// Where [`Gullies`](crate::Gullies) put the base with gullies, and the displacement.
    Eroded: scarp_eroded {
        /// The base plus the displacement
        value: f32,
        /// Its gradient
        dx: f32,
        /// Its gradient along y
        dy: f32,
        /// The displacement: a map of ridges and gullies
        displacement: f32,
        /// The gradient of the displacement
        displacement_dx: f32,
        /// The gradient of the displacement along y
        displacement_dy: f32,
    }
}
