// SPDX-License-Identifier: GPL-3.0-or-later
// The first line of a report, in every case: what was judged, what was found, what was not judged.
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "verify/findings_text.hpp"
#include "verify/report.hpp"

namespace tetproof::test {
namespace {

using verify::Check;
using verify::CheckResult;
using verify::Report;
using verify::Verdict;

// A report of 78 tetrahedra in which every check holds; those against a surface only with one.
Report report(bool with_surface) {
  Report made;
  made.certificate = true;
  made.mesh.tets = 78;
  for (int i = 0; i < verify::check_count; ++i) {
    const auto check = static_cast<Check>(i);
    made.checks.push_back({.check = check});
    if (with_surface || !info(check).needs_surface) made.checks.back().verdict = Verdict::pass;
  }
  return made;
}

void set(Report& made, Check check, Verdict verdict, std::int64_t count = 1) {
  CheckResult& result = made.checks[static_cast<std::size_t>(check)];
  result.verdict = verdict;
  result.count = count;
  result.consequences = verdict == Verdict::fail ? 2 : 0;
}

struct Case {
  std::string name;
  bool with_surface;
  std::function<void(Report&)> change;
  std::string line;
};

void refuse(Report& made) {
  made.certificate = false;
  set(made, Check::inverted, Verdict::fail);
  set(made, Check::face_orientation, Verdict::fail, 0);
}
void miss(Report& made) {
  set(made, Check::missing_region, Verdict::fail);
  set(made, Check::volume_surface, Verdict::fail, 0);
  set(made, Check::surface_to_mesh, Verdict::fail);
}
void open(Report& made) {
  made.certificate = std::nullopt;
  made.left_out.push_back({"check overlap", 1, "not asked for"});
}
void hang(Report& made) {
  set(made, Check::hanging_node, Verdict::fail);
}
void mix(Report& made) {
  made.not_judged = {{"prisms", 8, "only tetrahedra are judged"},
                     {"pyramids", 1, "only tetrahedra are judged"}};
}
void empty(Report& made) {
  made.certificate = std::nullopt;
  made.mesh.tets = 0;
  made.not_judged.push_back({"mesh", 1, "it has no tetrahedra"});
}

const std::vector<Case> cases{
    {"Sound", false, [](Report&) {}, "sound: certified: 78 tetrahedra, a valid triangulation of a solid"},
    {"SoundAndFills", true, [](Report&) {},
     "sound: certified: 78 tetrahedra, a valid triangulation of a solid that fills the surface"},
    {"OneTetrahedron", false, [](Report& r) { r.mesh.tets = 1; },
     "sound: certified: 1 tetrahedron, a valid triangulation of a solid"},
    {"SoundAsFarAsAsked", false, open,
     "sound: only as far as asked: 78 tetrahedra without a certificate; left out: check overlap"},
    {"SoundAsFarAsAskedAndFills", true, open,
     "sound: only as far as asked: 78 tetrahedra without a certificate, which fill the surface; left out: "
     "check overlap"},
    {"LeftOutOfTheComparison", true,
     [](Report& r) {
       set(r, Check::volume_voxel, Verdict::skipped, 0);
       r.left_out = {{"check volume-voxel", 1, "not asked for"}};
     },
     "sound: certified: 78 tetrahedra, a valid triangulation of a solid; left out: check volume-voxel"},
    {"ManyLeftOut", false,
     [](Report& r) {
       r.left_out = {{"hexahedra", 2, "why"}, {"checks flat, overlap, crack, cavity", 4, "why"}};
     },
     "sound: certified: 78 tetrahedra, a valid triangulation of a solid; left out: 2 hexahedra, 4 checks"},
    {"Undecided", true, [](Report& r) { set(r, Check::mesh_to_surface, Verdict::undecided, 0); },
     "sound: certified: 78 tetrahedra, a valid triangulation of a solid; undecided: mesh-to-surface"},
    {"Warnings", true,
     [](Report& r) {
       set(r, Check::cavity, Verdict::warning);
       set(r, Check::normals, Verdict::warning);
     },
     "sound: certified: 78 tetrahedra, a valid triangulation of a solid that fills the surface; warnings: "
     "cavity, normals"},
    {"WarnsThatItDoesNotFill", true, [](Report& r) { set(r, Check::missing_region, Verdict::warning); },
     "sound: certified: 78 tetrahedra, a valid triangulation of a solid; warnings: missing-region"},
    {"Allowed", false,
     [](Report& r) {
       r.certificate = false;
       set(r, Check::crack, Verdict::warning);
     },
     "sound: no certificate, but nothing is wrong that is not allowed: 78 tetrahedra; warnings: crack"},

    {"Mixed", false, mix, "incomplete: certified: 78 tetrahedra; not judged: 8 prisms, 1 pyramid"},
    {"MixedAndFills", true, mix,
     "incomplete: certified: 78 tetrahedra that fill the surface; not judged: 8 prisms, 1 pyramid"},
    {"MixedWithWarnings", false,
     [](Report& r) {
       mix(r);
       set(r, Check::cavity, Verdict::warning);
     },
     "incomplete: certified: 78 tetrahedra; warnings: cavity; not judged: 8 prisms, 1 pyramid"},
    {"ByCorners", false,
     [](Report& r) {
       r.by_corners = true;
       r.not_judged = {{"curved shapes", 78, "why"}};
     },
     "incomplete: certified by corners: 78 tetrahedra; not judged: 78 curved shapes"},
    {"MixedAndNotAsked", false,
     [](Report& r) {
       open(r);
       mix(r);
     },
     "incomplete: no certificate, checks that it needs were not made: 78 tetrahedra; not judged: 8 prisms, 1 "
     "pyramid; left out: check overlap"},
    {"AllowedAndMixed", false,
     [](Report& r) {
       mix(r);
       r.certificate = false;
       set(r, Check::crack, Verdict::warning);
     },
     "incomplete: no certificate, but nothing was found that is not allowed: 78 tetrahedra; warnings: crack; "
     "not judged: 8 prisms, 1 pyramid"},
    {"Empty", false, empty, "incomplete: no certificate, the mesh is empty; not judged: mesh"},

    {"Refused", false, refuse, "DEFECTIVE: no certificate, no valid triangulation of a solid (inverted)"},
    {"RefusedAndFills", true, refuse,
     "DEFECTIVE: no certificate, no valid triangulation of a solid (inverted)"},
    {"RefusedAndMisses", true,
     [](Report& r) {
       refuse(r);
       miss(r);
     },
     "DEFECTIVE: no certificate, no valid triangulation of a solid (inverted); nor does it fill the surface "
     "(missing-region, surface-to-mesh)"},
    {"Misses", true, miss,
     "DEFECTIVE: the mesh does not fill the surface (missing-region, surface-to-mesh); by itself it is a "
     "valid triangulation (certified: 78 tetrahedra)"},
    {"MissesByAConsequenceOfAWarning", true,
     [](Report& r) {
       set(r, Check::missing_region, Verdict::warning);
       set(r, Check::volume_surface, Verdict::fail, 0);
     },
     "DEFECTIVE: the mesh does not fill the surface (volume-surface); by itself it is a valid triangulation "
     "(certified: 78 tetrahedra)"},
    {"Hangs", false, hang,
     "DEFECTIVE: hanging-node, though by exact arithmetic the mesh is a valid triangulation (certified: 78 "
     "tetrahedra)"},
    {"HangsAndMisses", true,
     [](Report& r) {
       hang(r);
       miss(r);
     },
     "DEFECTIVE: hanging-node, and the mesh does not fill the surface (missing-region, surface-to-mesh), "
     "though by exact arithmetic it is a valid triangulation (certified: 78 tetrahedra)"},
    {"HangsAndNotAsked", false,
     [](Report& r) {
       open(r);
       hang(r);
     },
     "DEFECTIVE: hanging-node; no certificate, checks that it needs were not made; left out: check overlap"},
    {"HangsMissesAndNotAsked", true,
     [](Report& r) {
       open(r);
       hang(r);
       miss(r);
     },
     "DEFECTIVE: hanging-node, and the mesh does not fill the surface (missing-region, surface-to-mesh); no "
     "certificate, checks that it needs were not made; left out: check overlap"},
    {"MissesAndNotAsked", true,
     [](Report& r) {
       open(r);
       miss(r);
     },
     "DEFECTIVE: the mesh does not fill the surface (missing-region, surface-to-mesh); no certificate, "
     "checks that it needs were not made; left out: check overlap"},
    {"MissesAndAllowed", true,
     [](Report& r) {
       r.certificate = false;
       set(r, Check::crack, Verdict::warning);
       miss(r);
     },
     "DEFECTIVE: the mesh does not fill the surface (missing-region, surface-to-mesh); no certificate"},
    {"EmptyAndMisses", true,
     [](Report& r) {
       empty(r);
       miss(r);
     },
     "DEFECTIVE: the mesh does not fill the surface (missing-region, surface-to-mesh): no certificate, it is "
     "empty; not judged: mesh"},
    {"DefectiveByCornersAndMixed", true,
     [](Report& r) {
       r.by_corners = true;
       mix(r);
       set(r, Check::off_surface_vertex, Verdict::fail);
     },
     "DEFECTIVE: the mesh does not fill the surface (off-surface-vertex); by itself it is a valid "
     "triangulation (certified by corners: 78 tetrahedra); not judged: 8 prisms, 1 pyramid"},
};

TEST(Verdict, TheFirstLineInEveryCase) {
  for (const Case& c : cases) {
    Report made = report(c.with_surface);
    c.change(made);
    EXPECT_EQ(verdict_text(made), c.line) << c.name;
  }
}

// No combination of proof, failures, warnings and scope is without a line, and none is called sound that
// lacks anything.
TEST(Verdict, EveryCombinationHasALine) {
  for (int bits = 0; bits < 256; ++bits) {
    Report made = report(bits & 1);
    if (bits & 2) made.certificate = std::nullopt;
    if (bits & 4) refuse(made);
    if (bits & 8) hang(made);
    if ((bits & 16) && (bits & 1)) miss(made);
    if (bits & 32) mix(made);
    if (bits & 64) empty(made);
    if (bits & 128) set(made, Check::near_contact, Verdict::warning);
    const std::string line = verdict_text(made);
    const bool fails = bits & (4 | 8) || ((bits & 16) && (bits & 1)), lacks = bits & (32 | 64);
    EXPECT_EQ(line.substr(0, line.find(':')), fails ? "DEFECTIVE" : lacks ? "incomplete" : "sound") << line;
    EXPECT_EQ(line.find("certified") != line.npos, made.certificate == true) << line;
    EXPECT_EQ(line.find("not judged: ") != line.npos, lacks) << line;
    EXPECT_EQ(line.find("near-contact") != line.npos, !fails && (bits & 128)) << line;
  }
}

TEST(Verdict, TheReasonsFollow) {
  Report made = report(false);
  mix(made);
  made.not_judged.push_back({"checks a, b, c, d", 4, "too many pairs"});
  made.left_out.push_back({"hexahedra", 1, "only tetrahedra are judged"});
  EXPECT_EQ(scope_text(made),
            "unjudged  8 prisms: only tetrahedra are judged\n"
            "unjudged  1 pyramid: only tetrahedra are judged\n"
            "unjudged  checks a, b, c, d: too many pairs\n"
            "left out  1 hexahedron: only tetrahedra are judged\n");
}

}  // namespace
}  // namespace tetproof::test
