// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a file that appears whole or not at all: it is written beside its place, then renamed.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace tetproof {

/// Writes beside `path`; `commit` renames the file to `path`. Without `commit` the destructor leaves nothing
/// behind. Every failure is an InputError that names `path` and the system's reason.
class AtomicFile {
 public:
  explicit AtomicFile(std::string path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view bytes);
  /// The same for a caller that has the CRC-32 of `bytes` already. It is used only if `keeps_checksum`.
  void write(std::string_view bytes, std::uint32_t crc32);
  /// Asks for a CRC-32 of everything written. To be called before the first byte.
  void keep_checksum() { keeps_checksum_ = true; }
  bool keeps_checksum() const { return keeps_checksum_; }
  /// The CRC-32 so far.
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

/// Throws as AtomicFile does if no file can be made at `path`, so that a long job fails before it begins.
/// Leaves nothing there. Does not touch what is neither a file nor a folder (a pipe, a device).
void check_creatable(const std::string& path);

}  // namespace tetproof
