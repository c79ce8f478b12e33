// SPDX-License-Identifier: MIT
//! What is wrong with a noise, or with what is asked of it.
use super::Noise;
use crate::error::{ready, text_of, Error, Status};
use crate::ffi;
use std::os::raw::c_int;

impl Noise<'_> {
    fn numbers(&self) -> [(&'static str, f32); 7] {
        [
            ("frequency", if self.frequency == 0.0 { 0.0 } else { 1.0 }),
            ("octaves", self.octaves),
            ("lacunarity", self.lacunarity),
            ("gain", self.gain),
            ("amplitude", self.amplitude),
            ("erosion", self.erosion),
            ("jitter", self.jitter),
        ]
    }

    /// Refuses members that are 0, which C would take for the default, also those of warps, and a
    /// library of another version.
    #[inline]
    pub(crate) fn prepare(&self) -> Result<(), Error> {
        ready()?;
        let (mut noise, mut depth) = (self, 0);
        loop {
            // Without branches: this runs at every call.
            if noise.numbers().iter().fold(false, |any, (_, number)| any | (*number == 0.0)) {
                return Err(noise.complain_of_zero(depth));
            }
            match noise.warp {
                Some(warp) if depth < 5 => (noise, depth) = (warp, depth + 1),
                _ => return Ok(()), // the library refuses more than four
            }
        }
    }

    #[cold]
    fn complain_of_zero(&self, depth: usize) -> Error {
        let zero = self.numbers().into_iter().find(|(_, number)| *number == 0.0);
        let member = "warp.".repeat(depth) + zero.map_or("", |(name, _)| name);
        Error::new(Status::Parameter, member, "must not be 0. Leave it out for the default")
    }

    /// Whether calls in 2 or 3 dimensions take this noise; if not, the error names the member at
    /// fault, of warps as `warp.octaves`.
    ///
    /// ```
    /// use scarp::Noise;
    /// let bend = Noise { gain: f32::NAN, ..Noise::default() };
    /// let error = Noise { warp: Some(&bend), ..Noise::default() }.check(2).unwrap_err();
    /// assert_eq!(error.member(), Some("warp.gain"));
    /// ```
    pub fn check(&self, dimensions: usize) -> Result<(), Error> {
        self.prepare()?;
        match self.fault(dimensions) {
            Some(error) => Err(error),
            None => Ok(()),
        }
    }

    /// What the library says against this noise
    pub(super) fn fault(&self, dimensions: usize) -> Option<Error> {
        let mut member = std::ptr::null();
        let dimensions = c_int::try_from(dimensions).unwrap_or(0);
        // SAFETY: the noise has the layout of C, and all warps are alive.
        let (status, text) = unsafe {
            let status = ffi::scarp_noise_check(self.c(), dimensions, &mut member);
            (status, ffi::scarp_noise_fault(self.c(), dimensions, 0, 0, std::ptr::null_mut()))
        };
        let name = text_of(member).unwrap_or("dimensions");
        text_of(text).map(|text| Error::new(Status::of(status), name, text))
    }

    /// The error of a call that failed: the noise is at fault, or what was asked of it.
    #[inline]
    pub(super) fn blame(
        &self,
        status: ffi::scarp_status,
        dimensions: usize,
        names: impl FnOnce() -> Vec<&'static str>,
    ) -> Result<(), Error> {
        if status == ffi::SCARP_OK {
            return Ok(());
        }
        let names = if status == ffi::SCARP_ERROR_UNSUPPORTED { names() } else { Vec::new() };
        Err(self.complain(status, dimensions, &names))
    }

    #[cold]
    fn complain(
        &self,
        status: ffi::scarp_status,
        dimensions: usize,
        names: &[&'static str],
    ) -> Error {
        let lacked = || names.iter().find_map(|name| Some((*name, self.lack(name, dimensions)?)));
        self.fault(dimensions).unwrap_or_else(|| match lacked() {
            Some((name, why)) => Error::new(Status::Unsupported, name, why),
            None => Error::of(status, ""),
        })
    }

    /// Why this noise does not have an output
    fn lack(&self, name: &str, dimensions: usize) -> Option<&'static str> {
        let is_second = matches!(name.as_bytes(), [b'd' | b'v', b'x'..=b'z', b'x'..=b'z']);
        if dimensions == 2 && name.contains('z') {
            Some("the plane has no z")
        } else if is_second || name == "dphase" {
            let (order, dphase) = if is_second { (2, 0) } else { (0, 1) };
            let dimensions = c_int::try_from(dimensions).unwrap_or(0);
            let member = std::ptr::null_mut();
            // SAFETY: the noise has the layout of C, and all warps are alive.
            text_of(unsafe { ffi::scarp_noise_fault(self.c(), dimensions, order, dphase, member) })
        } else {
            None
        }
    }
}
