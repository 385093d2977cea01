// SPDX-License-Identifier: GPL-3.0-or-later
// Writes .msh 4.0 and 4.1.
#include <fmt/format.h>

#include <algorithm>

#include "io/error.hpp"
#include "io/msh/msh.hpp"
#include "io/msh/msh_plan.hpp"
#include "io/msh/msh_write.hpp"

namespace tetproof::io {
namespace {

template <bool Binary>
class Writer {
 public:
  Writer(AtomicFile& file, const Document& document, const std::string& format, const EntityPlan& plan,
         const Holds& holds)
      : file_(file),
        document_(document),
        v40_(format == "msh40"),
        format_(format),
        plan_(plan),
        holds_(holds),
        tags_(msh4_tags(document)) {
    for (std::size_t b = 0; b < document.blocks.size(); ++b)
      if (holds_.nodes_each(document.blocks[b]) > 0 && document.blocks[b].count > 0) blocks_.push_back(b);
  }

  void write() {
    file_.write(msh_header(v40_ ? "4" : "4.1", Binary));
    file_.write(msh_kept_sections(document_, holds_, true));
    file_.write(msh_names(document_, holds_));
    entities(false);
    if (plan_.partitions > 0 || !plan_.ghosts.empty() ||
        (!plan_.entities.empty() && plan_.entities.back().parent_dim >= 0))
      entities(true);
    nodes();
    elements();
    file_.write(msh_kept_sections(document_, holds_, false));
    write_msh_data(file_, tags_, holds_, format_, Binary);
  }

 private:
  void end(const char* section) { file_.write(fmt::format("{}$End{}\n", Binary ? "\n" : "", section)); }

  void entities(bool partitioned) {
    file_.write(partitioned ? "$PartitionedEntities\n" : "$Entities\n");
    if (partitioned) {
      file_.write(line<Binary>(1, [&](auto& out) { out.size(plan_.partitions); }));
      file_.write(line<Binary>(1, [&](auto& out) { out.size(plan_.ghosts.size()); }));
      for (const GhostEntity& ghost : plan_.ghosts)
        file_.write(
            line<Binary>(2, [&](auto& out) { out.integer(ghost.tag), out.integer(ghost.partition); }));
    }
    std::array<std::int64_t, 4> counts{};
    for (const Entity& entity : plan_.entities) counts[entity.dim] += (entity.parent_dim >= 0) == partitioned;
    file_.write(line<Binary>(4, [&](auto& out) {
      for (std::int64_t count : counts) out.size(count);
    }));
    for (const Entity& entity : plan_.entities) {
      if ((entity.parent_dim >= 0) != partitioned) continue;
      const auto& groups = document_.tag_sets[entity.groups];
      const auto& partitions = document_.tag_sets[entity.partitions];
      const std::size_t numbers = 12 + groups.size() + partitions.size() + entity.boundary.size();
      file_.write(line<Binary>(numbers, [&](auto& out) {
        integer(out, entity.tag);
        if (partitioned) {
          out.integer(entity.parent_dim), integer(out, entity.parent);
          set(out, partitions);
        }
        for (int k = 0; k < (entity.dim == 0 && !v40_ ? 3 : 6); ++k) out.real(entity.box[k]);
        set(out, groups);
        if (entity.dim > 0) set(out, entity.boundary);
      }));
    }
    end(partitioned ? "PartitionedEntities" : "Entities");
  }

  void set(auto& out, const std::vector<std::int64_t>& tags) {
    out.size(tags.size());
    for (std::int64_t tag : tags) integer(out, tag);
  }

  // Tags of entities and groups have 4 bytes in binary.
  void integer(auto& out, std::int64_t tag) {
    if (Binary && (tag > largest_int || tag < -largest_int - 1))
      throw InputError(
          fmt::format("{}: entity or group {} is too large for binary .msh, which gives it 4 bytes",
                      document_.path, tag));
    out.integer(tag);
  }

  void of_entity(auto& out, int dim, std::int64_t tag) {
    if (!v40_) out.integer(dim);
    integer(out, tag);
    if (v40_) out.integer(dim);
  }

  void nodes() {
    const auto [least, most] =
        range_of(document_.node_tags, tags_.renumber ? 1 : document_.first_node, 0, document_.points.size());
    file_.write("$Nodes\n");
    file_.write(line<Binary>(4, [&, low = least, high = most](auto& out) {
      out.size(plan_.node_blocks.size()), out.size(document_.points.size());
      if (!v40_) out.size(low), out.size(high);
    }));
    for (const NodeBlock& block : plan_.node_blocks) {
      const int each = block.parameters_each == block.dim ? block.dim : 0;
      file_.write(line<Binary>(4, [&](auto& out) {
        of_entity(out, block.dim, block.entity);
        out.integer(each > 0), out.size(block.count);
      }));
      if (!v40_)
        write_items(file_, block.count, Putter<Binary>::longest, [&](std::size_t i, char* to) {
          Putter<Binary> out{to};
          out.size(tags_.node(static_cast<Index>(block.first + i)));
          out.end_line();
          return out.to;
        });
      write_items(file_, block.count, (4 + each) * Putter<Binary>::longest, [&](std::size_t i, char* to) {
        Putter<Binary> out{to};
        if (v40_) out.integer(tags_.node(static_cast<Index>(block.first + i)));
        for (double x : document_.points[block.first + i]) out.real(x);
        for (int k = 0; k < each; ++k) out.real(document_.parameters[block.parameters + i * each + k]);
        out.end_line();
        return out.to;
      });
    }
    end("Nodes");
  }

  void elements() {
    std::int64_t least = 0, most = 0, total = 0;
    for (std::size_t b : blocks_) {
      const ElementBlock& block = document_.blocks[b];
      const auto range = range_of(document_.element_tags, tags_.renumber ? 1 : document_.first_element,
                                  block.first, block.count);
      least = total == 0 ? range.first : std::min(least, range.first);
      most = total == 0 ? range.second : std::max(most, range.second);
      total += block.count;
    }
    file_.write("$Elements\n");
    file_.write(line<Binary>(4, [&](auto& out) {
      out.size(blocks_.size()), out.size(total);
      if (!v40_) out.size(least), out.size(most);
    }));
    for (std::size_t b : blocks_) {
      const ElementBlock& block = document_.blocks[b];
      const int each = block.nodes_each;
      file_.write(line<Binary>(4, [&](auto& out) {
        of_entity(out, block.dim, plan_.block_tags[b]);
        out.integer(block.type), out.size(block.count);
      }));
      write_items(file_, block.count, (1 + each) * Putter<Binary>::longest, [&](std::size_t i, char* to) {
        Putter<Binary> out{to};
        out.size(tags_.element_at(block.first + i));
        const Index* node = document_.connectivity.data() + block.nodes + i * each;
        for (int k = 0; k < each; ++k) out.size(tags_.node(node[k]));
        out.end_line();
        return out.to;
      });
    }
    end("Elements");
  }

  AtomicFile& file_;
  const Document& document_;
  const bool v40_;  // 4.0 has its numbers in another order, and is never binary
  const std::string& format_;
  const EntityPlan& plan_;
  const Holds& holds_;
  const MshTags tags_;
  std::vector<std::size_t> blocks_;  // those that are written
};

class Msh4FilePlan : public MshFilePlan {
 public:
  Msh4FilePlan(const Document& document, const char* format, bool binary)
      : MshFilePlan(document), format_(format), binary_(binary), plan_(plan_entities(document)) {
    holds_ = msh4_holds(document, plan_, format_, binary);
  }

 private:
  void write_into(AtomicFile& file) override {
    if (!has_boxes_) compute_new_boxes(document_, plan_);
    has_boxes_ = true;
    binary_ ? Writer<true>(file, document_, format_, plan_, holds_).write()
            : Writer<false>(file, document_, format_, plan_, holds_).write();
  }

  const std::string format_;  // "msh40" or "msh41"
  const bool binary_;
  EntityPlan plan_;
  bool has_boxes_ = false;
};

}  // namespace

std::unique_ptr<FilePlan> plan_msh40(const Document& document, bool) {
  return std::make_unique<Msh4FilePlan>(document, "msh40", false);
}

std::unique_ptr<FilePlan> plan_msh41(const Document& document, bool binary) {
  return std::make_unique<Msh4FilePlan>(document, "msh41", binary);
}

}  // namespace tetproof::io
