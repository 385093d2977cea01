# SPDX-License-Identifier: GPL-3.0-or-later
"""Cells and their data in VTK's terms, as they are collected from the meshes of other libraries."""
from __future__ import annotations

from typing import Any, Iterable

import numpy as np

from . import _core
from ._arrays import InputError, index_array
from ._documents import Document

POLYGON, TETRAHEDRON, WEDGE, POLYHEDRON, UNKNOWN = 7, 10, 13, 42, 255  #: VTK's numbers of types
# fmt: off
_VTK_NUMBERS = {
    "f8": "Float64", "f4": "Float32", "f2": "Float32", "i8": "Int64", "u8": "UInt64", "i4": "Int32",
    "u4": "UInt32", "i2": "Int16", "u2": "UInt16", "i1": "Int8", "u1": "UInt8", "b1": "UInt8",
}
# fmt: on


class Cells:
    """Cells and data in VTK's terms, collected block by block."""

    def __init__(self) -> None:
        self.points = np.empty((0, 3))
        self.connectivity: list[np.ndarray] = []
        self.sizes: list[np.ndarray] = []
        self.types: list[np.ndarray] = []
        self.faces: list[int] = []
        self.face_ends: list[np.ndarray] = []
        self.point_data: list[tuple[str, str, Any]] = []
        self.cell_data: list[tuple[str, str, Any]] = []
        self.fields: list[tuple[str, str, Any]] = []
        self.dropped: list[_core.Loss] = []

    def add(self, number: int, nodes: np.ndarray) -> None:
        """Cells of one type, a row of nodes each."""
        count, each = nodes.shape
        self.add_mixed(np.broadcast_to(number, count), nodes.ravel(), np.broadcast_to(each, count))

    def add_mixed(self, types: np.ndarray, connectivity: np.ndarray, sizes: np.ndarray) -> None:
        self.types.append(types)
        self.connectivity.append(connectivity)
        self.sizes.append(sizes)
        self.face_ends.append(np.broadcast_to(-1, len(types)))

    def add_polyhedron(self, faces: Iterable[Iterable[int]]) -> None:
        """A polyhedron, given by the points of its faces."""
        lists = [[int(node) for node in face] for face in faces]
        nodes = list(dict.fromkeys(node for face in lists for node in face))
        self.add(POLYHEDRON, np.array([nodes], dtype=np.int64).reshape(1, -1))
        self.faces.append(len(lists))
        for face in lists:
            self.faces += [len(face), *face]
        self.face_ends[-1] = np.array([len(self.faces)])

    def add_data(self, kind: str, name: str, values: Any, items: int | None) -> None:
        """An array of points, cells or neither; what is no table of numbers or texts is listed as dropped."""
        array = np.asarray(values)
        known = _VTK_NUMBERS.get(array.dtype.str[1:])
        to = {"points": self.point_data, "cells": self.cell_data, "neither": self.fields}[kind]
        if array.ndim == 0:
            array = array.reshape(1)
        if array.ndim > 2:
            array = array.reshape(len(array), -1)
        if items is not None and len(array) != items:
            raise InputError(f"data '{name}' of {kind}: expected {items} rows, found {len(array)}")
        if known:
            to.append((str(name), known, array.astype(np.float32) if array.dtype.str[1:] == "f2" else array))
        elif array.dtype.kind in "US" and array.ndim == 1:
            to.append((str(name), "String", [str(text) for text in array]))
        elif array.dtype.kind == "O" and array.ndim == 1 and all(isinstance(text, str) for text in array):
            to.append((str(name), "String", list(array)))
        else:
            self.drop(f"data of {kind} that are neither numbers nor texts", 1, f"'{name}', {array.dtype}")

    def drop(self, item: str, count: int, example: str, elements: bool = False) -> None:
        if count:
            self.dropped.append(_core.Loss(item, count, example, elements))

    def count(self) -> int:
        return sum(map(len, self.types))

    def only_tetrahedra(self) -> np.ndarray | None:
        """The corners, if there are only tetrahedra of four nodes, and no data that might be their groups."""
        if self.dropped or any(_core.may_be_tag_name(name.encode()) for name, _, _ in self.cell_data):
            return None
        if any((types != TETRAHEDRON).any() for types in self.types):
            return None
        if any((sizes != 4).any() for sizes in self.sizes):  # a contradiction: the document tells which
            return None
        parts = [connectivity.reshape(-1, 4) for connectivity in self.connectivity]
        tets = parts[0] if len(parts) == 1 else np.concatenate([np.empty((0, 4), dtype=np.int32), *parts])
        return index_array(tets, 4, "cells")

    def document(self, name: str) -> Document:
        def joined(parts: list[np.ndarray]) -> np.ndarray:
            return np.concatenate(parts).astype(np.int64, copy=False) if parts else none

        none = np.empty(0, dtype=np.int64)
        return Document(_core.document_of_cells(
            name.encode(), self.points, joined(self.connectivity), np.cumsum(joined(self.sizes)),
            joined(self.types), np.array(self.faces, dtype=np.int64),
            joined(self.face_ends) if self.faces else none, self.point_data, self.cell_data, self.fields,
            self.dropped))
