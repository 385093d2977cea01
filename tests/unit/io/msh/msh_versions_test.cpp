// SPDX-License-Identifier: GPL-3.0-or-later
// What each version of .msh can hold, as text and as binary: what its plan says, and every sample written in
// it and read again.
#include <gtest/gtest.h>

#include <filesystem>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "io/codecs.hpp"
#include "io/losses.hpp"
#include "io/mesh_files.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/test_files.hpp"
#include "tests/unit/io/msh/msh_data_texts.hpp"

namespace tetproof {
namespace {

struct Version {
  const char* name;
  WriteOptions options;

  friend void PrintTo(const Version& test, std::ostream* out) { *out << test.name; }
};
const std::vector<Version> versions{{"Msh22Text", {.format = "msh22"}},
                                    {"Msh22Binary", {.format = "msh22", .binary = true}},
                                    {"Msh40Text", {.format = "msh40"}},
                                    {"Msh41Text", {.format = "msh41"}},
                                    {"Msh41Binary", {.format = "msh41", .binary = true}}};

TEST(MeshDataWrite, WhatEachVersionHolds) {
  const test::TestFiles files;
  const Document document = read_document(files.write(
      "a.msh",
      test::mesh41 +
          "$Periodic\n1\n2 2 1\n2 1 2\n0\n$EndPeriodic\n$GhostElements\n1\n5 1 1 2\n$EndGhostElements\n" +
          test::data));
  for (const Version& version : versions) {
    const std::string& format = version.options.format;
    const auto plan = io::codec_named(format).plan(document, version.options.binary.value_or(false));
    const io::Holds& holds = plan->holds();
    EXPECT_EQ(holds.periodic, format == "msh41") << version.name;  // its transformation has 2 numbers
    EXPECT_EQ(holds.ghosts, format != "msh22") << version.name;
    EXPECT_EQ(holds.entities, format != "msh22") << version.name;
    EXPECT_EQ(holds.node_entities, format != "msh22") << version.name;
    EXPECT_TRUE(holds.values(document.node_values[0], io::Of::node)) << version.name;
    Values values = document.node_values[0];
    values.name = "a\nb";
    EXPECT_FALSE(holds.values(values, io::Of::node)) << version.name;
    values = {.name = "materials", .reals = {}, .integers = {1, 2}};
    EXPECT_FALSE(holds.values(values, io::Of::element)) << version.name;
    values = {.name = "pressure", .reals = {1, 2}, .integers = {}};
    EXPECT_TRUE(holds.values(values, io::Of::element)) << version.name;
    values.step = 3;  // only views have steps
    EXPECT_FALSE(holds.values(values, io::Of::element)) << version.name;
  }
}

const std::filesystem::path formats_folder =
    std::filesystem::path(TETPROOF_SOURCE_DIR) / ".." / "shared" / "formats";

// The lines of a document's text that every version of .msh holds without a supplement: nodes, elements
// without their entities, data.
std::string core(const Document& document) {
  std::istringstream lines(test::text_of(document, false));
  std::string kept;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("n ") || line.starts_with("v ") || line.starts_with("G ")) kept += line + "\n";
    if (!line.starts_with("e ")) continue;
    const std::size_t type = line.find(' ', 2), place = line.find(' ', type + 1),
                      group = line.find(" g", place);
    kept += line.substr(0, place) + line.substr(group, line.find(" p") - group) +
            line.substr(line.find(':')) + "\n";
  }
  return kept;
}

class MeshVersions : public testing::TestWithParam<Version> {};

// Every sample through each version: with its supplement it comes back whole, without it the parts that all
// versions hold.
TEST_P(MeshVersions, HoldEverySample) {
  if (!std::filesystem::exists(formats_folder)) GTEST_SKIP() << formats_folder << " is not here";
  const test::TestFiles files;
  std::size_t seen = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(formats_folder)) {
    if (entry.path().extension() != ".msh") continue;
    const Document document = read_document(entry.path().string());
    write_document(files.path("a.msh"), document, GetParam().options);
    const Document again = read_document(files.path("a.msh"));
    // Parts that only say that there is no entity, or that follow from the rest, are not kept aside.
    if (!kept_aside("a.msh", document, GetParam().options).items.empty()) {
      EXPECT_EQ(test::text_of(again, false), test::text_of(document, false)) << entry.path();
    }
    test::TestFiles::leave_out_supplement(files.path("a.msh"));
    const auto plan =
        io::codec_named(GetParam().options.format).plan(document, GetParam().options.binary.value_or(false));
    const io::Holds& holds = plan->holds();
    // Some versions do not hold numbers of more than 4 bytes, or a group 0.
    bool all = holds.node_tags && holds.element_tags;
    for (const Values& values : document.node_values) all = all && holds.values(values, io::Of::node);
    for (const ElementBlock& block : document.blocks)
      all = all && (!holds.groups_of || holds.groups_of(block));
    if (!all) continue;
    EXPECT_EQ(core(read_document(files.path("a.msh"))), core(document)) << entry.path();
    ++seen;
  }
  EXPECT_GE(seen, 40u);
}

INSTANTIATE_TEST_SUITE_P(Samples, MeshVersions, testing::ValuesIn(versions),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace tetproof
