# SPDX-License-Identifier: GPL-3.0-or-later
"""Section 4: solid angles from dihedral angles, D/A from exact areas, and flips, whose convexity shows in exact volumes. To 60
digits; no formula of van Oosterom and Strackee."""
from decimal import Decimal
from fractions import Fraction as F
from itertools import combinations

from exact import FACES, PI, Draws, arctangent, cross, decimal, dot, sub, tangent, volume

QUALITY_FLAGS = {
    "smallest": "The solid angle at the first vertex is not the smallest of the four: the smallest counts (reading D20).",
    "largest-face": "The faces differ in area: the smallest distance D belongs to the largest face (reading E5).",
    "permuted": "The same tetrahedron with its vertices in another order.",
    "flat": "Almost flat: the solid angles are tiny, or close to half of the full angle.",
    "needle": "One vertex is far away from the others.",
    "scaled": "Solid angles and D/sqrt(A) stay the same when lengths are scaled, D/A does not (reading E5).",
    "far-away": "Far from the origin.",
}


def solid_angles(corners):
    """The four solid angles, each the sum of three dihedral angles less pi."""
    normals = [cross(sub(corners[b], corners[a]), sub(corners[c], corners[a])) for a, b, c in FACES]  # outward; face k is opposite to vertex k
    between = {}
    for i, j in combinations(range(4), 2):
        c = cross(normals[i], normals[j])
        between[i, j] = PI - arctangent(decimal(dot(c, c)).sqrt(), decimal(dot(normals[i], normals[j])))
    # The faces i and j meet in the edge of the two other vertices; it counts at both of them.
    return [sum((angle for pair, angle in between.items() if v not in pair), -PI) for v in range(4)]


def aspect_ratios(corners, face=max):
    """D/A and D/sqrt(A) for the face that `face` chooses by its area."""
    squares = []
    for a, b, c in FACES:
        n = cross(sub(corners[b], corners[a]), sub(corners[c], corners[a]))
        squares.append(decimal(dot(n, n)) / 4)
    area2 = face(squares)
    height = 3 * decimal(volume(*corners)) / area2.sqrt()
    return height / area2.sqrt(), height / area2.sqrt().sqrt()


def fraction(x):
    return F(*Decimal(x).as_integer_ratio())


def quality_case(name, flags, comment, corners):
    corners = [tuple(F(x) for x in p) for p in corners]
    if volume(*corners) < 0:
        corners[2], corners[3] = corners[3], corners[2]
    angles = solid_angles(corners)
    ratio, plain = aspect_ratios(corners)
    flags = flags + ["smallest"] * (angles[0] > min(angles) * Decimal("1.000001"))
    flags += ["largest-face"] * (aspect_ratios(corners, min)[0] > ratio * Decimal("1.000001"))
    return {"id": "quality-" + name, "flags": flags, "comment": comment, "input": {"points": corners},
            "expected": {"tangent": fraction(tangent(min(angles) / 2)), "solid_angle": fraction(min(angles) / (4 * PI)),
                         "d_over_a": fraction(ratio), "d_over_sqrt_a": fraction(plain)},
            "tolerance": {"relative": 1e-12}}


def quality():
    regular = [(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)]
    right = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
    kuhn = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (1, 1, 1)]
    skew = [(0, 0, 0), (8, 1, 0), (2, 5, 1), (3, 1, 4)]
    for name, corners in (("regular", regular), ("right", right), ("kuhn", kuhn), ("skew", skew)):
        yield quality_case(name, [], "all angles equal" if corners is regular else "three edges", corners)
        for k, order in enumerate(((1, 0, 3, 2), (2, 3, 0, 1), (3, 2, 1, 0))):
            yield quality_case(f"{name}-order-{k}", ["permuted"], "even permutations of the vertices", [corners[i] for i in order])
        for power in (-20, 20):
            scaled = [tuple(F(x) * F(2) ** power for x in p) for p in corners]
            yield quality_case(f"{name}-scale-{power}", ["scaled"], "scaled by a power of two", scaled)
        yield quality_case(f"{name}-far", ["far-away"], "moved by 2^20", [tuple(F(x) + 2**20 for x in p) for p in corners])
    for k in (4, 10, 20, 30):
        h = F(1, 2**k)
        yield quality_case(f"sliver-{k}", ["flat"], "four points of a square, one pair lifted", [(0, 0, 0), (1, 1, 0), (1, 0, h), (0, 1, h)])
        yield quality_case(f"cap-{k}", ["flat"], "a vertex just above the opposite face: its angle is almost half of the full one",
                           [(0, 0, 0), (4, 0, 0), (0, 4, 0), (1, 1, h)])
        yield quality_case(f"needle-{k}", ["needle"], "one vertex far away", [(0, 0, 0), (1, 0, 0), (0, 1, 0), (F(1, 4), F(1, 4), 2**k)])
        yield quality_case(f"wedge-{k}", ["flat", "needle"], "a short edge opposite to a long one", [(0, 0, 0), (h, 0, 0), (0, 4, 0), (0, 0, 4)])
    draws = Draws(51)
    made = 0
    while made < 24:
        corners = [tuple(F(draws.between(-32, 32), 8) for _ in range(3)) for _ in range(4)]
        if abs(volume(*corners)) > F(1, 16):
            yield quality_case(f"random-{made:02}", [], "drawn at random", corners)
            made += 1


# --- flips

FLIPS_FLAGS = {
    "two-three": "A face gives way to an edge.",
    "three-two": "An edge gives way to a face.",
    "no-gain": "A flip is possible, but none raises the smallest quality: no flip.",
    "not-convex": "Five points whose hexahedron is not convex: their flip would turn a tetrahedron over (reading D22).",
    "flat-hexahedron": "An edge passes through the edge of a face: the hexahedron is convex, but not strictly, and its flip would make a flat "
                       "tetrahedron (reading D22).",
    "within-the-set": "A better flip exists, but one of its tetrahedra does not belong to the set O_i (readings D21, D22).",
    "gain-not-quality": "The flip with the largest gain is not the one whose new tetrahedra have the best quality (reading D22).",
    "criterion": "The other criterion asks for another flip.",
    "around-four": "Four tetrahedra around an edge: no flip takes them all.",
    "tie": "Two flips gain the same: the one with the lowest five vertices (reading D22).",
}


def worst(points, tets, criterion):
    """The smallest quality: tan(Omega/2), or D/A."""
    values = []
    for t in tets:
        corners = [points[v] for v in t]
        if volume(*corners) < 0:
            corners[2], corners[3] = corners[3], corners[2]
        values.append(tangent(min(solid_angles(corners)) / 2) if criterion == "solid-angle" else aspect_ratios(corners)[0])
    return min(values)


def candidates(points, tets, chosen):
    """Every exchange among the chosen tetrahedra, as (old positions, five points, face, edge, new tetrahedra, how convex)."""
    for size in (2, 3):
        for old in combinations(chosen, size):
            hull = sorted(set().union(*(tets[t] for t in old)))
            common = sorted(set(tets[old[0]]).intersection(*(tets[t] for t in old[1:])))
            if len(hull) != 5 or len(common) != 5 - size:
                continue
            rest = [v for v in hull if v not in common]
            face, edge = (common, rest) if size == 2 else (rest, common)
            new = [[v for v in hull if v != c] for c in common]
            size_of = lambda t: abs(volume(*(points[v] for v in t)))
            before, after = sum(size_of(tets[t]) for t in old), sum(map(size_of, new))
            shape = "not-convex" if before != after else "flat-hexahedron" if any(size_of(t) == 0 for t in new) else "convex"
            yield old, hull, face, edge, new, shape


def flips_case(name, comment, points, tets, chosen, criterion="solid-angle"):
    points = [tuple(F(x) for x in p) for p in points]
    tets = [list(t) for t in tets]
    for t in tets:
        if volume(*(points[v] for v in t)) < 0:
            t[2], t[3] = t[3], t[2]

    def best(chosen, by, key="gain", least=Decimal(0)):
        options = []
        for old, hull, face, edge, new, shape in candidates(points, tets, chosen):
            if shape == "convex":
                before, after = worst(points, [tets[t] for t in old], by), worst(points, new, by)
                if least is None or after - before > least + Decimal("1e-14"):
                    options.append((-(after - before if key == "gain" else after), hull, old, face, edge, new, before, after))
        options.sort(key=lambda o: (o[0].quantize(Decimal("1e-30")), o[1]))
        return options

    options = best(chosen, criterion)
    flags = sorted({c[5] for c in candidates(points, tets, chosen)} - {"convex"})
    if len(options) > 1:
        if Decimal("1e-30") < abs(options[0][0] - options[1][0]) < Decimal("1e-9"):
            raise AssertionError(f"{name}: almost a tie")
        flags += ["tie"] * (abs(options[0][0] - options[1][0]) < Decimal("1e-30"))
    taken = lambda o: o[0][3:5] if o else None
    flags += ["no-gain"] * (not options and bool(best(chosen, criterion, least=None)))
    flags += ["within-the-set"] * (taken(best(range(len(tets)), criterion)) != taken(options))
    flags += ["gain-not-quality"] * (taken(best(chosen, criterion, "quality")) != taken(options))
    other = "aspect-ratio" if criterion == "solid-angle" else "solid-angle"
    flags += ["criterion"] * (taken(best(chosen, other)) != taken(options))
    expected = {"flip": None, "tetrahedra": []}
    if options:
        _, hull, old, face, edge, new, before, after = options[0]
        flags.append("two-three" if len(old) == 2 else "three-two")
        for t in new:
            if volume(*(points[v] for v in t)) < 0:
                t[2], t[3] = t[3], t[2]
        share = lambda x: fraction(2 * arctangent(x, Decimal(1)) / (4 * PI)) if criterion == "solid-angle" else fraction(x)
        expected = {"flip": {"kind": "2-3" if len(old) == 2 else "3-2", "face": face, "edge": edge, "quality": [share(before), share(after)]}, "tetrahedra": new}
    return {"id": "flips-" + name, "flags": flags, "comment": comment,
            "input": {"points": points, "tetrahedra": tets, "set": list(chosen), "criterion": criterion}, "expected": expected,
            "tolerance": {"relative": 1e-10, "absolute": 1e-13}}


def bipyramid(height, shift=(0, 0), at=(0, 0, 0)):
    x, y, z = at
    return [(x, y, z), (x + 4, y, z), (x, y + 4, z), (x + 1 + shift[0], y + 1 + shift[1], z + height), (x + 1 - shift[0], y + 1 - shift[1], z - height)]


TWO = [[0, 1, 2, 3], [0, 2, 1, 4]]
THREE = [[0, 1, 3, 4], [1, 2, 3, 4], [2, 0, 3, 4]]


def flips():
    for criterion in ("solid-angle", "aspect-ratio"):
        end = "" if criterion == "solid-angle" else "-aspect"
        for k, h in enumerate((F(1, 8), F(1, 2), F(1), F(2), F(4), F(16))):
            yield flips_case(f"two-{k}{end}", f"two tetrahedra of height {h} on one face", bipyramid(h), TWO, [0, 1], criterion)
            yield flips_case(f"three-{k}{end}", f"three tetrahedra around an edge of length {2 * h}", bipyramid(h), THREE, [0, 1, 2], criterion)
        for k, shift in enumerate(((F(1, 2), 0), (F(1, 4), F(-1, 2)), (0, F(3, 4)))):
            yield flips_case(f"oblique-{k}{end}", "the line between the two tips passes obliquely through the face", bipyramid(F(2), shift), TWO, [0, 1], criterion)
            yield flips_case(f"oblique-three-{k}{end}", "three around an oblique edge", bipyramid(F(1, 2), shift), THREE, [0, 1, 2], criterion)
    beside = [(0, 0, 0), (4, 0, 0), (0, 4, 0), (1, 1, 4), (3, 3, -4)]
    yield flips_case("on-edge", "the line between the tips passes through an edge of the face", beside, TWO, [0, 1])
    beside[4] = (4, 4, -4)
    yield flips_case("beside", "the line between the tips passes beside the face", beside, TWO, [0, 1])
    beside[4] = (-1, -1, -4)
    yield flips_case("on-vertex", "the line between the tips passes through a vertex of the face", beside, TWO, [0, 1])
    yield flips_case("two-of-three", "two of three tetrahedra around an edge: they are not convex together", bipyramid(F(1, 4)), THREE, [0, 1])
    yield flips_case("one-of-two", "only one of the two belongs to the set", bipyramid(F(8)), TWO, [0])
    yield flips_case("one-of-three", "only one of the three belongs to the set", bipyramid(F(1, 8)), THREE, [1])
    four = [(0, 0, -1), (0, 0, 1), (8, 0, 0), (0, 8, 0), (-8, 0, 0), (0, -8, 0)]
    around = [[0, 1, 2, 3], [0, 1, 3, 4], [0, 1, 4, 5], [0, 1, 5, 2]]
    case = flips_case("around-four", "four flat tetrahedra around an edge", four, around, [0, 1, 2, 3])
    case["flags"].append("around-four")
    yield case
    moved = lambda points, by: [(x + by, y, z) for x, y, z in points]
    both = TWO + [[v + 5 for v in t] for t in TWO]
    good = [(8, 8, 6), (7, 0, 4), (0, 1, 1), (6, 1, 3), (2, 4, 6)]  # its flip gains most
    better = [(1, 3, 0), (7, 6, 2), (3, 3, 8), (4, 3, 2), (4, 7, 4)]  # its flip gains less, but from a better start
    small = [(7, 2, 3), (7, 1, 4), (2, 3, 5), (3, 0, 2), (6, 3, 5)]
    for name, points in (("good", good), ("better", better), ("small", small)):
        yield flips_case(f"face-{name}", "two tetrahedra on one face", points, TWO, [0, 1])
        yield flips_case(f"face-{name}-half", "only one of the two belongs to the set", points, TWO, [1])
    for swap in (0, 1):  # two equal pairs; the second pair of tetrahedra has the higher or the lower numbers of points
        yield flips_case(f"tie-{swap}", "two equal pairs", good + moved(good, 32), both[2:] + both[:2] if swap else both, [0, 1, 2, 3])
        first, second = (good, better) if swap else (better, good)
        yield flips_case(f"gain-{swap}", "two pairs: the larger gain, not the better outcome", first + moved(second, 32), both, [0, 1, 2, 3])
        yield flips_case(f"gain-within-{swap}", "two pairs, but only one belongs to the set", good + moved(small, 32), both, [2, 3] if swap else [0, 1])
    yield flips_case("three-pairs", "three pairs", small + moved(good, 32) + moved(better, 64), both + [[v + 10 for v in t] for t in TWO], range(6))
    draws = Draws(52)
    made = 0
    while made < 20:
        points = [tuple(F(draws.between(0, 16), 2) for _ in range(3)) for _ in range(5)]
        if all(volume(*(points[v] for v in t)) > 1 for t in TWO):
            yield flips_case(f"pair-{made:02}", "two tetrahedra drawn at random", points, TWO, [0, 1], ("solid-angle", "aspect-ratio")[made % 2])
            made += 1
    made = 0
    corner = [(i, j, k) for k in (0, 1) for j in (0, 1) for i in (0, 1)]
    kuhn = [[0, 1, 3, 7], [0, 1, 5, 7], [0, 2, 3, 7], [0, 2, 6, 7], [0, 4, 5, 7], [0, 4, 6, 7]]
    while made < 30:
        points = [tuple(F(16 * x + draws.between(-6, 6), 4) for x in p) for p in corner]
        inner = made % 3 == 2  # one of the tetrahedra is split by a point
        tets = [list(t) if k in (0, 3, 4) else [t[0], t[1], t[3], t[2]] for k, t in enumerate(kuhn)]
        if any(volume(*(points[v] for v in t)) <= 1 for t in tets):
            continue
        if inner:
            t = tets.pop(draws.below(6))
            points.append(tuple(sum(points[v][x] for v in t) / 4 for x in range(3)))
            tets += [[8 if v == w else v for v in t] for w in t]
        chosen = sorted(draws.shuffled(range(len(tets)))[:draws.between(4, len(tets))]) if made % 2 else list(range(len(tets)))
        try:
            yield flips_case(f"random-{made:02}", "the tetrahedra of a distorted cell", points, tets, chosen, ("solid-angle", "aspect-ratio")[made // 2 % 2])
        except AssertionError:
            continue
        made += 1
