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
    ($name:ident, $of:ident, $from:expr; $($(#[$each:meta])* $member:ident: $type:ty,)*) => {
        $name { $($member: $of(&$from.$member),)* }
    };
    (mut $name:ident, $of:ident, $from:expr; $($(#[$each:meta])* $member:ident: $type:ty,)*) => {
        $name { $($member: $of(&mut $from.$member),)* }
    };
}

/// All slices of a structure
macro_rules! each {
    ($of:expr; $($(#[$each:meta])* $member:ident: $type:ty,)*) => { [$(&mut $of.$member),*] };
}

/// The length of the first slice that is there
macro_rules! first {
    ($of:expr; $($(#[$each:meta])* $member:ident: $type:ty,)*) => {
        [$($of.$member),*].into_iter().flatten().next().map_or(0, <[f32]>::len)
    };
}

/// A structure of slices that a call writes to
macro_rules! outputs {
    ($(#[$about:meta])* $name:ident: $c:ident; $($(#[$each:meta])* $member:ident: $type:ty,)*) => {
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
    ($(#[$about:meta])* $name:ident: $c:ident; $($(#[$each:meta])* $member:ident: $type:ty,)*) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, Default)]
        pub struct $name<'a> {
            $($(#[$each])* pub $member: Option<&'a [$type]>,)*
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

members! { scarp_samples => outputs! {
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
    Samples: scarp_samples;
} }

impl<'a> Samples<'a> {
    /// To read what is there
    pub fn view(&self) -> View<'_> {
        fn of<'b>(slice: &'b Option<&mut [f32]>) -> Option<&'b [f32]> {
            slice.as_deref()
        }
        members!(scarp_samples => every! { View, of, self; })
    }

    pub(crate) fn each(&mut self) -> [&mut Option<&'a mut [f32]>; 11] {
        members!(scarp_samples => each! { self; })
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

members! { scarp_samples => inputs! {
    /// Samples that a call reads: inputs of the [chain rule](crate::chain), and the base of
    /// [gullies](crate::Gullies). All slices that are there have the same length. Fields are those
    /// of [`Samples`], of which [`Samples::view`] makes it.
    View: scarp_samples;
} }

impl View<'_> {
    /// The length of the first slice that is there
    pub(crate) fn count(&self) -> usize {
        members!(scarp_samples => first! { self; })
    }
}

members! { scarp_partials => inputs! {
    /// A function at each point: its value, and its partial derivatives by one or two arguments.
    /// What [`chain::apply1`](crate::chain::apply1) and `apply2` take.
    Partials: scarp_partials;
} }

/// The structure of vectors
macro_rules! vectors {
    ($(#[$about:meta])* $name:ident; $($(#[$each:meta])* $member:ident: $type:ty,)*) => {
        $(#[$about])*
        #[derive(Clone, Debug, Default, PartialEq)]
        pub struct $name {
            $($(#[$each])* pub $member: Vec<$type>,)*
        }
    };
}

members! { scarp_samples => vectors! {
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
    Arrays;
} }

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
        members!(scarp_samples => every! { mut Samples, of, self; })
    }

    /// To read
    pub fn view(&self) -> View<'_> {
        fn of(vector: &[f32]) -> Option<&[f32]> {
            Some(vector).filter(|slice| !slice.is_empty())
        }
        members!(scarp_samples => every! { View, of, self; })
    }
}

members! { scarp_cells => outputs! {
    /// Where [`Noise::cells2`](crate::Noise::cells2) and `cells3` tell what is near each point.
    /// Distances and positions are in units of input.
    Cells: scarp_cells;
} }

members! { scarp_flow => outputs! {
    /// Where [`Noise::curl2`](crate::Noise::curl2) and `curl3` put velocities and their Jacobian.
    Flow: scarp_flow;
} }

members! { scarp_eroded => outputs! {
    /// Where [`Gullies`](crate::Gullies) put the base with gullies, and the displacement.
    Eroded: scarp_eroded;
} }
