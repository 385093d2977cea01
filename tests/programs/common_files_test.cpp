// SPDX-License-Identifier: GPL-3.0-or-later
// Which files may be inputs and outputs of a program. An output never replaces an input or another output.
// Standard input and standard output stand for one file each. A target that cannot hold the grid is refused
// before the work.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/programs/common_jobs.hpp"

namespace tetproof::test {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

class CommonFiles : public CommonBehaviour {
 protected:
  CommonFiles() {
    for (const std::string& name : inputs.names()) before.push_back(inputs.read(name));
  }

  // Expects a refusal, and that no file has changed or appeared.
  void expect_same_file_refused(const std::vector<std::string>& command, const std::string& argument) {
    const std::vector<std::string> there = outputs.names();
    const Outcome outcome = run_program(command);
    SCOPED_TRACE(::testing::PrintToString(command));
    expect_refused(outcome);
    EXPECT_THAT(outcome.err, HasSubstr(" is the same file as "));
    EXPECT_THAT(outcome.err, HasSubstr("(" + argument + ")"));
    std::vector<std::string> after;
    for (const std::string& name : inputs.names()) after.push_back(inputs.read(name));
    EXPECT_EQ(after, before);
    EXPECT_EQ(outputs.names(), there);
  }

  std::vector<std::string> before;  // the bytes of the inputs
};

INSTANTIATE_TEST_SUITE_P(Programs, CommonFiles, ::testing::ValuesIn(jobs), numbered_name);

TEST_P(CommonFiles, AnInputIsNoOutput) {
  for (const std::size_t position : inputs_in_command()) {
    const fs::path input = command("")[position];
    // The file itself, its other names, and another file of its set. All names end in .node, which every
    // option accepts.
    std::vector<std::string> names{input.string(), inputs / ("./" + input.filename().string()),
                                   outputs / "symbolic.node", outputs / "hard.node"};
    fs::create_symlink(input, outputs / "symbolic.node");
    fs::create_hard_link(input, outputs / "hard.node");
    if (input.extension() == ".node") names.push_back(inputs / "octahedron.ele");
    for (const std::string& name : names) {
      for (const std::string& option : GetParam().outputs)
        if (option != "--defects" || !name.ends_with(".off"))  // .off: refused for another reason
          expect_same_file_refused(command(outputs / "out.msh", {option, name}), option);
      if (GetParam().writes && !name.ends_with(".off"))
        expect_same_file_refused(command(name), GetParam().name == "tetproof-mesh" ? "-o" : "OUT");
    }
    fs::remove(outputs / "symbolic.node");
    fs::remove(outputs / "hard.node");
  }
}

TEST_P(CommonFiles, TwoOutputsAreTwoFiles) {
  fs::create_directory(outputs / "folder");
  fs::create_directory_symlink(outputs / "folder", outputs / "link");
  std::vector<std::string> options = GetParam().outputs;
  for (std::size_t i = 0; i < options.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      for (const char* other : {"folder/out.node", "./folder//out.node", "link/out.node"})
        expect_same_file_refused(command(outputs / "out.msh", {options[i], outputs / "folder/out.node",
                                                               options[k], outputs / other}),
                                 options[i]);
      EXPECT_TRUE(fs::is_empty(outputs / "folder"));
    }
    if (!GetParam().writes) continue;
    for (const char* other : {"folder/out.msh", "link/out.msh"})
      expect_same_file_refused(command(outputs / "folder/out.msh", {options[i], outputs / other}),
                               options[i]);
    // Another file of the set that OUT names.
    expect_same_file_refused(command(outputs / "folder/out.node", {options[i], outputs / "link/out.ele"}),
                             options[i]);
    EXPECT_TRUE(fs::is_empty(outputs / "folder"));
  }
}

TEST_P(CommonFiles, StandardOutputHasRoomForOne) {
  for (const std::string& option : GetParam().outputs) {
    if (option == "--json" || option == "--defects") continue;
    const Outcome outcome = run({"--json", "-", option, "-"});
    expect_refused(outcome);
    EXPECT_THAT(outcome.err,
                AnyOf(HasSubstr("--json - and " + option + " -: only one of them fits on standard"),
                      HasSubstr(option + " - and --json -: only one of them fits on standard")));
    EXPECT_TRUE(outputs.names().empty());
    const Outcome alone = run({option, "-"});
    EXPECT_EQ(alone.exit_code, 0) << alone;
    EXPECT_EQ(run({option, outputs / "out.file"}).exit_code, 0);
    EXPECT_EQ(alone.out, outputs.read("out.file")) << "nothing else is on standard output";
    for (const std::string& name : outputs.names()) fs::remove(outputs / name);
  }
}

TEST_P(CommonFiles, AMeshDoesNotGoToStandardOutput) {
  if (GetParam().writes) expect_refused(run_program(command("-")));
  for (const std::string& option : GetParam().outputs)
    if (option == "--defects") expect_refused(run({option, "-"}));
}

TEST_P(CommonFiles, NothingIsLostInDevNull) {
  std::vector<std::string> options;
  for (const std::string& option : GetParam().outputs)
    if (option != "--defects") options.insert(options.end(), {option, "/dev/null"});
  const Outcome outcome = run(options);
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
}

TEST_P(CommonFiles, StandardInputIsAnyOneFile) {
  inputs.write("octahedron.msh", octahedron_msh);
  for (const std::size_t position : inputs_in_command()) {
    std::vector<std::string> words = command(outputs / "out.msh", {"--json", "-"});
    const bool surface = words[position].ends_with(".off");
    if (!surface) words[position] = inputs / "octahedron.msh";
    const Outcome named = run_program(words);
    ASSERT_EQ(named.exit_code, 0) << named;
    const std::string written = GetParam().writes ? outputs.read("out.msh") : "";
    words[position] = "-";
    const Outcome piped = run_program(words, {.input = surface ? octahedron_off : octahedron_msh});
    EXPECT_EQ(piped.exit_code, 0) << piped;
    EXPECT_EQ(GetParam().writes ? outputs.read("out.msh") : "", written);
    // Only the name of the file differs.
    const auto json_without_names = [](const std::string& text) {
      nlohmann::json json = nlohmann::json::parse(text);
      for (const char* key : {"input", "other", "reference"})
        if (json.contains(key) && json[key].is_object()) json[key].erase("file");
      if (json.contains("generation")) json["generation"]["surface"].erase("file");
      return json;
    };
    EXPECT_EQ(json_without_names(piped.out), json_without_names(named.out));
  }
}

TEST_P(CommonFiles, StandardInputIsOneFileOnly) {
  const std::vector<std::size_t> positions = inputs_in_command();
  if (positions.size() < 2) return;
  std::vector<std::string> words = command(outputs / "out.msh");
  for (const std::size_t position : positions) words[position] = "-";
  const Outcome outcome = run_program(words, {.input = octahedron_msh});
  expect_refused(outcome);
  EXPECT_THAT(outcome.err, HasSubstr(": only one of them can be standard input"));
}

// The shell opens the file, so its name is not on the command line.
TEST_P(CommonFiles, AnInputBehindStandardInputIsNoOutput) {
  inputs.write("octahedron.msh", octahedron_msh);
  for (const std::size_t position : inputs_in_command()) {
    std::vector<std::string> words = command(outputs / "out.msh");
    const std::string input = words[position].ends_with(".off") ? words[position] : inputs / "octahedron.msh";
    words[position] = "-";
    words.insert(words.end(), {"--json", input});
    words.insert(words.begin(), {"sh", "-c", "exec \"$0\" \"$@\" < " + input});
    const std::string bytes = inputs.read(fs::path(input).filename());
    const Outcome outcome = run_program(words);
    expect_refused(outcome);
    EXPECT_THAT(outcome.err, HasSubstr("(--json) is the same file as - ("));
    EXPECT_EQ(inputs.read(fs::path(input).filename()), bytes);
  }
}

// Files with an unknown ending, or with the ending of another format.
TEST_P(CommonFiles, FromSaysTheFormat) {
  if (GetParam().name == "tetproof-compare") return;
  inputs.write("octahedron.obj",
               "v 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n"
               "f 2 1 6\nf 3 2 6\nf 4 3 6\nf 1 4 6\n");
  inputs.write(
      "octahedron.mesh",
      "MeshVersionFormatted 2\nDimension 3\nVertices\n6\n1 0 0 0\n0 1 0 0\n-1 0 0 0\n0 -1 0 0\n0 0 1 0\n"
      "0 0 -1 0\nTetrahedra\n4\n1 2 6 5 0\n2 3 6 5 0\n3 4 6 5 0\n4 1 6 5 0\nEnd\n");
  for (const std::size_t position : inputs_in_command()) {
    std::vector<std::string> words = command(outputs / "out.msh");
    const bool surface = words[position].ends_with(".off");
    const std::string option = surface && GetParam().name == "tetproof-verify" ? "--surface-from" : "--from";
    const std::string format = surface ? "obj" : "medit";
    const std::string content = inputs.read(surface ? "octahedron.obj" : "octahedron.mesh");
    for (const std::string& name : {inputs.write("octahedron.unknown", content),
                                    inputs.write("octahedron.vtu", content), std::string("-")}) {
      words[position] = name;
      std::vector<std::string> told = words;
      told.insert(told.end(), {option, format});
      const Outcome outcome = run_program(told, {.input = content});
      EXPECT_EQ(outcome.exit_code, 0) << name << outcome;
      told.back() = "stl";  // the option also overrules the content
      expect_refused(run_program(told, {.input = content}));
    }
    words.insert(words.end(), {option, "no-such-format"});
    const Outcome outcome = run_program(words);
    expect_refused(outcome);
    EXPECT_THAT(outcome.err, HasSubstr("no-such-format"));
  }
}

}  // namespace
}  // namespace tetproof::test
