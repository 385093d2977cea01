// SPDX-License-Identifier: GPL-3.0-or-later
// A file that appears whole or not at all: written beside its place, then renamed.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace tetproof {

/// Writes beside `path` and takes its place on `commit`; without it the destructor leaves nothing behind.
/// Every failure is an InputError that names `path` and the system's reason.
class AtomicFile {
 public:
  explicit AtomicFile(std::string path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view bytes);
  /// The same for those who have taken their CRC-32 already, where `keeps_checksum`.
  void write(std::string_view bytes, std::uint32_t crc32);
  /// The CRC-32 of what was written since `keep_checksum`, which comes before the first byte.
  void keep_checksum() { keeps_checksum_ = true; }
  bool keeps_checksum() const { return keeps_checksum_; }
  std::uint32_t checksum() const { return checksum_; }
  void commit();

 private:
  void reserve(std::size_t more);
  [[noreturn]] void fail(const char* what) const;

  std::string path_, beside_;
  std::FILE* file_ = nullptr;
  std::size_t written_ = 0, reserved_ = 0;  // bytes
  bool keeps_checksum_ = false;
  std::uint32_t checksum_ = 0;
};

/// Throws as AtomicFile does when no file can be made at `path`, and leaves nothing there: so that a long job
/// fails before it begins. What is neither a file nor a folder (a pipe, a device) is not touched.
void check_creatable(const std::string& path);

}  // namespace tetproof
