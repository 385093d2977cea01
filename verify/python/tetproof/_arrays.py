# SPDX-License-Identifier: GPL-3.0-or-later
"""Brings a caller's arrays into the form that the extension takes, and refuses what cannot be judged exactly.
"""
from __future__ import annotations

import operator
import os
from typing import Any, Iterable, SupportsFloat

import numpy as np

from . import _core

InputError = _core.InputError


def point_array(points: Any, what: str = "points") -> np.ndarray:
    """The n x 3 table of float64 with the same numbers, in C's order: the caller's array where that is one.

    InputError for another shape or kind of numbers, and where float64 cannot hold a number exactly: a judge
    that rounds would judge another mesh.
    """
    table = _array(points, what)
    if table.ndim == 2 and table.size == 0 or table.shape == (0,):
        return np.empty((0, 3))
    if table.ndim != 2 or table.shape[1] != 3:
        raise InputError(f"{what}: expected the shape (n, 3), found {table.shape}")
    if table.dtype.kind not in "fiu":
        raise InputError(f"{what}: expected real numbers, found {table.dtype}")
    exact = np.ascontiguousarray(table, dtype=np.float64)
    if table.dtype.itemsize > 8 or table.dtype.kind in "iu" and table.dtype.itemsize == 8:
        wrong = (exact.astype(table.dtype) != table) & (table == table)
        if wrong.any():
            place = tuple(int(i) for i in np.argwhere(wrong)[0])
            raise InputError(f"{what}: {table[place]} at {place} is no float64; round it where you know why")
    return exact


def index_array(rows: Any, columns: int, what: str) -> np.ndarray:
    """The n x `columns` table of int32 or int64 with the same numbers, in C's order, from any array of
    integers."""
    table = _array(rows, what)
    if table.shape == (0,) or table.shape == (0, columns):
        return np.empty((0, columns), dtype=np.int32)
    if table.ndim != 2 or table.shape[1] != columns:
        raise InputError(f"{what}: expected the shape (n, {columns}), found {table.shape}")
    return integer_array(table, what)


def integer_array(values: Any, what: str) -> np.ndarray:
    """Integers of any shape as int32 or int64 in C's order."""
    table = _array(values, what)
    if table.dtype.kind not in "iu":
        raise InputError(f"{what}: expected integers, found {table.dtype}")
    is_wide = table.dtype.kind == "u" and table.dtype.itemsize == 8
    if is_wide and table.size and table.max() > np.iinfo(np.int64).max:
        raise InputError(f"{what}: {table.max()} is too large for a number of 64 bits with a sign")
    kind = np.int32 if np.can_cast(table.dtype, np.int32) else np.int64
    return np.ascontiguousarray(table, dtype=kind)


def file_name(path: str | os.PathLike[str]) -> bytes:
    """The bytes of a path, whatever its characters are."""
    return os.fsencode(path)


def is_path(thing: Any) -> bool:
    return isinstance(thing, (str, os.PathLike))


def _array(values: Any, what: str) -> np.ndarray:
    if np.ma.is_masked(values):
        raise InputError(f"{what}: some numbers are masked, and a mesh has no holes of that kind")
    try:
        return np.asarray(values)
    except ValueError as error:
        raise InputError(f"{what}: expected an array: {error}") from None


def real(name: str, value: Any) -> float:
    """An option that is a number."""
    if isinstance(value, (bool, str)) or not isinstance(value, SupportsFloat):
        raise InputError(f"{name}: expected a number, found {value!r}")
    return float(value)


def whole(name: str, value: Any) -> int:
    """An option that is a whole number."""
    try:
        return operator.index(value)
    except TypeError:
        raise InputError(f"{name}: expected a whole number, found {value!r}") from None


def word(name: str, value: Any) -> str:
    """An option that is a word; the extension knows which ones there are."""
    if not isinstance(value, str):
        raise InputError(f"{name}: expected a text, found {value!r}")
    return value


def words(values: str | Iterable[str]) -> list[str]:
    """A list of words, or a text with commas between them."""
    if isinstance(values, str):
        return [part.strip() for part in values.split(",") if part.strip()]
    return [str(one) for one in values]
