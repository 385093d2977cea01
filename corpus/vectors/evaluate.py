#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The parametric definitions of the generated surfaces, written after SURFACES.md with Python's standard library alone.

usage: evaluate.py SPEC U V           prints the point at (u,v), as in: evaluate.py torus:R=1,r=0.4 0.25 0
       evaluate.py SPEC FILE.obj      checks that every corner of every face has the place that its (u,v) says; exit code 1 if not"""
import math
import sys

PRESETS = {"sphere": {"r": 1}, "torus": {"R": 1, "r": 0.4}, "shells": {"r": 1, "inner": 0.5, "count": 2},
           "random": {"seed": 1, "r": 1, "roughness": 0.5, "waves": 1.5}, "wing": {"naca": "0012", "chord": 1, "span": 3}}


def direction(u, v):
    """The unit vector of the unfolded octahedron."""
    x, y, z = u, v, 1 - abs(u) - abs(v)
    if z < 0:
        x, y = math.copysign(1 - abs(v), u), math.copysign(1 - abs(u), v)
    length = math.sqrt(x * x + y * y + z * z)
    return x / length, y / length, z / length


class Random:
    """The 64-bit Mersenne Twister, MT19937-64, as the C++ standard seeds it."""

    def __init__(self, seed):
        self.state = [seed % 2**64]
        for i in range(1, 312):
            before = self.state[-1]
            self.state.append((6364136223846793005 * (before ^ before >> 62) + i) % 2**64)
        self.next = 312

    def word(self):
        if self.next == 312:
            for i in range(312):
                mixed = (self.state[i] & 0xFFFFFFFF80000000) | (self.state[(i + 1) % 312] & 0x7FFFFFFF)
                self.state[i] = self.state[(i + 156) % 312] ^ mixed >> 1 ^ (0xB5026F5AA96619E9 if mixed & 1 else 0)
            self.next = 0
        x = self.state[self.next]
        self.next += 1
        x ^= x >> 29 & 0x5555555555555555
        x ^= x << 17 & 0x71D67FFFEDA60000
        x ^= x << 37 & 0xFFF7EEE000000000
        return x ^ x >> 43

    def unit(self):
        return (self.word() >> 11) * 2.0**-53

    def between(self, low, high):
        return low + (high - low) * self.unit()


def modes(seed, waves):
    """The twelve (frequency, phase, amplitude) of a random surface."""
    random, drawn = Random(seed), []
    for _ in range(12):
        while True:
            f = [random.between(-1, 1) for _ in range(3)]
            if sum(x * x for x in f) <= 1:
                break
        drawn.append(([waves * x for x in f], random.unit(), random.between(0.5, 1)))
    total = sum(a for _, _, a in drawn)
    return [(f, phase, a / total) for f, phase, a in drawn]


def evaluator(spec):
    """The function of (u,v) for a specification such as "torus:R=1,r=0.4"."""
    name, _, rest = spec.partition(":")
    given = dict(PRESETS[name], x=0, y=0, z=0)
    for item in filter(None, rest.split(",")):
        key, _, value = item.partition("=")
        given[key] = value if key == "naca" else float(value)
    centre = [given["x"], given["y"], given["z"]]
    place = lambda p: tuple(c + x for c, x in zip(centre, p))
    if name == "sphere":
        return lambda u, v: place(given["r"] * x for x in direction(u, v))
    if name == "torus":
        def torus(u, v):
            ring = given["R"] + given["r"] * math.cos(2 * math.pi * v)
            return place((ring * math.cos(2 * math.pi * u), ring * math.sin(2 * math.pi * u), given["r"] * math.sin(2 * math.pi * v)))
        return torus
    if name == "shells":
        def shells(u, v):
            i = math.floor((u + 2) / 4)
            radius = given["r"] + (given["inner"] - given["r"]) * i / (given["count"] - 1)
            return place(radius * x for x in direction(u - 4 * i, v))
        return shells
    if name == "random":
        drawn = modes(int(given["seed"]), given["waves"])

        def random(u, v):
            d = direction(u, v)
            bump = sum(a * math.cos(2 * math.pi * (sum(f * x for f, x in zip(frequency, d)) + phase)) for frequency, phase, a in drawn)
            return place(given["r"] * (1 + given["roughness"] * bump) * x for x in d)
        return random
    m, p, t = int(given["naca"][0]) / 100, int(given["naca"][1]) / 10, int(given["naca"][2:]) / 100

    def wing(u, v):
        s = math.sin(math.pi / 2 * abs(u))
        x = s * s
        thick = 5 * t * s * (1 - s) * (0.2969 + 0.1709 * (s + s**2) - 0.1807 * (s**3 + s**4) + 0.1036 * (s**5 + s**6))
        if m == 0:
            line = slope = 0
        elif x < p:
            line, slope = m / p**2 * (2 * p * x - x * x), 2 * m / p**2 * (p - x)
        else:
            line, slope = m / (1 - p)**2 * (1 - 2 * p + 2 * p * x - x * x), 2 * m / (1 - p)**2 * (p - x)
        part = max(0, 1 - max(0, -v, v - 1))
        half = math.copysign(thick * part, u) / math.sqrt(1 + slope * slope)
        return place((given["chord"] * (x - half * slope), given["span"] * min(max(v, 0), 1), given["chord"] * (line + half)))
    return wing


def check(spec, path):
    """The largest distance between a corner and the place of its (u,v), and the number of corners."""
    evaluate, points, texture, worst, corners = evaluator(spec), [], [], 0, 0
    with open(path, encoding="utf-8") as file:
        for words in map(str.split, file):
            if words[:1] == ["v"]:
                points.append(tuple(map(float, words[1:4])))
            elif words[:1] == ["vt"]:
                texture.append(tuple(map(float, words[1:3])))
            elif words[:1] == ["f"]:
                for point, uv in (map(int, corner.split("/")[:2]) for corner in words[1:]):
                    worst = max(worst, math.dist(points[point - 1], evaluate(*texture[uv - 1])))
                    corners += 1
    return worst, corners


def main(words):
    if len(words) == 3:
        print(*evaluator(words[0])(float(words[1]), float(words[2])))
        return 0
    if len(words) == 2:
        worst, corners = check(*words)
        print(f"{corners} corners, at most {worst:.1e} from the place of their (u,v)")
        return 0 if corners and worst < 1e-13 else 1
    print(__doc__, file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
