# SPDX-License-Identifier: GPL-3.0-or-later
"""The Hypothesis strategy: valid surfaces, many different ones, and failures that shrink."""

import numpy as np
import pytest
import tetproof
from hypothesis import HealthCheck, find, given, settings
from tetproof.strategies import surfaces
from tetproof.testing import assert_sound

QUIET = settings(max_examples=100, database=None, deadline=None, derandomize=True,
                 suppress_health_check=list(HealthCheck))


def test_surfaces_are_valid_and_different():
    seen = {}

    @QUIET
    @given(surfaces())
    def look(surface):
        assert surface.fault == "" and surface.name.startswith("fuzz:")
        seen[surface.name] = surface

    look()
    assert len(seen) > 30
    for surface in list(seen.values())[:5]:  # the name is the surface
        again = tetproof.generate(surface.name)
        assert again.points.tobytes() == surface.points.tobytes()
        assert (again.triangles == surface.triangles).all()


def test_kinds_and_modifiers():
    @QUIET
    @given(surfaces(kinds=["torus"], modifiers=["none"]))
    def look(surface):
        assert "torus" in surface.name and "+" not in surface.name

    look()
    with pytest.raises(tetproof.InputError, match="no-such-kind"):
        surfaces(kinds=["no-such-kind"])


def toy_mesher(points, triangles):
    """Fills a surface that is star-shaped about its centroid. The planted fault: it fills any other, too."""
    centre = points[np.unique(triangles)].mean(axis=0)
    tets = np.column_stack([np.full(len(triangles), len(points)), triangles])
    return np.vstack([points, centre]), tets


def test_a_planted_fault_is_found_and_shrunk():
    def fails(surface):
        try:
            assert_sound(toy_mesher(*surface), surface, fidelity=1e-9, voxels=0, decide_only=True)
        except AssertionError:
            return True
        return False

    smallest = find(surfaces(kinds=["torus", "comb", "cylinder"]), fails, settings=QUIET)
    assert len(smallest.triangles) <= 44 and "+" not in smallest.name, smallest
    assert not fails(tetproof.generate("fuzz:uv-sphere(n=6,m=4)"))


def test_hypothesis_prints_the_name(said_by_pytest):
    _, out = said_by_pytest(
        "from hypothesis import given, settings\n"
        "from tetproof.strategies import surfaces\n"
        "@settings(database=None, deadline=None, derandomize=True)\n"
        "@given(surfaces(kinds=['torus'], modifiers=['none']))\n"
        "def test_mesher(surface):\n"
        "    assert len(surface.triangles) < 5\n")
    assert "surface=<tetproof.Surface fuzz:torus(n=3,m=3,r=0.5): 9 points, 18 triangles>" in out
