# SPDX-License-Identifier: MIT
"""Finds the shared library, declares its calls, and turns what they return into exceptions."""
import ctypes
import ctypes.util
import glob
import keyword
import os
import sys

from . import _interface

HERE = os.path.dirname(os.path.abspath(__file__))
POINTER = ctypes.sizeof(ctypes.c_void_p)
VERSION = tuple(int(part) for part in _interface.VERSION.split("."))
STATUS = _interface.ENUMS["scarp_status"]
STATUS_NAMES = {value: name for name, value in STATUS.items()}


class ScarpError(ValueError):
    """What the library does not take.

    member: the name of the member at fault, as "octaves" or "period[1]", or None.
    status: the name of the status in C, as "SCARP_ERROR_PARAMETER".
    """

    def __init__(self, text, member=None, status="SCARP_ERROR_PARAMETER"):
        super().__init__(text if member is None else "%s: %s" % (member, text))
        self.text, self.member, self.status = text, member, status

    def __reduce__(self):
        return type(self), (self.text, self.member, self.status)


class LibraryError(ImportError):
    """The shared library of scarp is not there, or is of another version."""


# Types of structures and calls

_TYPES = {"i1": ctypes.c_int8, "u1": ctypes.c_uint8, "i4": ctypes.c_int32, "u4": ctypes.c_uint32,
          "f4": ctypes.c_float, "i8": ctypes.c_int64, "u8": ctypes.c_uint64, "f8": ctypes.c_double,
          "size": ctypes.c_size_t, "text": ctypes.c_char_p, "pointer": ctypes.c_void_p}


def _here(number):
    """A number that may be two, one for each size of pointers."""
    return number[POINTER // 8] if isinstance(number, tuple) else number


def _structure(name):
    size, members = _interface.STRUCTURES[name]
    fields = []
    for member, code, lengths in members:
        kind = _TYPES[code] if code in _TYPES else STRUCTURES[code]
        for length in reversed(lengths):
            kind = kind * _here(length)
        # A word of Python, such as `from`, gets an underscore.
        fields.append((member + "_" * keyword.iskeyword(member), kind))
    made = type(name, (ctypes.Structure,), {"_fields_": fields})
    # Elsewhere (32-bit x86) doubles are aligned otherwise, and sizes may be less.
    if ctypes.alignment(ctypes.c_double) == 8 and ctypes.sizeof(made) != _here(size):
        raise LibraryError("struct %s has another size here: %d, not %d" % (
            name, ctypes.sizeof(made), _here(size)))
    return made


STRUCTURES = {}
for _name in _interface.STRUCTURES:
    STRUCTURES[_name] = _structure(_name)


# The library

def _names():
    """File names of the shared library, the most exact one first."""
    abi = "%d.%d" % VERSION[:2] if VERSION[0] == 0 else str(VERSION[0])
    if sys.platform == "win32":
        return ["scarp.dll", "libscarp.dll"]
    if sys.platform == "darwin":
        return ["libscarp.%s.dylib" % abi, "libscarp.dylib"]
    return ["libscarp.so." + abi, "libscarp.so"]


def candidates():
    """What is tried, in this order: SCARP_LIBRARY in the environment and nothing else if it is
    set; else the library beside this file; else that of the system."""
    chosen = os.environ.get("SCARP_LIBRARY")
    if chosen:
        return [os.path.abspath(chosen)]
    beside = [path for name in _names() for end in ("", ".*")
              for path in sorted(glob.glob(os.path.join(glob.escape(HERE), name + end)))]
    found = ctypes.util.find_library("scarp")
    return beside + _names() + ([found] if found else [])


def check_version(told, path):
    """Raises LibraryError unless a library of this version serves the tables of this module."""
    try:
        version = tuple(int(part) for part in told.split("."))
    except ValueError:
        version = ()
    fixed = 2 if VERSION[0] == 0 else 1
    if len(version) != 3 or version[:fixed] != VERSION[:fixed] or version < VERSION:
        raise LibraryError("%s is version %s of scarp, but this module needs %s, or a later one "
                           "that begins with %s" % (path, told, _interface.VERSION, ".".join(
                               str(part) for part in VERSION[:fixed])))


def _load():
    complaints = []
    for path in candidates():
        try:
            library = ctypes.CDLL(path)
        except OSError as error:
            complaints.append("    %s" % error)
            continue
        try:
            library.scarp_version.restype = ctypes.c_char_p
        except AttributeError:
            raise LibraryError("%s is not the library scarp" % path) from None
        check_version(library.scarp_version().decode(), path)
        return library, path
    raise LibraryError("the shared library of scarp was not found. Install it, or name its file in "
                       "the environment: SCARP_LIBRARY=/path/to/%s. Tried:\n%s" % (
                           _names()[-1], "\n".join(complaints)))


def _declare(library):
    for name, (returns, arguments) in _interface.FUNCTIONS.items():
        try:
            function = getattr(library, name)
        except AttributeError:
            raise LibraryError("%s has no call %s" % (path_of_library, name)) from None
        function.restype = _TYPES[returns]
        function.argtypes = [_TYPES[code] for code in arguments]


lib, path_of_library = _load()
_declare(lib)


def _words(function):
    found = []
    while True:
        word = function(len(found))
        if word is None:
            return tuple(found)
        found.append(word.decode())


BASES, FADES, FRACTALS = (_words(lib.scarp_basis_name), _words(lib.scarp_fade_name),
                          _words(lib.scarp_fractal_name))
VERSION_OF_LIBRARY = lib.scarp_version().decode()


def told(call, *arguments):
    """(member, text): what a call of the library tells of a fault, each None if there is none."""
    member = ctypes.c_char_p()
    text = call(*arguments, ctypes.addressof(member))
    return tuple(None if part is None else part.decode() for part in (member.value, text))


def complain(status, member=None, text=None):
    """The exception for a status other than SCARP_OK."""
    if status == STATUS["SCARP_ERROR_SIZE"] and text is None and member is None:
        return MemoryError(lib.scarp_status_text(status).decode())
    return ScarpError(text or lib.scarp_status_text(status).decode(), member,
                      STATUS_NAMES.get(status, str(status)))


# Instruction sets

def isa():
    """The instruction set in use, as "avx2". Results do not depend on it."""
    return lib.scarp_isa_name(lib.scarp_isa_active()).decode()


def isas():
    """The instruction sets that this library has and this processor can run: a tuple of words."""
    return tuple(word for number, word in enumerate(_words(lib.scarp_isa_name))
                 if lib.scarp_isa_supported(number))


def select_isa(name=None):
    """Uses an instruction set from now on, in all threads; None is the best one.

    Raises ScarpError for a name that there is not, or that cannot run here."""
    words = _words(lib.scarp_isa_name)
    if name is not None and name not in isas():
        raise ScarpError("cannot run here; there are " + ", ".join(isas()), "isa %r" % (name,),
                         "SCARP_ERROR_UNSUPPORTED")
    status = lib.scarp_isa_select(0 if name is None else words.index(name))
    if status:
        raise complain(status)
