// SPDX-License-Identifier: GPL-3.0-or-later
// Small meshes as files, and tetproof-verify run on them as users run it.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/run_program.hpp"

namespace tetproof::test {

using nlohmann::json;

// A cube of side 2 around the origin, cut into six tetrahedra around its diagonal from node 1 to node 8.
inline constexpr const char* cube_node =
    "8 3 0 0\n1 -1 -1 -1\n2 1 -1 -1\n3 -1 1 -1\n4 1 1 -1\n5 -1 -1 1\n6 1 -1 1\n7 -1 1 1\n8 1 1 1\n";
inline constexpr const char* cube_ele =
    "6 4 0\n1 1 2 4 8\n2 1 4 3 8\n3 1 3 7 8\n4 1 7 5 8\n5 1 5 6 8\n6 1 6 2 8\n";
// The second tetrahedron wound the other way, the fourth twice, and a seventh with a node that does not
// exist.
inline constexpr const char* bad_ele =
    "8 4 0\n1 1 2 4 8\n2 1 3 4 8\n3 1 3 7 8\n4 1 7 5 8\n5 1 5 6 8\n6 1 6 2 8\n7 1 7 5 8\n8 1 2 4 99\n";
inline constexpr const char* cube_off =
    "OFF\n8 12 0\n-1 -1 -1\n1 -1 -1\n-1 1 -1\n1 1 -1\n-1 -1 1\n1 -1 1\n-1 1 1\n1 1 1\n"
    "3 0 3 1\n3 0 2 3\n3 4 5 7\n3 4 7 6\n3 0 1 5\n3 0 5 4\n3 2 7 3\n3 2 6 7\n3 0 4 6\n3 0 6 2\n3 1 3 7\n3 1 "
    "7 5\n";

class Verify : public ::testing::Test {
 protected:
  Verify() {
    files.write("cube.node", cube_node);
    files.write("cube.ele", cube_ele);
    files.write("bad.node", cube_node);
    files.write("bad.ele", bad_ele);
    files.write("cube.off", cube_off);
  }
  Outcome run(std::vector<std::string> arguments) const {
    for (std::string& word : arguments)
      if (std::filesystem::exists(files / word)) word = files / word;
    arguments.insert(arguments.begin(), program("tetproof-verify"));
    return run_program(arguments);
  }
  json report(std::vector<std::string> arguments, int exit_code) const {
    arguments.insert(arguments.end(), {"--json", "-"});
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome;
    EXPECT_EQ(outcome.err, "");
    return json::parse(outcome.out);
  }
  static json check(const json& report, const std::string& id) {
    for (const json& entry : report["checks"])
      if (entry["id"] == id) return entry;
    return {};
  }

  ScratchFolder files;
};

}  // namespace tetproof::test
