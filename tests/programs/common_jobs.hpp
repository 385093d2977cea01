// SPDX-License-Identifier: GPL-3.0-or-later
// A small job for every program, for tests of what all programs do in the same way.
#pragma once

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "tests/support/run_program.hpp"

namespace tetproof::test {

// A program with arguments that make it do a small job and succeed. SURFACE, MESH and OUT stand for files.
struct Job {
  std::string name;
  std::vector<std::string> arguments;
  bool writes = false;                         // the arguments contain OUT
  std::vector<std::string> outputs{"--json"};  // options that name an output

  std::string test_name() const {
    std::string text = name + (writes ? "_writing" : "");
    for (char& c : text)
      if (c == '-') c = '_';
    return text;
  }
};

inline void PrintTo(const Job& job, std::ostream* stream) {
  *stream << job.test_name();
}

inline const std::vector<Job> jobs{
    {"tetproof-mesh",
     {"SURFACE", "-o", "OUT", "--cells", "6"},
     true,
     {"--json", "--trace", "--figure", "--html"}},
    {"tetproof-verify", {"MESH"}, false, {"--json", "--junit", "--defects", "--html"}},
    {"tetproof-verify",
     {"MESH", "SURFACE", "--fidelity", "0.2", "--voxels", "16"},
     false,
     {"--json", "--junit", "--defects", "--html"}},
    {"tetproof-compare", {"MESH", "MESH"}, false, {"--json", "--html"}},
    {"tetproof-convert", {"MESH", "OUT"}, true, {"--json", "--losses"}},
};

// An octahedron, cut into four tetrahedra around its long diagonal.
inline constexpr const char* octahedron_node =
    "6 3 0 0\n1 1 0 0\n2 0 1 0\n3 -1 0 0\n4 0 -1 0\n5 0 0 1\n6 0 0 -1\n";
inline constexpr const char* octahedron_ele = "4 4 0\n1 1 2 6 5\n2 2 3 6 5\n3 3 4 6 5\n4 4 1 6 5\n";
inline constexpr const char* octahedron_msh =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n1 1 0 0\n2 0 1 0\n3 -1 0 0\n4 0 -1 0\n5 0 0 1\n6 0 0 "
    "-1\n$EndNodes\n$Elements\n4\n1 4 0 1 2 6 5\n2 4 0 2 3 6 5\n3 4 0 3 4 6 5\n4 4 0 4 1 6 5\n$EndElements\n";
inline constexpr const char* octahedron_off =
    "OFF\n6 8 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n0 0 1\n0 0 -1\n"
    "3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n3 1 0 5\n3 2 1 5\n3 3 2 5\n3 0 3 5\n";

class CommonBehaviour : public ::testing::TestWithParam<Job> {
 protected:
  CommonBehaviour() {
    inputs.write("octahedron.node", octahedron_node);
    inputs.write("octahedron.ele", octahedron_ele);
    inputs.write("octahedron.off", octahedron_off);
  }

  // The command of the job: it writes the file `out`, and `more` is added at its end.
  std::vector<std::string> command(const std::string& out, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{program(GetParam().name)};
    for (const std::string& word : GetParam().arguments)
      words.push_back(word == "SURFACE" ? inputs / "octahedron.off"
                      : word == "MESH"  ? inputs / "octahedron.node"
                      : word == "OUT"   ? out
                                        : word);
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  Outcome run(const std::vector<std::string>& more = {}) const {
    return run_program(command(outputs / "out.msh", more));
  }

  // Positions in `command` of the files that the job reads.
  std::vector<std::size_t> inputs_in_command() const {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < GetParam().arguments.size(); ++i)
      if (GetParam().arguments[i] == "SURFACE" || GetParam().arguments[i] == "MESH") all.push_back(i + 1);
    return all;
  }

  // Expects one line of error, with the program's name and what is wrong, and nothing on standard output.
  void expect_refused(const Outcome& outcome) const {
    EXPECT_EQ(outcome.exit_code, 2) << outcome;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(lines(outcome.err), 1u) << outcome;
    EXPECT_THAT(outcome.err, ::testing::StartsWith(GetParam().name + ": "));
  }

  ScratchFolder inputs, outputs;
};

inline std::string numbered_name(const ::testing::TestParamInfo<Job>& job) {
  return std::to_string(job.index) + "_" + job.param.test_name();
}

}  // namespace tetproof::test
