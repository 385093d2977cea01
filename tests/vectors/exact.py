# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact arithmetic for the vectors: points of fractions, roots to 60 digits, and draws that are the same everywhere."""
from fractions import Fraction
from itertools import combinations

FACES = ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))  # of a positive tetrahedron, seen from outside anticlockwise


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def mean(points):
    return tuple(sum(column, Fraction(0)) / len(points) for column in zip(*points))


def volume(a, b, c, d):
    """(b-a) x (c-a) . (d-a) / 6."""
    return Fraction(dot(cross(sub(b, a), sub(c, a)), sub(d, a))) / 6


def along(a, b, t):
    """The point a + t (b - a)."""
    return tuple(x + t * (y - x) for x, y in zip(a, b))


def integer_root(n, k):
    """The largest r with r^k <= n."""
    low, high = 0, 1 << (n.bit_length() // k + 1)
    while low < high:
        middle = (low + high + 1) // 2
        low, high = (middle, high) if middle**k <= n else (low, middle - 1)
    return low


def root(x, k):
    """The k-th root of a fraction x >= 0: exact where it is rational, else within 1e-60 of it, relatively."""
    x = Fraction(x)
    top, bottom = integer_root(x.numerator, k), integer_root(x.denominator, k)
    if top**k == x.numerator and bottom**k == x.denominator:
        return Fraction(top, bottom)
    shift = 256 + x.denominator.bit_length()
    return Fraction(integer_root((x.numerator << (k * shift)) // x.denominator, k), 1 << shift)


def power(t, p):
    """t^p for a fraction p."""
    return root(Fraction(t) ** p.numerator, p.denominator)


def disjoint(s, t):
    """Whether the interiors of two tetrahedra (four points each) have nothing in common: some plane parallel to a face of one,
    or to an edge of each, separates them."""
    normals = [cross(sub(one[b], one[a]), sub(one[c], one[a])) for one in (s, t) for a, b, c in FACES]
    edges = [[sub(b, a) for a, b in combinations(one, 2)] for one in (s, t)]
    normals += [cross(e, f) for e in edges[0] for f in edges[1]]
    for n in normals:
        if any(n):
            first, second = [dot(n, p) for p in s], [dot(n, p) for p in t]
            if max(first) <= min(second) or max(second) <= min(first):
                return True
    return False


class Draws:
    """A linear congruential generator (Knuth's MMIX), so that every version of Python draws the same."""

    def __init__(self, seed):
        self.state = seed
        for _ in range(3):
            self.below(2)

    def below(self, n):
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % 2**64
        return (self.state >> 33) % n

    def between(self, low, high):
        return low + self.below(high - low + 1)

    def choice(self, items):
        return items[self.below(len(items))]

    def shuffled(self, items):
        items = list(items)
        for i in range(len(items) - 1, 0, -1):
            j = self.below(i + 1)
            items[i], items[j] = items[j], items[i]
        return items
