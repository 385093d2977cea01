# SPDX-License-Identifier: GPL-3.0-or-later
"""meshio's meshes from documents."""
from __future__ import annotations

from typing import Any

import numpy as np

from . import _core
from ._cells import POLYHEDRON, WEDGE
from ._documents import Document, Loss, LossWarning, _losses, warn
from ._meshes import MESHIO, WEDGE_ORDER


def meshio_cells(cells: dict[str, Any]) -> tuple[list[tuple[str, Any]], list[np.ndarray]]:
    """Cells in VTK's terms as meshio's blocks; and the positions of the cells of each block."""
    types, ends, connectivity = cells["types"], cells["ends"], cells["connectivity"]
    starts = np.concatenate([[0], ends[:-1]]) if len(ends) else ends
    sizes = ends - starts
    breaks = np.flatnonzero((types[1:] != types[:-1]) | (sizes[1:] != sizes[:-1])) + 1
    blocks: list[tuple[str, Any]] = []
    places: list[np.ndarray] = []
    face_starts = np.maximum.accumulate(np.concatenate([[0], cells["face_ends"]]))
    for first, last in zip([0, *breaks], [*breaks, len(types)]):
        if first == last:
            continue
        number, size = int(types[first]), int(sizes[first])
        places.append(np.arange(first, last))
        if number == POLYHEDRON:
            faces = [_faces(cells["faces"], int(face_starts[c])) for c in range(first, last)]
            blocks.append((f"polyhedron{size}", faces))
            continue
        nodes = connectivity[starts[first]:ends[last - 1]].reshape(-1, size)
        blocks.append((MESHIO[number], nodes[:, WEDGE_ORDER] if number == WEDGE else nodes))
    return blocks, places


def _faces(stream: np.ndarray, at: int) -> list[np.ndarray]:
    faces = []
    count, at = int(stream[at]), at + 1
    for _ in range(count):
        size = int(stream[at])
        faces.append(stream[at + 1:at + 1 + size])
        at += 1 + size
    return faces


def _is_known(meshio: Any, block: tuple[str, Any]) -> bool:
    try:
        meshio.CellBlock(*block)
        return True
    except KeyError:  # it looks up the type's dimension
        return False


def to_meshio(document: Document) -> Any:
    import meshio

    cells = _core.cells_of_document(document._core)
    blocks, places = meshio_cells(cells)
    known = [_is_known(meshio, block) for block in blocks]
    unknown = [Loss("elements of a type that this meshio does not have", len(block[1]), block[0], True)
               for block, is_known in zip(blocks, known) if not is_known]
    blocks = [block for block, is_known in zip(blocks, known) if is_known]
    places = [place for place, is_known in zip(places, known) if is_known]
    for loss in [*document.losses(".vtu"), *_losses(cells["lost"]), *unknown]:
        warn(f"lost: {loss}", LossWarning)

    def arrays(kind: str) -> list[tuple[str, np.ndarray]]:
        return [(name, np.asarray(values)) for name, values in cells[kind]]

    return meshio.Mesh(
        np.array(document.points), blocks, point_data=dict(arrays("point_data")),
        cell_data={name: [values[place] for place in places] for name, values in arrays("cell_data")},
        field_data=dict(arrays("field_data")))
