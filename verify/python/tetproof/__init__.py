# SPDX-License-Identifier: GPL-3.0-or-later
"""tetproof: an exact judge of tetrahedral meshes, a mesh format toolkit, and a reference grid generator.

    import tetproof
    report = tetproof.verify(points, tets, surface=(points, triangles))
    report.verdict, report.findings
    print(report)

Beside it: `tetproof.testing` for pytest, `tetproof.strategies` for Hypothesis.
"""
from __future__ import annotations

import os as _os
import pathlib as _pathlib

from . import _core
from ._arrays import InputError
from ._documents import (
    Block, Document, FileWarning, Loss, LossError, Losses, LossWarning, convert, read, write)
from ._judge import Comparison, compare, list_checks, verify
from ._meshes import as_document
from ._report import Check, Finding, NotJudged, Report
from ._surfaces import Grid, Surface, as_surface, fuzz, generate, list_surfaces, mesh

__version__: str = _core.version
__all__ = [
    "Block", "Check", "Comparison", "Document", "FileWarning", "Finding", "Grid", "InputError", "Loss",
    "LossError", "LossWarning", "Losses", "NotJudged", "Report", "Surface", "as_document", "as_surface",
    "compare", "convert", "fuzz", "generate", "list_checks", "list_surfaces", "mesh", "read", "verify",
    "write",
]


def _say_where_the_helper_is() -> None:
    """A program reads what only Gmsh reads. It stands in the build folder, or in libexec below the prefix."""
    above = list(_pathlib.Path(_core.__file__).parents)
    places = [above[2], *(prefix / "libexec/tetproof" for prefix in above[3:5])]
    for place in places:
        if _os.access(place / "tetproof-gmsh-import", _os.X_OK):
            _os.environ.setdefault("TETPROOF_GMSH_IMPORT", str(place / "tetproof-gmsh-import"))
            return


_say_where_the_helper_is()
