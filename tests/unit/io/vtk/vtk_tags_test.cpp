// SPDX-License-Identifier: GPL-3.0-or-later
// Tags of elements by the words of other tools, and names of groups.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/losses.hpp"
#include "io/mesh_files.hpp"
#include "io/model/tag_words.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// Two tetrahedra with integers as cell data: each a name and the two numbers.
std::string legacy(const std::vector<std::pair<std::string, std::string>>& arrays, const char* type = "int") {
  std::string text =
      "# vtk DataFile Version 3.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 5 double\n"
      "0 0 0 1 0 0 0 1 0 0 0 1 1 1 1\nCELLS 2 10\n4 0 1 2 3\n4 1 2 3 4\nCELL_TYPES 2\n10 10\nCELL_DATA 2\n";
  for (const auto& [name, numbers] : arrays)
    text += fmt::format("SCALARS {} {}\nLOOKUP_TABLE default\n{}\n", name, type, numbers);
  return text;
}

// The first group of each element, or its entity; 0: none.
std::vector<std::int64_t> tags(const Document& document, io::Tag tag) {
  std::vector<std::int64_t> tags;
  for (const ElementBlock& block : document.blocks) {
    const auto& groups = document.tag_sets.at(static_cast<std::size_t>(block.groups));
    tags.insert(tags.end(), block.count,
                tag == io::Tag::entity ? block.entity
                : groups.empty()       ? 0
                                       : groups[0]);
  }
  return tags;
}

TEST(VtkTags, AreReadByTheWordsOfManyTools) {
  const test::TestFiles files;
  for (const io::TagWord& word : io::tag_words) {
    const Document document = read_document(files.write("a.vtk", legacy({{std::string(word.word), "7 9"}})));
    EXPECT_THAT(tags(document, word.tag), ElementsAre(7, 9)) << word.word;
    EXPECT_THAT(document.element_values, IsEmpty()) << word.word;
    EXPECT_THAT(document.dropped, IsEmpty()) << word.word;
  }
}

TEST(VtkTags, TheFirstWordCountsAndTheOthersAreData) {
  const test::TestFiles files;
  const Document document = read_document(
      files.write("a.vtk", legacy({{"material", "1 2"}, {"gmsh:physical", "7 9"}, {"entity", "3 4"}})));
  EXPECT_THAT(tags(document, io::Tag::group), ElementsAre(7, 9));
  EXPECT_THAT(tags(document, io::Tag::entity), ElementsAre(3, 4));
  ASSERT_EQ(document.element_values.size(), 1u);
  EXPECT_EQ(document.element_values[0].name, "material");
  for (const char* name : {"b.vtu", "b.vtk"}) {
    EXPECT_THAT(losses(files.path(name), document), IsEmpty()) << name;
    write_document(files.path(name), document);
    const Document back = read_document(files.path(name));
    EXPECT_THAT(tags(back, io::Tag::group), ElementsAre(7, 9)) << name;
    ASSERT_EQ(back.element_values.size(), 1u) << name;
    EXPECT_THAT(back.element_values[0].integers, ElementsAre(1, 2)) << name;
  }
}

// A pipeline that looks for its array by name finds it again.
TEST(VtkTags, KeepTheirWordFromVtkToVtk) {
  const test::TestFiles files;
  for (const io::TagWord& word : io::tag_words) {
    if (word.tag != io::Tag::group) continue;
    const std::string name(word.word);
    const Document document = read_document(files.write("a.vtk", legacy({{name, "7 9"}})));
    for (const char* to : {"b.vtu", "b.vtk"}) {
      write_document(files.path(to), document, {.binary = false});
      EXPECT_THAT(files.read(files.path(to)),
                  HasSubstr(to == std::string("b.vtu") ? "\"" + name + "\"" : "\n" + name + " 1 2 int\n"));
      EXPECT_THAT(tags(read_document(files.path(to)), word.tag), ElementsAre(7, 9)) << to;
    }
  }
}

TEST(VtkTags, AreNotTakenFromFractionsNegativeRealsAndZeros) {
  const test::TestFiles files;
  for (const std::string& text : {legacy({{"material", "0 0"}}), legacy({{"material", "7 9.5"}}, "double"),
                                  legacy({{"material", "7 -9"}}, "double")}) {
    const Document document = read_document(files.write("a.vtk", text));
    EXPECT_THAT(tags(document, io::Tag::group), ElementsAre(0, 0));
    ASSERT_EQ(document.element_values.size(), 1u);
    write_document(files.path("b.vtu"), document);
    const Document back = read_document(files.path("b.vtu"));
    ASSERT_EQ(back.element_values.size(), 1u);
    EXPECT_EQ(back.element_values[0].name, "material");
  }
}

// MMG writes its references as floats.
TEST(VtkTags, AreTakenFromWholeReals) {
  const test::TestFiles files;
  const Document document = read_document(files.write("a.vtk", legacy({{"medit:ref", "7 9"}}, "float")));
  EXPECT_THAT(tags(document, io::Tag::group), ElementsAre(7, 9));
  EXPECT_THAT(document.element_values, IsEmpty());
}

// Point data of MMG and meshio are references of nodes, in a .mesh as well.
TEST(VtkTags, OfNodesAreReferences) {
  const test::TestFiles files;
  for (const char* type : {"int", "float"}) {
    const Document document = read_document(
        files.write("a.vtk", legacy({}) + fmt::format("POINT_DATA 5\nSCALARS medit:ref {}\nLOOKUP_TABLE "
                                                      "default\n1 2 3 0 -4\n",
                                                      type)));
    ASSERT_EQ(document.node_values.size(), 1u);
    EXPECT_EQ(document.node_values[0].name, "references");
    EXPECT_THAT(document.node_values[0].integers, ElementsAre(1, 2, 3, 0, -4));
    for (const char* name : {"b.vtu", "b.vtk", "b.mesh"}) {
      EXPECT_THAT(losses(files.path(name), document), IsEmpty()) << name;
      write_document(files.path(name), document, {.binary = false});
      const Document back = read_document(files.path(name));
      ASSERT_EQ(back.node_values.size(), 1u) << name;
      EXPECT_THAT(back.node_values[0].integers, ElementsAre(1, 2, 3, 0, -4)) << name;
    }
    EXPECT_THAT(files.read(files.path("b.vtu")), HasSubstr("Name=\"medit:ref\""));
  }
}

TEST(VtkTags, ReferencesBesideOthersOfTheirNameKeepIt) {
  const test::TestFiles files;
  const auto array = [](const char* name) {
    return fmt::format("SCALARS {} int\nLOOKUP_TABLE default\n1 2 3 0 -4\n", name);
  };
  const Document document = read_document(
      files.write("a.vtk", legacy({}) + "POINT_DATA 5\n" + array("references") + array("medit:ref")));
  ASSERT_EQ(document.node_values.size(), 2u);
  EXPECT_EQ(document.node_values[1].name, "medit:ref");
  EXPECT_THAT(losses(files.path("b.vtu"), document), IsEmpty());
  write_document(files.path("b.vtu"), document);
  const Document back = read_document(files.path("b.vtu"));
  EXPECT_EQ(back.node_values.at(0).name, "references");
  EXPECT_EQ(back.node_values.at(1).name, "medit:ref");
}

// Gmsh turns elements of a negative group inside out, and keeps 32 bits of a group. In its own array, and in
// Medit's, such numbers are groups; in those of other tools a negative number stays one of its element, and
// large ones are data.
TEST(VtkTags, NegativeNumbersOfOtherToolsStayNumbers) {
  const test::TestFiles files;
  for (const char* name : {"gmsh:physical", "medit:ref"})
    for (const char* type : {"int", "float"})
      EXPECT_THAT(tags(read_document(files.write("a.vtk", legacy({{name, "-7 9"}}, type))), io::Tag::group),
                  ElementsAre(-7, 9));
  const Document document = read_document(files.write("a.vtk", legacy({{"material", "-7 9"}})));
  EXPECT_THAT(tags(document, io::Tag::group), ElementsAre(0, 9));
  ASSERT_EQ(document.element_values.size(), 1u);
  EXPECT_EQ(document.element_values[0].name, "material");
  EXPECT_THAT(document.element_values[0].at, ElementsAre(0));
  EXPECT_THAT(document.element_values[0].integers, ElementsAre(-7));
  for (const char* name : {"b.vtu", "b.vtk"}) {  // in one array again
    EXPECT_THAT(losses(files.path(name), document), IsEmpty()) << name;
    write_document(files.path(name), document);
    const Document back = read_document(files.path(name));
    EXPECT_THAT(tags(back, io::Tag::group), ElementsAre(0, 9)) << name;
    ASSERT_EQ(back.element_values.size(), 1u) << name;
    EXPECT_THAT(back.element_values[0].at, ElementsAre(0)) << name;
    EXPECT_THAT(back.element_values[0].integers, ElementsAre(-7)) << name;
  }
  const Document large = read_document(files.write("a.vtk", legacy({{"material", "7 2147483648"}}, "long")));
  EXPECT_THAT(tags(large, io::Tag::group), ElementsAre(0, 0));
  EXPECT_EQ(large.element_values.size(), 1u);
}

// Integers of another format that only happen to have such a name stay data, by another name, which is said.
TEST(VtkTags, DataIsNeverWrittenAsTags) {
  const test::TestFiles files;
  Document document = read_document(files.write("a.vtk", legacy({{"other", "7 9"}})));
  document.element_values[0].name = "material";
  EXPECT_THAT(losses(files.path("b.vtu"), document),
              ElementsAre(::testing::Field(&Loss::example, "\"material\" becomes \"material #2\"")));
  write_document(files.path("b.vtu"), document);
  EXPECT_THAT(tags(read_document(files.path("b.vtu")), io::Tag::group), ElementsAre(0, 0));
}

TEST(VtkTags, AreWrittenInTheWordsOfTheirToolOrMeshio) {
  const test::TestFiles files;
  const auto written = [&](const Document& document, const char* name) {
    write_document(files.path(name), document);
    return test::TestFiles::read(files.path(name));
  };
  const Document of_mfem =
      read_document(files.write("a.vtk", legacy({{"material", "7 9"}, {"CellEntityIds", "3 4"}})));
  EXPECT_THAT(written(of_mfem, "b.vtu"), HasSubstr("\"material\""));
  EXPECT_THAT(written(of_mfem, "b.vtu"), HasSubstr("\"gmsh:geometrical\""));
  EXPECT_THAT(written(of_mfem, "b.vtk"), HasSubstr("SCALARS CellEntityIds"));
  Document document = of_mfem;
  document.group_word.clear();
  document.format = "msh41";
  EXPECT_THAT(written(document, "c.vtu"), HasSubstr("\"gmsh:physical\""));
  EXPECT_THAT(written(document, "c.vtu"), Not(HasSubstr("material")));
  document.format = "medit";
  EXPECT_THAT(written(document, "d.vtu"), HasSubstr("\"medit:ref\""));
}

// As meshio has them: the number and the dimension, called as the group.
TEST(VtkTags, NamesOfGroupsAreFieldData) {
  const test::TestFiles files;
  Document document = read_document(files.write("a.vtk", legacy({{"gmsh:physical", "7 9"}})));
  document.group_names = {{3, 7, "left & \"right\""}, {3, 9, "\xc3\xa9t\xc3\xa9"}};
  for (const char* name : {"b.vtu", "b.vtk"}) {
    EXPECT_THAT(losses(files.path(name), document), IsEmpty()) << name;
    write_document(files.path(name), document);
    const Document back = read_document(files.path(name));
    EXPECT_THAT(back.tables, IsEmpty()) << name;
    ASSERT_EQ(back.group_names.size(), 2u) << name;
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(back.group_names[k].dim, document.group_names[k].dim) << name;
      EXPECT_EQ(back.group_names[k].group, document.group_names[k].group) << name;
      EXPECT_EQ(back.group_names[k].name, document.group_names[k].name) << name;
    }
  }
}

TEST(VtkTags, NamesThatWouldNotComeBackAreLost) {
  const test::TestFiles files;
  Document document = read_document(files.write("a.vtk", legacy({{"gmsh:physical", "7 9"}})));
  document.group_names = {{3, 7, "a"}, {3, 9, "a"}, {3, 7, ""}, {2, 7, "no element"}, {3, 8, "nor here"}};
  const std::vector<Loss> lost = losses(files.path("b.vtu"), document);
  ASSERT_EQ(lost.size(), 1u);
  EXPECT_EQ(lost[0].item, "names of physical groups");
  EXPECT_EQ(lost[0].count, 4);
  write_document(files.path("b.vtu"), document);
  EXPECT_EQ(read_document(files.path("b.vtu")).group_names.size(), 1u);
}

TEST(VtkTags, OtherFieldDataStays) {
  const test::TestFiles files;
  Document document = read_document(files.write("a.vtk", legacy({{"gmsh:physical", "7 9"}})));
  const auto table = [](const char* name, std::vector<std::int64_t> numbers) {
    Table made{.name = name, .rows = numbers.size(), .columns = {{.name = name, .type = "Int32"}}};
    made.columns[0].integers = std::move(numbers);
    return made;
  };
  document.tables = {table("range", {1, 2}), table("three", {7, 3, 1}), table("far", {7, 4})};
  EXPECT_THAT(losses(files.path("b.vtu"), document), IsEmpty());
  write_document(files.path("b.vtu"), document);
  EXPECT_EQ(read_document(files.path("b.vtu")).tables.size(), 3u);
  document.tables.push_back(table("looks like a name", {9, 3}));
  EXPECT_EQ(losses(files.path("b.vtu"), document).size(), 1u);
  // A group has one name: behind this one it is a table.
  document.group_names = {{3, 9, "steel"}};
  EXPECT_THAT(losses(files.path("b.vtu"), document), IsEmpty());
  write_document(files.path("b.vtu"), document);
  EXPECT_EQ(read_document(files.path("b.vtu")).tables.size(), 4u);
  EXPECT_EQ(read_document(files.path("b.vtu")).group_names.size(), 1u);
  document.group_names.push_back({3, 9, "iron"});
  EXPECT_EQ(losses(files.path("b.vtu"), document).size(), 1u);
  document.group_names.clear();
  document.tables.back().columns[0].components = 2;  // one pair, not two numbers
  document.tables.back().rows = 1;
  EXPECT_THAT(losses(files.path("b.vtu"), document), IsEmpty());
}

}  // namespace
}  // namespace tetproof
