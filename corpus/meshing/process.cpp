// SPDX-License-Identifier: GPL-3.0-or-later
// Runs commands: prepares what the warden needs, forks it, and collects the command's output.
#include "corpus/meshing/process.hpp"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "corpus/meshing/kept_output.hpp"
#include "corpus/meshing/line_buffering.hpp"
#include "corpus/meshing/program_path.hpp"
#include "corpus/meshing/warden.hpp"

extern char** environ;

namespace tetproof::corpus {

namespace {

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// A pipe that no command inherits.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_, O_CLOEXEC) != 0) fail("pipe");
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    close_reader();
    close_writer();
  }
  int reader() const { return ends_[0]; }
  int writer() const { return ends_[1]; }
  void close_reader() {
    if (ends_[0] >= 0) ::close(ends_[0]);
    ends_[0] = -1;
  }
  void close_writer() {
    if (ends_[1] >= 0) ::close(ends_[1]);
    ends_[1] = -1;
  }

 private:
  int ends_[2];
};

/// Reads once; 0 at the end.
std::size_t read_some(int descriptor, char* buffer, std::size_t size) {
  for (;;) {
    const ssize_t got = ::read(descriptor, buffer, size);
    if (got >= 0) return static_cast<std::size_t>(got);
    if (errno != EINTR) fail("reading a program's output");
  }
}

std::vector<char*> pointers(const std::vector<std::string>& words) {
  std::vector<char*> result;
  result.reserve(words.size() + 1);
  for (const std::string& word : words) result.push_back(const_cast<char*>(word.c_str()));
  result.push_back(nullptr);
  return result;
}

/// This program's environment with `more`, of which the later ones win.
std::vector<std::string> merged_environment(const std::vector<std::string>& more) {
  std::vector<std::string> result;
  const auto set = [&result](const std::string& variable) {
    const std::string_view name = std::string_view(variable).substr(0, variable.find('=') + 1);
    for (std::string& present : result)
      if (present.compare(0, name.size(), name) == 0) {
        present = variable;
        return;
      }
    result.push_back(variable);
  };
  for (char** variable = environ; variable && *variable; ++variable) result.emplace_back(*variable);
  for (const std::string& variable : more) set(variable);
  for (const std::string& variable : line_buffering(result)) set(variable);
  return result;
}

/// Forks with all signals blocked: no handler of this program may run in the warden.
pid_t fork_warden(const Order& order) {
  sigset_t all, before;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);
  const pid_t warden = ::fork();
  if (warden == 0) be_warden(order);
  const int error = errno;
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  errno = error;
  return warden;
}

ProcessEnd not_started(const std::string& program, const std::string& why) {
  ProcessEnd end;
  end.started = false;
  end.output = program + ": " + why + "\n";
  return end;
}

bool allowed(double seconds) {
  return std::isfinite(seconds) && seconds > 0;
}

}  // namespace

ProcessEnd run_process(const std::vector<std::string>& command, const ProcessOptions& options) {
  if (command.empty()) throw std::invalid_argument("run_process: an empty command");
  if (!allowed(options.limits.cpu_s) || !allowed(options.limits.wall_s) || options.limits.memory_mb <= 0)
    throw std::invalid_argument("run_process: a limit that is not positive and finite");
  const std::string program = program_path(command[0]);
  if (program.empty()) return not_started(command[0], "there is no such program");
  const std::vector<std::string> environment = merged_environment(options.environment);
  const std::vector<char*> words = pointers(command), variables = pointers(environment);

  Pipe output, results;
  Order order;
  order.program = program.c_str();
  order.words = words.data();
  order.environment = variables.data();
  order.folder = options.folder.empty() ? nullptr : options.folder.c_str();
  order.limits = options.limits;
  order.output = output.writer();
  order.results = results.writer();
  order.owner = ::getpid();
  const pid_t warden = fork_warden(order);
  if (warden < 0) fail("fork");
  output.close_writer();
  results.close_writer();
  // The warden ends, and is waited for, even if its output cannot be kept.
  struct Waits {
    Pipe& output;
    pid_t warden;
    ~Waits() {
      output.close_reader();
      while (::waitpid(warden, nullptr, 0) < 0 && errno == EINTR) {
      }
    }
  };
  std::optional<Waits> waits(std::in_place, output, warden);

  KeptOutput kept(options.most_output);
  std::vector<char> buffer(1 << 16);
  while (const std::size_t got = read_some(output.reader(), buffer.data(), buffer.size()))
    kept.add(buffer.data(), got);
  WardenReport report;
  std::size_t have = 0;
  while (have < sizeof report) {
    const std::size_t got =
        read_some(results.reader(), reinterpret_cast<char*>(&report) + have, sizeof report - have);
    if (got == 0) break;
    have += got;
  }
  waits.reset();
  if (have < sizeof report)
    throw std::runtime_error("the process that watches " + command[0] + " was killed");
  if (report.bad_folder) throw std::system_error(report.error, std::generic_category(), options.folder);
  if (report.error) return not_started(command[0], std::strerror(report.error));

  ProcessEnd end;
  if (WIFEXITED(report.status)) end.exit_code = WEXITSTATUS(report.status);
  if (WIFSIGNALED(report.status)) end.signal = WTERMSIG(report.status);
  end.limit = report.limit;
  // The kernel's own limits, where the warden came too late.
  if (end.limit == Limit::none && (end.signal == SIGXCPU || end.signal == SIGKILL) &&
      report.cpu_s > options.limits.cpu_s)
    end.limit = Limit::cpu;
  if (end.limit == Limit::none && end.signal == SIGXFSZ) end.limit = Limit::memory;
  end.output = kept.text();
  end.cpu_s = report.cpu_s;
  end.wall_s = report.wall_s;
  end.peak_mb = report.peak_bytes / 1000000;
  return end;
}

}  // namespace tetproof::corpus
