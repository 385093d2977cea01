// SPDX-License-Identifier: GPL-3.0-or-later
// Writes .msh 2.2.
#include <algorithm>

#include "io/error.hpp"
#include "io/model/element_types.hpp"
#include "io/msh/msh.hpp"
#include "io/msh/msh22_ghosts.hpp"
#include "io/msh/msh22_limits.hpp"
#include "io/msh/msh_plan.hpp"
#include "io/msh/msh_write.hpp"

namespace tetproof::io {
namespace {

template <bool Binary>
class Writer {
 public:
  Writer(AtomicFile& file, const Document& document, const GhostBlocks& all, const Msh22Limits& limits,
         const Holds& holds)
      : file_(file),
        document_(document),
        tag_sets_(all.tag_sets),
        holds_(holds),
        limits_(limits),
        tags_{&document, limits_.renumber, limits_.first_unknown} {
    for (const ElementBlock& block : all.blocks)
      if (holds_.nodes_each(block) > 0 && block.count > 0) {
        blocks_.push_back(&block);
        elements_ += block.count * groups22(document, block).size();
      }
  }

  void write() {
    file_.write(msh_header("2.2", Binary));
    file_.write(msh_kept_sections(document_, holds_, true));
    file_.write(msh_names(document_, holds_));
    limits_.parametric ? parametric_nodes() : nodes();
    elements();
    file_.write(msh_kept_sections(document_, holds_, false));
    write_msh_data(file_, tags_, holds_, "msh22", Binary);
  }

 private:
  void end(const char* section) { file_.write(fmt::format("{}$End{}\n", Binary ? "\n" : "", section)); }

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
    for (const NodeBlock& block : limits_.node_blocks) {
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
    out.integer(tags_.node(static_cast<Index>(i)));
    for (double x : document_.points[i]) out.real(x);
  }

  void elements() {
    file_.write(fmt::format("$Elements\n{}\n", elements_));
    std::int64_t copy = limits_.first_copy;
    bool marked = false;
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      const ElementBlock& block = *blocks_[b];
      marked = b > 0 && !marked && looks_like_a_copy(*blocks_[b - 1], block);
      const std::vector<std::int64_t> groups = groups22(document_, block);
      std::vector<std::string> middles;  // for each group, the numbers between an element's tag and its nodes
      std::size_t longest = 0;
      for (const std::int64_t group : groups) {
        middles.push_back(middle(block, tags_of(block, group, marked)));
        longest = std::max(longest, middles.back().size());
      }
      if (Binary)
        file_.write(line<Binary>(3, [&](auto& out) {
          out.integer(block.type), out.integer(block.count * groups.size());
          out.integer(tags_of(block, 0, marked).size());
        }));
      const int each = block.nodes_each;
      const bool counted = has_counted_nodes(block.type);
      longest += static_cast<std::size_t>(2 + each) * Putter<Binary>::longest;
      write_items(file_, block.count * groups.size(), longest, [&](std::size_t i, char* to) {
        Putter<Binary> out{to};
        const std::size_t e = i / groups.size(), k = i % groups.size();
        out.integer(k == 0 ? tags_.element_at(block.first + e)
                           : copy + static_cast<std::int64_t>(e * (groups.size() - 1) + k - 1));
        out.to = std::copy(middles[k].begin(), middles[k].end(), out.to);
        if (!Binary) out.to[-1] = ' ';  // the line goes on
        if (counted) out.integer(each);
        const Index* node = document_.connectivity.data() + block.nodes + e * static_cast<std::size_t>(each);
        for (int n = 0; n < each; ++n) out.integer(tags_.node(node[n]));
        out.end_line();
        return out.to;
      });
      copy += static_cast<std::int64_t>(block.count * (groups.size() - 1));
    }
    end("Elements");
  }

  std::string middle(const ElementBlock& block, const std::vector<std::int64_t>& tags) const {
    return line<Binary>(2 + tags.size(), [&](auto& out) {
      if (!Binary) out.integer(block.type), out.integer(static_cast<std::int64_t>(tags.size()));
      for (std::int64_t tag : tags) out.integer(tag);
    });
  }

  // Whether a reader would take the first element of `next` for the last one of `block` in a further group.
  // If so, one more tag at the end, a 0 without a meaning, tells that it is another element.
  bool looks_like_a_copy(const ElementBlock& block, const ElementBlock& next) const {
    const std::vector<std::int64_t> groups = groups22(document_, block);
    const std::int64_t group = groups22(document_, next)[0];
    if (block.type != next.type || block.nodes_each != next.nodes_each ||
        entity_of(block) != entity_of(next) || block.partitions != next.partitions || groups[0] == 0 ||
        group == 0 || std::find(groups.begin(), groups.end(), group) != groups.end())
      return false;
    const auto each = static_cast<std::size_t>(block.nodes_each);
    const Index* nodes = document_.connectivity.data();
    return std::equal(nodes + next.nodes, nodes + next.nodes + each,
                      nodes + block.nodes + (block.count - 1) * each);
  }

  static std::int64_t entity_of(const ElementBlock& block) { return block.entity == 0 ? 1 : block.entity; }

  // The tags: physical, elementary, and if there are partitions, their number and the partitions.
  std::vector<std::int64_t> tags_of(const ElementBlock& block, std::int64_t group, bool marked) const {
    const auto& partitions = tag_sets_[static_cast<std::size_t>(block.partitions)];
    std::vector<std::int64_t> tags{group, entity_of(block)};
    if (!partitions.empty()) {
      tags.push_back(static_cast<std::int64_t>(partitions.size()));
      tags.insert(tags.end(), partitions.begin(), partitions.end());
    }
    if (marked) tags.push_back(0);
    for (std::int64_t tag : tags)
      if (Binary && (tag > largest_int || tag < -largest_int - 1))
        throw InputError(fmt::format(
            "{}: entity, group or partition {} is too large for binary .msh, which gives it 4 bytes",
            document_.path, tag));
    return tags;
  }

  AtomicFile& file_;
  const Document& document_;
  const std::vector<std::vector<std::int64_t>>& tag_sets_;  // the document's, and partitions with ghosts
  const Holds& holds_;
  const Msh22Limits& limits_;
  const MshTags tags_;
  std::vector<const ElementBlock*> blocks_;  // those that are written
  std::size_t elements_ = 0;
};

class Msh22FilePlan : public MshFilePlan {
 public:
  Msh22FilePlan(const Document& document, bool binary)
      : MshFilePlan(document),
        limits_(msh22_limits(document, binary)),
        blocks_(blocks_with_ghosts(document)),
        binary_(binary) {
    holds_ = msh22_holds(document, limits_, blocks_.complete, binary);
  }

 private:
  void write_into(AtomicFile& file) override {
    binary_ ? Writer<true>(file, document_, blocks_, limits_, holds_).write()
            : Writer<false>(file, document_, blocks_, limits_, holds_).write();
  }

  const Msh22Limits limits_;
  const GhostBlocks blocks_;
  const bool binary_;
};

}  // namespace

std::unique_ptr<FilePlan> plan_msh22(const Document& document, bool binary) {
  return std::make_unique<Msh22FilePlan>(document, binary);
}

}  // namespace tetproof::io
