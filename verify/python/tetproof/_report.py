# SPDX-License-Identifier: GPL-3.0-or-later
"""The judge's report as a Python object."""
from __future__ import annotations

import dataclasses
import html
import json
from fractions import Fraction
from typing import Any, NoReturn

from . import _core


@dataclasses.dataclass(frozen=True)
class Finding:
    """A place where a check does not hold.

    Numbers are those of the mesh that was given. Of arrays, and of meshio's, PyVista's and VTK's meshes, they
    are positions from 0: `vertices` and `faces` in the points, `tets` among all cells, or among the
    tetrahedra where there are arrays of them alone. Of a file or a Document they are the file's numbers.
    """

    check: str  #: the id of the check
    what: str  #: what is wrong, for people
    tets: tuple[int, ...]  #: the tetrahedra
    vertices: tuple[int, ...]  #: points
    faces: tuple[tuple[int, int, int], ...]  #: three points each
    point: tuple[float, float, float] | None  #: a place [length]
    point_exact: tuple[Fraction, Fraction, Fraction] | None  #: the same, where float64 rounds it
    consequences: dict[str, int]  #: findings of other checks that follow from it, by their ids
    #: the tetrahedra as positions among the mesh's tetrahedra, from 0, whatever `tets` counts
    rows: tuple[int, ...]
    #: all of them, as runs from first to last, where `tets` has a part
    tet_runs: tuple[tuple[int, int], ...] = ()


@dataclasses.dataclass(frozen=True)
class Check:
    """The result of one check. verify/checks/checks.md explains each."""

    id: str
    verdict: str  #: "pass", "warning", "fail", "undecided" or "skipped"
    exact: bool  #: it rests on exact decisions alone
    count: int  #: findings that do not follow from others
    consequences: int  #: findings that follow from those of other checks
    measured: float | None
    allowed: float | None
    findings: tuple[Finding, ...]  #: the first of those that `count` counts
    why: str = ""  #: the reason, if it was skipped


@dataclasses.dataclass(frozen=True)
class NotJudged:
    """Elements or checks that the verdict does not cover."""

    what: str
    count: int
    why: str


class Report:
    """What the judge says of a mesh.

    `str(report)` is the report for people, `to_dict()` what `tetproof-verify --json` writes. A report has
    three verdicts, so it is neither true nor false: ask for `report.sound`. In a notebook it shows as a
    table. It keeps its copy of the mesh, for `defects` and `to_html`.
    """

    def __init__(self, core: _core.Report) -> None:
        self._core = core
        self._json = core.json()
        self._parts: dict[str, Any] = json.loads(self._json)
        rows = core.rows()
        self._checks = {c["id"]: _check(c, of_check) for c, of_check in zip(self._parts["checks"], rows)}

    @property
    def verdict(self) -> str:
        """"sound", "defective" or "incomplete": nothing is wrong, but not everything was judged."""
        return self._parts["verdict"]

    @property
    def sound(self) -> bool:
        """No check failed, and everything was judged."""
        return self.verdict == "sound"

    @property
    def defective(self) -> bool:
        """A check failed."""
        return self.verdict == "defective"

    @property
    def incomplete(self) -> bool:
        """No check failed, and not everything was judged."""
        return self.verdict == "incomplete"

    @property
    def certificate(self) -> bool | None:
        """Whether the mesh is proved to be a valid triangulation of a solid. None: checks of the proof were
        skipped."""
        return self._parts["certificate"]

    @property
    def summary(self) -> str:
        """The first line of the text."""
        return self._core.verdict_text()

    @property
    def checks(self) -> dict[str, Check]:
        """All checks by their ids, causes before what follows from them."""
        return dict(self._checks)

    @property
    def findings(self) -> tuple[Finding, ...]:
        """The findings of all checks, in the order of the checks; of each check the first ones."""
        return tuple(finding for check in self._checks.values() for finding in check.findings)

    @property
    def not_judged(self) -> tuple[NotJudged, ...]:
        """What should have been judged and was not: with any of it no verdict is sound."""
        return tuple(NotJudged(**entry) for entry in self._parts["not_judged"])

    @property
    def left_out(self) -> tuple[NotJudged, ...]:
        """What the options left out."""
        return tuple(NotJudged(**entry) for entry in self._parts["left_out"])

    def to_dict(self) -> dict[str, Any]:
        """The report as `tetproof-verify --json` writes it; verify/reports/report.schema.json has the keys.
        """
        return json.loads(self._json)

    def to_json(self) -> str:
        """The text that `tetproof-verify --json` writes."""
        return self._json

    def to_junit(self, name: str = "mesh") -> str:
        """The report as JUnit XML, with a test case for each check. `name`: what the mesh is called there."""
        return self._core.junit(name)

    def to_html(self, name: str = "mesh") -> str:
        """The page that `tetproof-verify --html` writes: findings, checks, histograms, and the mesh with its
        defects in three dimensions. It opens from disk in any browser. `name`: what the mesh is called there.
        """
        return self._core.html(name)

    def failure_text(self, most: int = 5) -> str:
        """The verdict, what was not judged, and the checks that failed, with the first `most` findings in
        all."""
        return self._core.failure_text(most)

    def defects(self) -> Any:
        """A Document of the tetrahedra that the findings name and one ring around them, for a viewer.

        Each check with findings is an array of the cells, called by its id: 1 on the elements that it names.
        `tetproof.write("defects.vtu", report.defects())` is `tetproof-verify --defects`.
        """
        from ._documents import Document

        return Document(self._core.defects())

    def __str__(self) -> str:
        return self._core.text()

    def __repr__(self) -> str:
        return f"<tetproof.Report {self.summary}>"

    def __bool__(self) -> NoReturn:
        raise TypeError("a report is sound, defective or incomplete, so it is neither true nor false: "
                        "ask for report.sound or report.verdict")

    def __reduce__(self) -> NoReturn:
        raise TypeError("a report is not pickled or copied: hand on report.to_dict() or report.to_json()")

    def _repr_html_(self) -> str:
        mesh, volume = self._parts["mesh"], self._parts["volume"]["mesh"]
        facts = f"{mesh['tets']} tetrahedra, {mesh['points']} points, {mesh['boundary_faces']} boundary faces"
        if volume is not None:
            facts += f", volume {volume:.12g}"
        rows = [("", html.escape(self.summary), "")]
        for entry in self.not_judged:
            rows.append(("not judged", html.escape(f"{entry.count} {entry.what}"), html.escape(entry.why)))
        for check in self._checks.values():
            if check.verdict not in ("pass", "skipped"):
                rows.append((check.verdict, html.escape(check.id), _findings_html(check)))
        rows.append(("", html.escape(facts), ""))
        cell = "<td style='text-align:left;vertical-align:top'>"
        lines = "".join("<tr>" + "".join(f"{cell}{text}</td>" for text in row) + "</tr>" for row in rows)
        return f"<table class='tetproof-report'>{lines}</table>"


def _check(result: dict[str, Any], rows: list[list[int]]) -> Check:
    findings = tuple(_finding(result["id"], finding, of_finding)
                     for finding, of_finding in zip(result["findings"], rows))
    return Check(id=result["id"], verdict=result["verdict"], exact=result["exact"], count=result["count"],
                 consequences=result["consequences"], measured=result["measured"], allowed=result["allowed"],
                 findings=findings, why=result.get("why", ""))


def _finding(check: str, finding: dict[str, Any], rows: list[int]) -> Finding:
    exact = finding["point_exact"]
    point = finding["point"]
    return Finding(
        check=check, what=finding["what"], tets=tuple(finding["tets"]), vertices=tuple(finding["vertices"]),
        faces=tuple((a, b, c) for a, b, c in finding["faces"]),
        point=None if point is None else (point[0], point[1], point[2]),
        point_exact=None if exact is None else (Fraction(exact[0]), Fraction(exact[1]), Fraction(exact[2])),
        consequences={c["check"]: c["count"] for c in finding["consequences"]}, rows=tuple(rows),
        tet_runs=tuple((first, last) for first, last in finding.get("tet_runs", ())))


def _findings_html(check: Check, most: int = 3) -> str:
    """The first findings of a check, a line for each, and the number of the others."""
    lines = []
    for finding in check.findings[:most]:
        kind, numbers = ("tetrahedra", finding.tets) if finding.tets else ("points", finding.vertices)
        named = ", ".join(map(str, numbers[:5])) + (", ..." if len(numbers) > 5 else "")
        lines.append(html.escape((f"{kind} {named}: " if numbers else "") + finding.what))
    if check.count > len(lines):
        lines.append(f"{check.count - len(lines)} more")
    if check.consequences:
        lines.append(f"{check.consequences} that follow from other findings")
    return "<br>".join(lines)
