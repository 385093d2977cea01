# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed surfaces, generated, random or from elsewhere; and the reference's grids of them."""
from __future__ import annotations

from typing import Any, Iterable, Iterator, NamedTuple, Sequence

import numpy as np

from . import _core
from ._arrays import (
    InputError, file_name, index_array, is_path, point_array, real, whole, word, words)
from ._documents import _losses, _tell


class Surface:
    """A triangulated surface, which `points, triangles = surface` takes apart.

    It is judged when it is first needed, and only once: pass the same Surface to compare many meshes with it.
    """

    def __init__(self, core: _core.Surface) -> None:
        self._core = core

    @property
    def points(self) -> np.ndarray:
        """(n, 3) float64, coordinates [length]; a view that cannot be written to."""
        return self._core.points

    @property
    def triangles(self) -> np.ndarray:
        """(m, 3) int32, positions in `points`; of a closed surface anticlockwise seen from outside. A view.
        """
        return self._core.triangles

    @property
    def name(self) -> str:
        """The file, or the specification that `generate` and every program take: "fuzz:cylinder(n=3)"."""
        return self._core.name

    @property
    def fault(self) -> str:
        """Why it is no closed, manifold, oriented surface free of self-intersections; empty: it is one,
        proved."""
        return self._core.fault

    @property
    def notes(self) -> list[str]:
        """Remarks that are no faults, as on an inward orientation."""
        return self._core.notes

    @property
    def warnings(self) -> list[str]:
        """What is suspicious in its file."""
        return self._core.warnings

    @property
    def dropped(self) -> list[Any]:
        """What the reader of its file did not take: a list of `Loss`."""
        return _losses(self._core.dropped)

    def __iter__(self) -> Iterator[np.ndarray]:
        return iter((self.points, self.triangles))

    def __repr__(self) -> str:
        return f"<tetproof.Surface {self.name}: {len(self.points)} points, {len(self.triangles)} triangles>"


class Grid(NamedTuple):
    """A grid of tetrahedra, to which `verify`, `write` and `compare` can be applied."""

    points: np.ndarray  #: (n, 3) float64, coordinates [length]
    tets: np.ndarray  #: (m, 4) int32, positions in `points`; positive: (b-a) x (c-a) . (d-a) > 0


def as_surface(surface: Any, format: str | None = None) -> Surface:
    """The surface of arrays (points, triangles), of a file, of a specification such as "torus:R=1,r=0.4", of
    a Document, or of a mesh of another library (see `as_document`): its faces, larger ones cut to triangles.
    """
    from ._meshes import as_document

    if isinstance(surface, Surface):
        return surface
    if is_path(surface):
        opened = Surface(_core.open_surface(file_name(surface), format or ""))
        _tell(opened)
        return opened
    if isinstance(surface, (tuple, list)) and len(surface) == 2:
        points, triangles = surface
    elif not hasattr(surface, "points") and hasattr(surface, "vertices") and hasattr(surface, "faces"):
        points, triangles = surface.vertices, surface.faces
    else:
        made = Surface(_core.Surface(as_document(surface)._core, b"surface"))
        _tell(made)
        return made
    return Surface(_core.Surface(point_array(points, "surface: points"),
                                 index_array(triangles, 3, "surface: triangles"), b"surface"))


def generate(spec: str) -> Surface:
    """A closed surface by name: "sphere:r=1,n=5000", "fuzz:seed=7,case=12"; `list_surfaces()` tells them all.

    It is closed, 2-manifold, oriented outward and free of self-intersections, and has the same bytes
    everywhere.
    """
    if not _core.is_generated(file_name(spec)):
        raise InputError(f"{spec}: no such generated surface: list_surfaces() tells those that there are")
    return Surface(_core.open_surface(file_name(spec), ""))


def fuzz(seed: int, index: int, *, kinds: Iterable[str] = (), modifiers: Iterable[str] = (),
         most_triangles: int = 2000, extreme_sizes: bool = False) -> Surface:
    """Case `index` of `seed`: a random surface that is hard for meshers, and proved to be valid.

    It depends on these and the options alone. `kinds`: only these kinds; `modifiers`: only these, "none" for
    none. `extreme_sizes`: also sizes of 1e-60 and 1e60. Its `name` is "fuzz:RECIPE".
    """
    for name, number in (("seed", seed), ("index", index)):
        if not isinstance(number, (int, np.integer)) or not 0 <= number < 2**64:
            raise InputError(f"{name}: expected a number from 0 to 2^64 - 1, found {number!r}")
    most = whole("most_triangles", most_triangles)
    if not 0 < most < 2**31:
        raise InputError(f"most_triangles: expected a number from 1 on, found {most}")
    return Surface(_core.fuzz_surface(int(seed), int(index), kinds=words(kinds), modifiers=words(modifiers),
                                      most_triangles=most, extreme_sizes=extreme_sizes))


def list_surfaces() -> str:
    """The generated surfaces with their parameters, and the kinds of random ones: a text."""
    return _core.list_surfaces()


def mesh(surface: Any, cells: int | Sequence[int] | None = None, region: str = "inside",
         points: int | str = 0, *, engine: str = "fast", box_scale: float = 1.2, on_surface: float = 1e-6,
         diagonals: str = "lowest", literal: bool = False, parametric: bool = True, v0: float | str = 0.2,
         v1: float | str = 2.0, d1: float = 0.0, p: float = 1.0, e_avg: float | str = 0.0,
         past_dilution: bool = False, curvature: bool = False, improve: str = "solid-angle",
         improve_below: float = 0.002) -> Grid:
    """The grid that `tetproof-mesh` makes of a closed surface, by the method of Hamann, Chen and Hong (1994).

    surface  whatever `as_surface` takes
    cells    of the lattice, along the longest side or along x, y and z; None: 24, or twice as many up to 192
             until the grid of a thin surface is not empty
    region   "inside", or "outside" up to the scaled box
    points   the largest number of points to insert; 0: the first grid only; "auto": until no split lowers
             E_avg (the program's default)

    The others are the options of the program, with its names and defaults; "abs:0.001" is a volume [length^3]
    for `v0`, `v1` and `e_avg`. The grid is not judged here. InputError for a surface that is not closed, for
    options out of range, and if the grid would be empty.
    """
    numbers = (24,) if cells is None else (cells,) if isinstance(cells, (int, np.integer)) else tuple(cells)
    are_counts = all(isinstance(n, (int, np.integer)) and 0 < n < 10**8 for n in numbers)
    if len(numbers) not in (1, 3) or not are_counts:
        raise InputError(f"cells: expected a positive number or three, found {cells!r}")
    if not (points == "auto" or isinstance(points, (int, np.integer)) and 0 <= points < 2**63):
        raise InputError(f"points: expected a number from 0 or 'auto', found {points!r}")
    made = _core.mesh(as_surface(surface)._core, cells=[*map(int, numbers), 0, 0][:3],
                      raise_cells=cells is None, region=word("region", region),
                      points=-1 if points == "auto" else int(points), engine=word("engine", engine),
                      box_scale=real("box_scale", box_scale), on_surface=real("on_surface", on_surface),
                      diagonals=word("diagonals", diagonals), literal=literal, parametric=parametric,
                      v0=_volume(v0, "v0"), v1=_volume(v1, "v1"), d1=real("d1", d1), p=real("p", p),
                      e_avg=_volume(e_avg, "e_avg"), past_dilution=past_dilution, curvature=curvature,
                      improve=word("improve", improve), improve_below=real("improve_below", improve_below))
    return Grid(*made)


def _volume(value: float | str, name: str) -> tuple[float, bool]:
    """A volume, and whether it is absolute."""
    absolute = isinstance(value, str) and value.startswith("abs:")
    try:
        return float(value[4:] if absolute else value), absolute  # type: ignore[index]
    except (TypeError, ValueError):
        raise InputError(f"{name}: expected a number, or 'abs:0.001', found {value!r}") from None
