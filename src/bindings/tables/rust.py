# SPDX-License-Identifier: MIT
"""The declarations of Rust: the module `ffi` of the crate, with a test of its layout. And the
functions of the chain rule."""
import re

from tables import chain
from tables.arrays import arrays
from tables.text import replaced, wrapped

PATH = "src/bindings/rust/src/ffi.rs"
FUNCTIONS, TESTED = "src/bindings/rust/src/chain.rs", "src/bindings/rust/tests/functions/mod.rs"
MEMBERS = "src/bindings/rust/src/members.rs"
LISTS = ("scarp_samples", "scarp_partials", "scarp_cells", "scarp_flow", "scarp_eroded")
MACRO = """// SPDX-License-Identifier: MIT
//! The members of structures of arrays. Made by src/bindings/interface.py; do not change them by
//! hand.

/// Gives another macro what stands there, then the members of a structure of `scarp.h`.
#[rustfmt::skip]
macro_rules! members {
"""
TESTS = """// SPDX-License-Identifier: MIT
//! The calls of tests/bindings/chain.h, apart and in place. Made by src/bindings/interface.py; do not
//! change it by hand.
use scarp::{chain, Error, Samples, View};

type Apart = fn(&View<'_>, &View<'_>, &mut Samples<'_>) -> Result<(), Error>;
/// Of `a`, which is written, with a copy of it
type InPlace = fn(&mut Samples<'_>, &View<'_>, &View<'_>) -> Result<(), Error>;

#[rustfmt::skip]
pub const FUNCTIONS: &[(&str, Apart, InPlace)] = &[
"""

TYPES = {"char": "c_char", "unsigned char": "u8", "int": "c_int", "int32_t": "i32",
         "uint32_t": "u32", "float": "f32", "int64_t": "i64", "uint64_t": "u64", "double": "f64",
         "size_t": "usize", "void": "c_void"}
KEYWORDS = {"as", "box", "break", "const", "crate", "dyn", "else", "enum", "extern", "false", "fn",
            "for", "if", "impl", "in", "let", "loop", "macro", "match", "mod", "move", "mut", "pub",
            "ref", "return", "static", "struct", "trait", "true", "try", "type", "unsafe", "use",
            "virtual", "where", "while", "yield"}
HEAD = """// SPDX-License-Identifier: MIT
//! The declarations of `scarp.h`. Made by src/bindings/interface.py; do not change them by hand.
//!
//! `scarp.h` has the contracts. Calls are unsafe: nothing here checks lengths. Zero a structure
//! before you fill it in: `scarp_noise::default()`, or `Plan::new` and `Recipe::new` of the crate
//! for what calls write as a whole.
#![allow(non_camel_case_types, missing_docs)]
use std::mem::size_of;
use std::os::raw::{c_char, c_int, c_void};

/// The version of the header that the declarations were made of
pub const VERSION: &str = "%s";
"""
ZERO = """
impl Default for %s {
    fn default() -> Self {
        // SAFETY: numbers and pointers may be 0.
        unsafe { std::mem::zeroed() }
    }
}
"""
LAYOUT = """
#[cfg(test)]
mod layout {
    use std::mem::{align_of, size_of, MaybeUninit};
    use std::ptr::addr_of;

    // Numbers are those of the description: for pointers of 4 bytes, and of 8. They hold where
    // doubles lie at multiples of 8 bytes, which they do not on 32-bit x86.
    macro_rules! layout {
        ($name:ident: $four:expr, $eight:expr; $($member:ident: $at4:expr, $at8:expr;)*) => {
            #[test]
            fn $name() {
                if align_of::<f64>() != 8 {
                    return;
                }
                let here = |four, eight| if size_of::<usize>() == 4 { four } else { eight };
                assert_eq!(size_of::<super::$name>(), here($four, $eight));
                let place = MaybeUninit::<super::$name>::uninit();
                let start = place.as_ptr();
                $(
                    // SAFETY: the address is taken, and nothing is read.
                    let member = unsafe { addr_of!((*start).$member) } as usize;
                    let name = stringify!($member);
                    assert_eq!(member - start as usize, here($at4, $at8), "{}", name);
                )*
            }
        };
    }
"""


def name_of(name):
    return "r#" + name if name in KEYWORDS else name


def type_of(kind):
    """`const char *const *` as `*const *const c_char`"""
    base, *stars = re.split(r"(?=\*)", kind)
    words = base.split()
    is_const = "const" in words
    words = [word for word in words if word not in ("const", "struct", "enum")]
    made = " ".join(words)
    made = TYPES.get(made, made)
    for star in stars:
        made = "*%s %s" % ("const" if is_const else "mut", made)
        is_const = "const" in star
    return made


def length(expression):
    return re.sub(r"sizeof\(\s*(?:void \*|size_t)\s*\)", "size_of::<usize>()", expression)


def member_type(member):
    made = type_of(member["type"])
    for expression in reversed(member["expressions"]):
        made = "[%s; %s]" % (made, length(expression))
    return made


def is_large(structure):
    """What calls write as a whole has no default: it does not belong on a stack."""
    return structure[8][0] > 4096


def call(name, returns, arguments):
    """A declaration, as rustfmt breaks it."""
    parts = ["%s: %s" % (name_of(argument), type_of(kind)) for argument, kind in arguments]
    result = "" if returns == "void" else " -> " + type_of(returns)
    line = "    pub fn %s(%s)%s;" % (name, ", ".join(parts), result)
    if len(line) <= 100:
        return line
    return "    pub fn %s(\n%s\n    )%s;" % (
        name, "\n".join("        %s," % part for part in parts), result)


def defaults(header):
    """What 0 stands for in numbers of a description, where that is another number"""
    out = ["", "/// What 0 stands for in members that are numbers, by structure",
           "#[allow(non_upper_case_globals)]", "pub mod defaults {"]
    for name, structure in header.structures.items():
        told = [m for m in structure["members"] if m["default"]]
        if told:
            out += ["    pub mod %s {" % name]
            out += ["        pub const %s: %s = %r;" % (m["name"], type_of(m["type"]), m["default"])
                    for m in told] + ["    }"]
    return out + ["}"]


def table(header):
    """The content of ffi.rs."""
    out = [HEAD % header.version]
    out += ["pub const %s: i32 = %d;" % pair for pair in header.constants.items()]
    for name, values in header.enums.items():
        out += ["", "pub type %s = u32;" % name]
        out += ["pub const %s: %s = %d;" % (word, name, value) for word, value in values.items()]
    for name, structure in header.structures.items():
        out += ["", "#[repr(C)]", "#[derive(Clone, Copy)]", "pub struct %s {" % name]
        out += ["    pub %s: %s," % (name_of(m["name"]), member_type(m))
                for m in structure["members"]] + ["}"]
        if not is_large(structure):
            out.append((ZERO % name).rstrip("\n"))
    out += defaults(header)
    out += ["", 'extern "C" {']
    out += [call(name, *rest) for name, rest in header.functions.items()] + ["}", LAYOUT.rstrip()]
    for name, structure in header.structures.items():
        out += ["", "    layout! {", "        %s: %d, %d;" % (
            name, structure[4][0], structure[8][0])]
        out += ["        %s: %d, %d;" % (name_of(m["name"]), m[4][0], m[8][0])
                for m in structure["members"]] + ["    }"]
    return "\n".join(out + ["}"]) + "\n"


def functions(header):
    """Those of the chain rule. A slope cannot be in place."""
    return [f for f in chain.functions(header) if f.call != chain.SLOPE]


def listed(header):
    """What the macro of chain.rs takes"""
    for f in functions(header):
        yield from wrapped("    /// ", f.about(), "    /// ")
        yield "    %s(%s;%s), %s;" % (f.name, " ".join(f.inputs[1:]),
                                     "".join(" " + name for name in f.numbers), f.call)


def tested(header):
    """The content of tests/functions/mod.rs."""
    out = [TESTS.rstrip()]
    for f in functions(header):
        others = ["b", "a"][:len(f.inputs) - 1]
        numbers = [str(float(number)) for number in f.given.values()]
        b = "b" if others else "_"
        out += ['    ("%s",' % f.name,
                "     |a, %s, out| chain::%s(%s)," % (
                    b, f.name, ", ".join(["a"] + others + numbers + ["out"])),
                "     |a, %s, %s| a.%s(%s))," % (
                    "copy" if "a" in others else "_", b, f.name,
                    ", ".join(["b", "copy"][:len(others)] + numbers))]
    return "\n".join(out + ["];"]) + "\n"


def members(header):
    """The content of members.rs."""
    out = [MACRO.rstrip()]
    for name in LISTS:
        out += ["    (%s => $then:ident! { $($given:tt)* }) => {" % name,
                "        $then! { $($given)*"]
        for array in arrays(header, name):
            out += wrapped("            /// ", array.about, "            /// ")
            out.append("            %s: %s," % (array.name, TYPES[array.kind]))
        out += ["        }", "    };"]
    return "\n".join(out + ["}"]) + "\n"


def made(header, read):
    """Files with what is made of the header: pairs of a path and a text"""
    yield PATH, table(header)
    yield FUNCTIONS, replaced(FUNCTIONS, read(FUNCTIONS), "chain", listed(header))
    yield TESTED, tested(header)
    yield MEMBERS, members(header)
