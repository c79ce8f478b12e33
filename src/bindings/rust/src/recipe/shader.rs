// SPDX-License-Identifier: MIT
//! Recipes as shaders.
use super::Recipe;
use crate::error::{Error, Status};
use crate::ffi;
use std::os::raw::c_char;

impl Recipe {
    /// The recipe as functions of a shading language. `file` is the text of `scarp.glsl`, or
    /// `scarp.hlsl`, or `scarp.wgsl`; derivatives have an `order` of 0, 1 or 2.
    pub fn shader(
        &self,
        language: crate::Language,
        order: usize,
        file: &str,
    ) -> Result<String, Error> {
        let how = ffi::scarp_shader {
            language: language as i32,
            order: i32::try_from(order).unwrap_or(-1),
            file: file.as_ptr().cast(),
            length: file.len(),
            ..Default::default()
        };
        let bytes = fill::<u8>(file.len() + 1, |bytes, capacity, length| {
            let text: *mut c_char = bytes.cast();
            // SAFETY: all pointers are valid, for as many bytes as they are said to have.
            unsafe { ffi::scarp_recipe_shader(&*self.c, &how, text, capacity, length) }
        })?;
        String::from_utf8(bytes).map_err(|_| Error::new(Status::Parameter, "file", "it is no text"))
    }

    /// The uniform buffer of that shader, in the layout std140: seed and parameters are in here.
    pub fn uniforms(&self) -> Result<Vec<u8>, Error> {
        let words = fill::<u32>(8192, |words, capacity, size| {
            // SAFETY: all pointers are valid, for as many bytes as they are said to have. Floats
            // may stand where words do.
            unsafe { ffi::scarp_recipe_uniforms(&*self.c, words.cast(), capacity, size) }
        })?;
        Ok(words.into_iter().flat_map(u32::to_ne_bytes).collect())
    }

    /// What that shader must answer, for a self-test at the start of a program: 4,096 hashes
    ///
    /// ```
    /// let hills = scarp::Recipe::preset("hills")?;
    /// assert_eq!(hills.answers(1)?.len(), 4096);
    /// assert_eq!(hills.uniforms()?.len() % 16, 0);
    /// # Ok::<(), scarp::Error>(())
    /// ```
    pub fn answers(&self, order: usize) -> Result<Vec<u32>, Error> {
        let mut answers = vec![0; ffi::SCARP_GPU_ANSWERS as usize];
        let order = i32::try_from(order).unwrap_or(-1);
        // SAFETY: there is room for all answers.
        crate::error::check(unsafe {
            ffi::scarp_recipe_answers(&*self.c, order, answers.as_mut_ptr())
        })?;
        Ok(answers)
    }
}

/// Calls with room for so many bytes, and once more if that was too little. What calls write are
/// whole elements.
fn fill<T: Clone + Default>(
    bytes: usize,
    call: impl Fn(*mut T, usize, *mut usize) -> ffi::scarp_status,
) -> Result<Vec<T>, Error> {
    let (each, mut length) = (std::mem::size_of::<T>(), 0);
    let mut made = vec![T::default(); bytes / each];
    let mut status = call(made.as_mut_ptr(), made.len() * each, &mut length);
    if status == ffi::SCARP_ERROR_SIZE {
        made.resize(length / each + 1, T::default());
        status = call(made.as_mut_ptr(), made.len() * each, &mut length);
    }
    crate::error::check(status)?;
    made.truncate(length / each);
    Ok(made)
}
