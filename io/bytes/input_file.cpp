// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bytes/input_file.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "io/error.hpp"

namespace tetproof {
InputFile::InputFile(const std::string& path) : path_(path) {
  const auto fail = [&](const char* what) -> void {
    throw InputError(fmt::format("{}: {}: {}", path_, what, std::strerror(errno)));
  };
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) fail("cannot open");
  struct stat about {};
  if (::fstat(file, &about) != 0 || S_ISDIR(about.st_mode)) {
    if (S_ISDIR(about.st_mode)) errno = EISDIR;
    const int reason = errno;
    ::close(file);
    errno = reason;
    fail("cannot read");
  }
  if (S_ISREG(about.st_mode) && about.st_size > 0) {
    void* map = ::mmap(nullptr, about.st_size, PROT_READ, MAP_PRIVATE, file, 0);
    if (map != MAP_FAILED) {
      map_ = map;
      bytes_ = {static_cast<const char*>(map), static_cast<std::size_t>(about.st_size)};
      file_ = file;
      return;
    }
  }
  try {
    read_all(file);
  } catch (...) {
    ::close(file);
    throw;
  }
  ::close(file);
}

InputFile::InputFile(StandardInput) : path_("standard input"), named_(false) {
  read_all(STDIN_FILENO);
}

InputFile InputFile::standard_input() {
  return InputFile(StandardInput{});
}

InputFile InputFile::in_memory(std::string_view bytes, const std::string& name) {
  return {bytes, name};
}

void InputFile::read_all(int descriptor) {
  char buffer[1 << 16];
  for (;;) {
    const ssize_t got = ::read(descriptor, buffer, sizeof buffer);
    if (got == 0) break;
    if (got > 0) copy_.append(buffer, static_cast<std::size_t>(got));
    if (got < 0 && errno != EINTR)
      throw InputError(fmt::format("{}: cannot read: {}", path_, std::strerror(errno)));
  }
  bytes_ = copy_;
}

InputFile::~InputFile() {
  if (map_) ::munmap(map_, bytes_.size());
  if (file_ >= 0) ::close(file_);
}

void InputFile::copy(std::size_t offset, std::size_t size, char* to) const {
  if (listener_) {  // what is copied twice counts twice, and all is never more than all
    const std::uint64_t all = bytes_.size();
    listener_("reading", std::min<std::uint64_t>(copied_ += size, all), all);
  }
  if (file_ < 0) {
    std::memcpy(to, bytes_.data() + offset, size);
    return;
  }
  while (size > 0) {
    const ssize_t got = ::pread(file_, to, size, static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw InputError(fmt::format("{}: cannot read: {}", path_, std::strerror(errno)));
    if (got == 0)
      throw InputError(
          fmt::format("{}: byte {}: the file ends here, but was longer when it was opened", path_, offset));
    offset += static_cast<std::size_t>(got), to += got, size -= static_cast<std::size_t>(got);
  }
}

}  // namespace tetproof
