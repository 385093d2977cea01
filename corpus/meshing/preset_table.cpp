// SPDX-License-Identifier: GPL-3.0-or-later
// The known meshers: how they are called, what they read and write, and how near they stay to the surface.
//
// Mmg is missing: it improves a mesh that another mesher made, and what is wrong could be the fault of
// either.
#include "corpus/meshing/preset_table.hpp"

#include <string>
#include <utility>
#include <vector>

namespace tetproof::corpus {

namespace {

using Words = std::vector<std::string>;

/// Gmsh, with algorithm `algorithm` on `threads` threads. Binary output keeps every bit of the coordinates.
Words gmsh(const std::string& algorithm, const std::string& threads, const Words& more = {}) {
  Words words{"gmsh", "-3", "-nt", threads, "-setnumber", "Mesh.Algorithm3D", algorithm};
  words.insert(words.end(), more.begin(), more.end());
  for (const char* word : {"{surface}", "-o", "{mesh}", "-format", "msh41", "-bin"}) words.emplace_back(word);
  return words;
}

/// One size everywhere, instead of sizes that the surface's triangles set.
Words uniform(const std::string& size) {
  return {"-setnumber", "Mesh.MeshSizeExtendFromBoundary", "0", "-clmax", size};
}

Preset tetgen() {
  Preset p{"tetgen", "TetGen", {"tetgen"}, {"-h"}, "Version", ".smesh", "surface.1.ele"};
  // It takes neighbours at more than 179.9 degrees for one plane, in which it may place points: some 1e-5 of
  // the diagonal. With -Y it keeps the surface's triangles.
  p.may_change_boundary = true;
  p.fidelity = 1e-4;
  p.variants = {
      {"pY", {"tetgen", "-pY", "{surface}"}, "keeps the surface's triangles", 1, true},
      {"pq", {"tetgen", "-pq", "{surface}"}, "refines for quality"},
      {"pqa", {"tetgen", "-pqa{volume}", "{surface}"}, "quality, and small tetrahedra"},
      {"pYq", {"tetgen", "-pYq", "{surface}"}, "quality inside, keeps the surface's triangles", 1, true},
      {"pYqa", {"tetgen", "-pYqa{volume}", "{surface}"}, "the same, and small tetrahedra", 1, true},
      {"p", {"tetgen", "-p", "{surface}"}, "adds points on the surface where it must"}};
  return p;
}

Preset gmsh_preset() {
  Preset p{"gmsh",    "Gmsh, its Delaunay algorithm and others", {"gmsh"}, {"--version"}, "", ".geo",
           "mesh.msh"};
  p.digits = 0;
  p.variants = {
      {"delaunay", gmsh("1", "1"), "algorithm 1"},
      {"fine", gmsh("1", "1", uniform("{size}")), "one size everywhere: points inside"},
      {"raw", gmsh("1", "1", {"-setnumber", "Mesh.Optimize", "0"}), "without optimization"},
      {"netgen", gmsh("1", "1", {"-optimize_netgen"}), "optimized by Netgen, where it is compiled in"},
      {"frontal", gmsh("4", "1"), "algorithm 4, where it is compiled in"},
      {"mmg3d", gmsh("7", "1"), "algorithm 7, where it is compiled in"}};
  return p;
}

Preset hxt() {
  Preset p{"hxt", "Gmsh's HXT", {"gmsh"}, {"--version"}, "", ".geo", "mesh.msh"};
  p.digits = 0;
  p.variants = {
      {"1", gmsh("10", "1"), "one thread"},
      {"1-fine", gmsh("10", "1", uniform("{size}")), "one thread, one size everywhere: points inside"},
      {"1-coarse", gmsh("10", "1", uniform("{box}")), "one thread, hardly any point inside"},
      {"1-raw", gmsh("10", "1", {"-setnumber", "Mesh.Optimize", "0"}), "one thread, without optimization"},
      {"2", gmsh("10", "2"), "two threads: results differ from run to run", 10},
      {"2-fine", gmsh("10", "2", uniform("{size}")), "two threads, one size everywhere", 10},
      {"2-coarse", gmsh("10", "2", uniform("{box}")), "two threads, hardly any point inside", 10}};
  return p;
}

Preset netgen() {
  Preset p{"netgen",
           "Netgen's library, on the surface's own triangles",
           {"tetproof-netgen"},
           {"--version"},
           "",
           ".off",
           "mesh.node"};
  p.digits = 0;
  p.variants = {
      {"default", {"tetproof-netgen", "{surface}", "{mesh}"}, "its default parameters"},
      {"fine", {"tetproof-netgen", "{surface}", "{mesh}", "{size}"}, "one size everywhere: points inside"},
      {"raw", {"tetproof-netgen", "{surface}", "{mesh}", "{box}", "raw"}, "without optimization"}};
  return p;
}

Preset cgal() {
  Preset p{"cgal", "CGAL's Mesh_3", {"cgal_mesh3"}, {"--version"}, "CGAL ", ".off", "mesh.mesh"};
  p.may_change_boundary = true;
  p.fidelity =
      0.05;      // it keeps its facet distance at the centres of facets, but cuts sharp edges by its size
  p.digits = 6;  // as its output_to_medit does
  p.variants = {
      {"default", {"cgal_mesh3", "{surface}", "{mesh}", "{size}", "{distance}"}, "without optimization"},
      {"optimise",
       {"cgal_mesh3", "{surface}", "{mesh}", "{size}", "{distance}", "optimise"},
       "with perturbation and exudation"}};
  return p;
}

Preset cdt() {
  // Its own .tet has 6 digits; Medit's .mesh has 16.
  Preset p{"cdt", "Attene's CDT", {"cdt", "CDT"}, {}, "", ".off", "surface.off.mesh"};
  p.variants = {{"default", {"cdt", "-rm", "{surface}"}, "its exact points rounded to doubles"},
                {"float", {"cdt", "-rmf", "{surface}"}, "the same, after it tried to make doubles suffice"}};
  return p;
}

Preset ftetwild() {
  Preset p{"ftetwild", "fTetWild", {"FloatTetwild_bin"}, {}, "", ".off", "mesh.msh"};
  p.may_change_boundary = true;
  p.fidelity = 1e-3;  // its default envelope
  p.variants = {{"default",
                 {"FloatTetwild_bin", "-i", "{surface}", "-o", "{mesh}", "--max-threads", "1"},
                 "its default parameters"},
                {"coarse",
                 {"FloatTetwild_bin", "-i", "{surface}", "-o", "{mesh}", "--max-threads", "1", "-l", "0.25"},
                 "long edges"}};
  return p;
}

Preset tetproof() {
  Preset p{"tetproof", "our own reference, tetproof-mesh", {"tetproof-mesh"}, {"--version"}, "", ".off",
           "mesh.msh"};
  p.may_change_boundary = true;
  p.fidelity =
      0.09;  // one cell: the box is 1.2 times the surface's, a cell at most a 24th of it along each axis
  p.digits = 0;
  p.own_verdict_exit = 1;
  p.own_failure_exit = 3;
  p.partly_judged_exit = 4;
  p.coarse = true;
  const auto words = [](const std::string& cells) {
    return Words{"tetproof-mesh", "{surface}", "-o", "{mesh}",    "--binary", "--cells",
                 cells,           "--voxels",  "0",  "--threads", "1",        "--quiet"};
  };
  p.variants = {{"24", words("24"), "24 cells along the longest side"}, {"48", words("48"), "48 cells"}};
  return p;
}

}  // namespace

const std::vector<Preset>& preset_table() {
  static const std::vector<Preset> table{tetgen(), gmsh_preset(), hxt(),      netgen(),
                                         cgal(),   cdt(),         ftetwild(), tetproof()};
  return table;
}

}  // namespace tetproof::corpus
