// SPDX-License-Identifier: GPL-3.0-or-later
// Starts a process, takes what it says, and ends it when its time is over.
#include "io/gmsh/gmsh_import_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <system_error>

extern char** environ;

namespace tetproof::io {
namespace {

[[noreturn]] void fail(const char* what, int reason = errno) {
  throw std::system_error(reason, std::generic_category(), what);
}

struct Descriptor {
  int number = -1;
  ~Descriptor() { close(); }
  void close() {
    if (number >= 0) ::close(number);
    number = -1;
  }
};

// The descriptors and settings with which a process begins.
struct Start {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;

  Start(int output, int shared) {
    if (::posix_spawn_file_actions_init(&files) || ::posix_spawnattr_init(&attributes)) fail("posix_spawn");
    sigset_t none, all;
    ::sigemptyset(&none);
    ::sigfillset(&all);
    // The shared file comes last. Until then its number is above 3, see run_process.
    if (::posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0) ||
        ::posix_spawn_file_actions_adddup2(&files, output, 1) ||
        ::posix_spawn_file_actions_adddup2(&files, output, 2) ||
        ::posix_spawn_file_actions_adddup2(&files, shared, 3) ||
        ::posix_spawn_file_actions_addclosefrom_np(&files, 4) ||
        ::posix_spawnattr_setsigmask(&attributes, &none) ||
        ::posix_spawnattr_setsigdefault(&attributes, &all) || ::posix_spawnattr_setpgroup(&attributes, 0) ||
        ::posix_spawnattr_setflags(&attributes,
                                   POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP))
      fail("posix_spawn");
  }
  ~Start() {
    ::posix_spawn_file_actions_destroy(&files);
    ::posix_spawnattr_destroy(&attributes);
  }
};

// Takes what is in the pipe and does not wait for more. False at its end.
bool drain(int pipe, std::string& said) {
  constexpr std::size_t most = std::size_t{1} << 20;
  char buffer[1 << 14];
  for (;;) {
    const ssize_t got = ::read(pipe, buffer, sizeof buffer);
    if (got == 0) return false;
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return errno == EAGAIN;
    said.append(buffer, std::min(static_cast<std::size_t>(got), most - said.size()));
  }
}

}  // namespace

NamelessFile::NamelessFile() {
  std::string name = (std::filesystem::temp_directory_path() / "tetproof-XXXXXX").string();
  descriptor_ = ::mkostemp(name.data(), O_CLOEXEC);
  if (descriptor_ < 0) fail(name.c_str());
  ::unlink(name.c_str());
}

NamelessFile::~NamelessFile() {
  ::close(descriptor_);
}

std::string NamelessFile::path() const {
  return "/proc/self/fd/" + std::to_string(descriptor_);
}

ProcessEnd run_process(const std::vector<std::string>& command, int shared,
                       std::chrono::milliseconds allowed) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point deadline = Clock::now() + allowed;
  Descriptor in, out, high;
  {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) fail("pipe");
    // Numbers above 3: then a descriptor that is put in its place cannot overwrite another one.
    in.number = ends[0];
    const int copy = ::fcntl(ends[1], F_DUPFD_CLOEXEC, 10), reason = errno;
    ::close(ends[1]);
    out.number = copy;
    if (copy < 0) fail("fcntl", reason);
  }
  if ((high.number = ::fcntl(shared, F_DUPFD_CLOEXEC, 10)) < 0) fail("fcntl");
  if (::fcntl(in.number, F_SETFL, O_NONBLOCK) != 0) fail("fcntl");

  pid_t child = 0;
  {
    const Start start(out.number, high.number);
    std::vector<char*> words;
    for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    if (const int reason =
            ::posix_spawn(&child, words[0], &start.files, &start.attributes, words.data(), environ))
      fail(words[0], reason);
  }
  out.close();

  // The pipe's end shows at once that the process ended. But something that the process started may keep the
  // pipe open, so the process itself is checked too, every 50 ms.
  ProcessEnd end;
  int status = 0;
  for (bool open = true;;) {
    const pid_t ended = ::waitpid(child, &status, WNOHANG);
    if (ended == child) break;
    if (ended < 0 && errno != EINTR) fail("waitpid");
    if (Clock::now() >= deadline) {
      end.too_late = true;
      ::kill(-child, SIGKILL);
      while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
      }
      break;
    }
    pollfd wait{in.number, POLLIN, 0};
    ::poll(&wait, open ? 1 : 0, open ? 50 : 2);
    if (open) open = drain(in.number, end.said);
  }
  drain(in.number, end.said);
  if (WIFEXITED(status)) end.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  return end;
}

}  // namespace tetproof::io
