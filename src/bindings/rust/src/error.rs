// SPDX-License-Identifier: MIT
//! Statuses as errors, and the check of the library's version.
use crate::ffi;
use std::borrow::Cow;
use std::ffi::CStr;
use std::fmt;
use std::os::raw::c_char;
use std::sync::atomic::{AtomicBool, Ordering};

/// What kind of error a call met: `enum scarp_status` of C
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Status {
    /// A slice that an output needs is missing.
    Null,
    /// An enumerator does not exist in this version of the library.
    Enum,
    /// A number is not finite, or outside its documented interval.
    Parameter,
    /// A slice has another length than is needed, or a count is too large.
    Size,
    /// This version, build, call or processor cannot serve the request.
    Unsupported,
}

impl Status {
    pub(crate) fn of(status: ffi::scarp_status) -> Status {
        match status {
            ffi::SCARP_ERROR_NULL => Status::Null,
            ffi::SCARP_ERROR_ENUM => Status::Enum,
            ffi::SCARP_ERROR_PARAMETER => Status::Parameter,
            ffi::SCARP_ERROR_SIZE => Status::Size,
            _ => Status::Unsupported,
        }
    }
}

/// An error in the text of a recipe
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Place {
    /// The line, counted from 1
    pub line: usize,
    /// The column of the first byte, counted from 1, in bytes
    pub column: usize,
    /// The bytes of the text that are at fault
    pub span: std::ops::Range<usize>,
    /// What is wrong: a clause without a full stop
    pub text: &'static str,
    /// The member of a noise, or the argument, that is at fault
    pub member: Option<&'static str>,
    /// A number that would do there
    pub nearest: Option<f64>,
}

impl Place {
    pub(crate) fn of(error: &ffi::scarp_recipe_error) -> Place {
        Place {
            line: error.line as usize,
            column: error.column as usize,
            span: error.from..error.to,
            text: text_of(error.text).unwrap_or(""),
            member: text_of(error.member),
            nearest: Some(error.nearest).filter(|number| *number != 0.0),
        }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}, column {}: ", self.line, self.column)?;
        if let Some(member) = self.member {
            write!(f, "{}: ", member)?;
        }
        f.write_str(self.text)?;
        match self.nearest {
            Some(number) => write!(f, "; {} would do", number),
            None => Ok(()),
        }
    }
}

/// Why a call did nothing. Outputs are untouched then.
///
/// ```
/// let noise = scarp::Noise { octaves: 99.0, ..Default::default() };
/// let error = noise.range(2).unwrap_err();
/// assert_eq!(error.status(), scarp::Status::Parameter);
/// assert_eq!(error.member(), Some("octaves"));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Error {
    status: Status,
    member: Option<Cow<'static, str>>,
    text: Cow<'static, str>,
    places: Vec<Place>,
}

impl Error {
    pub(crate) fn new(
        status: Status,
        member: impl Into<Cow<'static, str>>,
        text: impl Into<Cow<'static, str>>,
    ) -> Error {
        let member = Some(member.into()).filter(|member| !member.is_empty());
        Error { status, member, text: text.into(), places: Vec::new() }
    }

    /// A status other than `SCARP_OK`, in the words of the library
    pub(crate) fn of(status: ffi::scarp_status, member: impl Into<Cow<'static, str>>) -> Error {
        if status == ffi::SCARP_ERROR_NULL {
            return Error::new(Status::Null, member, "a slice that an output needs is missing");
        }
        // SAFETY: any number is allowed; the text is static.
        let text = text_of(unsafe { ffi::scarp_status_text(status) });
        Error::new(Status::of(status), member, text.unwrap_or(""))
    }

    pub(crate) fn of_places(status: ffi::scarp_status, places: Vec<Place>) -> Error {
        let member = places[0].member.unwrap_or("");
        Error { places, ..Error::new(Status::of(status), member, "") }
    }

    /// The kind of error
    pub fn status(&self) -> Status {
        self.status
    }

    /// What is at fault, as the fields of this crate are called: `octaves`, `warp.period[1]`,
    /// `dx`, the parameter of a recipe
    pub fn member(&self) -> Option<&str> {
        self.member.as_deref()
    }

    /// What is wrong, without the member: a clause without a full stop
    pub fn text(&self) -> &str {
        self.places.first().map_or(&self.text, |place| place.text)
    }

    /// The errors in the text of a recipe, in its order; empty for all other errors
    pub fn places(&self) -> &[Place] {
        &self.places
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, place) in self.places.iter().enumerate() {
            write!(f, "{}{}", if i == 0 { "" } else { "\n" }, place)?;
        }
        match &self.member {
            _ if !self.places.is_empty() => Ok(()),
            Some(member) => write!(f, "{}: {}", member, self.text),
            None => f.write_str(&self.text),
        }
    }
}

impl std::error::Error for Error {}

/// A static text of the library
pub(crate) fn text_of(text: *const c_char) -> Option<&'static str> {
    // SAFETY: the library gives NULL or a static text of ASCII that ends with a 0.
    (!text.is_null()).then(|| unsafe { CStr::from_ptr(text) }.to_str().unwrap_or(""))
}

pub(crate) fn check(status: ffi::scarp_status) -> Result<(), Error> {
    if status == ffi::SCARP_OK {
        Ok(())
    } else {
        Err(Error::of(status, ""))
    }
}

/// Whether a library of the version `told` serves declarations of the version `wanted`: the same
/// major version, and while that is 0, the same minor one; and not an older library
fn serves(told: &str, wanted: &str) -> bool {
    let numbers = |version: &str| -> Vec<u32> {
        version.split('.').map_while(|part| part.parse().ok()).collect()
    };
    let (told, wanted) = (numbers(told), numbers(wanted));
    let fixed = if wanted[0] == 0 { 2 } else { 1 };
    told.len() == 3 && told[..fixed] == wanted[..fixed] && told >= wanted
}

/// Refuses a shared library of a version that has other structures. Asks it once.
#[inline]
pub(crate) fn ready() -> Result<(), Error> {
    if IS_SERVED.load(Ordering::Relaxed) {
        Ok(())
    } else {
        ask()
    }
}

static IS_SERVED: AtomicBool = AtomicBool::new(false);

#[cold]
fn ask() -> Result<(), Error> {
    if serves(crate::version(), ffi::VERSION) {
        IS_SERVED.store(true, Ordering::Relaxed);
        return Ok(());
    }
    let text = format!("the library is {}, the crate needs {}", crate::version(), ffi::VERSION);
    Err(Error::new(Status::Unsupported, "", text))
}

#[cfg(test)]
mod tests {
    use super::serves;

    #[test]
    fn versions() {
        for (told, wanted, is_served) in [
            ("0.2.0", "0.2.0", true),
            ("0.2.7", "0.2.0", true),
            ("0.2.0", "0.2.1", false),
            ("0.3.0", "0.2.0", false),
            ("1.2.0", "0.2.0", false),
            ("1.3.0", "1.2.9", true),
            ("2.0.0", "1.2.9", false),
            ("0.2", "0.2.0", false),
            ("", "0.2.0", false),
        ] {
            assert_eq!(serves(told, wanted), is_served, "{} for {}", told, wanted);
        }
    }

    #[test]
    fn the_crate_has_the_version_of_the_header() {
        assert_eq!(env!("CARGO_PKG_VERSION"), crate::ffi::VERSION);
    }
}
