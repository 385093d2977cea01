// SPDX-License-Identifier: GPL-3.0-or-later
// The harness itself: it reports what a command did.
#include "tests/support/run_program.hpp"

namespace tetproof::test {
namespace {

TEST(RunProgram, CapturesBothStreamsAndTheExitCode) {
  const Outcome run = run_program({"sh", "-c", "cat; echo talk >&2; exit 7"}, {.input = "given\n"});
  EXPECT_EQ(run.exit_code, 7) << run;
  EXPECT_EQ(run.out, "given\n");
  EXPECT_EQ(run.err, "talk\n");
}

TEST(RunProgram, ArgumentsReachTheProgramAsTheyAre) {
  EXPECT_EQ(run_program({"printf", "%s|", "a b", "*", "$HOME", ""}).out, "a b|*|$HOME||");
}

TEST(RunProgram, MoreOutputThanAPipeHolds) {
  EXPECT_EQ(run_program({"head", "-c", "3000000", "/dev/zero"}).out.size(), 3000000u);
}

TEST(RunProgram, NamesTheSignal) {
  const Outcome run = run_program({"sh", "-c", "kill -SEGV $$"});
  EXPECT_EQ(run.signal, SIGSEGV);
  EXPECT_EQ(run.exit_code, -1);
}

TEST(RunProgram, EndsAProgramThatHangs) {
  const Outcome run = run_program({"sleep", "60"}, {.timeout_s = 1});
  EXPECT_EQ(run.signal, SIGALRM);
  EXPECT_LT(run.seconds, 10);
}

TEST(RunProgram, MissingProgramIs127) {
  EXPECT_EQ(run_program({"/nonexistent/program"}).exit_code, 127);
}

TEST(RunProgram, MeasuresPeakMemory) {
  // dd holds its one block of 64 MiB in memory.
  const Outcome run = run_program({"dd", "if=/dev/zero", "of=/dev/null", "bs=64M", "count=1"});
  EXPECT_GE(run.peak_memory_kib, 64 * 1024) << run;
  EXPECT_LT(run.peak_memory_kib, 128 * 1024) << run;
}

TEST(RunProgram, DirectoryAndScratchFolder) {
  std::string gone;
  {
    const ScratchFolder folder;
    gone = folder.path();
    EXPECT_TRUE(folder.names().empty());
    folder.write("b", "2");
    EXPECT_EQ(run_program({"sh", "-c", "echo 1 > a"}, {.directory = folder.path()}).exit_code, 0);
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(folder.read("a"), "1\n");
  }
  EXPECT_FALSE(std::filesystem::exists(gone));
}

}  // namespace
}  // namespace tetproof::test
