# SPDX-License-Identifier: GPL-3.0-or-later
"""assert_sound, as a user's test suite has it."""

import numpy as np
import pytest
import tetproof
from tetproof.testing import assert_sound


def test_it_returns_the_report(two_tets):
    assert assert_sound(*two_tets).sound
    assert assert_sound(*two_tets, certified=True).certificate
    grid = tetproof.mesh("sphere:r=1,n=500", cells=6)
    assert assert_sound(grid, "sphere:r=1,n=500", fidelity=0.2).sound


def test_it_fails_with_the_report(inverted):
    with pytest.raises(AssertionError) as failed:
        assert_sound(*inverted)
    text = str(failed.value)
    assert text.startswith("the mesh is DEFECTIVE: no certificate") and "tetrahedron 1: negative" in text


def test_what_was_not_judged_fails(two_tets):
    points, tets = two_tets
    with pytest.raises(AssertionError, match="incomplete"):
        assert_sound(points, np.empty((0, 4), int))
    assert_sound(points, tets, check="flat")
    with pytest.raises(AssertionError, match="no certificate"):
        assert_sound(points, tets, check="flat", certified=True)


def test_bad_arguments_are_no_failed_assertion(two_tets):
    with pytest.raises(tetproof.InputError):
        assert_sound(two_tets[0], two_tets[1][:, :3])


def test_pytest_shows_the_report_at_the_callers_line(said_by_pytest):
    code, out = said_by_pytest(
        "from tetproof.testing import assert_sound\n"
        "def test_mesher():\n"
        "    points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]\n"
        "    assert_sound(points, [[0, 2, 1, 3]])\n")
    assert code == 1
    assert "tetrahedron 0: negative: volume -0.166667" in out
    assert ">       assert_sound(points, [[0, 2, 1, 3]])" in out
    assert "raise AssertionError" not in out
