// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/meshing/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "tests/support/run_program.hpp"

namespace tetproof::corpus {
namespace {

using test::ScratchFolder;

ProcessEnd shell(const std::string& script, const Limits& limits = {}, const std::string& folder = "") {
  ProcessOptions options;
  options.limits = limits;
  options.folder = folder;
  return run_process({"sh", "-c", script}, options);
}

bool lives(const std::string& pid) {
  return ::kill(std::atoi(pid.c_str()), 0) == 0;
}

/// Whether the process is gone, at the latest in five seconds.
bool goes(const std::string& pid) {
  for (int i = 0; i < 500 && lives(pid); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return !lives(pid);
}

TEST(Process, TellsExitCodesAndSignals) {
  EXPECT_EQ(shell("exit 7").exit_code, 7);
  EXPECT_EQ(shell("exit 0").exit_code, 0);
  const ProcessEnd end = shell("kill -SEGV $$");
  EXPECT_EQ(end.exit_code, -1);
  EXPECT_EQ(end.signal, SIGSEGV);
  EXPECT_EQ(end.limit, Limit::none);
}

TEST(Process, ReadsOutputAndErrorsInTheirOrder) {
  EXPECT_EQ(shell("echo 1; echo 2 >&2; echo 3; echo 4 >&2; printf 5").output, "1\n2\n3\n4\n5");
}

TEST(Process, InputIsEmpty) {
  EXPECT_EQ(shell("cat; echo end").output, "end\n");
}

TEST(Process, RunsInTheFolderWithItsVariables) {
  const ScratchFolder folder;
  ProcessOptions options;
  options.folder = folder.path();
  options.environment = {"TETPROOF_A=x", "HOME=/nowhere"};
  EXPECT_EQ(run_process({"sh", "-c", "pwd; echo $TETPROOF_A $HOME"}, options).output,
            folder.path() + "\nx /nowhere\n");
  options.folder = folder / "missing";
  EXPECT_THROW(run_process({"true"}, options), std::system_error);
}

TEST(Process, LinesOfAProgramThatAbortsAreNotLost) {
  if (!test::have_tool("stdbuf") || !test::have_tool("python3")) GTEST_SKIP();
  // The C library's own buffer, as a C program has it.
  const ProcessEnd end = run_process(
      {"python3", "-c", "import ctypes, os; c = ctypes.CDLL(None); c.puts(b'last words'); os.abort()"});
  EXPECT_EQ(end.signal, SIGABRT);
  EXPECT_EQ(end.output.substr(0, 11), "last words\n");
}

TEST(Process, AMissingProgramIsNotStarted) {
  for (const char* name : {"no-such-program", "/no/such/program", "/etc/passwd"}) {
    const ProcessEnd end = run_process({name});
    EXPECT_FALSE(end.started) << name;
    EXPECT_NE(end.output.find(name), std::string::npos);
  }
  const ScratchFolder folder;
  const std::string script = folder.write("script", "not a program");
  ::chmod(script.c_str(), 0755);
  EXPECT_FALSE(run_process({script}).started);
}

TEST(Process, LimitsCpuTimeOfAllProcessesTogether) {
  const ProcessEnd end = shell("for i in 1 2 3; do (while :; do :; done) & done; wait", {0.6, 60, 2000});
  EXPECT_EQ(end.limit, Limit::cpu);
  EXPECT_GT(end.cpu_s, 0.6);
  EXPECT_LT(end.cpu_s, 1.5);
}

TEST(Process, CountsCpuTimeOfWhatHasEnded) {
  const ProcessEnd end = shell("i=0; while [ $i -lt 4000 ]; do /bin/true; i=$((i+1)); done", {0.3, 60, 2000});
  EXPECT_EQ(end.limit, Limit::cpu);
}

TEST(Process, LimitsWallTime) {
  const ProcessEnd end = shell("trap '' TERM INT HUP; sleep 1000", {5, 0.4, 2000});
  EXPECT_EQ(end.limit, Limit::wall);
  EXPECT_EQ(end.signal, SIGKILL);
  EXPECT_GE(end.wall_s, 0.4);
  EXPECT_LT(end.wall_s, 10);
  EXPECT_LT(end.cpu_s, 1);
}

TEST(Process, LimitsMemoryOfAllProcessesTogether) {
  if (!test::have_tool("python3")) GTEST_SKIP();
  const std::string hog = "python3 -c 'import time; a = bytearray(70000000); time.sleep(60)'";
  const ProcessEnd one = shell(hog, {5, 1.5, 150}), two = shell(hog + " & " + hog, {5, 60, 150});
  EXPECT_EQ(one.limit, Limit::wall);
  EXPECT_GT(one.peak_mb, 69);
  EXPECT_EQ(two.limit, Limit::memory);
  EXPECT_GT(two.peak_mb, 149);
}

TEST(Process, WhatItLeftBehindIsGone) {
  const ScratchFolder folder;
  const ProcessEnd end = shell(
      "setsid sh -c 'trap \"\" TERM HUP; echo $$ > pid; exec sleep 1000' & while ! [ -s pid ]; do :; done",
      {}, folder.path());
  EXPECT_EQ(end.exit_code, 0);
  EXPECT_FALSE(lives(folder.read("pid")));
}

TEST(Process, AGrandchildInASessionOfItsOwnIsGoneAfterTheLimit) {
  const ScratchFolder folder;
  const ProcessEnd end =
      shell("setsid sh -c 'echo $$ > pid; exec sleep 1000' & sleep 1000", {5, 0.5, 2000}, folder.path());
  EXPECT_EQ(end.limit, Limit::wall);
  EXPECT_FALSE(lives(folder.read("pid")));
}

TEST(Process, AllAreGoneWhenThisProgramIsKilled) {
  const ScratchFolder folder;
  const pid_t owner = ::fork();
  ASSERT_GE(owner, 0);
  if (owner == 0) {
    shell("echo $$ > child; setsid sh -c 'echo $$ > grandchild; exec sleep 1000' & sleep 1000",
          {50, 500, 2000}, folder.path());
    ::_exit(0);
  }
  for (int i = 0; i < 500 && !(folder.has("grandchild") && !folder.read("grandchild").empty()); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  ASSERT_TRUE(lives(folder.read("child")));
  ASSERT_TRUE(lives(folder.read("grandchild")));
  ::kill(owner, SIGKILL);
  ::waitpid(owner, nullptr, 0);
  EXPECT_TRUE(goes(folder.read("child")));
  EXPECT_TRUE(goes(folder.read("grandchild")));
}

TEST(Process, LongOutputKeepsItsBeginningAndEnd) {
  ProcessOptions options;
  options.most_output = 1000;
  const ProcessEnd end = run_process(
      {"sh", "-c", "echo first; head -c 64000000 /dev/zero | tr '\\0' x; echo; echo last"}, options);
  EXPECT_EQ(end.exit_code, 0);
  EXPECT_EQ(end.output.substr(0, 8), "first\nxx");
  EXPECT_EQ(end.output.substr(end.output.size() - 6), "\nlast\n");
  // 6 + 64,000,000 + 1 + 5 bytes, of which 1000 are kept.
  EXPECT_NE(end.output.find("\n[63999012 bytes of output were cut here]\n"), std::string::npos);
  EXPECT_LT(end.output.size(), 1100u);
}

TEST(Process, ClosedOutputDoesNotEndTheWait) {
  const ScratchFolder folder;
  shell("exec >&- 2>&-; sleep 0.3; echo done > file", {}, folder.path());
  EXPECT_TRUE(folder.has("file"));
}

TEST(Process, ManyThreadsAtOnce) {
  std::vector<std::thread> threads;
  std::vector<int> wrong(8);
  for (std::size_t k = 0; k < wrong.size(); ++k)
    threads.emplace_back([&wrong, k] {
      for (int i = 0; i < 25; ++i) {
        const std::string word = std::to_string(100 * k) + "-" + std::to_string(i);
        const ProcessEnd end = shell("echo " + word + "; exit " + std::to_string(k + 1));
        wrong[k] += end.output != word + "\n" || end.exit_code != static_cast<int>(k + 1);
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, std::vector<int>(8));
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);  // no process is left unwaited
  EXPECT_EQ(errno, ECHILD);
}

TEST(Process, SignalsOfTheCallerAreNotInherited) {
  const auto before = ::signal(SIGPIPE, SIG_IGN);
  EXPECT_EQ(shell("kill -PIPE $$; echo survived").signal, SIGPIPE);
  ::signal(SIGPIPE, before);
}

TEST(Process, RefusesSenselessLimits) {
  EXPECT_THROW(run_process({}), std::invalid_argument);
  EXPECT_THROW(shell("true", {0, 1, 1}), std::invalid_argument);
}

TEST(Backtrace, LeavesTheFramesOfSystemLibrariesOut) {
  EXPECT_THAT(
      own_frames({"Thread 2 received signal SIGSEGV", "#0  0x00007f11 in raise () from /lib/libc.so.6",
                  "#1  0x00007f12 in refine(int, double) () from /lib/x86_64-linux-gnu/libmesher.so.4.8",
                  "#2  0x00007f13 in GOMP_parallel () from /lib/x86_64-linux-gnu/libgomp.so.1",
                  "#3  mesh_all () at mesh.c:12", "#4  0x00007f14 in ?? ()"}),
      ::testing::ElementsAre("refine", "mesh_all", "?"));
}

TEST(Backtrace, NamesTheFunctionsOfACrash) {
  if (!test::have_tool("gdb") || ::access("/usr/bin/python3", X_OK) != 0) GTEST_SKIP();
  const std::vector<std::string> frames =
      backtrace({"/usr/bin/python3", "-c", "import ctypes; ctypes.CDLL(None).strlen(1)"});
  ASSERT_FALSE(frames.empty());  // strlen itself is the C library's
  for (const std::string& frame : frames) EXPECT_EQ(frame.find("strlen"), std::string::npos);
  // Where a program exits by itself, only on demand.
  const std::vector<std::string> exits{"/usr/bin/python3", "-c", "import os; os._exit(3)"};
  EXPECT_TRUE(backtrace(exits).empty());
  EXPECT_FALSE(backtrace(exits, {}, true).empty());
  EXPECT_TRUE(backtrace({"true"}).empty());
  EXPECT_TRUE(backtrace({"no-such-program"}).empty());
}

}  // namespace
}  // namespace tetproof::corpus
