// SPDX-License-Identifier: GPL-3.0-or-later
// Files of known groups.
#include "corpus/campaign/known_groups.hpp"

#include <gtest/gtest.h>

#include "io/error.hpp"
#include "tests/support/run_program.hpp"

namespace tetproof::corpus {
namespace {

using tetproof::test::ScratchFolder;

TEST(KnownGroups, OneALineWithComments) {
  const ScratchFolder folder;
  const std::string path = folder.write("known",
                                        "# reported\n\n  tetgen:crashed:f: Assertion `a # b' failed \r\n"
                                        "\t# more\ngmsh:wrong-answer:inverted");
  EXPECT_EQ(read_known_groups(path), (std::vector<std::string>{"tetgen:crashed:f: Assertion `a # b' failed",
                                                               "gmsh:wrong-answer:inverted"}));
  EXPECT_TRUE(read_known_groups(folder.write("none", "# nothing\n")).empty());
}

TEST(KnownGroups, WhatIsNoIdIsNamed) {
  const ScratchFolder folder;
  for (const char* line : {"tetgen", "tetgen:crash:f", "crashed:f", "tetgen:crashed"}) {
    const std::string path = folder.write("known", std::string("# first\n") + line + "\n");
    try {
      read_known_groups(path);
      ADD_FAILURE() << line;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("known:2: "), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(line), std::string::npos) << error.what();
    }
  }
  EXPECT_THROW(read_known_groups(folder / "missing"), InputError);
}

}  // namespace
}  // namespace tetproof::corpus
