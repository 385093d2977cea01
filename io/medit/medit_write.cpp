// SPDX-License-Identifier: GPL-3.0-or-later
// Writes Medit's files. Text and binary have the same keywords, so they share a writer.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <set>
#include <string>

#include "io/bytes/byte_order.hpp"
#include "io/bytes/text_output.hpp"
#include "io/medit/medit.hpp"
#include "io/medit/medit_plan.hpp"
#include "io/model/block_of.hpp"
#include "io/model/element_types.hpp"
#include "io/model/node_order.hpp"

namespace tetproof::io {
namespace {

class Writer {
 public:
  Writer(AtomicFile& file, const Document& document, const MeditPlan& plan, bool binary)
      : file_(file), document_(document), plan_(plan), binary_(binary) {}

  void write() {
    if (binary_)
      header();
    else
      file_.write("MeshVersionFormatted 2\n\nDimension 3\n");
    vertices();
    for (const std::size_t k : plan_.order) elements(*medit_elements()[k], plan_.lists[k]);
    if (plan_.fields.empty())
      for (const MeditSolutionPart& part : plan_.element_fields) element_fields(part);
    marks(document_.node_values, true);
    marks(document_.element_values, false);
    std::set<std::string> written;
    for (const Section& section : document_.sections)
      if (writes_medit_section(section, binary_) && written.insert(section.name).second)
        this->section(section);
    if (binary_)
      start(medit_end, 0);
    else
      file_.write("\nEnd\n");
  }

 private:
  // Version 2 if everything fits.
  void header() {
    std::int64_t least = 0, most = 0;
    const auto see = [&](std::int64_t value) {
      least = std::min(least, value), most = std::max(most, value);
    };
    for (std::size_t i = 0; i < document_.points.size(); ++i) see(medit_reference_of(plan_, i));
    for (const std::int64_t number : document_.unknown) see(number);
    for (const ElementBlock& block : document_.blocks) see(medit_reference(document_, block));
    std::size_t size = 1000 + 32 * document_.points.size();
    for (const ElementBlock& block : document_.blocks)
      size += block.count * static_cast<std::size_t>(block.nodes_each + 1) * 4;
    for (const auto* values : {&document_.node_values, &document_.element_values})
      for (const Values& each : *values)
        size += 4 * each.at.size() + 4 * each.integers.size() + 8 * each.reals.size() + 100;
    for (const Section& section : document_.sections) size += 8 * section.body.size() + 100;
    for (const Section& section : document_.sections)
      if (const MeditKeyword* keyword = medit_keyword(section.name);
          keyword && writes_medit_section(section, true))
        for (const MeditLines lines = *medit_lines(*keyword, section.body, 3);
             const std::int64_t value : lines.integers)
          see(value);
    const bool wide =
        least < std::numeric_limits<std::int32_t>::min() || most > std::numeric_limits<std::int32_t>::max();
    version_ = wide ? 4 : size > std::numeric_limits<std::int32_t>::max() ? 3 : 2;
    number(std::int32_t{1});
    number(std::int32_t{version_});
    start(medit_dimension, 4);
    number(std::int32_t{3});
  }

  // Writes a keyword and the place of the next one, which is `bytes` after this head.
  void start(int code, std::size_t bytes) {
    number(std::int32_t{code});
    const std::size_t next = code == medit_end ? 0 : at_ + (version_ < 3 ? 4 : 8) + bytes;
    version_ < 3 ? number(static_cast<std::int32_t>(next)) : number(static_cast<std::int64_t>(next));
  }

  std::size_t integer_size() const { return version_ == 4 ? 8 : 4; }

  char* put_integer(char* to, std::int64_t value) const {
    return version_ == 4 ? store(to, value, std::endian::native)
                         : store(to, static_cast<std::int32_t>(value), std::endian::native);
  }

  template <class T>
  void number(T value) {
    char bytes[sizeof(T)];
    store(bytes, value, std::endian::native);
    file_.write({bytes, sizeof(T)});
    at_ += sizeof(T);
  }

  // Writes the head of a keyword with `count` lines, in binary of `row` bytes each.
  void head(const MeditKeyword& keyword, std::size_t count, std::size_t row) {
    if (!binary_) {
      file_.write(fmt::format("\n{}\n", keyword.name));
      if (keyword.counted) file_.write(fmt::format("{}\n", count));
      return;
    }
    const std::size_t counter = keyword.counted ? integer_size() : 0;
    start(keyword.code, counter + count * row);
    char bytes[8];
    if (keyword.counted)
      file_.write(
          {bytes, static_cast<std::size_t>(put_integer(bytes, static_cast<std::int64_t>(count)) - bytes)});
    at_ += counter + count * row;
  }

  void vertices() {
    const std::size_t count = document_.points.size();
    head({medit_vertices, "Vertices", 0, ""}, count, 24 + integer_size());
    const bool reals = !binary_ && plan_.references && are_real_medit_references(*plan_.references);
    write_items(file_, count, 4 * (longest_real + 1), [&](std::size_t i, char* to) {
      const Eigen::Vector3d& p = document_.points[i];
      if (binary_) {
        for (int k = 0; k < 3; ++k) to = store(to, p[k], std::endian::native);
        return put_integer(to, medit_reference_of(plan_, i));
      }
      for (int k = 0; k < 3; ++k) to = put(put(to, p[k]), ' ');
      to = reals ? put(to, plan_.references->reals[i]) : put(to, medit_reference_of(plan_, i));
      return put(to, '\n');
    });
  }

  bool is_written(const Index* nodes, int count) const {
    return plan_.numbers_stay || std::none_of(nodes, nodes + count, [](Index i) { return i < 0; });
  }

  void elements(const MeditKeyword& keyword, const std::vector<const ElementBlock*>& blocks) {
    const auto each = static_cast<std::size_t>(element_type(keyword.element)->nodes);
    std::size_t count = 0;
    for (const ElementBlock* block : blocks)
      for (std::size_t e = 0; e < block->count; ++e)
        count += is_written(nodes_of(*block, e), block->nodes_each);
    if (count == 0) return;
    head(keyword, count, (each + 1) * integer_size());
    const auto order = node_order(keyword.element, NodeOrder::medit);
    for (const ElementBlock* block : blocks) {
      const std::int64_t group = medit_reference(document_, *block);
      write_items(file_, block->count, (each + 1) * (longest_integer + 1), [&](std::size_t e, char* to) {
        const Index* nodes = nodes_of(*block, e);
        if (!is_written(nodes, block->nodes_each)) return to;
        for (std::size_t k = 0; k < each; ++k) {
          const Index node = nodes[order.empty() ? k : static_cast<std::size_t>(order[k])];
          const std::int64_t number = node < 0 ? document_.named(node) : std::int64_t{node} + 1;
          to = binary_ ? put_integer(to, number) : put(put(to, number), ' ');
        }
        return binary_ ? put_integer(to, group) : put(put(to, group), '\n');
      });
    }
  }

  const Index* nodes_of(const ElementBlock& block, std::size_t e) const {
    return document_.connectivity.data() + block.nodes + e * static_cast<std::size_t>(block.nodes_each);
  }

  void marks(const std::vector<Values>& all, bool of_nodes) {
    std::set<std::string> written;
    for (const Values& values : all) {
      const std::vector<Index> marked = medit_marked(document_, values, of_nodes, binary_);
      if (marked.empty() || !written.insert(values.name).second) continue;
      std::vector<std::int64_t> numbers;
      for (const Index at : marked)
        if (at < 0 && plan_.numbers_stay)
          numbers.push_back(document_.unknown[static_cast<std::size_t>(-1 - at)]);
        else if (at >= 0 && of_nodes)
          numbers.push_back(std::int64_t{at} + 1);
        else if (at >= 0)
          if (const std::int64_t rank =
                  rank_of(static_cast<std::size_t>(at), medit_mark(values.name)->element);
              rank > 0)
            numbers.push_back(rank);
      const MeditKeyword& keyword = *medit_keyword(values.name);
      head(keyword, numbers.size(), integer_size());
      lines(numbers, {}, keyword, numbers.size());
    }
  }

  // Writes the values of all elements of a kind: how many there are, the types of the fields, the numbers.
  void element_fields(const MeditSolutionPart& all) {
    const std::size_t count = all.items;
    if (binary_) {
      const std::size_t numbers = count * medit_row(all.fields) * sizeof(double);
      start(all.keyword->code, integer_size() + 4 * (1 + all.fields.size()) + numbers);
      char bytes[8];
      file_.write(
          {bytes, static_cast<std::size_t>(put_integer(bytes, static_cast<std::int64_t>(count)) - bytes)});
      at_ += integer_size();
      number(static_cast<std::int32_t>(all.fields.size()));
      for (const auto& [values, field] : all.fields) number(std::int32_t{field});
      at_ += numbers;
    } else {
      file_.write(fmt::format("\n{}\n{}\n{}", all.keyword->name, count, all.fields.size()));
      for (const auto& [values, field] : all.fields) file_.write(fmt::format(" {}", field));
      file_.write("\n");
    }
    write_medit_numbers(file_, all.fields, count, binary_);
  }

  // Returns the number of an element among those of its keyword, from 1; 0: it is not one of them.
  std::int64_t rank_of(std::size_t element, int type) {
    if (ranks_.empty()) {
      ranks_.resize(document_.elements(), 0);
      for (const auto& blocks : plan_.lists) {
        std::int64_t next = 0;
        for (const ElementBlock* block : blocks)
          for (std::size_t e = 0; e < block->count; ++e)
            if (is_written(nodes_of(*block, e), medit_place(*block).nodes)) ranks_[block->first + e] = ++next;
      }
    }
    if (element >= document_.elements()) return 0;
    const MeditPlace place = medit_place(block_of(document_.blocks, element));
    return place.keyword && place.keyword->element == type ? ranks_[element] : 0;
  }

  void section(const Section& section) {
    if (!binary_) {
      // A line that begins with a letter would be read as a keyword.
      const bool goes_on = !section.body.empty() && is_medit_letter(section.body[0]);
      file_.write(fmt::format("\n{}{}{}\n", section.name, goes_on ? ' ' : '\n', section.body));
      return;
    }
    const MeditKeyword& keyword = *medit_keyword(section.name);
    const MeditLines content = *medit_lines(keyword, section.body, 3);
    std::size_t row = 0;
    for (const char kind : keyword.format) row += kind == 'i' ? integer_size() : kind == 'r' ? 8 : 24;
    head(keyword, content.count, row);
    lines(content.integers, content.reals, keyword, content.count);
  }

  void lines(const std::vector<std::int64_t>& integers, const std::vector<double>& reals,
             const MeditKeyword& keyword, std::size_t count) {
    std::string bytes;
    char one[longest_real];
    std::size_t integer = 0, real = 0;
    for (std::size_t line = 0; line < count; ++line) {
      for (const char kind : keyword.format)
        for (int k = 0; k < (kind == 'c' ? 3 : 1); ++k) {
          char* end;
          if (kind == 'i')
            end = binary_ ? put_integer(one, integers[integer]) : put(one, integers[integer]), ++integer;
          else
            end = store(one, reals[real++], std::endian::native);
          bytes.append(one, end);
        }
      if (!binary_) bytes += '\n';
    }
    file_.write(bytes);
  }

  AtomicFile& file_;
  const Document& document_;
  const MeditPlan& plan_;
  const bool binary_;
  int version_ = 2;
  std::size_t at_ = 0;  // bytes written, in binary
  std::vector<std::int64_t> ranks_;
};

}  // namespace

void write_medit(AtomicFile& file, const Document& document, const MeditPlan& plan, bool binary) {
  Writer(file, document, plan, binary).write();
}

}  // namespace tetproof::io
