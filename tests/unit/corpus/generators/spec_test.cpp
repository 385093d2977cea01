// SPDX-License-Identifier: GPL-3.0-or-later
// The specifications that users write, and the messages about wrong ones.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "corpus/generators/generators.hpp"
#include "corpus/surfaces.hpp"
#include "io/error.hpp"
#include "tests/support/surface_facts.hpp"

namespace tetproof::corpus {
namespace {

template <class Make = TriangleSurface (*)(const std::string&)>
std::string error_of(const std::string& spec, const Make& make = make_surface) {
  try {
    make(spec);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Spec, ErrorsAreOneLineThatSaysWhatToDo) {
  const struct {
    const char *spec, *error;
  } cases[] = {
      {"sphere:q=1", "sphere:q=1: unknown key 'q' (known keys: r, n, x, y, z)"},
      {"torus:R=1,rr=2", "torus:R=1,rr=2: unknown key 'rr' (known keys: R, r, n, x, y, z)"},
      {"sphere:r", "sphere:r: expected key=value, found 'r' (known keys: r, n, x, y, z)"},
      {"sphere:r=1,,n=8", "sphere:r=1,,n=8: expected key=value, found '' (known keys: r, n, x, y, z)"},
      {"sphere:r=1,r=2", "sphere:r=1,r=2: the key 'r' is given twice"},
      {"sphere:r=", "sphere:r=: r: expected a finite number, found ''"},
      {"sphere:r=nan", "sphere:r=nan: r: expected a finite number, found 'nan'"},
      {"sphere:r=inf", "sphere:r=inf: r: expected a finite number, found 'inf'"},
      {"sphere:r=1e999", "sphere:r=1e999: r: expected a finite number, found '1e999'"},
      {"sphere:r=1x", "sphere:r=1x: r: expected a finite number, found '1x'"},
      {"sphere:r=-1", "sphere:r=-1: r: expected 1e-09 to 1e+09, found '-1'"},
      {"sphere:n=8.5", "sphere:n=8.5: n: expected a whole number, found '8.5'"},
      {"sphere:n=1e12", "sphere:n=1e12: n: expected 8 to 2e+07, found '1e12'"},
      {"random:seed=-1", "random:seed=-1: seed: expected 0 to 9007199254740992, found '-1'"},
      {"sphere:r=1e-9,x=1", "sphere:r=1e-9,x=1: the centre is more than a million radii from the origin"},
      {"torus:r=1", "torus:r=1: r: expected at most 0.999 R; beyond it the torus has no hole"},
      {"torus:r=1e-4", "torus:r=1e-4: r: expected at least 0.001 R"},
      {"wing:naca=12", "wing:naca=12: naca: expected four digits, found '12'"},
      {"wing:naca=00120", "wing:naca=00120: naca: expected four digits, found '00120'"},
      {"wing:naca=2012",
       "wing:naca=2012: naca: expected a position of the camber (second digit) of 1 to 9, because the first "
       "digit is "
       "not 0"},
      {"wing:naca=0000", "wing:naca=0000: naca: expected a thickness (last two digits) of 01 to 50"},
      {"wing:naca=9150", "wing:naca=9150: naca: too thick for its camber, the section folds over itself"},
      {"wing:span=1e4", "wing:span=1e4: span: expected 0.001 to 1000 chords"},
      {"shells:inner=1", "shells:inner=1: inner: expected less than r"},
      {"shells:inner=0.99,n=100",
       "shells:inner=0.99,n=100: the shells are too close for so few triangles: they would intersect"},
      {"box:x1=0", "box:x1=0: expected x0 below x1"},
      {"box:z0=1,z1=1.0000000000000002,n=3", "box:z0=1,z1=1.0000000000000002,n=3: expected z0 below z1"},
      {"groove:m=3,width=2,depth=1", "groove:m=3,width=2,depth=1: width: expected at most m - 2"},
      {"groove:m=3,depth=3", "groove:m=3,depth=3: depth: expected at most m - 1"},
      {"groove:m=200,n=1000", "groove:m=200,n=1000: n: more than 2e7 triangles"},
      {"hollow:m=1,wall=0.5", "hollow:m=1,wall=0.5: wall: expected less than m / 2"},
      {"bottle:m=1,wall=0.25,neck=0.5", "bottle:m=1,wall=0.25,neck=0.5: neck: expected less than m - 2 wall"},
      {"pair:x=1e12,h=1e-9", "pair:x=1e12,h=1e-9: h: so small beside the origin that planes coincide"},
  };
  for (const auto& c : cases) EXPECT_EQ(error_of(c.spec), c.error);
  EXPECT_EQ(error_of("shpere:r=1"),
            "shpere:r=1: no such generated surface (known: sphere, torus, wing, random, shells, octahedron, "
            "box, groove, terrain, "
            "hollow, bottle, pair, fuzz)");
}

TEST(Spec, LongOrUnprintableOnesGiveAShortLine) {
  const std::string error = error_of("sphere:" + std::string(1'000'000, '\n') + "=1");
  EXPECT_LT(error.size(), 400u);
  EXPECT_EQ(error.find('\n'), std::string::npos);
}

TEST(Spec, Accepts) {
  EXPECT_EQ(make_surface("sphere").vertices, make_surface("sphere:").vertices);
  EXPECT_EQ(make_surface("sphere:n=72,r=2").vertices, make_surface("sphere:r=2e0,n=7.2e1").vertices);
  EXPECT_EQ(make_surface("wing:naca=0012").vertices, make_surface("wing").vertices);
}

TEST(Spec, IsGenerated) {
  for (const char* spec : {"sphere", "sphere:", "sphere:nonsense", "torus:R=1", "bottle"})
    EXPECT_TRUE(is_generated(spec)) << spec;
  for (const char* spec : {"", ":", "sphere.off", "./sphere", "spheres:r=1", "Sphere", "a.stl"})
    EXPECT_FALSE(is_generated(spec)) << spec;
}

TEST(Spec, EveryGeneratorIsListedWithAllItsKeysAndWorksByItself) {
  const std::string list = list_surfaces();
  for (const Generator& generator : generators()) {
    EXPECT_NE(list.find(std::string(generator.name) + ": " + generator.meaning), std::string::npos);
    for (const Parameter& p : generator.parameters) {
      EXPECT_NE(list.find(std::string(p.key) + "="), std::string::npos) << p.key;
      EXPECT_LE(p.least, p.preset) << generator.name << ' ' << p.key;
      EXPECT_LE(p.preset, p.most) << generator.name << ' ' << p.key;
    }
    EXPECT_NO_THROW(make_surface(generator.name)) << generator.name;
    EXPECT_TRUE(exact_volume(generator.name).has_value()) << generator.name;
  }
}

const auto opened = [](const std::string& spec) { return open_surface(spec); };

TEST(OpenSurface, GeneratedOrFromAFile) {
  EXPECT_EQ(open_surface("sphere:n=8").triangles.size(), 8u);
  const std::string folder = TETPROOF_SOURCE_DIR "/corpus/surfaces/";
  EXPECT_EQ(open_surface(folder + "spot.obj").triangles.size(), 5856u);
  EXPECT_EQ(open_surface(folder + "unit_sphere.STL").vertices.size(), 642u);
  EXPECT_EQ(error_of("shpere", opened),
            "shpere: no such file, and no such generated surface (known: sphere, torus, wing, random, "
            "shells, octahedron, box, groove, "
            "terrain, hollow, bottle, pair, fuzz)");
  EXPECT_EQ(error_of("/no/such.off", opened), "/no/such.off: cannot open: No such file or directory");
}

// A .msh of two triangles that share an edge. The second one has its own copies of the common nodes.
TEST(OpenSurface, TrianglesOfAMeshFileAreWelded) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "two_triangles.MSH";
  const auto write = [&](const char* elements) {
    std::ofstream(path) << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 1 "
                           "1 0\n5 1 0 0\n6 -0 1 0\n"
                           "$EndNodes\n$Elements\n"
                        << elements << "$EndElements\n";
  };
  write("2\n1 2 2 1 1 1 2 3\n2 2 2 1 1 5 4 6\n");
  const TriangleSurface surface = open_surface(path.string());
  EXPECT_EQ(surface.vertices.size(), 4u);
  EXPECT_EQ(surface.triangles, (std::vector<std::array<Index, 3>>{{0, 1, 2}, {1, 3, 2}}));
  write("1\n1 15 2 1 1 1\n");
  EXPECT_EQ(error_of(path.string(), opened),
            path.string() + ": expected a surface, found no triangles or polygons");
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace tetproof::corpus
