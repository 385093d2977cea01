// SPDX-License-Identifier: GPL-3.0-or-later
// The process between this program and a command.
//
// Why a process of its own? It is the subreaper of the command: whatever the command leaves behind, also in a
// session of its own, becomes the warden's child, so that no process can get away and the CPU time of all is
// counted; no two threads of this program ever wait for the same process; and when this program is killed,
// the warden is still there to end the command. It runs between fork and exec, in the copy of a program with
// many threads, and so it uses system calls only.
//
// There is no limit of the address space: sanitizers and threads reserve far more than they use. Resident
// memory is read every few milliseconds instead, in which a command can take some 20 MB more than allowed.
#include "corpus/meshing/warden.hpp"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "corpus/meshing/process_tree.hpp"

namespace tetproof::corpus {

namespace {

constexpr double longest_pause_s = 0.01;

double now() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// CPU time of all that has ended.
double ended_cpu() {
  rusage usage{};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Lowers a limit; one that is lower already stays.
void lower_limit(int resource, double value) {
  rlimit limit{};
  if (::getrlimit(static_cast<__rlimit_resource_t>(resource), &limit) != 0 || !(value < 1e18)) return;
  const auto wanted = static_cast<rlim_t>(value);
  limit.rlim_max = std::min(limit.rlim_max, wanted);
  limit.rlim_cur = std::min(limit.rlim_cur, wanted);
  ::setrlimit(static_cast<__rlimit_resource_t>(resource), &limit);
}

/// Closes what the fork copied: another command's pipe would not end while it is open here.
void keep_only(int a, int b) {
  const unsigned low = static_cast<unsigned>(std::min(a, b)), high = static_cast<unsigned>(std::max(a, b));
  const auto close_all = [](unsigned first, unsigned last) {
    if (first > last || ::syscall(SYS_close_range, first, last, 0u) == 0) return;
    rlimit limit{};  // a kernel before 5.9
    ::getrlimit(RLIMIT_NOFILE, &limit);
    const auto most = static_cast<unsigned>(std::min<rlim_t>(limit.rlim_cur, 1 << 16));
    for (unsigned i = first; i <= std::min(last, most); ++i) ::close(static_cast<int>(i));
  };
  if (low > 0) close_all(0, low - 1);
  close_all(low + 1, high - 1);
  close_all(high + 1, ~0u);
}

/// In the child that becomes the command. It shares the warden's memory until exec.
void start(const Order& order, pid_t warden, WardenReport& report) {
  ::setsid();
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != warden) ::_exit(127);  // the warden died before the line above
  // Copies with high numbers first: the pipe itself has one of 0 to 2 where the caller has closed those.
  const int input = ::fcntl(::open("/dev/null", O_RDONLY | O_CLOEXEC), F_DUPFD_CLOEXEC, 10);
  const int output = ::fcntl(order.output, F_DUPFD_CLOEXEC, 10);
  ::dup2(input, 0);
  ::dup2(output, 1);
  ::dup2(output, 2);
  if (order.folder && ::chdir(order.folder) != 0) {
    report.error = errno;
    report.bad_folder = true;
    ::_exit(127);
  }
  lower_limit(RLIMIT_CORE, 0);  // a core file takes seconds
  // What the warden's reading of times cannot do if the machine is too busy for it; each process by itself.
  lower_limit(RLIMIT_CPU, std::ceil(order.limits.cpu_s) + 2);
  lower_limit(RLIMIT_FSIZE, std::max(1e9, 1e6 * static_cast<double>(order.limits.memory_mb)));
  if (const int file = ::open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC); file >= 0) {
    // Where the whole machine runs out of memory, the kernel shall end the command and nobody else.
    static_cast<void>(!::write(file, "800", 3));
    ::close(file);
  }
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::execve(order.program, order.words, order.environment);
  report.error = errno;
  ::_exit(127);
}

/// Forks without copying the warden's memory: the warden sleeps until the child is the command.
__attribute__((noinline)) pid_t fork_command(const Order& order, WardenReport& report) {
  const pid_t warden = ::getpid();
  const pid_t child = ::vfork();
  if (child == 0) start(order, warden, report);
  return child;
}

/// Waits for what has ended; false when nothing is left. Takes the command's own status on the way.
bool reap(pid_t command, bool& ended, WardenReport& report) {
  for (;;) {
    int status = 0;
    const pid_t done = ::waitpid(-1, &status, WNOHANG);
    if (done == 0) return true;
    if (done < 0) {
      if (errno == EINTR) continue;
      return false;
    }
    if (done == command) {
      report.status = status;
      ended = true;
    }
  }
}

void pause(double most_s) {
  sigset_t child;
  ::sigemptyset(&child);
  ::sigaddset(&child, SIGCHLD);
  const timespec time{0, static_cast<long>(1e9 * most_s)};
  ::sigtimedwait(&child, nullptr, &time);
}

void watch(const Order& order, pid_t command, WardenReport& report) {
  const double begin = now(), tick = 1.0 / static_cast<double>(::sysconf(_SC_CLK_TCK));
  const auto page = static_cast<std::int64_t>(::sysconf(_SC_PAGESIZE));
  bool ended = false;
  double pause_s = 0.0005;
  while (reap(command, ended, report) && !ended) {
    const TreeUse use = walk_process_tree(::getpid(), 0);
    report.peak_bytes = std::max(report.peak_bytes, use.pages * page);
    const double cpu = ended_cpu() + tick * static_cast<double>(use.cpu_ticks);
    if (cpu > order.limits.cpu_s)
      report.limit = Limit::cpu;
    else if (now() - begin > order.limits.wall_s)
      report.limit = Limit::wall;
    else if (use.pages * page > 1000000 * order.limits.memory_mb)
      report.limit = Limit::memory;
    if (report.limit != Limit::none || ::getppid() != order.owner) break;
    pause(pause_s);
    pause_s = std::min(longest_pause_s, 1.5 * pause_s);
  }
  // The group dies at once; the tree in rounds, because what loses its parent becomes the warden's child.
  for (pause_s = 0.0005; reap(command, ended, report); pause_s = std::min(longest_pause_s, 2 * pause_s)) {
    if (!ended) ::kill(-command, SIGKILL);
    walk_process_tree(::getpid(), SIGKILL);
    pause(pause_s);
  }
  report.cpu_s = ended_cpu();
  report.wall_s = now() - begin;
}

}  // namespace

void be_warden(const Order& order) {
  ::setsid();  // the terminal's interrupt shall not end the warden before its command
  ::prctl(PR_SET_NAME, "tetproof-warden");
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  for (int i = 1; i < NSIG; ++i) ::signal(i, SIG_DFL);
  keep_only(order.output, order.results);
  WardenReport report;
  const pid_t command = fork_command(order, report);
  if (command < 0) {
    report.error = errno;
  } else {
    ::close(order.output);
    watch(order, command, report);
  }
  static_cast<void>(!::write(order.results, &report, sizeof report));
  ::_exit(0);
}

}  // namespace tetproof::corpus
