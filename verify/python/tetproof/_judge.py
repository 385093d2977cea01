# SPDX-License-Identifier: GPL-3.0-or-later
"""Judging meshes, and comparing grids and traces."""
from __future__ import annotations

import json
import math
import os
from typing import Any, Iterable, NoReturn

import numpy as np

from . import _core
from ._arrays import (
    InputError, file_name, index_array, integer_array, is_path, point_array, real, whole, words)
from ._documents import Document, _tell, read
from ._meshes import as_document, judged
from ._report import Report
from ._surfaces import as_surface


def verify(mesh: Any = None, tets: Any = None, surface: Any = None, *, points: Any = None,
           region: str | None = None, fidelity: float = 1e-3, regions: Any = None,
           check: str | Iterable[str] = (), skip: str | Iterable[str] = (), allow: str | Iterable[str] = (),
           strict_topology: bool = False, voxels: int = 128, only_tets: bool = False, quality: bool = True,
           decide_only: bool = False, timings: bool = False, timeout: float | None = None,
           threads: int | None = None, format: str | None = None,
           surface_format: str | None = None) -> Report:
    """Judges a tetrahedral mesh exactly as it is: `verify(points, tets, surface)` or `verify(mesh, surface)`.

    points       (n, 3) real numbers, coordinates [length]
    tets         (m, 4) integers, positions in the points from 0; positive: (b-a) x (c-a) . (d-a) > 0
    mesh         a Document, the path of a file, a pair (points, tets), or a mesh of meshio, PyVista or VTK,
                 whose elements that are no tetrahedra are named as not judged
    surface      what the mesh should fill: (points, triangles), a Surface, a path, "sphere:r=1", a mesh
    region       the part of space to be filled: "inside" (if there is a surface), "outside" or "none"
    fidelity     allowed distance from the surface, in diagonals of its box; 0: the surface exactly
    regions      (m,) integers, the region of each tetrahedron; None: by the groups of a Document
    check, skip  ids of the only checks, and of checks that are not made; `list_checks()` tells them
    allow        ids of checks whose findings are meant: "crack", "non-conforming-interface"
    strict_topology  findings of topology, cavities, non-manifold edges and vertices fail instead of warn
    voxels       along the longest side, for the independent account of volume, 0 to 1024; 0: without
    only_tets    judge the tetrahedra alone
    quality      measure angles and aspect ratios
    decide_only  compare distances with the allowed one, and do not measure them
    timings      seconds of each phase, in the report
    timeout      seconds after which to give up with TimeoutError
    threads      the most threads; None: all cores
    format, surface_format  of files, where content and ending do not tell

    Arrays are taken as they are: NaN, and indices that no point has, are findings. A mesh without tetrahedra
    is never sound. InputError for arrays of another shape or kind, an unusable surface, and options out of
    range. Any number of threads may call it at once. Ctrl-C takes effect when the verdict is there.
    """
    to_judge, surface = _mesh_of(mesh, tets, points, surface, format)
    if regions is not None:
        of_tet = integer_array(regions, "regions")
        if of_tet.shape != (len(to_judge.tets),):
            raise InputError(f"regions: expected the shape ({len(to_judge.tets)},), found {of_tet.shape}")
        to_judge.set_regions(of_tet.astype(np.int64))
    if region is None:
        region = "none" if surface is None else "inside"
    if region not in ("inside", "outside", "none"):
        raise InputError(f"region: expected 'inside', 'outside' or 'none', found {region!r}")
    if surface is None and region != "none":
        raise InputError(f"region {region} needs a surface")
    if not real("fidelity", fidelity) >= 0 or math.isinf(fidelity):
        raise InputError(f"fidelity: expected a number from 0 on, found {fidelity}")
    if not 0 <= whole("voxels", voxels) <= 1024:
        raise InputError(f"voxels: expected a number from 0 to 1024, found {voxels}")
    if timeout is not None and not 0 <= real("timeout", timeout) < 1e9:
        raise InputError(f"timeout: expected seconds from 0 to 1e9, found {timeout}")
    if threads is not None and whole("threads", threads) < 1:
        raise InputError(f"threads: expected a number from 1 on, found {threads}")
    against = None if surface is None else as_surface(surface, surface_format)._core
    return Report(_core.verify(
        to_judge, against, region=region, fidelity=fidelity, strict_topology=strict_topology,
        voxels=whole("voxels", voxels), check=words(check), skip=words(skip), allow=words(allow), only_tets=only_tets,
        quality=quality, decide_only=decide_only, timings=timings, timeout=timeout, threads=min(threads or 0, 2**31 - 1)))


def list_checks() -> str:
    """The id of every check, what it proves, its accuracy and its severity: a text."""
    return _core.list_checks()


class Comparison:
    """The comparison of two grids or two traces. `str()` is the result for people.

    It can be equal, different or undecided, so it is neither true nor false: ask for `.equal`.
    """

    def __init__(self, text: str, as_json: str) -> None:
        self._text, self._json = text, as_json

    @property
    def verdict(self) -> str:
        """Of grids "equal", "diverges" or "incomplete"; of traces "equal", "tie", "diverges" or "unresolved".
        """
        return self.to_dict()["verdict"]

    @property
    def equal(self) -> bool:
        """They are equal, or equal but for proven ties, and all was compared."""
        found = self.to_dict()
        return found["verdict"] in ("equal", "tie") and not found.get("not_compared")

    def to_dict(self) -> dict[str, Any]:
        """What `tetproof-compare --json` writes; corpus/vectors/TRACE.md has the keys."""
        return json.loads(self._json)

    def to_json(self) -> str:
        """The text that `tetproof-compare --json` writes."""
        return self._json

    def __str__(self) -> str:
        return self._text

    def __repr__(self) -> str:
        return f"<tetproof.Comparison {self.verdict}>"

    def __bool__(self) -> NoReturn:
        raise TypeError("a comparison may be undecided, so it is neither true nor false: ask for .equal")


def compare(other: Any, reference: Any, *, tolerance: float = 1e-9,
            surface: str | os.PathLike[str] | None = None) -> Comparison:
    """Compares two traces decision by decision, or two grids up to numbering, as `tetproof-compare` does.

    Traces are paths of .jsonl files; `surface` is the surface of both, if not the one that they name. Grids
    are whatever `as_document` takes. `tolerance`: points that are closer than this, 0 to 0.1, in diagonals of
    the reference's box, are the same; 0: equal to the last bit.
    """
    if not 0 <= tolerance <= 0.1:
        raise InputError(f"tolerance: expected a number from 0 to 0.1, found {tolerance}")
    traces = [is_path(one) and _core.is_trace(file_name(one)) for one in (other, reference)]
    if all(traces):
        return Comparison(*_core.compare_traces(file_name(other), file_name(reference), tolerance,
                                                file_name(surface) if surface is not None else b""))
    if any(traces):
        raise InputError("one of them is a trace, and the other is not: two traces or two grids are compared")
    roles = ((other, b"other"), (reference, b"reference"))
    names = [file_name(thing) if is_path(thing) else role for thing, role in roles]
    return Comparison(*_core.compare_grids(_document_of(other)._core, names[0], _document_of(reference)._core,
                                           names[1], tolerance))


def _mesh_of(mesh: Any, tets: Any, points: Any, surface: Any, format: str | None) -> tuple[_core.Mesh, Any]:
    """The mesh that is meant, and the surface."""
    if points is not None:
        if mesh is not None:
            raise InputError("a mesh or points: both are given")
        mesh = points
    if mesh is None:
        raise InputError("expected a mesh, or points and tets")
    if isinstance(mesh, tuple) and len(mesh) == 2 and (tets is None or np.ndim(mesh[0]) == 2):
        (mesh, own), given = mesh, tets
        surface = _one_surface(given, surface)
        return _core.Mesh(point_array(mesh), index_array(own, 4, "tets")), surface
    if isinstance(mesh, (np.ndarray, list, tuple)) or not _is_mesh(mesh) and hasattr(mesh, "__array__"):
        if tets is None:
            raise InputError("expected tets beside points")
        return _core.Mesh(point_array(mesh), index_array(tets, 4, "tets")), surface
    made = _core.Mesh(_document_of(mesh, format)._core) if is_path(mesh) else judged(mesh)
    return made, _one_surface(tets, surface)


def _one_surface(second: Any, surface: Any) -> Any:
    """The surface of verify(mesh, surface), whichever argument it came as."""
    if second is not None and surface is not None:
        raise InputError("a mesh has its own tetrahedra: expected verify(mesh, surface)")
    return surface if second is None else second


def _is_mesh(thing: Any) -> bool:
    return isinstance(thing, Document) or is_path(thing) or hasattr(thing, "points")


def _document_of(mesh: Any, format: str | None = None) -> Document:
    if not is_path(mesh):
        return as_document(mesh)
    document = read(mesh, format)
    _tell(document)
    return document
