# SPDX-License-Identifier: GPL-3.0-or-later
"""For the tests of a mesher: assertions that fail with the judge's report.

    from tetproof.testing import assert_sound

    def test_my_mesher():
        assert_sound(my_mesher(surface), surface, fidelity=1e-3)

`tetproof.strategies` makes the surfaces.
"""
from __future__ import annotations

from typing import Any

from . import _judge
from ._report import Report


def assert_sound(mesh: Any = None, tets: Any = None, surface: Any = None, *, certified: bool = False,
                 most: int = 5, **options: Any) -> Report:
    """Asserts that no check fails and that everything was judged, and returns the report.

    Arguments and options are those of `tetproof.verify`: `assert_sound(points, tets, surface)` or
    `assert_sound(mesh, surface)`. `certified`: the mesh must be proved to be a valid triangulation of a
    solid, so that no check of the proof may be left out. AssertionError with the verdict, what was not
    judged, and the first `most` findings, causes before what follows from them; `tetproof.InputError` for
    what cannot be judged.
    """
    __tracebackhide__ = True  # pytest shows the caller's line
    options.setdefault("quality", False)  # measures nothing that could fail
    report = _judge.verify(mesh, tets, surface, **options)
    if not report.sound:
        raise AssertionError(f"the mesh is {report.failure_text(most).rstrip()}")
    if certified and not report.certificate:
        raise AssertionError(f"the mesh has no certificate: {report.summary}")
    return report
