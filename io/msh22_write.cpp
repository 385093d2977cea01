// SPDX-License-Identifier: GPL-3.0-or-later
// Writes .msh 2.2.
#include <algorithm>

#include "io/error.hpp"
#include "io/msh.hpp"
#include "io/msh22_limits.hpp"
#include "io/msh_entities.hpp"
#include "io/msh_write.hpp"

namespace tetproof::io {
namespace {

template <bool Binary>
class Writer {
 public:
  Writer(AtomicFile& file, const Document& document)
      : file_(file), document_(document), limits_(msh22_limits(document, Binary)) {
    for (const ElementBlock& block : document.blocks)
      if (msh_holds(document, block, "msh22", Binary)) {
        blocks_.push_back(&block);
        elements_ += block.count;
      }
  }

  void write() {
    file_.write(msh_header("2.2", Binary));
    file_.write(msh_kept_sections(document_, "msh22", Binary, true));
    file_.write(msh_names(document_));
    limits_.parametric ? parametric_nodes() : nodes();
    elements();
    file_.write(msh_kept_sections(document_, "msh22", Binary, false));
  }

 private:
  void end(const char* section) { file_.write(fmt::format("{}$End{}\n", Binary ? "\n" : "", section)); }

  std::int64_t node_tag(std::size_t i) const {
    return limits_.renumber_nodes ? static_cast<std::int64_t>(i) + 1 : document_.node_tag(i);
  }
  std::int64_t named(Index i) const {
    if (!limits_.renumber_nodes) return document_.named(i);
    return i < 0 ? static_cast<std::int64_t>(document_.points.size()) - i : node_tag(i);
  }

  void nodes() {
    file_.write(fmt::format("$Nodes\n{}\n", document_.points.size()));
    write_items(file_, document_.points.size(), 4 * Putter<Binary>::longest, [&](std::size_t i, char* to) {
      Putter<Binary> out{to};
      put_node(out, i);
      out.end_line();
      return out.to;
    });
    end("Nodes");
  }

  void parametric_nodes() {
    file_.write(fmt::format("$ParametricNodes\n{}\n", document_.points.size()));
    for (const NodeBlock& block : plan_entities(document_).node_blocks) {
      const int each = std::min(block.parameters_each, block.dim < 3 ? block.dim : 0);
      write_items(file_, block.count, (6 + each) * Putter<Binary>::longest, [&](std::size_t i, char* to) {
        Putter<Binary> out{to};
        put_node(out, block.first + i);
        out.integer(block.dim), out.integer(block.entity);
        for (int k = 0; k < each; ++k)
          out.real(document_.parameters[block.parameters + i * block.parameters_each + k]);
        out.end_line();
        return out.to;
      });
    }
    end("ParametricNodes");
  }

  void put_node(Putter<Binary>& out, std::size_t i) const {
    out.integer(node_tag(i));
    for (double x : document_.points[i]) out.real(x);
  }

  void elements() {
    file_.write(fmt::format("$Elements\n{}\n", elements_));
    for (const ElementBlock* block : blocks_) {
      const std::vector<std::int64_t> tags = tags_of(*block);
      if (Binary)
        file_.write(line<Binary>(3, [&](auto& out) {
          out.integer(block->type), out.integer(block->count), out.integer(tags.size());
        }));
      const std::string middle = line<Binary>(2 + tags.size(), [&](auto& out) {
        if (!Binary) out.integer(block->type), out.integer(tags.size());
        for (std::int64_t tag : tags) out.integer(tag);
      });
      const int each = block->nodes_each;
      const std::size_t longest = (1 + each) * Putter<Binary>::longest + middle.size() + 1;
      write_items(file_, block->count, longest, [&](std::size_t i, char* to) {
        Putter<Binary> out{to};
        const std::size_t element = block->first + i;
        out.integer(limits_.renumber_elements ? static_cast<std::int64_t>(element) + 1
                                              : document_.element_tag(element));
        out.to = std::copy(middle.begin(), middle.end(), out.to);
        if (!Binary) out.to[-1] = ' ';  // its line goes on
        const Index* node = document_.connectivity.data() + block->nodes + i * each;
        for (int k = 0; k < each; ++k) out.integer(named(node[k]));
        out.end_line();
        return out.to;
      });
    }
    end("Elements");
  }

  // Physical, elementary, and if there are any the number of partitions and they themselves.
  std::vector<std::int64_t> tags_of(const ElementBlock& block) const {
    const auto& groups = document_.tag_sets[block.groups];
    const auto& partitions = document_.tag_sets[block.partitions];
    std::vector<std::int64_t> tags{groups.empty() ? 0 : groups[0], block.entity == 0 ? 1 : block.entity};
    if (!partitions.empty()) {
      tags.push_back(static_cast<std::int64_t>(partitions.size()));
      tags.insert(tags.end(), partitions.begin(), partitions.end());
    }
    for (std::int64_t tag : tags)
      if (Binary && (tag > largest_int || tag < -largest_int - 1))
        throw InputError(fmt::format(
            "{}: entity, group or partition {} is too large for binary .msh, which gives it 4 bytes",
            document_.path, tag));
    return tags;
  }

  AtomicFile& file_;
  const Document& document_;
  const Msh22Limits limits_;
  std::vector<const ElementBlock*> blocks_;  // those that are written
  std::size_t elements_ = 0;
};

}  // namespace

Msh22Limits msh22_limits(const Document& document, bool binary) {
  Msh22Limits limits;
  const auto fits = [](const std::pair<std::int64_t, std::int64_t>& range) {
    return range.first >= -largest_int - 1 && range.second <= largest_int;
  };
  if (binary) {
    const auto unknown =
        range_of(document.unknown.size(), [&](std::size_t k) { return document.unknown[k]; });
    limits.renumber_nodes =
        !fits(unknown) ||
        !fits(range_of(document.points.size(), [&](std::size_t i) { return document.node_tag(i); }));
    limits.renumber_elements =
        !fits(range_of(document.elements(), [&](std::size_t i) { return document.element_tag(i); }));
  }
  bool all = true, any = false;
  for (const NodeBlock& block : document.node_blocks) {
    any = any || (block.parameters_each > 0 && block.dim < 3);
    all = all && (block.dim == 0 || block.dim == 3 || block.parameters_each == block.dim);
  }
  limits.parametric = any && all;
  return limits;
}

void write_msh22(AtomicFile& file, const Document& document, bool binary) {
  binary ? Writer<true>(file, document).write() : Writer<false>(file, document).write();
}

}  // namespace tetproof::io
