// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of reading through Gmsh: each is one line, Gmsh is stopped after some time, and nothing is left
// behind.
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/run_program.hpp"

namespace tetproof::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// The text of the error about `in`, after the names of the program and the file. Expects that it is one
/// line.
std::string refusal(const ScratchFolder& folder, const std::string& in,
                    const std::vector<std::string>& environment = {}) {
  const auto before = folder.names();
  const Outcome run = run_program({program("tetproof-convert"), in, "out.msh"},
                                  {.directory = folder / "", .environment = environment});
  EXPECT_EQ(run.exit_code, 2) << run;
  EXPECT_EQ(lines(run.err), 1u) << run;
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(folder.names(), before);
  const std::string start = "tetproof-convert: " + in + ": ";
  EXPECT_TRUE(run.err.starts_with(start)) << run;
  return run.err.size() > start.size() ? run.err.substr(start.size(), run.err.size() - start.size() - 1) : "";
}

/// Makes a script that replaces the helper program; returns the environment variable that names it.
std::string helper_that(const ScratchFolder& folder, const std::string& does) {
  const std::string path = folder.write("helper", "#!/bin/sh\n" + does + "\n");
  ::chmod(path.c_str(), 0755);
  return "TETPROOF_GMSH_IMPORT=" + path;
}

TEST(GmshImport, GmshsErrorsAreOurs) {
  const ScratchFolder folder;
  folder.write("bad.geo", "a = ;\n");
  folder.write("empty.geo", "");
  folder.write("bad.step", "garbage\n");
  folder.write("bad.unv", "garbage\n");
  folder.write("a.cgns", "garbage\n");
  folder.write("a.Unv", "garbage\n");
  folder.write("a.BREP", "garbage\n");
  folder.write("a.pos", "View \"pressure\" {\nSP(0,0,0){1};\n};\n");
  EXPECT_EQ(refusal(folder, "bad.geo"), "Gmsh: 'bad.geo', line 1: syntax error (;)");
  EXPECT_EQ(refusal(folder, "empty.geo"), "Gmsh: finds no mesh and no geometry in it");
  EXPECT_EQ(refusal(folder, "bad.step"), "Gmsh: Could not read file 'bad.step'");
  EXPECT_EQ(refusal(folder, "bad.unv"), "Gmsh: finds no mesh and no geometry in it");
  EXPECT_EQ(refusal(folder, "none.geo"), "cannot open: No such file or directory");
  EXPECT_EQ(refusal(folder, "a.Unv"), "Gmsh does not know the ending .Unv: call it .unv");
  EXPECT_EQ(refusal(folder, "a.BREP"), "Gmsh does not know the ending .BREP: call it .brep");
  EXPECT_EQ(refusal(folder, "a.pos"), "Gmsh: finds no mesh and no geometry in it, but 1 views of values");
  EXPECT_THAT(refusal(folder, "a.cgns"), HasSubstr("Gmsh"));
}

TEST(GmshImport, ACrashOfGmshIsAnError) {
  const ScratchFolder folder;
  // Which file crashes Gmsh depends on its version. Scripts in place of the helper crash for certain.
  folder.write("a.unv", "");
  EXPECT_EQ(refusal(folder, "a.unv", {helper_that(folder, "kill -SEGV $$")}),
            "Gmsh crashes on it (signal 11, Segmentation fault)");
  EXPECT_EQ(refusal(folder, "a.unv", {helper_that(folder, "echo 'Error   : lost a bolt'; kill -ABRT $$")}),
            "Gmsh crashes on it (signal 6, Aborted)");
  EXPECT_THAT(refusal(folder, "a.unv", {helper_that(folder, "exit 3")}),
              HasSubstr("helper ends with code 3"));
  EXPECT_EQ(refusal(folder, "a.unv", {helper_that(folder, "echo 'Error   : lost a bolt'; exit 0")}),
            "Gmsh: lost a bolt");
  EXPECT_THAT(refusal(folder, "a.unv", {helper_that(folder, "exit 0")}),
              HasSubstr("what Gmsh made of it cannot be read: "));
  EXPECT_THAT(refusal(folder, "a.unv", {helper_that(folder, "yes | head -c 30000000; exit 3")}),
              HasSubstr("helper ends with code 3"));
}

TEST(GmshImport, FilesThatCrashGmshDoNotReachIt) {
  const std::filesystem::path crashers =
      std::filesystem::path(TETPROOF_SOURCE_DIR) / "../shared/formats/handmade/gmsh484_crashers";
  if (!std::filesystem::exists(crashers)) GTEST_SKIP() << "no " << crashers;
  for (const auto& entry : std::filesystem::directory_iterator(crashers)) {
    const ScratchFolder folder;
    // Gmsh recognises these files by their first line, whatever their ending. So does our own reader.
    std::filesystem::copy_file(entry.path(), folder / "a.geo");
    const Outcome run =
        run_program({program("tetproof-convert"), "a.geo", "out.msh"}, {.directory = folder / ""});
    EXPECT_THAT(run.err, Not(HasSubstr("Gmsh crashes"))) << entry.path();
    if (run.exit_code == 0) {
      EXPECT_THAT(run.err, HasSubstr("by its content, though its name ends in .geo")) << entry.path();
    } else {
      EXPECT_TRUE(run.exit_code == 2 && lines(run.err) == 1) << entry.path() << run;
      EXPECT_EQ(folder.names(), std::vector<std::string>{"a.geo"});
    }
  }
}

TEST(GmshImport, MissingHelper) {
  const ScratchFolder folder;
  folder.write("a.unv", "");
  EXPECT_EQ(refusal(folder, "a.unv", {"TETPROOF_GMSH_IMPORT=/nowhere/helper"}),
            ".unv is read through Gmsh by the program tetproof-gmsh-import, expected at /nowhere/helper (the "
            "environment variable TETPROOF_GMSH_IMPORT says where it is)");
}

// The package only recommends Gmsh's library. A copy of the helper asks for one that is not there.
TEST(GmshImport, MissingLibrary) {
  const ScratchFolder folder;
  std::filesystem::copy_file(program("tetproof-gmsh-import"), folder / "helper");
  std::string helper = folder.read("helper");
  const std::size_t name = helper.find("libgmsh.so");
  ASSERT_NE(name, std::string::npos);
  helper.replace(name, 7, "libnone");
  const std::string path = folder.write("helper", helper);
  ::chmod(path.c_str(), 0755);
  folder.write("a.unv", "");
  const std::string said = refusal(folder, "a.unv", {"TETPROOF_GMSH_IMPORT=" + path});
  EXPECT_TRUE(said.starts_with(".unv is read through Gmsh, whose library is not installed: libnone.so"))
      << said;
}

TEST(GmshImport, NoLongerThanAllowed) {
  const ScratchFolder folder;
  folder.write("a.geo", "SystemCall \"sleep 1000\";\n");
  const Outcome run =
      run_program({program("tetproof-convert"), "a.geo", "out.msh"},
                  {.directory = folder / "", .timeout_s = 30, .environment = {"TETPROOF_GMSH_TIMEOUT=0.5"}});
  EXPECT_EQ(run.exit_code, 2) << run;
  EXPECT_EQ(run.err,
            "tetproof-convert: a.geo: Gmsh is not done after 0.5 s (the environment variable "
            "TETPROOF_GMSH_TIMEOUT says how long it may take)\n");
  EXPECT_LT(run.seconds, 15);
  const Outcome nonsense =
      run_program({program("tetproof-convert"), "a.geo", "out.msh"},
                  {.directory = folder / "", .environment = {"TETPROOF_GMSH_TIMEOUT=soon"}});
  EXPECT_EQ(
      nonsense.err,
      "tetproof-convert: TETPROOF_GMSH_TIMEOUT: expected seconds above 0 and up to 1e9, found 'soon'\n");
}

TEST(GmshImport, NothingStaysBehind) {
  const ScratchFolder folder, temporary;
  folder.write("a.unv", "");
  // The helper shows that its standard input is empty (`cat` ends) and which files it has open. Then it is
  // stopped together with the program.
  const std::string helper = helper_that(folder, "cat; ls /proc/self/fd > fds; touch started; sleep 1000");
  const pid_t child = ::fork();
  if (child == 0) {
    ::putenv(const_cast<char*>(helper.c_str()));
    const std::string home = "TMPDIR=" + temporary.path();
    ::putenv(const_cast<char*>(home.c_str()));
    if (::chdir(folder.path().c_str()) == 0)
      ::execl(program("tetproof-convert").c_str(), "tetproof-convert", "a.unv", "out.msh", nullptr);
    ::_exit(127);
  }
  for (int i = 0; i < 500 && !folder.has("started"); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_TRUE(folder.has("started"));
  EXPECT_EQ(temporary.names(), std::vector<std::string>{});
  EXPECT_EQ(folder.read("fds"), "0\n1\n2\n3\n4\n");  // 4 is the folder that `ls` reads
  ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(temporary.names(), std::vector<std::string>{});
}

}  // namespace
}  // namespace tetproof::test
