// SPDX-License-Identifier: GPL-3.0-or-later
// Elements of some types, one document for each group, and the boundary of solids.
#include <Eigen/Geometry>

#include "edited.hpp"
#include "io/edit/solid_faces.hpp"
#include "io/edit/solid_sign.hpp"

namespace tetproof::test {
namespace {

TEST(GroupTexts, AreTextsInVtksFiles) {
  Document document = two_tets();
  EXPECT_EQ(said(io::add_group_texts(document)),
            "4 of 4 elements have the names or numbers of their groups as values \"group names\"");
  const TestFiles files;
  for (const char* name : {"a.vtu", "a.vtk"}) {
    const std::string path = files.path(name);
    write_document(path, document, {.binary = false});
    const Document back = read_document(path);
    const auto texts = std::find_if(back.element_values.begin(), back.element_values.end(),
                                    [](const Values& values) { return values.name == "group names"; });
    ASSERT_NE(texts, back.element_values.end()) << name;
    EXPECT_TRUE(texts->texts) << name;
    std::vector<std::string> all;
    for (const std::int64_t i : texts->integers) all.push_back(texts->labels.at(static_cast<std::size_t>(i)));
    EXPECT_EQ(all, (std::vector<std::string>{"5", "bottom", "steel", "2"})) << name;
  }
  document.group_names.clear();
  EXPECT_THROW(io::add_group_texts(document), InputError);
}

TEST(KeepOnly, KeepsNumbersValuesAndGroups) {
  Document document = two_tets();
  EXPECT_EQ(said(io::keep_only(document, "tetrahedra")),
            "2 of 4 elements kept; left out: 1 line, 1 triangle");
  EXPECT_EQ(left_of(document),
            "group 3 1 steel\ngroup 2 9 bottom\ne4 g1: 10 20 30 40\ne4 g2: 20 30 40 50\n"
            "node t x1: 1 2 3 4 5 6\nelement q x1: 80 90\n");
  EXPECT_EQ(document.element_tag(0), 8);
  EXPECT_EQ(document.points.size(), 6u);
}

TEST(KeepOnly, SeveralTypesByNameAndNumber) {
  for (const char* types : {"triangles,lines", "line,triangle", "1,2"}) {
    Document document = two_tets();
    io::keep_only(document, types);
    EXPECT_EQ(left_of(document),
              "group 3 1 steel\ngroup 2 9 bottom\ne1 g5: 10 20\ne2 g9: 10 20 30\nnode t x1: 1 2 3 4 5 6\n"
              "element q x1: 70 from 1\n")
        << types;
  }
}

TEST(KeepOnly, LinesAndPolylines) {
  const auto left = [](const char* types) {
    Document document =
        document_of_text("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\nl 1 2 3 4\nl 1 2\nf 1 2 3\n");
    io::keep_only(document, types);
    return left_of(document);
  };
  EXPECT_EQ(left("lines"), "e1000: 1 2 3 4\ne1: 1 2\n");
  EXPECT_EQ(left("polylines"), "e1000: 1 2 3 4\n");
  EXPECT_EQ(left("1"), "e1: 1 2\n");  // Gmsh's number of lines with two nodes
}

TEST(KeepOnly, Refuses) {
  const TestFiles files;
  Document document = two_tets();
  EXPECT_EQ(
      files.message([&] { io::keep_only(document, "tets"); }),
      "'tets' is no type of elements; expected points, lines, polylines, triangles, quadrangles, polygons, "
      "tetrahedra, "
      "hexahedra, prisms, pyramids, polyhedra, Bezier curves, Bezier triangles, Bezier tetrahedra, or Gmsh's "
      "number of a type");
  EXPECT_EQ(files.message([&] { io::keep_only(document, "prisms"); }),
            "a.msh: none of the 4 elements is of type prisms");
  EXPECT_EQ(files.message([&] { io::keep_only(document, "lines,"); }).substr(0, 25),
            "'' is no type of elements");
}

TEST(SplitByGroup, OneDocumentForEachGroup) {
  const std::vector<io::GroupPart> parts = io::split_by_group(two_tets());
  std::string text;
  for (const io::GroupPart& part : parts) text += part.word + ":\n" + left_of(part.document);
  EXPECT_EQ(text,
            "steel:\ngroup 3 1 steel\ne4 g1: 10 20 30 40\nnode t x1: 1 2 3 4\nelement q x1: 80\n"
            "2:\ne4 g2: 20 30 40 50\nnode t x1: 2 3 4 5\nelement q x1: 90\n"
            "bottom:\ngroup 2 9 bottom\ne2 g9: 10 20 30\nnode t x1: 1 2 3\nelement q x1: 70\n"
            "5:\ne1 g5: 10 20\nnode t x1: 1 2\n");
}

// Names that are the same word, or lead to another folder; elements in two groups and in none.
TEST(SplitByGroup, WordsForFiles) {
  const std::string nodes = "1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n";
  const std::vector<io::GroupPart> parts = io::split_by_group(document_of_text(
      "a.msh",
      msh22(nodes, "1 2 2 7 1 1 2 3\n2 2 2 8 2 1 2 4\n3 2 2 0 3 2 3 4\n4 1 2 7 1 1 2\n",
            "$PhysicalNames\n3\n2 7 \"../a/b\"\n2 8 \"Ungrouped\"\n1 7 \"a\"\n$EndPhysicalNames\n")));
  std::string words;
  for (const io::GroupPart& part : parts) words += part.word + " ";
  EXPECT_EQ(words, "___a_b Ungrouped_faces_8 a ungrouped ");
}

// Where capitals make no difference, "a" and "A" are one name, and what stands for one of them may be taken.
TEST(SplitByGroup, WordsThatAreTaken) {
  const std::string nodes = "1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n";
  const std::vector<io::GroupPart> parts = io::split_by_group(document_of_text(
      "a.msh", msh22(nodes, "1 4 2 1 1 1 2 3 4\n2 4 2 2 2 1 2 3 4\n3 4 2 3 3 1 2 3 4\n4 4 2 4 4 1 2 3 4\n",
                     "$PhysicalNames\n4\n3 1 \"a\"\n3 2 \"A\"\n3 3 \"A_Solids_1\"\n3 4 "
                     "\"a_solids_1_\"\n$EndPhysicalNames\n")));
  std::string words;
  for (const io::GroupPart& part : parts) words += part.word + " ";
  EXPECT_EQ(words, "a_solids_1__ A_solids_2 A_Solids_1 a_solids_1_ ");
}

TEST(SplitByGroup, NeedsGroups) {
  const TestFiles files;
  EXPECT_EQ(files.message([&] {
    io::split_by_group(document_of_text("a.off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"));
  }),
            "a.off: no element is in a group");
}

TEST(Boundary, FacesOfOneSolidWoundOutwards) {
  for (const bool inverted : {false, true}) {
    Document document = two_tets(inverted);
    EXPECT_EQ(
        said(io::boundary(document)),
        std::string("6 boundary faces of 2 solids in place of 4 elements; 1 of them was an element before") +
            (inverted ? "; turned outwards at 1 solid of negative volume" : ""));
    const std::string text = left_of(document);
    EXPECT_EQ(text.substr(0, text.find("e2 g2")),
              "group 3 1 steel\ngroup 2 9 bottom\ngroup 2 1 steel\n"
              "e2 g1: 10 40 30\ne2 g1: 10 20 40\ne2 g9: 10 30 20\n");
    EXPECT_EQ(text.substr(text.find("node t")), "node t x1: 1 2 3 4 5 6\nelement q x1: 80 80 70 90 90 90\n");
    const TriangleSurface surface = surface_of(document);
    double volume = 0;  // 1/6 and 1/3
    for (const auto& [a, b, c] : surface.triangles)
      volume += surface.vertices[static_cast<std::size_t>(a)].dot(
                    surface.vertices[static_cast<std::size_t>(b)].cross(
                        surface.vertices[static_cast<std::size_t>(c)])) /
                6;
    EXPECT_NEAR(volume, 0.5, 1e-15);
  }
}

// Group 9 of volumes is not group 9 of surfaces, and entity 6 not the entity 6 there.
TEST(Boundary, GroupsOfSolidsGetFreeNumbers) {
  Document document = document_of_text(
      "a.msh", msh22("1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n", "1 2 2 9 6 1 2 3\n2 4 2 9 6 1 2 3 4\n"));
  io::boundary(document);
  EXPECT_EQ(left_of(document), "e2 g10: 2 3 4\ne2 g10: 1 4 3\ne2 g10: 1 2 4\ne2 g9: 1 3 2\n");
  EXPECT_EQ(document.blocks[0].entity, 7);
  EXPECT_EQ(document.blocks[1].entity, 6);
}

// A face that is two elements stands in the surface once.
TEST(Boundary, SeveralElementsOnAFace) {
  Document document = document_of_text(
      "a.msh",
      msh22("1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n", "1 2 2 1 1 1 2 3\n2 2 2 2 2 2 3 1\n3 4 2 5 1 1 2 3 4\n"));
  EXPECT_EQ(said(io::boundary(document)),
            "4 boundary faces of 1 solid in place of 3 elements; 1 of them was an element before | further "
            "elements on a face 1 (element 2 on that of element 1, which has the groups of both)");
  EXPECT_EQ(left_of(document), "e2 g5: 2 3 4\ne2 g5: 1 4 3\ne2 g5: 1 2 4\ne2 g1 g2: 1 3 2\n");
}

// A Bezier tetrahedron and one with straight sides: the Bezier's sides are no triangles.
TEST(Boundary, ListsSolidsWithoutFaces) {
  Document document;
  for (int i = 0; i < 11; ++i) document.points.emplace_back(i % 2, i % 3, i % 5);
  document.blocks = {{.type = io::bezier(io::tetrahedron10), .nodes_each = 10, .count = 1},
                     {.count = 1, .first = 1, .nodes = 10}};
  document.connectivity = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 0, 2, 1, 10};
  EXPECT_NE(said(io::boundary(document)).find(" | solids without faces 1 (their boundary is left out)"),
            std::string::npos);
}

// The middle nodes on the sides of the bottom are in the three faces around it, and not in the bottom.
TEST(Boundary, ListsElementsOfLowerOrder) {
  Document document =
      document_of_text("a.msh", msh22("1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 .5 0 0\n6 .5 .5 0\n7 0 .5 0\n8 "
                                      "0 0 .5\n9 0 .5 .5\n10 .5 0 .5\n",
                                      "1 2 2 0 1 1 2 3\n2 11 2 0 1 1 2 3 4 5 6 7 8 9 10\n"));
  EXPECT_EQ(said(io::boundary(document)),
            "4 boundary faces of 1 solid in place of 2 elements; 1 of them was an element before | faces by "
            "their corners 1 (their other nodes are left out)");
  EXPECT_EQ(left_of(document), "e9: 2 3 4 6 9 10\ne9: 1 4 3 8 9 7\ne9: 1 2 4 5 10 8\ne2: 1 3 2\n");
}

// At any scale, far from the origin too: one of volume 1/6 size^3 that is inside out is turned, its mirror
// image not.
TEST(Boundary, SignsOfTinyAndLargeVolumes) {
  using io::is_inverted;
  const int tetrahedron = io::tetrahedron4, pyramid = 7;
  for (const double size : {1e-310, 1e-120, 1e-60, 1.0, 1e60, 1e120, 1e307}) {
    Document document;
    document.points = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}, {size, size, 0}};
    const Index right[] = {0, 1, 2, 3}, wrong[] = {0, 2, 1, 3};
    EXPECT_FALSE(is_inverted(document, {.type = tetrahedron}, right)) << size;
    EXPECT_TRUE(is_inverted(document, {.type = tetrahedron}, wrong)) << size;
    const Index upright[] = {0, 1, 4, 2, 3}, upside_down[] = {0, 2, 4, 1, 3};
    EXPECT_FALSE(is_inverted(document, {.type = pyramid}, upright)) << size;
    EXPECT_TRUE(is_inverted(document, {.type = pyramid}, upside_down)) << size;
  }
  Document document;  // one unit in the last place is out of the plane x + y + z = 1; half of it is exact
  document.points = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.25, 0.25, std::nextafter(0.5, 0.0)}};
  const Index outwards[] = {0, 1, 2, 3};
  EXPECT_TRUE(is_inverted(document, {.type = tetrahedron}, outwards));
  document.points[3][2] = 0.5;
  EXPECT_FALSE(is_inverted(document, {.type = tetrahedron}, outwards));
}

// The elements are numbered anew: what names their numbers would name others.
TEST(Boundary, ListsSections) {
  Document document = two_tets();
  document.sections = {{.name = "Mine", .body = "9\n", .format = "msh22"}};
  EXPECT_NE(said(io::boundary(document)).find(" | sections 1 ($Mine may name numbers"), std::string::npos);
}

// A pyramid on one side of a quadrangle, two tetrahedra on the other.
TEST(Boundary, TwoTrianglesCoverAQuadrangle) {
  Document document =
      document_of_text("a.msh", msh22("1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 .5 .5 -1\n6 .5 .5 1\n",
                                      "1 7 2 0 1 1 4 3 2 5\n2 4 2 0 1 1 2 3 6\n3 4 2 0 1 1 3 4 6\n"));
  EXPECT_EQ(said(io::boundary(document)),
            "8 boundary faces of 3 solids in place of 3 elements; 1 quadrangle with two triangles on the "
            "other side "
            "left out");
}

// A tetrahedron on a bent quadrangle: two of its sides are inside, by the quadrangle's diagonal, and two
// outside.
TEST(Boundary, OneTetrahedronCoversABentQuadrangle) {
  Document document = document_of_text("a.msh", msh22("1 0 0 0\n2 1 0 .5\n3 1 1 0\n4 0 1 .5\n5 .5 .5 -1\n",
                                                      "1 7 2 0 1 1 4 3 2 5\n2 4 2 0 1 1 2 3 4\n"));
  io::boundary(document);
  EXPECT_EQ(document.elements(), 6u);
  EXPECT_TRUE(std::all_of(document.blocks.begin(), document.blocks.end(),
                          [](const ElementBlock& block) { return block.type == io::triangle3; }));
}

TEST(Boundary, CollapsedHexahedron) {  // a prism, as some mesh generators write it
  Document document = document_of_text(
      "a.msh",
      msh22("1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 0 1\n6 0 1 1\n", "1 5 2 0 1 1 2 3 3 4 5 6 6\n"));
  io::boundary(document);
  EXPECT_EQ(left_of(document), "e2: 1 3 2\ne3: 1 2 5 4\ne3: 1 4 6 3\ne3: 2 3 6 5\ne2: 4 5 6\n");
}

TEST(Boundary, NeedsSolids) {
  const TestFiles files;
  Document document = document_of_text("a.off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_EQ(files.message([&] { io::boundary(document); }),
            "a.off: there are no solids that have a boundary");
}

// Every face of every type: wound outwards, and each middle node in the middle of its side.
TEST(Boundary, FacesOfAllTypes) {
  const std::vector<Eigen::Vector3d> hexahedron{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                                {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
      tetrahedron{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
      prism{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}},
      pyramid{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {.5, .5, 1}};
  const std::map<int, std::pair<const std::vector<Eigen::Vector3d>*, std::size_t>> types{
      {4, {&tetrahedron, 4}}, {11, {&tetrahedron, 4}}, {29, {&tetrahedron, 4}}, {5, {&hexahedron, 6}},
      {12, {&hexahedron, 6}}, {17, {&hexahedron, 6}},  {6, {&prism, 5}},        {13, {&prism, 5}},
      {18, {&prism, 5}},      {7, {&pyramid, 5}},      {14, {&pyramid, 5}},     {19, {&pyramid, 5}}};
  for (const auto& [type, shape] : types) {
    const std::vector<Eigen::Vector3d>* const corners = shape.first;
    const auto faces = io::solid_faces(type);
    ASSERT_EQ(faces.size(), shape.second) << type;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& corner : *corners) middle += corner / static_cast<double>(corners->size());
    for (const io::SolidFace& face : faces) {
      const auto p = [&](std::size_t k) { return (*corners)[static_cast<std::size_t>(face.nodes[k])]; };
      EXPECT_GT((p(1) - p(0)).cross(p(2) - p(0)).dot(p(0) - middle), 0) << type;
      EXPECT_EQ(io::element_type(face.type)->nodes, static_cast<int>(face.nodes.size())) << type;
      EXPECT_EQ(io::element_type(face.type)->corners, face.corners) << type;
    }
  }
  EXPECT_EQ(io::solid_faces(29)[0].type, io::triangle3);  // of third order: by corners
  EXPECT_TRUE(io::solid_faces(2).empty());
}

// Gmsh's orders of nodes, https://gmsh.info/doc/texinfo/gmsh.html#Node-ordering, for one face of each.
TEST(Boundary, MiddleNodes) {
  EXPECT_EQ(io::solid_faces(11)[1].nodes, (std::vector<std::int32_t>{0, 3, 2, 7, 8, 6}));
  EXPECT_EQ(io::solid_faces(17)[5].nodes, (std::vector<std::int32_t>{4, 5, 6, 7, 16, 18, 19, 17}));
  EXPECT_EQ(io::solid_faces(12)[2].nodes, (std::vector<std::int32_t>{0, 4, 7, 3, 10, 17, 15, 9, 22}));
  EXPECT_EQ(io::solid_faces(13)[4].nodes, (std::vector<std::int32_t>{1, 2, 5, 4, 9, 11, 14, 10, 17}));
  EXPECT_EQ(io::solid_faces(14)[4].nodes, (std::vector<std::int32_t>{0, 3, 2, 1, 6, 10, 8, 5, 13}));
}

TEST(Boundary, SecondOrderWithAllNodes) {
  Document document =
      document_of_text("a.msh", msh22("1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 .5 0 0\n6 .5 .5 0\n7 0 .5 0\n8 "
                                      "0 0 .5\n9 0 .5 .5\n10 .5 0 .5\n",
                                      "1 9 2 0 1 1 2 3 5 6 7\n2 11 2 0 1 1 2 3 4 5 6 7 8 9 10\n"));
  io::boundary(document);
  EXPECT_EQ(left_of(document), "e9: 2 3 4 6 9 10\ne9: 1 4 3 8 9 7\ne9: 1 2 4 5 10 8\ne9: 1 3 2 7 6 5\n");
}

}  // namespace
}  // namespace tetproof::test
