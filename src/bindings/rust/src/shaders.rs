// SPDX-License-Identifier: MIT
//! The constants of a noise, for shaders.
use crate::error::{Error, Status};
use crate::ffi;
use crate::noise::Noise;
use std::os::raw::c_int;

/// The constants of a noise as a uniform buffer, for `scarp.glsl`, `scarp.hlsl` and `scarp.wgsl`
///
/// ```
/// use scarp::{GpuPlan, Noise};
/// let plan = GpuPlan::new(&Noise { octaves: 6.0, ..Noise::default() }, 2)?;
/// assert_eq!(plan.as_bytes().len(), 5376);
/// # Ok::<(), scarp::Error>(())
/// ```
pub struct GpuPlan(Box<ffi::scarp_gpu_plan>);

impl std::fmt::Debug for GpuPlan {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("GpuPlan")
    }
}

type Make = unsafe extern "C" fn(
    *const ffi::scarp_noise,
    c_int,
    *mut ffi::scarp_gpu_plan,
    *mut *const std::os::raw::c_char,
) -> ffi::scarp_status;

impl GpuPlan {
    /// For shaders that sample the noise in 2 or 3 dimensions
    pub fn new(noise: &Noise<'_>, dimensions: usize) -> Result<GpuPlan, Error> {
        GpuPlan::make(noise, dimensions, ffi::scarp_gpu_plan_make)
    }

    /// For shaders that sample the components of vector noise, or velocities
    pub fn of_vector(noise: &Noise<'_>, dimensions: usize) -> Result<GpuPlan, Error> {
        GpuPlan::make(noise, dimensions, ffi::scarp_gpu_vector_plan_make)
    }

    fn make(noise: &Noise<'_>, dimensions: usize, call: Make) -> Result<GpuPlan, Error> {
        noise.check(dimensions)?;
        // SAFETY: numbers may be 0.
        let mut plan = unsafe { crate::zeroed_box::<ffi::scarp_gpu_plan>() };
        let mut member = std::ptr::null();
        // SAFETY: all pointers are valid.
        let status = unsafe { call(noise.c(), dimensions as c_int, &mut *plan, &mut member) };
        match status {
            ffi::SCARP_OK => Ok(GpuPlan(plan)),
            _ => Err(Error::of(status, crate::error::text_of(member).unwrap_or(""))),
        }
    }

    /// What to upload
    pub fn as_bytes(&self) -> &[u8] {
        let start: *const ffi::scarp_gpu_plan = &*self.0;
        // SAFETY: the plan has numbers of 4 bytes alone, so no padding.
        unsafe {
            std::slice::from_raw_parts(start.cast(), std::mem::size_of::<ffi::scarp_gpu_plan>())
        }
    }
}

impl Noise<'_> {
    /// What shaders must answer for this noise, for a self-test at the start of a program: 4,096
    /// hashes of results up to an order of derivatives
    ///
    /// ```
    /// assert_eq!(scarp::Noise::default().gpu_answers(2, 1)?.len(), 4096);
    /// # Ok::<(), scarp::Error>(())
    /// ```
    pub fn gpu_answers(&self, dimensions: usize, order: usize) -> Result<Vec<u32>, Error> {
        self.check(dimensions)?;
        if order > 2 {
            return Err(Error::new(Status::Parameter, "order", "it is 0, 1 or 2"));
        }
        let mut answers = vec![0; ffi::SCARP_GPU_ANSWERS as usize];
        let at = answers.as_mut_ptr();
        // SAFETY: there is room for all answers.
        match unsafe { ffi::scarp_gpu_answers(self.c(), dimensions as c_int, order as c_int, at) } {
            ffi::SCARP_OK => Ok(answers),
            status => GpuPlan::new(self, dimensions).and(Err(Error::of(status, "order"))),
        }
    }
}
