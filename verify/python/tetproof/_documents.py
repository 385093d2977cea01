# SPDX-License-Identifier: GPL-3.0-or-later
"""Documents: the content of mesh files of every format. Reading, writing, converting."""
from __future__ import annotations

import dataclasses
import inspect
import os
import warnings
from typing import Any, NamedTuple

import numpy as np

from . import _core
from ._arrays import InputError, file_name, index_array, is_path, point_array


@dataclasses.dataclass(frozen=True)
class Loss:
    """An item that a file has and its document has not, or the other way round."""

    item: str  #: the kind of thing
    count: int  #: how many of it
    example: str  #: the first of them
    elements: bool = False  #: elements that the mesh then lacks

    def __str__(self) -> str:
        return f"{self.item}: {self.count} ({self.example})"


class Block(NamedTuple):
    """A run of elements of one type in one entity, as the file has them."""

    type: int  #: Gmsh's number of the type, or one above 1000 that Gmsh does not have
    name: str  #: "tetrahedra", "triangles", ...
    dim: int
    #: (n, k) positions in the points, in Gmsh's order; -1-j: `Document.unknown[j]`, which none has
    nodes: np.ndarray
    entity: int  #: its tag; 0: none
    groups: tuple[int, ...]  #: physical groups


class FileWarning(UserWarning):
    """Something legal but suspicious in a file, or something that its reader did not take."""


class LossWarning(UserWarning):
    """Something that another program will not see, or misreads, in what is written."""


class LossError(Exception):
    """A strict conversion would lose something; nothing was written. `losses`: what."""

    def __init__(self, message: str, losses: Losses) -> None:
        super().__init__(message)
        self.losses = losses


class Losses(list):  # of Loss
    """What the format cannot hold of a document: a list of `Loss`, empty if nothing is lost.

    Further lists of `Loss`: `kept_aside`, what only tetproof reads back, from `kept_in`; `dangling`, elements
    that name points which do not exist; `dropped`, what the reader of the source did not take.
    """

    def __init__(self, done: _core.Writing, dropped: list[Loss]) -> None:
        super().__init__(_losses(done.losses))
        self.kept_aside = _losses(done.kept_aside)
        self.kept_in: str = done.kept_in
        self.dangling = _losses(done.dangling)
        self.dropped = dropped
        self.files: list[str] = done.files  #: the paths of all files of the format's set


class Document:
    """The content of a mesh file: points, elements of every type, groups and their names, values.

    `read` makes it of a file, `as_document` of arrays and of meshio's, PyVista's and VTK's meshes. It cannot
    be changed. `write` writes it in any format, `verify` judges its tetrahedra, `to_meshio` gives its values.
    """

    def __init__(self, core: _core.Document) -> None:
        self._core = core

    @property
    def points(self) -> np.ndarray:
        """(n, 3) float64, coordinates [length]; a view that cannot be written to."""
        return self._core.points

    @property
    def blocks(self) -> list[Block]:
        """The elements in the file's order, as views that cannot be written to."""
        return [Block(*block[:5], tuple(block[5])) for block in self._core.blocks]

    @property
    def cells(self) -> list[tuple[str, np.ndarray]]:
        """The elements by meshio's names of types and in its order of nodes, as ("tetra", (n, 4)) pairs."""
        from ._to_meshio import meshio_cells

        return meshio_cells(_core.cells_of_document(self._core))[0]

    @property
    def tets(self) -> np.ndarray:
        """(n, 4) positions in `judged_points`: the corners of all tetrahedra, as `verify` judges them."""
        return _core.Mesh(self._core).tets

    @property
    def judged_points(self) -> np.ndarray:
        """The points that `verify` judges: without nodes on edges, on faces and inside of curved elements."""
        return _core.Mesh(self._core).points

    @property
    def point_numbers(self) -> np.ndarray:
        """The file's number of each point."""
        return self._core.point_numbers

    @property
    def element_numbers(self) -> np.ndarray:
        """The file's number of each element, block by block."""
        return self._core.element_numbers

    @property
    def unknown(self) -> list[int]:
        """Numbers that elements name and no point has."""
        return self._core.unknown

    @property
    def group_names(self) -> dict[tuple[int, int], str]:
        """The names of physical groups, by dimension and number."""
        return self._core.group_names

    @property
    def path(self) -> str:
        """The file; empty for none."""
        return self._core.path

    @property
    def format(self) -> str:
        """The file's format: "msh41", "tetgen", ...; empty for none."""
        return self._core.format

    @property
    def title(self) -> str:
        """What the file calls itself, in formats that have such a line."""
        return self._core.title

    @property
    def warnings(self) -> list[str]:
        """What is legal but suspicious in the file, each with its place."""
        return self._core.warnings

    @property
    def dropped(self) -> list[Loss]:
        """What the reader did not take."""
        return _losses(self._core.dropped)

    def losses(self, path: str | os.PathLike[str], *, format: str | None = None,
               binary: bool | None = None) -> Losses:
        """What a file would not hold, as `write` returns it; nothing is written. `path`: as ".stl" or
        "a.stl"."""
        name = os.fspath(path)
        path = "file" + name if name.startswith(".") else name
        return _write(path, self, format, binary, "lax", False, (), True)

    def to_meshio(self) -> Any:
        """A meshio.Mesh with what a .vtu file of this document has; the rest is told by a LossWarning.

        Groups are the cell data "gmsh:physical" and, by their names, the field data, as meshio has them of
        .msh.
        """
        from ._to_meshio import to_meshio

        return to_meshio(self)

    def __repr__(self) -> str:
        counts: dict[str, int] = {}
        for block in self._core.blocks:
            counts[block[1]] = counts.get(block[1], 0) + len(block[3])
        elements = "".join(f", {count} {name}" for name, count in counts.items())
        return f"<tetproof.Document {self.path or 'without a file'}: {len(self.points)} points{elements}>"


def read(path: str | os.PathLike[str], format: str | None = None) -> Document:
    """Reads a mesh or surface file of any format that `tetproof-convert` reads.

    Content and ending tell the format; `format` ("msh41", "tetgen", "vtu", "stl", ...) overrules them. What
    the reader did not take is in `.dropped`, what is suspicious in `.warnings`. InputError with the file's
    line or byte for what the format does not permit.
    """
    return Document(_core.read(file_name(path), format or ""))


def write(path: str | os.PathLike[str], mesh: Any, *, format: str | None = None, binary: bool | None = None,
          strict: bool = False, strict_native: bool = False) -> Losses:
    """Writes a mesh, whole or not at all, in the format of the path's ending or in `format`.

    `mesh`: a Document, or whatever `as_document` takes. `binary`: the form; None: the format's usual one.
    Returns what the format cannot hold. With `strict`, LossError if that is anything, elements that only
    tetproof reads back included; with `strict_native`, also for all else that other programs do not read.
    InputError if the place cannot be written or the format does not have this form.
    """
    from ._meshes import as_document

    strictness = "native" if strict_native else "strict" if strict else "lax"
    return _write(path, as_document(mesh), format, binary, strictness, False, (), False)


def convert(source: str | os.PathLike[str], target: str | os.PathLike[str], *, from_format: str | None = None,
            format: str | None = None, binary: bool | None = None, strict: bool = False,
            strict_native: bool = False) -> Losses:
    """Converts a file, as `tetproof-convert source target` does. Arguments and result: see `read`, `write`.

    A strict conversion may lose nothing in reading either. `source` can be a generated surface.
    """
    if is_path(source) and not from_format and _core.is_generated(file_name(source)):
        from ._surfaces import generate

        document = Document(_core.Document(*generate(os.fspath(source))))
    else:
        document = read(source, from_format)
        _tell(document)
    strictness = "native" if strict_native else "strict" if strict else "lax"
    return _write(target, document, format, binary, strictness, True, (source,), False)


def of_rows(points: Any, rows: Any) -> Document:
    """The document of tetrahedra, or of triangles, given as arrays."""
    columns = 3 if np.ndim(rows) == 2 and np.shape(rows)[1] == 3 else 4
    what = "triangles" if columns == 3 else "tets"
    return Document(_core.Document(point_array(points), index_array(rows, columns, what)))


def warn(text: str, category: type[Warning]) -> None:
    """Warns at the line that called this package."""
    level, frame = 1, inspect.currentframe()
    while frame and frame.f_globals.get("__name__", "").partition(".")[0] == __name__.partition(".")[0]:
        level, frame = level + 1, frame.f_back
    warnings.warn(text, category, stacklevel=level)


def _losses(losses: list[_core.Loss]) -> list[Loss]:
    return [Loss(loss.item, loss.count, loss.example, loss.elements) for loss in losses]


def _tell(source: Any) -> None:
    """Says what the reader of a file has to say, where no Document shows it."""
    for warning in source.warnings:
        warn(warning, FileWarning)
    for loss in _losses(source._core.dropped):
        warn(f"not read: {loss}", FileWarning)


def _write(path: Any, document: Document, format: str | None, binary: bool | None, strictness: str,
           with_reading: bool, sources: tuple[Any, ...], only_plan: bool) -> Losses:
    def do(plan: bool) -> _core.Writing:
        return _core.write(file_name(path), document._core, format=format or "", binary=binary,
                           strictness=strictness, with_reading=with_reading, only_plan=plan)

    for target in do(True).files if sources else ():
        for source in sources:
            if os.path.exists(source) and os.path.exists(target) and os.path.samefile(source, target):
                raise InputError(f"{target}: is read, and would be written")
    done = do(only_plan)
    losses = Losses(done, document.dropped if with_reading else [])
    if done.refusal:
        raise LossError(done.refusal, losses)
    if not only_plan:
        for loss in losses.dangling:
            warn(f"{os.fspath(path)}: {loss}: other programs may refuse the file", LossWarning)
        if done.warning:
            warn(done.warning, LossWarning)
    return losses
