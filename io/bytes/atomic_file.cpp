// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bytes/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "io/bytes/checksum.hpp"
#include "io/error.hpp"

namespace tetproof {

AtomicFile::AtomicFile(std::string path) : path_(std::move(path)) {
  struct stat there {};
  if (::stat(path_.c_str(), &there) == 0 && !S_ISREG(there.st_mode))
    beside_ = path_;  // nothing can be renamed to a pipe or a device
  else
    beside_ = path_ + fmt::format(".{}.part", ::gettid());  // two threads may write the same file
  file_ = std::fopen(beside_.c_str(), "wb");
  if (!file_) fail("cannot create");
}

AtomicFile::~AtomicFile() {
  if (!file_) return;
  std::fclose(file_);
  if (beside_ != path_) std::remove(beside_.c_str());
}

// Reserves room on the disk ahead of the writing. Without this, ext4 looks for room only when the file
// replaces another one, and we would wait for that. A failure is ignored here: if something is wrong, writing
// reports it.
void AtomicFile::reserve([[maybe_unused]] std::size_t more) {
#ifdef FALLOC_FL_KEEP_SIZE
  constexpr std::size_t short_file = std::size_t{1} << 20, step = std::size_t{1} << 24;
  if (written_ + more <= std::max(short_file, reserved_)) return;
  const std::size_t room = std::max(written_ + more, reserved_ + step);
  static_cast<void>(::fallocate(::fileno(file_), FALLOC_FL_KEEP_SIZE, static_cast<off_t>(reserved_),
                                static_cast<off_t>(room - reserved_)));
  reserved_ = room;
#endif
}

void AtomicFile::write(std::string_view bytes) {
  write(bytes, keeps_checksum_ ? io::crc32_of(bytes) : 0);
}

void AtomicFile::write(std::string_view bytes, std::uint32_t crc32) {
  reserve(bytes.size());
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) fail("cannot write");
  written_ += bytes.size();
  if (keeps_checksum_) checksum_ = io::crc32_joined(checksum_, crc32, bytes.size());
}

void AtomicFile::commit() {
  if (reserved_ > written_ && std::fflush(file_) == 0)  // gives back what was reserved beyond the end
    static_cast<void>(::ftruncate(::fileno(file_), static_cast<off_t>(written_)));
  const bool closed = std::fclose(std::exchange(file_, nullptr)) == 0;
  if (closed && (beside_ == path_ || std::rename(beside_.c_str(), path_.c_str()) == 0)) return;
  const int reason = errno;
  if (beside_ != path_) std::remove(beside_.c_str());
  errno = reason;
  fail("cannot write");
}

void AtomicFile::fail(const char* what) const {
  throw InputError(fmt::format("{}: {}: {}", path_, what, std::strerror(errno)));
}

void check_creatable(const std::string& path) {
  struct stat there {};
  if (::stat(path.c_str(), &there) == 0 && !S_ISREG(there.st_mode) && !S_ISDIR(there.st_mode)) return;
  const AtomicFile attempt(path);
}

}  // namespace tetproof
