// SPDX-License-Identifier: GPL-3.0-or-later
// Writes .msh 4.1, ASCII and binary (of this machine's byte order, which the file names).
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "io/msh.hpp"
#include "io/msh_entities.hpp"
#include "io/text_output.hpp"

namespace tetproof::io {
namespace {

class Writer {
 public:
  Writer(AtomicFile& file, const Document& document)
      : file_(file), document_(document), plan_(plan_entities(document)) {}

  void write() {
    file_.write("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n");
    names();
    entities();
    nodes();
    elements();
  }

 private:
  void names() {
    if (document_.group_names.empty()) return;
    std::string text = fmt::format("$PhysicalNames\n{}\n", document_.group_names.size());
    for (const GroupName& name : document_.group_names)
      text += fmt::format("{} {} \"{}\"\n", name.dim, name.group, name.name);
    file_.write(text + "$EndPhysicalNames\n");
  }

  void entities() {
    std::array<std::size_t, 4> counts{};
    for (const Entity& entity : plan_.entities) ++counts[entity.dim];
    std::string text = fmt::format("$Entities\n{}\n", fmt::join(counts, " "));
    for (const Entity& entity : plan_.entities) {
      text += fmt::format("{}", entity.tag);
      for (int k = 0; k < (entity.dim == 0 ? 3 : 6); ++k) {
        char buffer[longest_real];
        text += ' ';
        text.append(buffer, put(buffer, entity.box[k]));
      }
      const auto& groups = plan_.tag_sets[entity.groups];
      text += fmt::format(" {} {}", groups.size(), fmt::join(groups, " "));
      if (!groups.empty()) text += ' ';
      if (entity.dim > 0)
        text += fmt::format("{} {}", entity.boundary.size(), fmt::join(entity.boundary, " "));
      text += '\n';
    }
    file_.write(text + "$EndEntities\n");
  }

  void nodes() {
    const auto [least, most] =
        range(document_.points.size(), [&](std::size_t i) { return document_.node_tag(i); });
    file_.write(
        fmt::format("$Nodes\n{} {} {} {}\n", plan_.node_blocks.size(), document_.points.size(), least, most));
    for (const NodeBlock& block : plan_.node_blocks) {
      file_.write(fmt::format("{} {} {} {}\n", block.dim, block.entity, block.parameters_each > 0 ? 1 : 0,
                              block.count));
      write_items(file_, block.count, longest_integer + 1, [&](std::size_t i, char* to) {
        return put(put(to, document_.node_tag(block.first + i)), '\n');
      });
      const int each = block.parameters_each;
      write_items(file_, block.count, (3 + each) * (longest_real + 1), [&](std::size_t i, char* to) {
        const Eigen::Vector3d& p = document_.points[block.first + i];
        to = put(put(put(put(put(to, p.x()), ' '), p.y()), ' '), p.z());
        for (int k = 0; k < each; ++k)
          to = put(put(to, ' '), document_.parameters[block.parameters + i * each + k]);
        return put(to, '\n');
      });
    }
    file_.write("$EndNodes\n");
  }

  void elements() {
    const std::size_t total = document_.elements();
    const auto [least, most] = range(total, [&](std::size_t i) { return document_.element_tag(i); });
    file_.write(fmt::format("$Elements\n{} {} {} {}\n", document_.blocks.size(), total, least, most));
    for (std::size_t b = 0; b < document_.blocks.size(); ++b) {
      const ElementBlock& block = document_.blocks[b];
      file_.write(fmt::format("{} {} {} {}\n", block.dim, plan_.block_tags[b], block.type, block.count));
      const int each = block.nodes_each;
      write_items(file_, block.count, (1 + each) * (longest_integer + 1), [&](std::size_t i, char* to) {
        to = put(to, document_.element_tag(block.first + i));
        const Index* node = document_.connectivity.data() + block.nodes + i * each;
        for (int k = 0; k < each; ++k) to = put(put(to, ' '), document_.named(node[k]));
        return put(to, '\n');
      });
    }
    file_.write("$EndElements\n");
  }

  template <class Tag>
  static std::pair<std::int64_t, std::int64_t> range(std::size_t count, const Tag& tag) {
    std::int64_t least = 0, most = 0;
    for (std::size_t i = 0; i < count; ++i) {
      least = i == 0 ? tag(i) : std::min(least, tag(i));
      most = i == 0 ? tag(i) : std::max(most, tag(i));
    }
    return {least, most};
  }

  AtomicFile& file_;
  const Document& document_;
  const EntityPlan plan_;
};

}  // namespace

void write_msh41(AtomicFile& file, const Document& document, bool binary) {
  if (binary) throw std::logic_error("msh41 binary");
  Writer(file, document).write();
}

}  // namespace tetproof::io
