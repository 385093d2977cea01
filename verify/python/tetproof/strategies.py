# SPDX-License-Identifier: GPL-3.0-or-later
"""For Hypothesis: random closed surfaces that are hard for meshers, each proved to be valid.

    from hypothesis import given, settings
    from tetproof.strategies import surfaces
    from tetproof.testing import assert_sound

    @settings(deadline=None)
    @given(surfaces())
    def test_my_mesher(surface):
        assert_sound(my_mesher(*surface), surface, fidelity=1e-9)

A failing surface shrinks towards few parts, no modifiers and simple numbers. Hypothesis prints its name,
"fuzz:RECIPE", which `tetproof.generate` and every program of tetproof take.
"""
from __future__ import annotations

import functools
from typing import Iterable

from hypothesis import strategies as st

from . import _core
from ._arrays import InputError, file_name
from ._surfaces import Surface, fuzz, generate

# A random case is drawn, bit by bit, and then steps that make it simpler. Nearly all values of a step leave
# the surface as it is, so that random cases keep their difficulty; the smallest values take a simpler
# surface, the smallest of all the most drastically simpler one. Hypothesis shrinks by trying smaller values.
# It also makes new examples by repeating parts of earlier ones: with many bits and few steps most of these
# are new surfaces (about half of 200 examples; a fifth, if the case were one number).
_BITS = 24
_STEPS = 16
_CHOICES = 64
_VALUES_OF_A_STEP = range(16384)


def surfaces(*, seed: int = 1, kinds: Iterable[str] = (), modifiers: Iterable[str] = (),
             most_triangles: int = 2000, extreme_sizes: bool = False) -> st.SearchStrategy[Surface]:
    """Surfaces that are closed, 2-manifold, oriented outward and free of self-intersections.

    `seed`: whose cases are drawn. The others choose among surfaces as for `tetproof.fuzz`; "none" as the only
    modifier leaves them out, which makes the surfaces easier.
    """
    chosen = {"kinds": tuple(kinds), "modifiers": tuple(modifiers), "most_triangles": most_triangles,
              "extreme_sizes": extreme_sizes}
    _case(seed, 0, **chosen)  # an unknown kind is told here, and not when a test runs

    @st.composite
    def cases(draw: st.DrawFn) -> Surface:
        index = 0
        for _ in range(_BITS):
            index = 2 * index + draw(st.booleans())
        surface = _case(seed, index, **chosen)
        for _ in range(_STEPS):
            step = draw(st.sampled_from(_VALUES_OF_A_STEP))
            if step < _CHOICES:
                surface = _simpler(surface, step)
        return surface

    return cases()


# Shrinking asks for the same surfaces again and again.
_case = functools.lru_cache(maxsize=256)(fuzz)


@functools.lru_cache(maxsize=1024)
def _simpler(surface: Surface, choice: int) -> Surface:
    """The simpler surface of this number, the most drastic first; the same one if there is no valid one."""
    names = _core.simpler(file_name(surface.name), choice + 1)
    if choice >= len(names):
        return surface
    try:
        made = generate(names[choice])
    except InputError:  # the recipe builds no valid surface
        return surface
    return surface if made.fault else made
