# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds what is wrong with a mesh, without tetproof: signs in exact arithmetic, and counts of faces."""
from collections import defaultdict
from fractions import Fraction


def read_tetgen(stem):
    with open(stem + ".node") as file:
        count = int(file.readline().split()[0])
        points = {}
        for _ in range(count):
            number, x, y, z = file.readline().split()[:4]
            points[int(number)] = (float(x), float(y), float(z))
    with open(stem + ".ele") as file:
        count = int(file.readline().split()[0])
        return points, [tuple(map(int, file.readline().split()[1:5])) for _ in range(count)]


def determinant(a, b, c, d):
    u, v, w = ([q - p for p, q in zip(a, x)] for x in (b, c, d))
    return (u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]))


def positive(corners):
    size = max(abs(x) for p in corners for x in p)
    value = determinant(*corners)
    if abs(value) > 1e-13 * size ** 3:   # above the rounding error
        return value > 0
    return determinant(*([Fraction(x) for x in p] for p in corners)) > 0


def faults(points, tets, triangles):
    """The reasons why the mesh is no triangulation. `triangles`: those of the surface as triples of coordinates, or None."""
    found = []
    wrong = sum(not positive([points[v] for v in tet]) for tet in tets)
    if wrong:
        found.append(f"{wrong} tetrahedra are not positive")
    faces = defaultdict(list)
    for a, b, c, d in tets:
        for face in ((b, c, d), (a, d, c), (a, b, d), (a, c, b)):
            first = face.index(min(face))
            key = tuple(sorted(face))
            faces[key].append(face[(first + 1) % 3] == key[1])
    for what, count in (("face of more than two tetrahedra", sum(len(sides) > 2 for sides in faces.values())),
                        ("face with both tetrahedra on one side", sum(sides in ([True] * 2, [False] * 2) for sides in faces.values()))):
        if count:
            found.append(f"{count} times a {what}")
    if triangles is None:
        return found
    boundary = [frozenset(points[v] for v in face) for face, sides in faces.items() if len(sides) == 1]
    if len(boundary) != len(triangles) or set(boundary) != set(triangles):
        used = {v for tet in tets for v in tet}
        twice = len(used) - len({points[v] for v in used})
        found.append(f"{len(boundary)} faces of one tetrahedron, the surface has {len(triangles)} triangles"
                     + (f"; {twice} points with the coordinates of others" if twice else ""))
    return found


def euler(triangles):
    """Vertices - edges + triangles."""
    return (len({v for t in triangles for v in t}) + len(triangles)
            - len({frozenset((t[k], t[k - 1])) for t in triangles for k in range(3)}))


def expected_warnings(points, tets, triangles):
    """Ids of the checks that may warn: a point is unused; the boundary touches itself in an edge or a vertex. If it does, or
    if its Euler characteristic is not that of the surface, its topology may differ, too."""
    count = defaultdict(int)
    for tet in tets:
        for k in range(4):
            count[tuple(sorted(tet[:k] + tet[k + 1:]))] += 1
    around, fans = defaultdict(list), defaultdict(list)   # the faces at an edge; the edges opposite to a vertex
    for face in (face for face, times in count.items() if times == 1):
        for k in range(3):
            edge = face[:k] + face[k + 1:]
            around[edge].append(face)
            fans[face[k]].append(edge)
    ids = {"boundary-nonmanifold-edge"} if any(len(faces) > 2 for faces in around.values()) else set()
    if len({v for tet in tets for v in tet}) < len(points):
        ids.add("unused-point")
    for edges in fans.values():
        reached, grown = set(edges[0]), True
        while grown:
            more = {v for edge in edges if reached & set(edge) for v in edge} - reached
            reached |= more
            grown = bool(more)
        if any(not reached & set(edge) for edge in edges):
            ids.add("boundary-nonmanifold-vertex")
    boundary = [face for face, times in count.items() if times == 1]
    if ids - {"unused-point"} or euler(boundary) != euler(triangles):
        ids.add("topology")
    return ids
