// SPDX-License-Identifier: GPL-3.0-or-later
// Reads runs of plain nodes and elements of .msh 2.2 with several threads.
#include "io/msh/msh22_plain.hpp"

#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <span>

#include "io/bytes/large_pages.hpp"
#include "io/bytes/plain_records.hpp"
#include "io/model/tagged_lines.hpp"
#include "io/msh/msh_sections.hpp"

namespace tetproof::io {
namespace {

constexpr std::size_t most_tags = 16;

// Adds elements to a piece one by one.
class PieceMaker {
 public:
  PieceMaker(const NodeIndex& index, PlainElements22& piece) : index_(index), piece_(piece) {}

  /// Null: unknown.
  const ElementType* type(std::int64_t number) {
    if (number == number_) return type_;
    number_ = number;
    return type_ = element_type(number);
  }
  void start(const ElementType& type, std::span<const std::int64_t> tags) {
    if (!piece_.runs.empty() && piece_.runs.back().type == &type && has_last_tags(tags)) return;
    piece_.run_tags.insert(piece_.run_tags.end(), tags.begin(), tags.end());
    piece_.runs.push_back({&type, tags.size(), 0});
  }
  bool node(std::int64_t tag) {
    const Index place = index_(tag);
    piece_.nodes.push_back(place);
    return place >= 0;
  }
  void end(std::int64_t tag) {
    PlainElements22::Run& run = piece_.runs.back();
    const auto each = static_cast<std::size_t>(run.type->nodes);
    piece_.tags.push_back(tag);
    ++run.count;
    if (!piece_.repeats) piece_.repeats = piece_.nodes.size() >= 2 * each && repeats_before(each);
  }

 private:
  // Loops instead of library calls: both compare only a few numbers.
  bool has_last_tags(std::span<const std::int64_t> tags) const {
    const std::size_t count = piece_.runs.back().tags;
    if (tags.size() != count) return false;
    const std::int64_t* const last = piece_.run_tags.data() + piece_.run_tags.size() - count;
    for (std::size_t k = 0; k < count; ++k)
      if (last[k] != tags[k]) return false;
    return true;
  }
  bool repeats_before(std::size_t each) const {
    const Index* const nodes = piece_.nodes.data() + piece_.nodes.size() - each;
    for (std::size_t k = 0; k < each; ++k)
      if (nodes[k] != (nodes - each)[k]) return false;
    return true;
  }

  const NodeIndex::Known index_;
  PlainElements22& piece_;
  std::int64_t number_ = -1;
  const ElementType* type_ = nullptr;  // the type with this number
};

bool read_element(PlainLine& line, PieceMaker& to) {
  std::int64_t tag, number, count;
  if (!line.integer(tag) || !line.integer(number) || !line.integer(count)) return false;
  if (count < 0 || count > static_cast<std::int64_t>(most_tags)) return false;
  std::array<std::int64_t, most_tags> tags;
  for (std::int64_t k = 0; k < count; ++k)
    if (!line.integer(tags[static_cast<std::size_t>(k)])) return false;
  const ElementType* const type = to.type(number);
  if (!type) return false;
  to.start(*type, {tags.data(), static_cast<std::size_t>(count)});
  for (int k = 0; k < type->nodes; ++k) {
    std::int64_t node;
    if (!line.integer(node) || !to.node(node)) return false;
  }
  to.end(tag);
  return line.end();
}

bool read_node_records(Numbers& in, std::size_t count, Document& document, Tags& tags) {
  constexpr std::size_t size = node_bytes22;
  if (in.swapped() || count < least_plain_records || in.remaining() / size < count) return false;
  const std::size_t first = document.points.size();
  resize_in_large_pages(document.points, first + count);
  std::atomic<bool> ascending = true;
  const std::int64_t first_tag = number_at<std::int32_t>(in.source().bytes.data() + in.offset());
  read_records(in.source(), in.offset(), size, count,
               [&](const char* record, std::size_t from, std::size_t here) {
                 for (std::size_t i = from; i < from + here; ++i, record += size) {
                   if (number_at<std::int32_t>(record) != first_tag + static_cast<std::int64_t>(i))
                     ascending = false;
                   std::memcpy(document.points[first + i].data(), record + 4, 3 * sizeof(double));
                 }
               });
  if (!ascending || !tags.add_run(first, first_tag, count)) {
    std::int64_t* const to = tags.spelled_out(first, count);
    read_records(in.source(), in.offset(), size, count,
                 [&](const char* record, std::size_t from, std::size_t here) {
                   for (std::size_t i = from; i < from + here; ++i, record += size)
                     to[i] = number_at<std::int32_t>(record);
                 });
  }
  in.go_to(in.offset() + count * size);
  return true;
}

}  // namespace

bool read_plain_nodes22(Numbers& in, std::size_t count, Document& document, Tags& tags) {
  if (in.binary()) return read_node_records(in, count, document, tags);
  if (count < least_plain_lines) return false;
  in.skip_blanks();
  const std::size_t first = document.points.size();
  resize_in_large_pages(document.points, first + count);
  const auto behind =
      read_tagged_lines(in.source(), in.offset(), count, tags, first, [&](PlainLine& line, std::size_t i) {
        Eigen::Vector3d& p = document.points[first + i];
        return line.real(p.x()) && line.real(p.y()) && line.real(p.z());
      });
  if (behind)
    in.go_to(*behind);
  else
    document.points.resize(first);
  return behind.has_value();
}

bool read_plain_elements22(Numbers& in, std::size_t count, const NodeIndex& index,
                           const TakeElements22& take) {
  if (count < least_plain_lines) return false;
  in.skip_blanks();
  std::vector<PlainElements22> read;
  LineReader reader;
  reader.begin = [&](const std::vector<LinePiece>& wave) {
    if (read.size() < wave.size()) read.resize(wave.size());
  };
  reader.read = [&](const LinePiece& piece) -> const char* {
    PlainLine line(piece.text.data(), piece.text.data() + piece.text.size());
    PlainElements22& mine = read[piece.number];
    mine.clear();
    PieceMaker elements(index, mine);
    for (std::size_t i = 0; i < piece.count; ++i)
      if (!read_element(line, elements)) return nullptr;
    return line.place();
  };
  reader.end = [&](const std::vector<LinePiece>& wave) {
    for (const LinePiece& piece : wave) take(read[piece.number]);
    return true;
  };
  const auto behind = read_lines(in.source(), in.offset(), count, reader);
  if (behind) in.go_to(*behind);
  return behind.has_value();
}

bool read_plain_records22(Numbers& in, const ElementType& type, std::size_t count, std::size_t tags_each,
                          const NodeIndex& index, const TakeElements22& take) {
  const auto nodes_each = static_cast<std::size_t>(type.nodes);
  const std::size_t size = 4 * (1 + tags_each + nodes_each);
  if (in.swapped() || count < least_plain_records || tags_each > most_tags || in.remaining() / size < count)
    return false;
  const std::size_t run = records_in_run(size);
  const std::size_t wave = 4 * static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()) * run;
  std::vector<PlainElements22> read((std::min(count, wave) + run - 1) / run);
  for (std::size_t done = 0, here; done < count; done += here) {
    here = std::min(wave, count - done);
    std::atomic<bool> known = true;
    read_records(in.source(), in.offset() + done * size, size, here,
                 [&](const char* at, std::size_t first, std::size_t records) {
                   const auto next = [&at] {
                     const auto number = number_at<std::int32_t>(at);
                     at += 4;
                     return number;
                   };
                   PlainElements22& mine = read[first / run];
                   mine.clear();
                   PieceMaker elements(index, mine);
                   bool all_known = true;
                   std::array<std::int64_t, most_tags> tags;
                   for (std::size_t i = 0; i < records; ++i) {
                     const std::int64_t tag = next();
                     for (std::size_t k = 0; k < tags_each; ++k) tags[k] = next();
                     elements.start(type, {tags.data(), tags_each});
                     for (std::size_t k = 0; k < nodes_each; ++k) all_known &= elements.node(next());
                     elements.end(tag);
                   }
                   if (!all_known) known = false;
                 });
    if (!known) return false;
    for (std::size_t r = 0; r * run < here; ++r) take(read[r]);
  }
  in.go_to(in.offset() + count * size);
  return true;
}

}  // namespace tetproof::io
