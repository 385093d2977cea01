# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact arithmetic for the vectors: points of fractions, roots to 60 digits, and draws that are the same everywhere."""
from decimal import Decimal, getcontext
from fractions import Fraction
from itertools import combinations

getcontext().prec = 80
PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494459230781640628620899862803")
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


def arctangent(y, x):
    """The angle of (x, y), y >= 0, between 0 and pi, to 60 digits: Decimals in and out."""
    if y == 0:
        return Decimal(0) if x > 0 else PI
    halvings = 0
    t = y / ((x * x + y * y).sqrt() + x) if x > 0 or y > abs(x) else None  # the tangent of half the angle
    if t is None:
        return PI - arctangent(y, -x)
    while t > Decimal("0.01"):
        t = t / (1 + (1 + t * t).sqrt())
        halvings += 1
    power, total, k = t, Decimal(0), 1
    while abs(power) > Decimal(10) ** -75:
        total += power / k if k % 4 == 1 else -power / k
        power *= t * t
        k += 2
    return total * 2 ** (halvings + 1)


def tangent(angle):
    """The tangent of a Decimal between 0 and pi/2, to 60 digits."""
    x, halvings = angle, 0
    while x > Decimal("0.01"):
        x, halvings = x / 2, halvings + 1
    sine, term, k = Decimal(0), x, 1
    while abs(term) > Decimal(10) ** -80:
        sine += term
        term *= -x * x / ((k + 1) * (k + 2))
        k += 2
    t = sine / (1 - sine * sine).sqrt()
    for _ in range(halvings):
        t = 2 * t / (1 - t * t)
    return t


def decimal(x):
    """A Decimal of a fraction, to 80 digits."""
    x = Fraction(x)
    return Decimal(x.numerator) / Decimal(x.denominator)
