# SPDX-License-Identifier: GPL-3.0-or-later
"""Eqs (3.1) to (3.6) in rational arithmetic; roots to 60 digits."""
from fractions import Fraction as F

from exact import Draws, dot, mean, power, root, sub, volume

TIE = F(1, 10**12)  # relative: distances that differ by rounding
EXPONENTS = (F(1, 4), F(1, 3), F(1, 2), F(1), F(2), F(3))  # those of the page

# --- eq. (3.1)

VOLUME_LAW_FLAGS = {
    "ends": "V0 at distance 0, V1 at d1, for every p.",
    "root": "p = 1/4, 1/3 or 1/2, as the nearest double: integer exponents only, or p read as a degree.",
    "polynomial": "p = 2 or 3.",
    "decreasing": "V0 > V1: eq. (3.1) does not forbid it (reading E4).",
    "equal": "V0 = V1: the same volume everywhere.",
    "beyond-d1": "d > d1: used as it stands, not cut off at d1 (reading D13).",
    "floor": "V0 > V1 far beyond d1: never below the smaller of both (reading D13); as it stands the volume would turn negative.",
    "d1-scaled": "d1 is not 1: the quotient d/d1 was forgotten, or taken to the power after a product.",
}


def desired(d, v0, v1, d1, p):
    t = power(F(d) / F(d1), p)
    return max((1 - t) * v0 + t * v1, min(v0, v1))


def volume_law():
    laws = [(F(1, 8), F(1), F(1)), (F(1, 4), F(2), F(3)), (F(3, 2), F(3, 8), F(5, 2)), (F(1, 2), F(1, 2), F(2)), (F(1, 2**40), F(3), F(1, 2**10))]
    for p in EXPONENTS:
        for n, (v0, v1, d1) in enumerate(laws):
            for t in (F(0), F(1, 4096), F(1, 64), F(1, 16), F(3, 8), F(1, 2), F(3, 4), F(1), F(5, 4), F(2), F(4), F(16)):
                d = t * d1
                value = desired(d, v0, v1, d1, p)
                flags = ["ends"] * (t in (0, 1)) + ["root"] * (p < 1) + ["polynomial"] * (p > 1) + ["decreasing"] * (v0 > v1)
                flags += ["equal"] * (v0 == v1) + ["beyond-d1"] * (t > 1) + ["d1-scaled"] * (d1 != 1)
                flags += ["floor"] * (v0 > v1 and t > 1)
                yield {"id": f"volume-p{p.numerator}/{p.denominator}-law{n + 1}-t{t.numerator}/{t.denominator}", "flags": flags,
                       "comment": f"d/d1 = {t}, p = {p}", "input": {"d": d, "v0": v0, "v1": v1, "d1": d1, "p": F(float(p))},
                       "expected": {"volume": value}, "tolerance": {"relative": 1e-13}}


# --- eq. (3.6)

CURVATURE_WEIGHT_FLAGS = {
    "ends": "1 at the smallest curvature, 1/10 at the largest: exchanged, the grid is finest where the surface is flat.",
    "between": "Linear in between.",
    "all-equal": "kappa_min = kappa_max: the weight is 1 (reading D15), not 0/0.",
}


def curvature_weight():
    ranges = [(F(0), F(1)), (F(1, 4), F(2)), (F(0), F(3) * 2**20), (F(1), F(1) + F(1, 2**20)), (F(7, 2), F(8))]
    for n, (low, high) in enumerate(ranges):
        for k in range(9):
            kappa = low + (high - low) * F(k, 8)
            weight = (high - kappa) / (high - low) + (kappa - low) / (high - low) / 10
            yield {"id": f"weight-range{n + 1}-{k}/8", "flags": ["ends" if k in (0, 8) else "between"], "comment": f"{k}/8 of the way from kappa_min to kappa_max",
                   "input": {"kappa": kappa, "kappa_min": low, "kappa_max": high}, "expected": {"weight": weight}, "tolerance": {"relative": 1e-13}}
    for kappa in (F(0), F(1), F(9, 4)):
        yield {"id": f"weight-equal-{float(kappa)}", "flags": ["all-equal"], "comment": "a sphere, or a body with flat faces only",
               "input": {"kappa": kappa, "kappa_min": kappa, "kappa_max": kappa}, "expected": {"weight": F(1)}, "tolerance": {"relative": 1e-13}}


# --- eqs (3.2), (3.3), (3.4) on whole grids

WEIGHTS_FLAGS = {
    "vertices-not-triangles": "The distance goes to the surface's vertices, as eq. (3.2) says, not to its triangles (reading D14).",
    "centroid": "The distance starts at the centroid, not at the closest vertex of the tetrahedron.",
    "nearest-tie": "Several surface vertices are equally close, but perhaps for rounding (1e-12, relative), and have different curvature: "
                   "the lexicographically smallest counts (reading D15).",
    "default-d1": "d1 is not given: the largest unweighted distance of this grid (reading D13).",
    "mean-volume": "V0 and V1 are multiples of this grid's mean volume (reading D13).",
    "curvature": "The weighted distance takes the place of d in eq. (3.1) (eq. (3.6)).",
    "kappa-range": "kappa_min and kappa_max come from all surface vertices, not only from those that are closest to a tetrahedron.",
    "average": "E_avg is the mean over tetrahedra, not weighted by volume, and the errors are absolute values: they do not cancel.",
}


def weigh(points, tets, surface, law, kappa):
    volumes = [volume(*(points[v] for v in t)) for t in tets]
    rows = []
    for t in tets:
        m = mean([points[v] for v in t])
        squares = [dot(sub(m, x), sub(m, x)) for x in surface]
        d2 = min(squares)
        _, near = min((x, k) for k, x in enumerate(surface) if squares[k] <= d2 * (1 + 2 * TIE))
        rows.append((root(d2, 2), near))
    unit = sum(volumes) / len(volumes) if law["unit"] == "mean-volume" else 1
    d1 = law["d1"] if law["d1"] is not None else max(d for d, _ in rows)
    result = []
    for (d, near), v in zip(rows, volumes):
        omega = F(1)
        if kappa and min(kappa) != max(kappa):
            span = max(kappa) - min(kappa)
            omega = (max(kappa) - kappa[near]) / span + (kappa[near] - min(kappa)) / span / 10
        wanted = desired(omega * d, law["v0"] * unit, law["v1"] * unit, d1, F(law["p"]).limit_denominator(4))
        result.append({"nearest": near, "d": d, "omega": omega, "volume": v, "desired": wanted, "error": abs(v - wanted)})
    return {"tetrahedra": result, "e_avg": sum(r["error"] for r in result) / len(result)}


def kuhn_grid(n, step):
    """n^3 cells of six tetrahedra."""
    points = [(F(i) * step, F(j) * step, F(k) * step) for k in range(n + 1) for j in range(n + 1) for i in range(n + 1)]
    number = lambda c: c[0] + (n + 1) * (c[1] + (n + 1) * c[2])
    tets = []
    for base in [(i, j, k) for k in range(n) for j in range(n) for i in range(n)]:
        for axes in ((0, 1, 2), (0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0)):
            corner, t = list(base), [number(base)]
            for axis in axes:
                corner[axis] += 1
                t.append(number(corner))
            if volume(*(points[v] for v in t)) < 0:
                t[2], t[3] = t[3], t[2]
            tets.append(t)
    return points, tets


def weights():
    draws = Draws(33)
    one = [tuple(map(F, p)) for p in ((0, 0, 0), (12, 0, 0), (0, 12, 0), (0, 0, 12))]
    absolute = {"v0": F(100), "v1": F(500), "d1": F(4), "p": F(1), "unit": "absolute"}

    def case(name, flags, comment, points, tets, surface, law, kappa=None, triangles=None):
        given = {"points": points, "tetrahedra": tets, "surface": surface, "law": {**law, "p": F(float(law["p"]))}, "kappa": kappa}
        if triangles:
            given["triangles"] = triangles
        return {"id": "weights-" + name, "flags": flags, "comment": comment, "input": given,
                "expected": weigh(points, tets, surface, law, kappa), "tolerance": {"relative": 1e-12, "absolute": 1e-12}}

    yield case("triangle-below", ["vertices-not-triangles"], "a large triangle passes the centroid at distance 1, its corners are far", one, [[0, 1, 2, 3]],
               [tuple(map(F, p)) for p in ((-40, -40, 2), (60, -40, 2), (3, 80, 2))], absolute, None, [[0, 1, 2]])
    yield case("vertex-at-corner", ["centroid"], "a surface vertex lies on a corner of the tetrahedron, the distance is still the centroid's", one, [[0, 1, 2, 3]],
               [tuple(map(F, p)) for p in ((12, 0, 0), (40, 0, 0), (0, 40, 0))], absolute)
    for shuffle in (False, True):
        surface = [tuple(map(F, p)) for p in ((3, 3, 7), (3, 7, 3), (7, 3, 3), (-1, 3, 3), (30, 30, 30))]
        kappa = [F(1), F(2), F(3), F(4), F(5)]
        if shuffle:
            surface, kappa = surface[::-1], kappa[::-1]
        yield case("tie" + "-reversed" * shuffle, ["nearest-tie", "curvature", "kappa-range"], "four surface vertices at distance 4; the smallest is (-1,3,3)", one,
                   [[0, 1, 2, 3]], surface, absolute, kappa)
    yield case("near-tie", ["nearest-tie", "curvature", "kappa-range"], "the smallest of them is farther by 2^-42", one, [[0, 1, 2, 3]],
               [(F(3), F(3), F(7)), (F(-1) - F(1, 2**42), F(3), F(3)), (F(7), F(3), F(3))], absolute, [F(1), F(4), F(2)])
    yield case("no-tie", ["curvature", "kappa-range"], "the lexicographically smallest is farther by 2^-20", one, [[0, 1, 2, 3]],
               [(F(3), F(3), F(7)), (F(-1) - F(1, 2**20), F(3), F(3)), (F(7), F(3), F(3))], absolute, [F(1), F(4), F(2)])
    yield case("kappa-range", ["kappa-range", "curvature"], "the largest curvature is at a vertex that is closest to no tetrahedron", one, [[0, 1, 2, 3]],
               [tuple(map(F, p)) for p in ((3, 3, 5), (50, 0, 0), (0, 50, 0))], absolute, [F(2), F(0), F(16)])
    yield case("kappa-equal", ["curvature"], "one curvature everywhere: the weight is 1", one, [[0, 1, 2, 3]],
               [tuple(map(F, p)) for p in ((3, 3, 5), (50, 0, 0), (0, 50, 0))], absolute, [F(2)] * 3)
    points, tets = kuhn_grid(2, F(3, 2))
    surface = [tuple(F(draws.between(-32, 80), 16) for _ in range(3)) for _ in range(40)]
    kappa = [F(draws.between(0, 4000), 64) for _ in surface]
    for p in EXPONENTS:
        for curved in (False, True):
            for unit in ("absolute", "mean-volume"):
                law = {"v0": F(1, 8), "v1": F(1) if unit == "absolute" else F(2), "d1": None if p != 2 else F(1), "p": p, "unit": unit}
                flags = ["average"] + ["default-d1"] * (law["d1"] is None) + ["mean-volume"] * (unit != "absolute") + ["curvature"] * curved
                yield case(f"cube-p{p.numerator}/{p.denominator}-{unit}" + "-curvature" * curved, flags, "48 tetrahedra of one volume, 40 surface vertices at random",
                           points, tets, surface, law, kappa if curved else None)
    # Tetrahedra of many volumes: the cube's points moved a little.
    moved = [tuple(x + F(draws.between(-6, 6), 32) for x in p) for p in points]
    if min(volume(*(moved[v] for v in t)) for t in tets) <= 0:
        raise AssertionError("a moved tetrahedron is not positive")
    for p in EXPONENTS:
        law = {"v0": F(1, 4), "v1": F(2), "d1": None, "p": p, "unit": "mean-volume"}
        yield case(f"moved-p{p.numerator}/{p.denominator}", ["average", "default-d1", "mean-volume", "curvature"], "48 tetrahedra of different volumes", moved, tets, surface, law, kappa)


# --- eq. (3.5)

CHOICE_FLAGS = {
    "pieces-4": "A split into four: the page's L+3.",
    "pieces-3": "A split into three: L+2 (reading D16).",
    "pieces-2": "A split into two: L+1 (reading D16).",
    "l-plus-3": "With L+3 for every split, as printed, another candidate would win.",
    "sum-not-mean": "The candidate with the smallest sum of errors is another one: the mean decides, and more pieces mean a larger denominator.",
    "worst-is-not-best": "The tetrahedron with the largest error is not the one whose split gives the smallest average.",
    "tie": "Candidates tie: the lowest number of a tetrahedron wins (reading D16).",
    "no-gain": "No split gives an average below E_avg: no insertion (reading D17).",
    "dilution": "The sum of errors grows, and yet the average falls, because the pieces are many: eq. (3.5) takes it (reading D17 says when to stop).",
}


def choose(errors, candidates):
    size, total = len(errors), sum(errors)
    e_avg = [(total - errors[c["tet"]] + sum(c["pieces"])) / (size + len(c["pieces"]) - 1) for c in candidates]
    best = min(range(len(candidates)), key=lambda k: (e_avg[k], candidates[k]["tet"]))
    return e_avg, best, e_avg[best] < total / size


def choice_case(name, flags, comment, errors, candidates, draws):
    errors = [F(e) for e in errors]
    candidates = draws.shuffled([{"tet": t, "pieces": [F(e) for e in pieces]} for t, pieces in candidates])
    e_avg, best, lowers = choose(errors, candidates)
    chosen = candidates[best]
    flags = list(flags) + sorted({f"pieces-{len(c['pieces'])}" for c in candidates})
    total = sum(errors)
    by_l3 = min(candidates, key=lambda c: ((total - errors[c["tet"]] + sum(c["pieces"])) / (len(errors) + 3), c["tet"]))
    by_sum = min(candidates, key=lambda c: (sum(c["pieces"]) - errors[c["tet"]], c["tet"]))
    if not lowers:
        flags.append("no-gain")
    else:
        flags += ["l-plus-3"] * (by_l3 is not chosen) + ["sum-not-mean"] * (by_sum is not chosen)
        flags += ["worst-is-not-best"] * (errors[chosen["tet"]] < max(errors)) + ["tie"] * (e_avg.count(min(e_avg)) > 1)
        flags += ["dilution"] * (sum(chosen["pieces"]) > errors[chosen["tet"]])
    return {"id": "choice-" + name, "flags": flags, "comment": comment, "input": {"errors": errors, "candidates": candidates},
            "expected": {"before": total / len(errors), "after_each": e_avg, "tet": chosen["tet"] if lowers else None},
            "tolerance": {"relative": 1e-13}}


def choice():
    draws = Draws(35)
    for m in (2, 3, 4):
        yield choice_case(f"one-{m}", [], f"one tetrahedron of error 8 and its split into {m}", [8], [(0, [F(8, m)] * m if m != 3 else [2, 3, 4])], draws)
        yield choice_case(f"three-{m}", [], f"the same split into {m} of one of three", [1, 8, 1], [(1, [1] * m)], draws)
        yield choice_case(f"tie-{m}", [], "equal candidates: the lowest number", [4, 8, 8, 4, 8], [(t, [1] * m) for t in (4, 2, 1)], draws)
        yield choice_case(f"worst-{m}", [], "the largest error gains least", [10, 6, 1], [(0, [5] * m), (1, [F(1, 2)] * m), (2, [1] * m)], draws)
        yield choice_case(f"no-gain-{m}", [], "each piece is as bad as the average or worse", [2, 2, 2], [(t, [2] * m) for t in range(3)], draws)
        yield choice_case(f"dilution-{m}", [], "a small error becomes several: the average still falls", [8, 8, 8, F(1, 8)], [(3, [F(1, 4)] * m)], draws)
    yield choice_case("mixed-sum", [], "four pieces add to the sum of errors more than two, and to the count as well", [8, 8, 8, 8],
                      [(0, [2, 2]), (1, [1, 2, 2]), (2, [1, 1, 1, F(3, 2)])], draws)
    yield choice_case("mixed-l3", [], "two pieces with a slightly smaller sum against four", [6] * 6, [(0, [F(1), F(1)]), (1, [F(17, 32)] * 4)], draws)
    yield choice_case("mixed-tie", [], "different numbers of pieces, the same average: the lowest number", [4, 4, 4, 12], [(1, [3, 3, 3, 3]), (3, [6, 5])], draws)
    for n in range(24):
        size = draws.between(3, 12)
        errors = [F(draws.between(1, 64), 16) for _ in range(size)]
        candidates = []
        for t in draws.shuffled(range(size))[:draws.between(2, size)]:
            m = draws.choice((2, 3, 4))
            candidates.append((t, [errors[t] * F(draws.between(2, 14), 16) for _ in range(m)] if draws.below(3) else [F(draws.between(1, 32), 16) for _ in range(m)]))
        yield choice_case(f"random-{n:02}", [], "drawn at random", errors, candidates, draws)
