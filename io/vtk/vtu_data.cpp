// SPDX-License-Identifier: GPL-3.0-or-later
// Facts: VTK's wiki, "VTK XML Formats", and what VTK 9.1 writes.
#include "io/vtk/vtu_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "io/bytes/base64.hpp"
#include "io/bytes/byte_order.hpp"
#include "io/bytes/input_file.hpp"
#include "io/bytes/scanner.hpp"
#include "io/bytes/words.hpp"
#include "io/vtk/vtk_types.hpp"
#include "io/vtk/vtu_unpack.hpp"

namespace tetproof::io {
namespace {

// Bytes of the file, raw or in base64. VTK encodes header and data together or separately, so there may be
// padding between them.
class Source {
 public:
  Source(const VtuEncoding& file, const VtuPlace& place)
      : file_(file), base64_(place.kind == VtuPlace::base64), at_(place.begin), end_(place.end) {}

  /// The next `size` bytes, valid until the next call.
  std::string_view take(std::uint64_t size, const char* what) {
    const std::uint64_t most = base64_ ? rest_.size() + (end_ - at_) / 4 * 3 + 3 : end_ - at_;
    if (size > most)
      fail(fmt::format("expected {} of {}, found {} at most", counted(size, "bytes"), what, most));
    if (!base64_) {
      at_ += size;
      return file_.bytes.substr(at_ - size, size);
    }
    taken_ = rest_;
    rest_.clear();
    taken_.reserve(size + 3);
    while (taken_.size() < size)
      if (!decode_quad())
        fail(fmt::format("expected {} of {}, found {}", counted(size, "bytes"), what, taken_.size()));
    rest_ = taken_.substr(size);
    taken_.resize(size);
    return taken_;
  }

  std::uint64_t number(const char* what) {
    const std::string_view bytes = take(static_cast<std::uint64_t>(file_.header_size), what);
    return file_.header_size == 8 ? load<std::uint64_t>(bytes.data(), file_.order)
                                  : load<std::uint32_t>(bytes.data(), file_.order);
  }

  bool empty() { return left() == 0; }

  /// The bytes that were not taken, as they stand in the file, without blanks in front of base64.
  std::size_t left() {
    while (base64_ && at_ < end_ && static_cast<unsigned char>(file_.bytes[at_]) <= ' ') ++at_;
    return end_ - at_ + rest_.size();
  }

  [[noreturn]] void fail(std::string_view message) const {
    Scanner(file_.path, file_.bytes, std::min(at_, file_.bytes.size())).fail_at_byte(message);
  }

 private:
  // Decodes four characters to three bytes, or to fewer where they end in =.
  bool decode_quad() {
    static constexpr auto values = [] {
      std::array<signed char, 256> table{};
      table.fill(-1);
      signed char next = 0;
      for (const char c : base64_digits) table[static_cast<unsigned char>(c)] = next++;
      return table;
    }();
    unsigned bits = 0;
    int digits = 0, padding = 0;
    while (digits + padding < 4) {
      if (at_ == end_) {
        if (digits + padding > 0) fail("expected four characters of base64, found the end of the data");
        return false;
      }
      const auto c = static_cast<unsigned char>(file_.bytes[at_]);
      if (c == '=' && digits > 1) {
        ++padding;
      } else if (values[c] >= 0 && padding == 0) {
        bits = bits << 6 | static_cast<unsigned>(values[c]);
        ++digits;
      } else if (c > ' ') {
        fail(fmt::format("expected base64, found {}",
                         c < 127 ? fmt::format("'{}'", static_cast<char>(c)) : fmt::format("byte {}", c)));
      }
      ++at_;
    }
    bits <<= 6 * padding;
    for (int k = 0; k < 3 - padding; ++k) taken_ += static_cast<char>(bits >> (16 - 8 * k) & 255);
    return true;
  }

  const VtuEncoding& file_;
  const bool base64_;
  std::size_t at_, end_;
  std::string taken_, rest_;
};

// Takes an array's bytes piece by piece.
class Sink {
 public:
  Sink(const VtuEncoding& file, Column& column) : file_(file), column_(column) {}

  void put(std::string_view bytes) {
    const std::size_t size = std::max<std::size_t>(1, vtk_type_size(column_.type));
    if (column_.type == "String") {
      for (const char c : bytes)
        c == '\0' ? column_.texts.push_back(std::move(text_)), text_.clear() : text_.push_back(c);
      return;
    }
    while (!half_.empty() && !bytes.empty()) {  // a number that is split between two blocks
      half_ += bytes.front();
      bytes.remove_prefix(1);
      if (half_.size() < size) continue;
      append_numbers(half_.data(), 1, file_.order, column_);
      half_.clear();
    }
    append_numbers(bytes.data(), bytes.size() / size, file_.order, column_);
    half_ += bytes.substr(bytes.size() / size * size);
  }

  bool whole() const { return half_.empty() && text_.empty(); }

 private:
  const VtuEncoding& file_;
  Column& column_;
  std::string half_, text_;
};

void check_size(const Source& source, std::uint64_t bytes, std::optional<std::size_t> count,
                const Column& column) {
  if (count && column.type != "String" && bytes != *count * vtk_type_size(column.type))
    source.fail(fmt::format("array \"{}\": expected {} of type {} in {}, found {}", column.name,
                            counted(*count, "values"), column.type,
                            counted(*count * vtk_type_size(column.type), "bytes"), counted(bytes, "bytes")));
}

void read_compressed(const VtuEncoding& file, Source& source, std::optional<std::size_t> count, Sink& sink,
                     const Column& column) {
  const std::uint64_t blocks = source.number("the number of blocks"), full = source.number("a block's size"),
                      partial = source.number("the last block's size");
  if (blocks == 0) return check_size(source, 0, count, column);
  const auto header = static_cast<std::uint64_t>(file.header_size);
  if (blocks > file.bytes.size() / header)
    source.fail(fmt::format("expected the number of blocks, found {}, more than the file can hold", blocks));
  std::vector<std::uint64_t> sizes(blocks);
  for (std::uint64_t& size : sizes) size = source.number("a compressed block's size");
  const std::uint64_t last = partial == 0 ? full : partial;
  const std::uint64_t ratio = most_times_larger(file.packing);
  constexpr std::uint64_t slack = 64;
  for (std::uint64_t b = 0; b < blocks; ++b)
    if ((b + 1 < blocks ? full : last) / ratio > sizes[b] + slack || sizes[b] > file.bytes.size())
      source.fail(fmt::format("expected the size of a compressed block of {}, found {}",
                              counted(b + 1 < blocks ? full : last, "bytes"), sizes[b]));
  check_size(source, (blocks - 1) * full + last, count, column);
  std::string block;
  for (std::uint64_t b = 0; b < blocks; ++b) {
    const std::uint64_t size = b + 1 < blocks ? full : last;
    const std::string found = unpack(file.packing, source.take(sizes[b], "a compressed block"), size, block);
    if (!found.empty())
      source.fail(fmt::format("expected {} compressed by {}, found {}", counted(size, "bytes"),
                              name_of(file.packing), found));
    sink.put(block);
  }
}

// VTK passes over what follows the values. Returns how many bytes these are.
std::size_t read_ascii(const VtuEncoding& file, const VtuPlace& place, std::optional<std::size_t> count,
                       Column& column) {
  Scanner in(file.path, file.bytes.substr(0, place.end), place.begin);
  const std::size_t most = count.value_or(std::numeric_limits<std::size_t>::max());
  std::size_t found = 0;
  for (std::string text; !in.at_end(); ++found) {
    if (found == most && column.type != "String") {
      const std::string_view left = file.bytes.substr(in.offset(), place.end - in.offset());
      return left.find_last_not_of(" \t\r\n") + 1;
    }
    if (is_real_type(column.type)) {
      column.reals.push_back(in.real("a number"));
    } else if (column.type == "String") {
      const std::int64_t c = in.integer("the code of a character");
      // VTK writes bytes of 128 and more as negative numbers.
      if (c < -128 || c > 255) in.fail_in_line(fmt::format("expected the code of a character, found {}", c));
      if (c == 0)
        column.texts.push_back(std::move(text)), text.clear();
      else
        text.push_back(static_cast<char>(c));
    } else {
      column.integers.push_back(read_vtk_integer(in, column.type));
    }
  }
  if (count && column_size(column) != *count)
    in.fail_in_line(fmt::format("array \"{}\": expected {}, found {}", column.name, counted(*count, "values"),
                                column_size(column)));
  return 0;
}

// In binary, eight bits are a byte, and the last byte may have bits behind them.
std::size_t read_bits(const VtuEncoding& encoding, const VtuPlace& place, std::optional<std::size_t> count,
                      Column& column) {
  Column packed{.name = column.name, .type = "UInt8"};
  const auto bytes = count ? std::optional((*count + 7) / 8) : std::nullopt;
  const std::size_t left = read_vtu_array(encoding, place, bytes, packed);
  std::string bits;
  for (const std::int64_t byte : packed.integers) bits += static_cast<char>(byte);
  column.type = "UInt8";
  append_bits(bits, count.value_or(8 * bits.size()), column);
  return left;
}

}  // namespace

std::size_t read_vtu_array(const VtuEncoding& encoding, const VtuPlace& place,
                           std::optional<std::size_t> count, Column& column) {
  if (place.kind == VtuPlace::ascii) {
    if (column.type == "Bit") column.type = "UInt8";
    return read_ascii(encoding, place, count, column);
  }
  if (column.type == "Bit") return read_bits(encoding, place, count, column);
  Source source(encoding, place);
  Sink sink(encoding, column);
  if (source.empty() && (!count || *count == 0)) return 0;
  if (encoding.packing != VtuPacking::none) {
    read_compressed(encoding, source, count, sink, column);
  } else {
    const std::uint64_t size = source.number("an array's size");
    check_size(source, size, count, column);
    sink.put(source.take(size, "an array"));
  }
  if (!sink.whole() || (count && column_size(column) != *count))
    source.fail(fmt::format("array \"{}\": expected whole values of type {}{}", column.name, column.type,
                            count ? fmt::format(", {} of them", *count) : ""));
  return source.left();
}

}  // namespace tetproof::io
