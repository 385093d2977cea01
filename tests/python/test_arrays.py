# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays of every layout and kind: the same numbers give the same report; others are refused."""
import numpy as np
import pytest
import tetproof


@pytest.fixture
def ball():
    return tetproof.mesh("sphere:r=1,n=500", cells=6)


def strided(array):
    wide = np.zeros((2 * len(array), 2 * array.shape[1]), dtype=array.dtype)
    wide[::2, ::2] = array
    return wide[::2, ::2]


def read_only(array):
    array = array.copy()
    array.flags.writeable = False
    return array


LAYOUTS = {
    "C": np.ascontiguousarray, "Fortran": np.asfortranarray, "strided": strided,
    "backwards": lambda a: a[::-1].copy()[::-1],
    "other byte order": lambda a: a.astype(a.dtype.newbyteorder()),
    "read only": read_only, "list": lambda a: a.tolist(), "subclass": lambda a: a.view(np.recarray),
}


@pytest.mark.parametrize("layout", LAYOUTS)
@pytest.mark.parametrize("kind", ["int32", "int64", "uint16", "uint32", "uint64"])
def test_every_layout_gives_the_same_report(ball, layout, kind):
    expected = tetproof.verify(*ball).to_json()
    given = LAYOUTS[layout]
    assert tetproof.verify(given(ball.points), given(ball.tets.astype(kind))).to_json() == expected


def test_the_callers_arrays_stay_as_they_are(ball):
    points, tets = ball.points.copy(), ball.tets.copy()
    tetproof.verify(points, tets)
    assert (points == ball.points).all() and (tets == ball.tets).all()


def test_numbers_of_other_kinds_are_taken_exactly(two_tets):
    points, tets = two_tets
    expected = tetproof.verify(points, tets).to_json()
    for kind in ("float16", "float32", "int8", "int64", "uint64", "longdouble"):
        assert tetproof.verify(points.astype(kind), tets).to_json() == expected


def test_what_float64_cannot_hold_is_refused(two_tets):
    points, tets = two_tets
    large = points.astype(np.int64)
    large[4] = 2**53 + 1
    with pytest.raises(tetproof.InputError, match=r"points: 9007199254740993 at \(4, 0\)"):
        tetproof.verify(large, tets)
    third = points.astype(np.longdouble)
    third[4, 1] = np.longdouble(1) / 3
    with pytest.raises(tetproof.InputError, match=r"\(4, 1\) is no float64"):
        tetproof.verify(third, tets)
    third[4, 1] = np.nan  # which float64 has
    assert tetproof.verify(third, tets).checks["finite-coordinates"].verdict == "fail"


@pytest.mark.parametrize("number", [5, 2**31, 2**40, -1, -7, -2**40])
def test_an_index_that_no_point_has_is_a_finding(two_tets, number):
    points, tets = two_tets
    tets = tets.astype(np.int64)
    tets[1, 3] = number
    report = tetproof.verify(points, tets)
    finding, = report.checks["index-range"].findings
    assert finding.tets == (1,) and report.defective
    assert number in finding.vertices or str(number) in finding.what


@pytest.mark.parametrize("number", [np.nan, np.inf, -np.inf])
def test_what_is_not_finite_is_a_finding(two_tets, number):
    points, tets = two_tets
    points[4, 2] = number
    assert tetproof.verify(points, tets).checks["finite-coordinates"].verdict == "fail"


@pytest.mark.parametrize("points, tets, said", [
    (np.zeros((5, 2)), np.zeros((1, 4), int), r"points: expected the shape \(n, 3\), found \(5, 2\)"),
    (np.zeros(15), np.zeros((1, 4), int), r"points: expected the shape"),
    (np.zeros((2, 5, 3)), np.zeros((1, 4), int), r"points: expected the shape"),
    (np.zeros((5, 3)), np.zeros((1, 3), int), r"tets: expected the shape \(n, 4\), found \(1, 3\)"),
    (np.zeros((5, 3)), np.zeros(4, int), r"tets: expected the shape"),
    (np.zeros((5, 3)), np.zeros((1, 4)), "tets: expected integers, found float64"),
    (np.zeros((5, 3)), np.zeros((1, 4), bool), "tets: expected integers, found bool"),
    (np.zeros((5, 3), complex), np.zeros((1, 4), int), "points: expected real numbers, found complex128"),
    (np.full((5, 3), "a"), np.zeros((1, 4), int), "points: expected real numbers"),
    (np.full((5, 3), None), np.zeros((1, 4), int), "points: expected real numbers, found object"),
    ([[0, 0], [1]], np.zeros((1, 4), int), "points: expected"),
    (np.zeros((5, 3)), np.full((1, 4), 2**64 - 1, np.uint64), "18446744073709551615 is too large"),
    (np.ma.masked_equal([[0.0, 1, 2]], 1), np.zeros((1, 4), int), "masked"),
])
def test_bad_arrays_are_refused(points, tets, said):
    with pytest.raises(tetproof.InputError, match=said):
        tetproof.verify(points, tets)


def test_views_stay_alive_and_cannot_be_written_to():
    points, triangles = tetproof.generate("sphere:r=1,n=500")  # the Surface itself is gone
    assert np.allclose(np.linalg.norm(points, axis=1), 1) and triangles.max() == len(points) - 1
    with pytest.raises(ValueError, match="read-only"):
        points[0, 0] = 5
    grid = tetproof.mesh("sphere:r=1,n=500", cells=6)
    grid.points[0, 0] = 5  # its arrays are the caller's
