// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the tree of processes from /proc with system calls alone.
//
// The kernel lists the children of each thread in /proc/PID/task/TID/children. Kernels that are built without
// this list (CONFIG_PROC_CHILDREN) have the parent in /proc/PID/stat only: then all processes are read.
#include "corpus/meshing/process_tree.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace tetproof::corpus {

namespace {

constexpr int most_processes = 4096;

/// A path in /proc, put together without allocating.
class Path {
 public:
  Path& operator<<(const char* text) {
    while (*text && used_ + 1 < sizeof text_) text_[used_++] = *text++;
    return *this;
  }
  Path& operator<<(long number) {
    char digits[24];
    int count = 0;
    do digits[count++] = static_cast<char>('0' + number % 10);
    while ((number /= 10) > 0);
    while (count > 0 && used_ + 1 < sizeof text_) text_[used_++] = digits[--count];
    return *this;
  }
  const char* text() {
    text_[used_] = 0;
    return text_;
  }

 private:
  char text_[128];
  std::size_t used_ = 0;
};

int open_to_read(const char* path, int more = 0) {
  return ::open(path, O_RDONLY | O_CLOEXEC | more);
}

/// Reads the number at `at` and moves `at` behind it.
std::int64_t number(const char*& at) {
  while (*at == ' ') ++at;
  std::int64_t value = 0;
  while (*at >= '0' && *at <= '9') value = 10 * value + (*at++ - '0');
  return value;
}

struct Stat {
  pid_t parent = 0;
  std::int64_t cpu_ticks = 0, pages = 0;
};

bool read_stat(pid_t process, Stat& stat) {
  Path path;
  const int file = open_to_read((path << "/proc/" << process << "/stat").text());
  if (file < 0) return false;
  char text[1024];
  const ssize_t got = ::read(file, text, sizeof text - 1);
  ::close(file);
  if (got <= 0) return false;
  text[got] = 0;
  const char* at = std::strrchr(text, ')');  // the name before it may hold anything
  if (!at) return false;
  // proc(5) counts fields from 1; the state, after the name, is field 3.
  int field = 2;
  for (++at; *at;) {
    while (*at == ' ') ++at;
    ++field;
    if (field == 4) stat.parent = static_cast<pid_t>(number(at));
    if (field >= 14 && field <= 17) stat.cpu_ticks += number(at);
    if (field == 24) {
      stat.pages = number(at);
      return true;
    }
    while (*at && *at != ' ') ++at;
  }
  return false;
}

/// The names in a folder of /proc that are numbers.
template <class Visit>
bool for_each_number(const char* folder, Visit visit) {
  const int file = open_to_read(folder, O_DIRECTORY);
  if (file < 0) return false;
  // As the kernel lays it out: the C library's readdir allocates.
  struct Entry {
    std::uint64_t inode;
    std::int64_t offset;
    std::uint16_t length;
    std::uint8_t type;
    char name[1];
  };
  alignas(Entry) char buffer[4096];
  for (long got; (got = ::syscall(SYS_getdents64, file, buffer, sizeof buffer)) > 0;) {
    for (long at = 0; at < got;) {
      std::uint16_t length;
      std::memcpy(&length, buffer + at + offsetof(Entry, length), sizeof length);
      const char* name = buffer + at + offsetof(Entry, name);
      if (*name >= '0' && *name <= '9') visit(static_cast<pid_t>(number(name)));
      at += length;
    }
  }
  ::close(file);
  return true;
}

/// A list of processes that grows while one walks over it.
struct Found {
  pid_t processes[most_processes];
  int count = 0;
  void add(pid_t process) {
    if (count < most_processes) processes[count++] = process;
  }
  bool has(pid_t process) const {
    return std::find(processes, processes + count, process) != processes + count;
  }
};

/// Adds the children of one thread; false if the kernel has no such list.
bool add_children(pid_t process, pid_t thread, Found& found) {
  Path path;
  const int file = open_to_read((path << "/proc/" << process << "/task/" << thread << "/children").text());
  if (file < 0) return false;
  char text[4096];
  std::int64_t value = 0;
  bool digits = false;
  for (ssize_t got; (got = ::read(file, text, sizeof text)) > 0;) {
    for (ssize_t i = 0; i < got; ++i) {
      if (text[i] >= '0' && text[i] <= '9') {
        value = 10 * value + (text[i] - '0');
        digits = true;
      } else if (digits) {
        found.add(static_cast<pid_t>(value));
        value = 0;
        digits = false;
      }
    }
  }
  if (digits) found.add(static_cast<pid_t>(value));
  ::close(file);
  return true;
}

/// Adds those whose parent is `root` or in the list, until there are no more.
void add_by_parents(pid_t root, Found& found) {
  for (int before = -1; before != found.count;) {
    before = found.count;
    for_each_number("/proc", [&](pid_t process) {
      Stat stat;
      if (!read_stat(process, stat)) return;
      if ((stat.parent == root || found.has(stat.parent)) && !found.has(process)) found.add(process);
    });
  }
}

}  // namespace

TreeUse walk_process_tree(pid_t root, int signal) {
  Found found;
  if (add_children(root, root, found)) {
    for (int i = 0; i < found.count; ++i) {
      const pid_t process = found.processes[i];
      Path path;
      for_each_number((path << "/proc/" << process << "/task").text(),
                      [&](pid_t thread) { add_children(process, thread, found); });
    }
  } else {
    add_by_parents(root, found);
  }
  TreeUse use;
  for (int i = 0; i < found.count; ++i) {
    if (Stat stat; read_stat(found.processes[i], stat)) {
      ++use.processes;
      use.cpu_ticks += stat.cpu_ticks;
      use.pages += stat.pages;
    }
    if (signal) ::kill(found.processes[i], signal);
  }
  return use;
}

}  // namespace tetproof::corpus
