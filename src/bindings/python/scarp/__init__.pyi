# SPDX-License-Identifier: MIT
from typing import Any, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float32]
Numbers = Sequence[float]
Out = Union[Array, Mapping[str, NDArray[Any]], "Samples", None]
Names = Union[List[str], Tuple[str, ...]]
Operand = Union["Samples", float]

__version__: str
VERSION_OF_LIBRARY: str
BASES: Tuple[str, ...]
FADES: Tuple[str, ...]
FRACTALS: Tuple[str, ...]
__all__: List[str]

class LibraryError(ImportError): ...

class ScarpError(ValueError):
    text: str
    member: Optional[str]
    status: str
    def __init__(self, text: str, member: Optional[str] = ..., status: str = ...) -> None: ...

class Place(NamedTuple):
    line: int
    column: int
    text: str
    member: Optional[str]
    nearest: float

class RecipeError(ScarpError):
    errors: List[Place]
    line: int
    column: int
    nearest: float
    def __init__(self, errors: Sequence[Place], status: str = ...) -> None: ...

class Param(NamedTuple):
    value: float
    lowest: float
    highest: float

class Info(NamedTuple):
    cell: Tuple[float, float]
    jumps: bool
    axes: str
    order: int

class Samples:
    shape: Tuple[int, ...]
    extent: Optional[Tuple[float, ...]]
    def __init__(self, value: ArrayLike, extent: Optional[Tuple[float, ...]] = ...,
                 **derivatives: ArrayLike) -> None: ...
    @property
    def members(self) -> Tuple[str, ...]: ...
    # <samples> made by src/bindings/interface.py of include/scarp.h: do not change them by hand
    @property
    def value(self) -> Array: ...
    @property
    def dx(self) -> Array: ...
    @property
    def dy(self) -> Array: ...
    @property
    def dz(self) -> Array: ...
    @property
    def dxx(self) -> Array: ...
    @property
    def dxy(self) -> Array: ...
    @property
    def dxz(self) -> Array: ...
    @property
    def dyy(self) -> Array: ...
    @property
    def dyz(self) -> Array: ...
    @property
    def dzz(self) -> Array: ...
    @property
    def dphase(self) -> Array: ...
    # </samples>
    def normals(self, height_scale: float = ...) -> Array: ...
    def constant(self, value: float) -> Samples: ...
    def __neg__(self) -> Samples: ...
    def __pos__(self) -> Samples: ...
    def __abs__(self) -> Samples: ...
    def __add__(self, other: Operand) -> Samples: ...
    def __radd__(self, other: float) -> Samples: ...
    def __sub__(self, other: Operand) -> Samples: ...
    def __rsub__(self, other: float) -> Samples: ...
    def __mul__(self, other: Operand) -> Samples: ...
    def __rmul__(self, other: float) -> Samples: ...
    def __truediv__(self, other: Operand) -> Samples: ...
    def __rtruediv__(self, other: float) -> Samples: ...
    # <chain> made by src/bindings/interface.py of include/scarp.h: do not change them by hand
    def affine(self, scale: float, offset: float = ...) -> Samples: ...
    def mix(self, other: Operand, mask: Operand) -> Samples: ...
    def min(self, other: Operand) -> Samples: ...
    def max(self, other: Operand) -> Samples: ...
    def smooth_min(self, other: Operand, k: float) -> Samples: ...
    def smooth_max(self, other: Operand, k: float) -> Samples: ...
    def clamp(self, lo: float, hi: float) -> Samples: ...
    def smooth_abs(self, round: float) -> Samples: ...
    def smoothstep(self, lo: float, hi: float) -> Samples: ...
    def terrace(self, steps: float, riser: float = ..., strength: float = ...) -> Samples: ...
    def sqrt(self) -> Samples: ...
    def sine(self) -> Samples: ...
    def pulse(self) -> Samples: ...
    # </chain>
    def curve(self, x: ArrayLike, value: ArrayLike) -> Samples: ...
    def slope(self) -> Samples: ...
    def apply(self, f: ArrayLike, fa: Optional[ArrayLike] = ...,
              faa: Optional[ArrayLike] = ...) -> Samples: ...
    def apply2(self, other: Operand, f: ArrayLike, fa: Optional[ArrayLike] = ...,
               fb: Optional[ArrayLike] = ..., faa: Optional[ArrayLike] = ...,
               fab: Optional[ArrayLike] = ..., fbb: Optional[ArrayLike] = ...) -> Samples: ...

class Cells:
    shape: Tuple[int, ...]
    members: Tuple[str, ...]
    # <cells> made by src/bindings/interface.py of include/scarp.h: do not change them by hand
    f1: Array
    f2: Array
    id: NDArray[np.uint32]
    x: Array
    y: Array
    z: Array
    dx1: Array
    dy1: Array
    dz1: Array
    dx2: Array
    dy2: Array
    dz2: Array
    # </cells>

class Flow:
    shape: Tuple[int, ...]
    members: Tuple[str, ...]
    # <flow> made by src/bindings/interface.py of include/scarp.h: do not change them by hand
    vx: Array
    vy: Array
    vz: Array
    vxx: Array
    vxy: Array
    vxz: Array
    vyx: Array
    vyy: Array
    vyz: Array
    vzx: Array
    vzy: Array
    vzz: Array
    # </flow>

class Noise:
    basis: str
    fractal: str
    fade: str
    seed: int
    frequency: float
    octaves: float
    lacunarity: float
    gain: float
    amplitude: float
    rotate: bool
    erosion: float
    sharpness: Optional[float]
    jitter: float
    phase: float
    period: Optional[Tuple[int, ...]]
    of_octaves: Optional[float]
    warp: Optional[Noise]
    offset_first: bool
    def __init__(self, basis: Union[str, int, None] = ..., fractal: Union[str, int, None] = ...,
                 *, fade: Union[str, int, None] = ..., rotate: Optional[bool] = ...,
                 seed: Optional[int] = ..., frequency: Optional[float] = ...,
                 octaves: Optional[float] = ..., lacunarity: Optional[float] = ...,
                 gain: Optional[float] = ..., amplitude: Optional[float] = ...,
                 erosion: Optional[float] = ..., phase: Optional[float] = ...,
                 jitter: Optional[float] = ..., sharpness: Optional[float] = ...,
                 period: Optional[Sequence[int]] = ..., of_octaves: Optional[float] = ...,
                 warp: Optional[Noise] = ...,
                 offset_first: Optional[bool] = ...) -> None: ...
    def replace(self, **changes: Any) -> Noise: ...
    def range(self, dimensions: int = ...) -> Tuple[float, float]: ...
    def grid(self, shape: Sequence[int], step: Union[float, Numbers] = ...,
             origin: Optional[Numbers] = ..., first: Optional[Sequence[int]] = ..., *,
             derivatives: int = ..., dphase: bool = ..., out: Out = ...,
             threads: int = ...) -> Samples: ...
    def at(self, x: ArrayLike, y: ArrayLike, z: Optional[ArrayLike] = ..., *,
           derivatives: int = ..., dphase: bool = ..., out: Out = ...,
           threads: int = ...) -> Samples: ...
    def vector(self, x: ArrayLike, y: ArrayLike, z: Optional[ArrayLike] = ..., *,
               derivatives: int = ..., threads: int = ...) -> Tuple[Samples, ...]: ...
    def cells(self, x: ArrayLike, y: ArrayLike, z: Optional[ArrayLike] = ..., *,
              derivatives: int = ..., out: Out = ..., threads: int = ...) -> Cells: ...
    def curl(self, x: ArrayLike, y: ArrayLike, z: Optional[ArrayLike] = ..., *,
             derivatives: int = ..., out: Out = ..., threads: int = ...) -> Flow: ...

class Gullies:
    def __init__(self, *, seed: int = ..., rotate: bool = ...,
                 period: Optional[Sequence[int]] = ..., frequency: Optional[float] = ...,
                 amplitude: Optional[float] = ..., octaves: Optional[float] = ...,
                 of_octaves: Optional[float] = ..., lacunarity: Optional[float] = ...,
                 gain: Optional[float] = ..., depth: Optional[float] = ...,
                 cells: Optional[float] = ..., slope: Optional[float] = ...,
                 slope_low: Optional[float] = ..., low: Optional[float] = ...,
                 high: Optional[float] = ..., floor: Optional[float] = ...,
                 stripes: Optional[float] = ..., branch: Optional[float] = ...,
                 round: Optional[float] = ..., keep: Optional[float] = ...,
                 offset_first: bool = ...) -> None: ...
    def range(self, base_range: Tuple[float, float]) -> Tuple[float, float]: ...
    def at(self, base: Samples, x: ArrayLike, y: ArrayLike, *, derivatives: int = ...,
           threads: int = ...) -> Tuple[Samples, Samples]: ...
    def grid(self, base: Samples, step: Union[float, Numbers] = ...,
             origin: Optional[Numbers] = ..., first: Optional[Sequence[int]] = ..., *,
             derivatives: int = ..., threads: int = ...) -> Tuple[Samples, Samples]: ...

class Recipe:
    seed: int
    finest: float
    @property
    def dimensions(self) -> int: ...
    @property
    def text(self) -> str: ...
    @property
    def outputs(self) -> Tuple[str, ...]: ...
    @property
    def params(self) -> Dict[str, Param]: ...
    def __init__(self, text: str, seed: int = ..., finest: float = ...,
                 **params: float) -> None: ...
    def __getattr__(self, name: str) -> float: ...
    def __setattr__(self, name: str, value: float) -> None: ...
    def set(self, name: str, value: float) -> None: ...
    def tile(self, x: float, y: float, z: float = ...) -> None: ...
    def scale(self, by: float, heights: float = ...) -> None: ...
    def info(self, output: Optional[str] = ...) -> Info: ...
    @overload
    def grid(self, shape: Sequence[int], step: Union[float, Numbers] = ...,
             origin: Optional[Numbers] = ..., first: Optional[Sequence[int]] = ..., *,
             derivatives: int = ..., output: Optional[str] = ..., out: Out = ...,
             threads: int = ...) -> Samples: ...
    @overload
    def grid(self, shape: Sequence[int], step: Union[float, Numbers] = ...,
             origin: Optional[Numbers] = ..., first: Optional[Sequence[int]] = ..., *,
             derivatives: int = ..., output: Names, out: Optional[Sequence[Out]] = ...,
             threads: int = ...) -> Tuple[Samples, ...]: ...
    @overload
    def at(self, x: ArrayLike, y: ArrayLike, z: Optional[ArrayLike] = ..., *,
           derivatives: int = ..., output: Optional[str] = ..., out: Out = ...,
           threads: int = ...) -> Samples: ...
    @overload
    def at(self, x: ArrayLike, y: ArrayLike, z: Optional[ArrayLike] = ..., *,
           derivatives: int = ..., output: Names, out: Optional[Sequence[Out]] = ...,
           threads: int = ...) -> Tuple[Samples, ...]: ...
    def range(self, output: Optional[str] = ...,
              box: Optional[Tuple[Numbers, Numbers]] = ...) -> Tuple[float, float]: ...

def preset(name: str, seed: int = ..., finest: float = ..., **params: float) -> Recipe: ...
def presets() -> Tuple[str, ...]: ...
def isa() -> str: ...
def isas() -> Tuple[str, ...]: ...
def select_isa(name: Optional[str] = ...) -> None: ...
