// SPDX-License-Identifier: MIT
//! The constants of a noise, which a program may keep.
use super::Noise;
use crate::error::Error;
use crate::ffi;
use std::os::raw::c_int;

/// The constants of a noise, for many calls with few points: a call with one point takes less than
/// half the time with it, and gives the same bits.
///
/// A plan knows the noise that it was made of. It does no harm to others: a call whose noise
/// differs in any way does without. The plan has nothing of a warp, so that may differ.
///
/// ```
/// use scarp::{Noise, Plan, Samples};
/// let noise = Noise { octaves: 8.0, ..Noise::default() };
/// let plan = Plan::new(&noise, 2)?; // for calls of the plane
/// let noise = Noise { plan: Some(&plan), ..noise };
/// let mut value = [0.0];
/// for i in 0..100 {
///     let mut out = Samples { value: Some(&mut value), ..Samples::default() };
///     noise.sample2(&[i as f32 / 8.0], &[0.5], &mut out)?;
/// }
/// # Ok::<(), scarp::Error>(())
/// ```
#[repr(transparent)]
pub struct Plan(ffi::scarp_plan);

impl Plan {
    /// The plan of a noise in 2 or 3 dimensions, in 12 KiB of its own. Errors are those of
    /// [`Noise::check`].
    pub fn new(noise: &Noise<'_>, dimensions: usize) -> Result<Box<Plan>, Error> {
        noise.check(dimensions)?;
        // SAFETY: all zeros is a plan, of nothing; Plan has the layout of scarp_plan.
        let mut plan = unsafe { crate::zeroed_box::<Plan>() };
        // SAFETY: both pointers are valid.
        let status = unsafe { ffi::scarp_plan_make(noise.c(), dimensions as c_int, &mut plan.0) };
        crate::error::check(status)?;
        Ok(plan)
    }
}

impl PartialEq for Plan {
    /// Whether two plans are the same one
    fn eq(&self, other: &Plan) -> bool {
        std::ptr::eq(self, other)
    }
}

impl std::fmt::Debug for Plan {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Plan")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A plan has the constants of its noise. Results cannot tell.
    #[test]
    fn plans_differ() {
        let plans = [(0, 2), (1, 2), (0, 3)]
            .map(|(seed, d)| Plan::new(&Noise { seed, ..Noise::DEFAULT }, d).unwrap());
        assert!(plans[0].0.rest != plans[1].0.rest && plans[0].0.rest != plans[2].0.rest);
    }
}
