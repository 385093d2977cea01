# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact geometry of points, triangles and tetrahedra, by brute force. Points are triples of integers or fractions. For check.py."""
import itertools
import random
from fractions import Fraction

FACES = ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))  # of a positive tetrahedron, seen from outside anticlockwise


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def sign(x):
    return (x > 0) - (x < 0)


def volume6(a, b, c, d):
    return dot(cross(sub(b, a), sub(c, a)), sub(d, a))


def to_segment(p, a, b):
    """The squared distance of a point and a segment."""
    ab, ap = sub(b, a), sub(p, a)
    along, length = dot(ap, ab), dot(ab, ab)
    if along <= 0:
        return Fraction(dot(ap, ap))
    if along >= length:
        return Fraction(dot(sub(p, b), sub(p, b)))
    return dot(ap, ap) - Fraction(along) ** 2 / length


def to_triangle(p, t):
    """The squared distance of a point and a triangle."""
    n = cross(sub(t[1], t[0]), sub(t[2], t[0]))
    sides = [(t[i], t[(i + 1) % 3]) for i in range(3)]
    if any(n) and all(dot(cross(n, sub(b, a)), sub(p, a)) >= 0 for a, b in sides):
        return Fraction(dot(n, sub(p, t[0]))) ** 2 / dot(n, n)
    return min(to_segment(p, a, b) for a, b in sides)


def between_segments(a, b, c, d):
    n, w = cross(sub(b, a), sub(d, c)), sub(c, a)
    nn = dot(n, n)
    if nn and 0 <= dot(cross(w, sub(d, c)), n) <= nn and 0 <= dot(cross(w, sub(b, a)), n) <= nn:
        return Fraction(dot(w, n)) ** 2 / nn
    return min(to_segment(a, c, d), to_segment(b, c, d), to_segment(c, a, b), to_segment(d, a, b))


def between_triangles(s, t):
    """The squared distance of two triangles that do not meet."""
    sides = [[(u[i], u[(i + 1) % 3]) for i in range(3)] for u in (s, t)]
    return min([to_triangle(p, t) for p in s] + [to_triangle(p, s) for p in t] +
               [between_segments(*e, *f) for e in sides[0] for f in sides[1]])


def clipped(polygon, normal, start):
    """The part of a convex polygon in the half-space normal . (x - start) >= 0."""
    heights, kept = [dot(normal, sub(p, start)) for p in polygon], []
    for i, (p, h) in enumerate(zip(polygon, heights)):
        q, k = polygon[i - 1], heights[i - 1]
        if sign(h) * sign(k) < 0:
            kept.append(tuple(x + (y - x) * Fraction(h) / (h - k) for x, y in zip(p, q)))
        if h >= 0:
            kept.append(p)
    return kept


def meet(s, t, common):
    """Whether two triangles (of positive area) meet in a point outside of their common vertices and common edge.

    `common` are the points that both have as a vertex: different vertices in one place are none.
    """
    if len(common) == 3:
        return True
    n = cross(sub(t[1], t[0]), sub(t[2], t[0]))
    for u, v, normal in ((s, t, n), (t, s, cross(sub(s[1], s[0]), sub(s[2], s[0])))):  # all of u on one side of v
        if len({sign(dot(normal, sub(p, v[0]))) for p in u if p not in common} | {0}) == 2 and all(
                dot(normal, sub(p, v[0])) for p in u if p not in common):
            return False
    polygon = clipped(clipped(list(s), n, t[0]), tuple(-x for x in n), t[0])
    for i in range(3):
        polygon = clipped(polygon, cross(n, sub(t[(i + 1) % 3], t[i])), t[i])
    if len(common) == 2:
        return any(any(cross(sub(p, common[0]), sub(common[1], common[0]))) for p in polygon)
    return any(p not in common for p in polygon)


def overlap(a, b):
    """Whether the interiors of two tetrahedra meet: no plane that is parallel to a face, or to an edge of each, parts them."""
    edges = [[sub(p, q) for p, q in itertools.combinations(t, 2)] for t in (a, b)]
    normals = [cross(sub(t[j], t[i]), sub(t[k], t[i])) for t in (a, b) for i, j, k in FACES]
    for n in normals + [cross(e, f) for e in edges[0] for f in edges[1]]:
        if any(n):
            one, other = ([dot(n, p) for p in t] for t in (a, b))
            if max(one) <= min(other) or max(other) <= min(one):
                return False
    return all(volume6(*t) for t in (a, b))


def inside(p, t):
    whole = sign(volume6(*t))
    return whole != 0 and all(sign(volume6(*t[:i], p, *t[i + 1:])) == whole for i in range(4))


def winding(p, triangles):
    """How often closed oriented triangles go around a point: 1 inside a solid, 0 outside, None on them."""
    chance = random.Random(1)
    for _ in range(50):
        ray, total = tuple(chance.randrange(-999, 1000) for _ in range(3)), 0
        for t in triangles:
            a, b, c = (sub(q, p) for q in t)
            sides = [sign(dot(ray, cross(*pair))) for pair in ((a, b), (b, c), (c, a))]
            if 0 in sides and not {1, -1} <= set(sides):
                break  # the ray meets an edge: another ray decides
            height = sign(dot(a, cross(b, c)))
            if sides[0] == sides[1] == sides[2] and sides[0] * height >= 0:
                if height == 0:
                    return None
                total += sides[0]
        else:
            return total
    return None


def volume_of(triangles, unit):
    """The volume that closed triangles enclose, which point outwards."""
    return Fraction(sum(dot(a, cross(b, c)) for a, b, c in triangles), 6 * unit ** 3)


def parts(groups):
    """How many parts there are of groups that hang together by common members."""
    parent = list(range(len(groups)))

    def root(i):
        while parent[i] != i:
            parent[i] = parent[parent[i]]
            i = parent[i]
        return i

    first = {}
    for i, group in enumerate(groups):
        for member in group:
            parent[root(first.setdefault(member, i))] = root(i)
    return len({root(i) for i in range(len(groups))})


def counts(triangles):
    """The parts that hang together by edges, and vertices - edges + triangles."""
    edges_of = [[frozenset(e) for e in itertools.combinations(t, 2)] for t in triangles]
    edges = {edge for group in edges_of for edge in group}
    return {"components": parts(edges_of), "euler": len({v for t in triangles for v in t}) - len(edges) + len(triangles)}
