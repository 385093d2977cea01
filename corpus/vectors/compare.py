# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares an answer with the expected result of a vector."""
from fractions import Fraction

import checks


class Different(Exception):
    pass


def difference(kind, case, result, optional):
    """The first fault of the answer, in a few words; empty if there is none."""
    try:
        if not isinstance(result, dict):
            raise Different("the result is no object")
        tolerance = case.get("tolerance", {})
        for key, expected in case["expected"].items():
            if key not in result:
                if key in optional:
                    continue
                raise Different(f"{key} is missing")
            COMPARE.get((kind, key), same)(expected, result[key], tolerance, key, case["input"])
    except Different as fault:
        return str(fault)
    return ""


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def close(expected, found, tolerance):
    if found != found or found in (float("inf"), float("-inf")):
        return False
    # Computed in fractions, without rounding, so that a tolerance of 0 means equality.
    off = abs(Fraction(found) - Fraction(expected))
    return off <= max(Fraction(tolerance.get("relative", 0)) * abs(Fraction(expected)), Fraction(tolerance.get("absolute", 0)))


def same(expected, found, tolerance, where, _=None):
    """Numbers must agree within the tolerance, everything else must be equal. Objects may have more keys than expected."""
    if is_number(expected):
        if not is_number(found):
            raise Different(f"{where}: expected a number, found {found!r:.60}")
        if not close(expected, found, tolerance if isinstance(expected, float) or isinstance(found, float) else {}):
            raise Different(f"{where}: expected {expected!r}, found {found!r}")
    elif isinstance(expected, list):
        if not isinstance(found, list) or len(found) != len(expected):
            raise Different(f"{where}: expected {len(expected)} entries, found {len(found) if isinstance(found, list) else repr(found)[:60]}")
        for k, (e, f) in enumerate(zip(expected, found)):
            same(e, f, tolerance, f"{where}[{k}]")
    elif isinstance(expected, dict):
        if not isinstance(found, dict):
            raise Different(f"{where}: expected an object, found {found!r:.60}")
        for key, e in expected.items():
            if key not in found:
                raise Different(f"{where}.{key} is missing")
            same(e, found[key], tolerance, f"{where}.{key}")
    elif type(found) is not type(expected) or found != expected:
        raise Different(f"{where}: expected {expected!r}, found {found!r:.60}")


def ordered(expected, found, tolerance, where, _=None):
    """Lists must be equal as sets. The elements may be edges, whose ends may be exchanged."""
    if not isinstance(found, list):
        raise Different(f"{where}: expected a list, found {found!r:.60}")
    tidy = lambda items: sorted((sorted(i) if isinstance(i, list) else i for i in items), key=repr)
    try:
        e, f = tidy(expected), tidy(found)
    except TypeError:
        raise Different(f"{where}: expected {expected}, found {found!r:.200}") from None
    if e != f:
        raise Different(f"{where}: expected {e}, found {f}")


def cuts(expected, found, tolerance, where, _=None):
    if not isinstance(found, list) or not all(isinstance(c, dict) and isinstance(c.get("edge"), list) and "point" in c for c in found):
        raise Different(f'{where}: expected a list of {{"edge": [a, b], "point": [x, y, z]}}')
    ordered([c["edge"] for c in expected], [c["edge"] for c in found], tolerance, where + ": edges")
    points = {tuple(sorted(c["edge"])): c["point"] for c in found}
    for c in expected:
        same(c["point"], points[tuple(sorted(c["edge"]))], tolerance, f"{where}: the point on edge {c['edge']}")


def counts(expected, found, tolerance, where, _=None):
    """Counts by name must be equal. A missing name counts as 0."""
    if not isinstance(found, dict):
        raise Different(f"{where}: expected an object, found {found!r:.60}")
    for name in sorted(set(expected) | set(found)):
        if expected.get(name, 0) != found.get(name, 0):
            raise Different(f"{where}: row {name} expected {expected.get(name, 0)} times, found {found.get(name, 0)}")


def tetrahedra(expected, found, tolerance, where, _=None):
    """The tetrahedra, given by coordinates, must be the expected ones, in any order, and each must be positive."""
    if not isinstance(found, list) or not all(checks.is_tet(t) for t in found):
        raise Different(f"{where}: expected a list of tetrahedra, each of four points [x, y, z]")
    if len(found) != len(expected):
        raise Different(f"{where}: expected {len(expected)}, found {len(found)}")
    for number, tet in enumerate(found):
        if checks.volume(*([Fraction(x) for x in p] for p in tet)) <= 0:
            raise Different(f"{where}: number {number} is not positive")
    left = list(expected)
    for number, tet in enumerate(found):
        match = next((e for e in left if all(any(all(close(a, b, tolerance) for a, b in zip(p, q)) for q in tet) for p in e)), None)
        if match is None:
            raise Different(f"{where}: number {number} is none of those expected")
        left.remove(match)


def oriented(tet):
    """The sorted corners, and 0 or 1 for an even or odd order of the given ones."""
    inversions = sum(tet[i] > tet[j] for i in range(4) for j in range(i + 1, 4))
    return sorted(tet), inversions % 2


def pieces(expected, found, tolerance, where, given):
    """The tetrahedra, given by point numbers, must be the expected ones, in any order, each with the expected orientation."""
    if not isinstance(found, list) or not all(isinstance(t, list) and len(t) == 4 and all(type(v) is int for v in t) for t in found):
        raise Different(f"{where}: expected a list of tetrahedra, each of four numbers")
    if sorted(map(oriented, expected)) != sorted(map(oriented, found)):
        raise Different(f"{where}: expected {expected}, found {found} (up to even permutations; a new point has the number {len(given['points'])})")


def flip(expected, found, tolerance, where, _=None):
    """The flip must be the expected one: its kind, the points of its face and edge in any order, and its qualities."""
    if expected is None or found is None:
        same(expected, found, tolerance, where)
        return
    if not isinstance(found, dict) or not {"kind", "face", "edge", "quality"} <= set(found):
        raise Different(f'{where}: expected {{"kind", "face", "edge", "quality"}}, found {found!r:.100}')
    same(expected["kind"], found["kind"], {}, where + ".kind")
    ordered(expected["face"], found["face"], {}, where + ".face")
    ordered(expected["edge"], found["edge"], {}, where + ".edge")
    same(expected["quality"], found["quality"], tolerance, where + ".quality")


COMPARE = {
    ("table1", "edges"): ordered,
    ("table2", "tetrahedra"): tetrahedra,
    ("table3", "cuts"): cuts,
    ("table3", "applied"): counts,
    ("table4", "replaced"): ordered,
    ("table4", "pieces"): pieces,
    ("flips", "flip"): flip,
    ("flips", "tetrahedra"): pieces,
}
