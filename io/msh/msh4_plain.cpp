// SPDX-License-Identifier: GPL-3.0-or-later
// Reads runs of plain tags, points and elements of .msh 4.1 with several threads.
#include "io/msh/msh4_plain.hpp"

#include <atomic>

#include "io/bytes/large_pages.hpp"
#include "io/bytes/plain_records.hpp"
#include "io/model/tagged_lines.hpp"

namespace tetproof::io {
namespace {

constexpr std::size_t number_size = 8;  // of tags and coordinates in binary

// Whether the next `count` records of so many numbers are binary and can be read at once.
bool are_records(const Numbers& in, std::size_t count, std::size_t numbers) {
  return in.binary() && !in.swapped() && count >= least_plain_records &&
         in.remaining() / (numbers * number_size) >= count;
}

// Adds tags that stand at the start of binary records.
void add_tags(const Numbers& in, std::size_t count, std::size_t record_size, Tags& tags, std::size_t position,
              bool ascending) {
  const auto first = number_at<std::int64_t>(in.source().bytes.data() + in.offset());
  if (ascending && tags.add_run(position, first, count)) return;
  std::int64_t* const to = tags.spelled_out(position, count);
  read_records(in.source(), in.offset(), record_size, count,
               [&](const char* record, std::size_t from, std::size_t here) {
                 for (std::size_t i = from; i < from + here; ++i, record += record_size)
                   to[i] = number_at<std::int64_t>(record);
               });
}

bool read_binary_tags(Numbers& in, std::size_t count, Tags& tags, std::size_t position) {
  if (!are_records(in, count, 1)) return false;
  const auto first = number_at<std::uint64_t>(in.source().bytes.data() + in.offset());
  std::atomic<bool> ascending = true;
  read_records(in.source(), in.offset(), number_size, count,
               [&](const char* record, std::size_t from, std::size_t here) {
                 std::uint64_t differences = 0;
                 for (std::size_t i = from; i < from + here; ++i, record += number_size)
                   differences |= number_at<std::uint64_t>(record) ^ (first + i);
                 if (differences != 0) ascending = false;
               });
  add_tags(in, count, number_size, tags, position, ascending);
  in.go_to(in.offset() + count * number_size);
  return true;
}

bool read_binary_elements(Numbers& in, std::size_t count, std::size_t each, Index* nodes,
                          const NodeIndex& index, Tags& tags, std::size_t position) {
  if (!are_records(in, count, 1 + each)) return false;
  const std::size_t record_size = (1 + each) * number_size;
  const auto first = number_at<std::uint64_t>(in.source().bytes.data() + in.offset());
  std::atomic<bool> ascending = true, known = true;
  read_records(in.source(), in.offset(), record_size, count,
               [&](const char* record, std::size_t from, std::size_t here) {
                 const NodeIndex::Known place(index);
                 std::uint64_t differences = 0;
                 Index any = 0;  // negative if any of them is
                 Index* node = nodes + from * each;
                 for (std::size_t i = from; i < from + here; ++i) {
                   differences |= number_at<std::uint64_t>(record) ^ (first + i);
                   record += number_size;
                   for (std::size_t k = 0; k < each; ++k, record += number_size)
                     any |= * node++ = place(number_at<std::int64_t>(record));
                 }
                 if (differences != 0) ascending = false;
                 if (any < 0) known = false;
               });
  if (!known) return false;
  add_tags(in, count, record_size, tags, position, ascending);
  in.go_to(in.offset() + count * record_size);
  return true;
}

}  // namespace

bool read_plain_tags(Numbers& in, std::size_t count, Tags& tags, std::size_t position) {
  if (in.binary()) return read_binary_tags(in, count, tags, position);
  if (count < least_plain_lines) return false;
  in.skip_blanks();
  const auto behind = read_tagged_lines(in.source(), in.offset(), count, tags, position,
                                        [](PlainLine&, std::size_t) { return true; });
  if (behind) in.go_to(*behind);
  return behind.has_value();
}

bool read_plain_points(Numbers& in, const NodeBlock& block, Document& document) {
  std::vector<Eigen::Vector3d>& points = document.points;
  if (in.binary()) {
    if (block.parameters_each > 0 || !are_records(in, block.count, 3)) return false;
    const std::size_t bytes = block.count * sizeof(Eigen::Vector3d);
    resize_in_large_pages(points, block.first + block.count);
    copy_bytes(in.source(), in.offset(), bytes, reinterpret_cast<char*>(points[block.first].data()));
    in.go_to(in.offset() + bytes);
    return true;
  }
  if (block.count < least_plain_lines) return false;
  in.skip_blanks();
  points.resize(block.first + block.count);
  const auto behind =
      read_plain_lines(in.source(), in.offset(), block.count, [&](PlainLine& line, std::size_t i) {
        Eigen::Vector3d& p = points[block.first + i];
        bool plain = line.real(p.x()) && line.real(p.y()) && line.real(p.z());
        double* parameter = document.parameters.data() + block.parameters + i * block.parameters_each;
        for (int k = 0; k < block.parameters_each && plain; ++k) plain = line.real(parameter[k]);
        return plain;
      });
  if (behind)
    in.go_to(*behind);
  else
    points.resize(block.first);
  return behind.has_value();
}

bool read_plain_elements(Numbers& in, std::size_t count, int each, Index* nodes, const NodeIndex& index,
                         Tags& tags, std::size_t position) {
  if (in.binary())
    return read_binary_elements(in, count, static_cast<std::size_t>(each), nodes, index, tags, position);
  if (count < least_plain_lines) return false;
  in.skip_blanks();
  const auto behind =
      read_tagged_lines(in.source(), in.offset(), count, tags, position, [&](PlainLine& line, std::size_t i) {
        for (Index *node = nodes + i * each, *end = node + each; node < end; ++node) {
          std::int64_t tag;
          if (!line.integer(tag)) return false;
          *node = index.known(tag);
          if (*node < 0) return false;
        }
        return true;
      });
  if (behind) in.go_to(*behind);
  return behind.has_value();
}

}  // namespace tetproof::io
