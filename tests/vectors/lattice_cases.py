# SPDX-License-Identifier: GPL-3.0-or-later
"""Eq. (2.1): the lattice in the scaled box of a surface, in rational arithmetic. The sum over the eight corners of the box is
written out, as on the page."""
from fractions import Fraction as F
from itertools import product
from math import floor

from exact import Draws

LEAST = 4  # the cells that every side gets at least, or N if N is smaller (reading D1); checks.py and geometry_answers.cpp have it, too

FLAGS = {
    "three-numbers": "The numbers of cells are given, one for each side.",
    "one-number": "One number, for the longest side: the other sides get theirs from the sides of the surface's own box (reading D1).",
    "rounded": "The number of cells of a side is rounded, not cut off.",
    "half": "Exactly between two numbers of cells: the larger one (reading D1), not the even one.",
    "at-least": "A side so short that rounding gives fewer cells than the least number (reading D1).",
    "centre": "The box is scaled about its centre, not about the origin.",
    "unused-vertex": "A vertex that no triangle names is no point of the surface and does not widen the box.",
}


def eq_2_1(low, high, cells, at):
    """The sum over I, J, K of the weights of the eight corners times the corners."""
    t = [F(i, n) for i, n in zip(at, cells)]
    point = [F(0)] * 3
    for corner in product((0, 1), repeat=3):
        weight = F(1)
        for c, x in zip(corner, t):
            weight *= x if c else 1 - x
        for axis in range(3):
            point[axis] += weight * (high if corner[axis] else low)[axis]
    return tuple(point)


def numbers_of_cells(cells, sides, cut=lambda x: floor(x + F(1, 2))):
    return list(cells) if len(cells) == 3 else [max(min(LEAST, cells[0]), cut(cells[0] * s / max(sides))) for s in sides]


def half_even(x):
    return floor(x) + (x - floor(x) > F(1, 2) or (x - floor(x) == F(1, 2) and floor(x) % 2 == 1))


def lattice_case(name, flags, comment, low, high, cells, scale, stray=None):
    """The surface is a tetrahedron in the box, with all of its six planes."""
    low, high = [F(x) for x in low], [F(x) for x in high]
    vertices = [tuple(low), (high[0], high[1], low[2]), (high[0], low[1], high[2]), (low[0], high[1], high[2])]
    triangles = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
    if stray:
        vertices.insert(1, tuple(map(F, stray)))
        triangles = [[v + (v > 0) for v in t] for t in triangles]
    sides = [h - l for l, h in zip(low, high)]
    numbers = numbers_of_cells(cells, sides)
    centre = [(l + h) / 2 for l, h in zip(low, high)]
    box = [[c + sign * s / 2 * scale for c, s in zip(centre, sides)] for sign in (-1, 1)]
    at = sorted({tuple(n * k // 2 for n, k in zip(numbers, ks)) for ks in ((0, 0, 0), (2, 2, 2), (1, 1, 1), (2, 0, 1), (1, 2, 0), (0, 1, 2))})
    flags = flags + ["three-numbers" if len(cells) == 3 else "one-number"] + ["unused-vertex"] * bool(stray)
    flags += ["rounded"] * (numbers != numbers_of_cells(cells, sides, floor)) + ["half"] * (numbers != numbers_of_cells(cells, sides, half_even))
    flags += ["at-least"] * (len(cells) == 1 and any(floor(cells[0] * s / max(sides) + F(1, 2)) < min(LEAST, cells[0]) for s in sides)) + ["centre"] * any(centre)
    size = max(max(map(abs, box[0])), max(map(abs, box[1])))
    return {"id": "lattice-" + name, "flags": flags, "comment": comment,
            "input": {"vertices": vertices, "triangles": triangles, "cells": list(cells), "box_scale": scale, "at": at},
            "expected": {"cells": numbers, "box": box, "points": [eq_2_1(box[0], box[1], numbers, a) for a in at]},
            "tolerance": {"absolute": float(size) * 1e-14}}


def lattice():
    one, scale = (1, 1, 1), F(5, 4)
    zero = (0, 0, 0)
    yield lattice_case("cube-4", [], "a cube: the same number along each side", zero, one, [4], scale)
    yield lattice_case("cube-about-origin", [], "a cube about the origin", (-1, -1, -1), one, [4], F(3, 2))
    yield lattice_case("cube-3-4-5", [], "three numbers", zero, one, [3, 4, 5], scale)
    yield lattice_case("one-cell", [], "a single cell", zero, one, [1, 1, 1], F(2))
    for n in (1, 2, 5, 12, 24):
        yield lattice_case(f"brick-{n}", [], "sides 8, 5, 3", (1, 2, 3), (9, 7, 6), [n], scale)
        yield lattice_case(f"plate-{n}", [], "sides 4, 16, 1/8: a thin plate", (-2, 1, 0), (2, 17, F(1, 8)), [n], F(3, 2))
    for n, sides in ((4, (16, 10, 6)), (6, (16, 4, 12)), (10, (4, 16, 6)), (2, (4, 3, 1)), (12, (8, 1, 3)), (12, (8, 3, 5)), (20, (16, 8, 10)), (9, (8, 4, 16)), (13, (10, 5, 8))):
        high = [F(s) for s in sides]
        yield lattice_case(f"half-{n}-{'-'.join(map(str, sides))}", [], "numbers of cells halfway between two", (0, 0, 0), high, [n], scale)
    for n in (1, 3, 8):
        yield lattice_case(f"rod-{n}", [], "a rod: rounding gives too few cells across", (0, 0, 0), (64, 1, 2), [n], F(9, 8))
    for n, stray in ((4, (100, 0, 0)), (4, (F(1, 2), F(1, 2), -7))):
        yield lattice_case(f"stray-{stray[0]}", [], "a vertex far away that no triangle names", zero, one, [n], scale, stray)
    yield lattice_case("stray-numbers", [], "a vertex that would make another side the longest", zero, (4, 2, 1), [8], scale, (0, 30, 0))
    draws = Draws(21)
    for n in range(16):
        low = [F(draws.between(-64, 64), 8) for _ in range(3)]
        high = [x + F(draws.between(1, 80), 8) for x in low]
        cells = [draws.between(1, 30)] if n % 2 else [draws.between(1, 9) for _ in range(3)]
        stray = [x - 3 for x in low] if n % 5 == 4 else None
        yield lattice_case(f"random-{n:02}", [], "drawn at random", low, high, cells, F(draws.between(17, 48), 16), stray)
