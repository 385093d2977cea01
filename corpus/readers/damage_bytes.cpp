// SPDX-License-Identifier: GPL-3.0-or-later
// Damage that knows nothing of formats: what disks, networks and editors do.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "corpus/readers/damage.hpp"

namespace tetproof::corpus {
namespace {

using Done = std::optional<std::string>;

std::size_t place(Random& random, std::size_t size) {
  return static_cast<std::size_t>(random.below(static_cast<int>(size)));
}

Done truncated(std::string& bytes, Random& random) {
  if (bytes.empty()) return std::nullopt;
  const std::size_t all = bytes.size(), at = place(random, all);
  bytes.resize(at);
  return fmt::format("cut off at byte {} of {}", at, all);
}

Done emptied(std::string& bytes, Random&) {
  if (bytes.empty()) return std::nullopt;
  bytes.clear();
  return "nothing is left";
}

Done flipped_bits(std::string& bytes, Random& random) {
  if (bytes.empty()) return std::nullopt;
  std::vector<std::string> done;
  for (int n = 1 + random.below(4); n > 0; --n) {
    const std::size_t at = place(random, bytes.size());
    const int bit = random.below(8);
    bytes[at] = static_cast<char>(static_cast<unsigned char>(bytes[at]) ^ (1U << bit));
    done.push_back(fmt::format("bit {} of byte {}", bit, at));
  }
  return fmt::format("flipped {}", fmt::join(done, ", "));
}

Done zeroed(std::string& bytes, Random& random) {
  if (bytes.empty()) return std::nullopt;
  const std::size_t at = place(random, bytes.size());
  const std::size_t size = std::min(bytes.size() - at, 1 + place(random, 512));
  std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), size, '\0');
  return fmt::format("bytes {} to {} are zero", at, at + size - 1);
}

Done lost_piece(std::string& bytes, Random& random) {
  if (bytes.empty()) return std::nullopt;
  const std::size_t at = place(random, bytes.size());
  const std::size_t size = std::min(bytes.size() - at, 1 + place(random, 64));
  bytes.erase(at, size);
  return fmt::format("bytes {} to {} are lost", at, at + size - 1);
}

Done doubled_piece(std::string& bytes, Random& random) {
  if (bytes.empty()) return std::nullopt;
  const std::size_t at = place(random, bytes.size());
  const std::size_t size = std::min(bytes.size() - at, 1 + place(random, 512));
  bytes.insert(at, bytes.substr(at, size));
  return fmt::format("bytes {} to {} come twice", at, at + size - 1);
}

Done trailing(std::string& bytes, Random& random) {
  const std::array<std::string, 5> ends{"\n\n\n", "garbage behind the end\n", std::string(1000, '\0'), bytes,
                                        std::string("\x1a")};
  const std::size_t which = place(random, ends.size());
  bytes += ends[which];
  return std::array{"blank lines behind the end", "words behind the end", "1000 zero bytes behind the end",
                    "the file comes twice", "a control Z behind the end"}[which];
}

Done crlf(std::string& bytes, Random&) {
  std::string changed;
  for (const char c : bytes) changed += c == '\n' ? "\r\n" : std::string(1, c);
  if (changed == bytes) return std::nullopt;
  bytes = std::move(changed);
  return "line ends became CR LF, as an FTP transfer as text makes them";
}

Done lone_cr(std::string& bytes, Random&) {
  if (std::find(bytes.begin(), bytes.end(), '\n') == bytes.end()) return std::nullopt;
  std::replace(bytes.begin(), bytes.end(), '\n', '\r');
  return "line ends became CR";
}

Done byte_order_mark(std::string& bytes, Random& random) {
  switch (random.below(3)) {
    case 0:
      bytes.insert(0, "\xef\xbb\xbf");
      return "a byte order mark of UTF-8 in front";
    case 1: {
      std::string wide("\xff\xfe");
      for (const char c : bytes) wide += c, wide += '\0';
      bytes = std::move(wide);
      return "as UTF-16";
    }
    default:
      bytes.insert(0, "\n\n");
      return "blank lines in front";
  }
}

}  // namespace

std::vector<DamageKind> damage_to_bytes() {
  return {{"truncated", "cut off at any byte", truncated},
          {"empty", "a file of no bytes", emptied},
          {"flipped-bits", "one to four bits flipped", flipped_bits},
          {"zeroed", "a run of zero bytes, as a full disk leaves it", zeroed},
          {"lost-piece", "up to 64 bytes are missing", lost_piece},
          {"doubled-piece", "up to 512 bytes come twice", doubled_piece},
          {"trailing", "something behind the end", trailing},
          {"crlf", "line ends CR LF", crlf},
          {"lone-cr", "line ends CR", lone_cr},
          {"byte-order-mark", "a byte order mark, UTF-16, or blank lines in front", byte_order_mark}};
}

}  // namespace tetproof::corpus
