#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Proves or refutes what a finding says, in exact arithmetic and by brute force, from the files in its folder alone.

usage: check.py FOLDER...
Coordinates are the doubles that the files hold or that their decimals round to; everything is computed from them in
integers and fractions. Nothing but Python's standard library is used. finding.json lists the statements; tetrahedra and
vertices have the numbers of the mesh file (.mesh: from 1), triangles of surface.off count from 0.
Exit code 0: all statements are confirmed; 1: one is refuted; 4: none is refuted, but not all can be checked here.
"""
import collections
import itertools
import json
import math
import pathlib
import struct
import sys
from fractions import Fraction

import exact
from exact import FACES, cross, dot, sign, sub, volume6
from mesh_files import READERS, NotCheckable, read_off


class Refuted(Exception):
    """The files do not bear the statement out; the text says how."""


def expect(holds, text):
    if not holds:
        raise Refuted(text)


class Finding:
    """The folder's surface and mesh, in integers: one unit of them is 1/`unit` of the files' length unit."""

    def __init__(self, folder):
        self.json = json.loads((folder / "finding.json").read_text())
        vertices, self.triangles = read_off(folder / self.json["surface"])
        self.mesh = self.no_mesh = None
        if self.json.get("mesh"):
            path = folder / self.json["mesh"]
            try:
                if path.suffix not in READERS:
                    raise NotCheckable(f"{path.name}: no reader for this format")
                self.mesh = READERS[path.suffix](path)
            except (NotCheckable, ValueError, IndexError, StopIteration, RuntimeError, struct.error) as error:
                self.no_mesh = f"{path.name} cannot be read: {error}"
        self.raw = self.mesh.points if self.mesh else {}
        finite = [x for p in itertools.chain(vertices, self.raw.values()) for x in p if math.isfinite(x)]
        self.unit = max((x.as_integer_ratio()[1] for x in finite), default=1)
        self.vertices = [self.exact(p) for p in vertices]
        self.points = {number: self.exact(p) for number, p in self.raw.items() if all(map(math.isfinite, p))}
        self.of_face = collections.defaultdict(list)  # tetrahedra of each face
        for number, tet in (self.mesh.tets if self.mesh else {}).items():
            for face in FACES:
                self.of_face[frozenset(tet[i] for i in face)].append((number, tuple(tet[i] for i in face)))

    def exact(self, point):
        return tuple(n * (self.unit // d) for n, d in (float(x).as_integer_ratio() for x in point))

    def scaled(self, point):
        return tuple(Fraction(x) * self.unit for x in point)

    def at(self, numbers):
        for number in numbers:
            expect(number in self.raw, f"the mesh has no vertex {number}")
            if number not in self.points:
                raise NotCheckable(f"the coordinates of vertex {number} are not finite")
        return [self.points[number] for number in numbers]

    def tet(self, number):
        expect(number in self.mesh.tets, f"the mesh has no tetrahedron {number}")
        return self.mesh.tets[number]

    def face(self, s, numbers, alone=True):
        """The corners of a face that belongs to one tetrahedron, which the statement names."""
        uses = self.of_face.get(frozenset(numbers), [])
        expect(uses, f"no tetrahedron has the face {numbers}")
        if alone:
            expect(len(uses) == 1, f"the face {numbers} belongs to {len(uses)} tetrahedra")
        expect(any(number in s["tets"] for number, _ in uses), f"the face {numbers} is not of the tetrahedra named")
        return self.at(numbers)

    def boundary(self):
        return [uses[0][1] for uses in self.of_face.values() if len(uses) == 1]

    def corners(self, of_mesh):
        if of_mesh:
            return [tuple(self.at(face)) for face in self.boundary()]
        return [tuple(self.vertices[v] for v in t) for t in self.triangles]


def equal(found, stated, what):
    expect(found == Fraction(stated), f"{what} is {float(found):.17g}, exactly {found}")


# --- the kinds of statements

def valid_surface(f, s):
    """Closed, manifold, oriented, free of self-intersections; with its counts and its volume."""
    triangles, corners = f.triangles, f.corners(False)
    expect(len(triangles) == s["triangles"], f"it has {len(triangles)} triangles")
    expect(all(0 <= v < len(f.vertices) for t in triangles for v in t), "a triangle names no vertex")
    expect(len(set(f.vertices)) == len(f.vertices), "two vertices have the same coordinates")
    expect(all(any(cross(sub(b, a), sub(c, a))) for a, b, c in corners), "a triangle has no area")
    edges = collections.Counter((t[i - 1], t[i]) for t in triangles for i in range(3))
    expect(all(n == 1 and edges[b, a] == 1 for (a, b), n in list(edges.items())), "an edge has not one triangle on each side")
    links = collections.defaultdict(dict)
    for a, b, c in triangles:
        links[a][b], links[b][c], links[c][a] = c, a, b
    for vertex, link in links.items():  # one closed fan of triangles
        start = at = next(iter(link))
        steps = 0
        while steps == 0 or at != start:
            at, steps = link[at], steps + 1
        expect(steps == len(link), f"vertex {vertex} has more than one fan of triangles")
    order = sorted(range(len(corners)), key=lambda i: min(p[0] for p in corners[i]))
    boxes = [[(min(x), max(x)) for x in zip(*t)] for t in corners]
    for n, i in enumerate(order):
        for j in order[n + 1:]:
            if boxes[j][0][0] > boxes[i][0][1]:
                break
            if all(a[0] <= b[1] and b[0] <= a[1] for a, b in zip(boxes[i], boxes[j])):
                common = [f.vertices[v] for v in triangles[i] if v in triangles[j]]
                expect(not exact.meet(corners[i], corners[j], common), f"triangles {i} and {j} intersect")
    for key, value in exact.counts(triangles).items():
        expect(value == s[key], f"{key}: {value}")
    equal(exact.volume_of(corners, f.unit), s["volume"], "its volume")
    expect(Fraction(s["volume"]) > 0, "its volume is not positive")


def tet_volume(f, s):
    expect(list(f.tet(s["tet"])) == s["vertices"], f"tetrahedron {s['tet']} has the vertices {f.tet(s['tet'])}")
    equal(Fraction(volume6(*f.at(s["vertices"])), 6 * f.unit ** 3), s["volume"], "the volume")


def signs(f, s):
    found = collections.Counter(sign(volume6(*f.at(tet))) for tet in f.mesh.tets.values())
    expect([found[1], found[-1], found[0]] == [s["positive"], s["negative"], s["flat"]], f"the mesh has {found[1]} positive, "
           f"{found[-1]} negative and {found[0]} flat tetrahedra")


def same_vertices(f, s):
    expect(len(set(s["tets"])) > 1, "only one tetrahedron is named")
    for t in s["tets"]:
        expect(sorted(f.tet(t)) == sorted(s["vertices"]), f"tetrahedron {t} has the vertices {f.tet(t)}")


def same_places(f, s):
    places = {frozenset(f.at(f.tet(t))) for t in s["tets"]}
    expect(len(set(s["tets"])) > 1 and len(places) == 1, "the tetrahedra have different corners")


def face_tets(f, s):
    found = sorted(number for number, _ in f.of_face.get(frozenset(s["face"]), []))
    expect(found == sorted(s["tets"]) and len(found) > 2, f"the face belongs to the tetrahedra {found}")


def same_side(f, s):
    heights = [volume6(*f.face(s, s["face"], alone=False), *f.at([v])) for v in s["apexes"]]
    for t, apex in zip(s["tets"], s["apexes"]):
        expect(sorted(f.tet(t)) == sorted(s["face"] + [apex]), f"tetrahedron {t} has the vertices {f.tet(t)}")
    expect(len(set(s["tets"])) == 2 and sign(heights[0]) * sign(heights[1]) > 0, f"they have heights of signs {[sign(h) for h in heights]}")


def same_order(f, s):
    uses = [face for number, face in f.of_face.get(frozenset(s["face"]), []) if number in s["tets"]]
    turns = [{u[i:] + u[:i] for i in range(3)} for u in uses]
    expect(len(uses) == 2 and turns[0] == turns[1], "they name the face in opposite directions")


def tets_overlap(f, s):
    a, b = (f.at(f.tet(t)) for t in s["tets"])
    expect(s["tets"][0] != s["tets"][1], "only one tetrahedron is named")
    if "point" in s:
        p = f.scaled(s["point"])
        expect(exact.inside(p, a) and exact.inside(p, b), "the point is not strictly inside both")
    expect(exact.overlap(a, b), "a plane parts them")


def vertex_on_face(f, s):
    corners = f.face(s, s["face"])
    expect(s["vertex"] not in s["face"] and any(s["vertex"] in tet for tet in f.mesh.tets.values()), "it is a corner, or of no tetrahedron")
    equal(exact.to_triangle(*f.at([s["vertex"]]), corners) / f.unit ** 2, s["squared_distance"], "the squared distance")


def coinciding_faces(f, s):
    one, other = (f.face(s, face) for face in s["faces"])
    expect(set(s["faces"][0]) != set(s["faces"][1]) and set(one) == set(other), "the faces are the same, or in different places")


def same_place(f, s):
    expect(len(set(s["vertices"])) > 1 and len(set(f.at(s["vertices"]))) == 1, "their coordinates differ")


def two_faces(f, s):
    faces = [f.face(s, face) for face in s["faces"]]
    expect(set(s["faces"][0]) != set(s["faces"][1]), "only one face is named")
    if not all(any(cross(sub(b, a), sub(c, a))) for a, b, c in faces):
        raise NotCheckable("one of the faces has no area")
    common = f.at([v for v in s["faces"][0] if v in s["faces"][1]])
    return faces, common, exact.meet(*faces, common)


def faces_meet(f, s):
    expect(two_faces(f, s)[2], "they meet in common vertices and edges only")


def near_faces(f, s):
    faces, common, meet = two_faces(f, s)
    expect(not common and not meet, "they touch")
    equal(exact.between_triangles(*faces) / f.unit ** 2, s["squared_distance"], "the squared distance")


def crossed_diagonals(f, s):
    for face in s["faces"]:
        f.face(s, face)
    triples = {frozenset(t) for t in itertools.combinations(s["vertices"], 3)}
    expect({frozenset(face) for face in s["faces"]} == triples and len(triples) == 4, "the faces are not those of four vertices")
    equal(abs(Fraction(volume6(*f.at(s["vertices"])), 6 * f.unit ** 3)), s["volume"], "the volume between them")


def volumes(f, s):
    equal(Fraction(sum(volume6(*f.at(t)) for t in f.mesh.tets.values()), 6 * f.unit ** 3), s["mesh"], "the mesh's volume")
    equal(exact.volume_of(f.corners(False), f.unit), s["surface"], "the surface's volume")


def boundary_counts(f, s):
    for key, triangles in (("mesh", f.boundary()), ("surface", f.triangles)):
        found = exact.counts(triangles)
        expect(found == s[key], f"{key}: {found}")


def far(f, s, corners, others):
    weights = [Fraction(w) for w in s["weights"]]
    expect(sum(weights) == 1 and min(weights) >= 0, "the point is not on the triangle")
    point = tuple(sum(w * p[k] for w, p in zip(weights, corners)) for k in range(3))
    equal(min(exact.to_triangle(point, t) for t in others) / f.unit ** 2, s["squared_distance"], "the squared distance")


def off_surface(f, s):
    far(f, s, f.face(s, s["face"]), f.corners(False))


def off_mesh(f, s):
    far(f, s, f.corners(False)[s["triangle"]], f.corners(True))


def region_point(f, s):
    p = f.scaled(s["point"])
    inside = exact.winding(p, f.corners(False))
    if inside is None:
        raise NotCheckable("the point is on the surface, or every ray met an edge")
    expect((inside != 0) == s["inside_surface"], f"the surface goes {inside} times around the point")
    tets = sorted(t for t, tet in f.mesh.tets.items() if exact.inside(p, f.at(tet)))
    expect(tets == sorted(s["tets"]), f"the tetrahedra {tets} contain the point")
    triangles = f.corners(s["inside_surface"])  # what is missing is far from the mesh, what is too much is far from the surface
    equal(min(exact.to_triangle(p, t) for t in triangles) / f.unit ** 2, s["squared_distance"], "the squared distance")


def edge_faces(f, s):
    found = sum(set(s["edge"]) <= set(face) for face in f.boundary())
    expect(found == s["count"] != 2, f"the edge has {found} boundary faces")


def vertex_fans(f, s):
    faces = [face for face in f.boundary() if s["vertex"] in face]
    links = [tuple(v for v in face if v != s["vertex"]) for face in faces]
    parts = exact.parts(links)
    expect(parts == s["count"] > 1, f"the boundary faces at the vertex form {parts} fans")


def no_such_point(f, s):
    missing = [v for v in f.tet(s["tet"]) if v not in f.raw]
    expect(sorted(set(missing)) == sorted(set(s["vertices"])) and missing, f"it names {missing}, which do not exist")


def not_finite(f, s):
    expect(s["vertex"] in f.raw and s["vertex"] not in f.points, "its coordinates are finite")
    expect(any(s["vertex"] in tet for tet in f.mesh.tets.values()), "no tetrahedron uses it")


def repeated_vertex(f, s):
    expect(len(set(f.tet(s["tet"]))) < 4, f"it has the vertices {f.tet(s['tet'])}")


def unused_point(f, s):
    expect(s["vertex"] in f.raw and not any(s["vertex"] in tet for tet in f.mesh.tets.values()), "a tetrahedron uses it")


def tet_count(f, s):
    expect(len(f.mesh.tets) == s["count"], f"the mesh has {len(f.mesh.tets)} tetrahedra")


KINDS = {function.__name__: function for function in (
    valid_surface, tet_volume, signs, same_vertices, same_places, face_tets, same_side, same_order, tets_overlap, vertex_on_face,
    coinciding_faces, same_place, faces_meet, near_faces, crossed_diagonals, volumes, boundary_counts, off_surface, off_mesh,
    region_point, edge_faces, vertex_fans, no_such_point, not_finite, repeated_vertex, unused_point, tet_count)}


def check(folder):
    """Prints a line for each statement. The worst of them: 0, 4, 1."""
    finding, worst = Finding(folder), 0
    for s in finding.json["statements"]:
        try:
            if s["kind"] not in KINDS:
                raise NotCheckable(s.get("why", f"statements of the kind {s['kind']} cannot be checked"))
            if s["kind"] != "valid_surface" and finding.mesh is None:
                raise NotCheckable(finding.no_mesh or "the finding has no mesh")
            KINDS[s["kind"]](finding, s)
            print(f"confirmed    {s['text']}")
        except Refuted as why:
            print(f"REFUTED      {s['text']}: {why}")
            worst = 1
        except NotCheckable as why:
            print(f"not checked  {s['text']}: {why}")
            worst = worst or 4
    if not finding.json["statements"]:
        print("not checked  there are no statements")
        worst = 4
    return worst


def main(folders):
    if not folders or folders[0].startswith("-"):
        sys.exit(__doc__)
    worst = 0
    for folder in folders:
        if len(folders) > 1:
            print(f"{folder}:")
        result = check(pathlib.Path(folder))
        worst = 1 if 1 in (result, worst) else result or worst
    return worst


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
