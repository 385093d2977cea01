#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the conformance vectors into a folder, corpus/vectors/ by default: expected results come from rational arithmetic and
closed forms, never from the code they test.

usage: make_vectors.py [FOLDER]"""
import json
import pathlib
import sys
from fractions import Fraction

sys.dont_write_bytecode = True
import curvature_cases  # noqa: E402
import equation_cases  # noqa: E402
import lattice_cases  # noqa: E402
import quality_cases  # noqa: E402
import surface_cases  # noqa: E402
import table3_cases  # noqa: E402
import table4_cases  # noqa: E402
import table_cases  # noqa: E402

# file: (what it is about, its flags, its cases, keys of the answer that may be left out)
FILES = {
    "table1": ("Table 1: the case of a lattice tetrahedron, and the edges that have an intersection point",
               table_cases.TABLE1_FLAGS, table_cases.table1, []),
    "table2": ("Table 2: the tetrahedra that come out of a lattice tetrahedron", table_cases.TABLE2_FLAGS, table_cases.table2, ["row"]),
    "table3": ("Table 3: indicators and cuts of a lattice cell whose edges meet the surface several times",
               table3_cases.FLAGS, table3_cases.table3, ["applied"]),
    "table4": ("Table 4: where a tetrahedron gets its new point, and its pieces", table4_cases.FLAGS, table4_cases.table4, ["row"]),
    "volume_law": ("Eq. (3.1): the volume that a tetrahedron at a distance should have", equation_cases.VOLUME_LAW_FLAGS,
                   equation_cases.volume_law, []),
    "weights": ("Eqs (3.2) to (3.4) and (3.6): distances, weights, volumes and errors of a grid", equation_cases.WEIGHTS_FLAGS,
                equation_cases.weights, ["nearest"]),
    "choice": ("Eq. (3.5): which tetrahedron is split", equation_cases.CHOICE_FLAGS, equation_cases.choice, []),
    "curvature_weight": ("Eq. (3.6): the weight of the distance", equation_cases.CURVATURE_WEIGHT_FLAGS,
                         equation_cases.curvature_weight, []),
    "curvature": ("Absolute curvature at a vertex of a triangulated surface, after the paper's reference [3]",
                  curvature_cases.FLAGS, curvature_cases.curvature, []),
    "lattice": ("Eq. (2.1): the lattice in the scaled box of a surface", lattice_cases.FLAGS, lattice_cases.lattice, []),
    "indicators": ("Exact indicators: which points lie inside, on and outside a surface", surface_cases.INDICATORS_FLAGS, surface_cases.indicators, []),
    "edge_points": ("The points that an edge has in common with a surface, as Table 3 counts them", surface_cases.EDGE_FLAGS,
                    surface_cases.edge_points, []),
    "closest_point": ("The point of a surface that is closest to a point", surface_cases.CLOSEST_FLAGS, surface_cases.closest_point, []),
    "quality": ("Section 4: the smallest solid angle of a tetrahedron, and D/A", quality_cases.QUALITY_FLAGS, quality_cases.quality, []),
    "flips": ("Section 4: the flip of a set of tetrahedra that gains most", quality_cases.FLIPS_FLAGS, quality_cases.flips, []),
}


def plain(value):
    """Fractions as the nearest double, or as an integer where they are one."""
    if isinstance(value, Fraction):
        return value.numerator if value.denominator == 1 and abs(value) < 2**53 else float(value)
    if isinstance(value, dict):
        return {key: plain(each) for key, each in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(each) for each in value]
    return value


def exact_inputs(value):
    """Whether every number of an input is what it says: a double holds it."""
    if isinstance(value, Fraction):
        return Fraction(float(value)) == value
    if isinstance(value, (dict, list, tuple)):
        return all(map(exact_inputs, value.values() if isinstance(value, dict) else value))
    return True


def text_of(name):
    about, notes, cases, optional = FILES[name]
    cases = list(cases())
    for case in cases:
        if not exact_inputs(case["input"]):
            raise AssertionError(f"{case['id']}: an input is no double")
    head = {"format": "tetproof-vectors 1", "kind": name, "about": about, "optional": optional, "flags": notes}
    lines = [json.dumps({key: case[key] for key in ("id", "comment", "flags", "input", "expected", "tolerance") if key in case})
             for case in map(plain, cases)]
    return json.dumps(head, indent=1)[:-2] + ',\n "cases": [\n' + ",\n".join(lines) + "\n ]\n}\n"


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parents[2] / "corpus/vectors")
    for name in FILES:
        (folder / f"{name}.json").write_text(text_of(name))
