// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>

#include "io/bytes/words.hpp"
#include "io/loss/loss_finder.hpp"
#include "io/model/element_types.hpp"
#include "io/model/weld.hpp"

namespace tetproof::io {
namespace {

// "tetrahedra of 10 nodes (type 11)".
std::string name_of(const ElementBlock& block) {
  if (!is_of_gmsh(block.type))
    return fmt::format("{} of {}", name_of_elements(block.type), counted(block.nodes_each, "nodes"));
  return fmt::format("{} of {} (type {})", name_of_elements(block.type), counted(block.nodes_each, "nodes"),
                     block.type);
}

bool is_plain(std::int64_t first) {
  return first == 0 || first == 1;
}

class MeshLosses : LossFinder {
 public:
  using LossFinder::LossFinder;

  void find() {
    elements();
    order();
    nodes();
    node_numbers();
    unknown_numbers();
    element_numbers();
    coordinates();
  }

  void find_dangling() {
    for (const ElementBlock& block : document_.blocks)
      if (holds_.nodes_each(block) > 0) unknown_nodes(block);
  }

 private:
  // Elements that are not written, or are written without their nodes between the corners.
  void elements() {
    for (const ElementBlock& block : document_.blocks) {
      const std::string what = name_of(block);
      const int each = holds_.nodes_each(block);
      if (each == 0) {
        not_written(block, what);
      } else if (!holds_.unknown_nodes && !document_.unknown.empty()) {
        unknown_nodes(block);
      }
    }
    for (const Written& written : written_.blocks())
      if (written.nodes_each < written.block->nodes_each)
        add("nodes between the corners of " + name_of(*written.block), written.count,
            element(*written.block));
  }

  // Elements of a block that has no place: each is cut into triangles or left out.
  void not_written(const ElementBlock& block, const std::string& what) {
    std::vector<bool> cut(block.count);
    const std::vector<Cut>& all = written_.cut();
    auto one = std::lower_bound(all.begin(), all.end(), &block,
                                [](const Cut& c, const ElementBlock* b) { return c.block < b; });
    for (; one != all.end() && one->block == &block; ++one) {
      cut[one->element] = true;
      if (!one->as_it_was) add(what + " cut into triangles", 1, element(block, one->element));
    }
    const auto first = std::find(cut.begin(), cut.end(), false);
    if (first == cut.end()) return;
    add(what, static_cast<std::size_t>(std::count(first, cut.end(), false)),
        element(block, static_cast<std::size_t>(first - cut.begin())), true);
  }

  void unknown_nodes(const ElementBlock& block) {
    for (std::size_t e = 0; e < block.count; ++e) {
      if (!written_.names_unknown(block, e)) continue;
      const Index* node = written_.nodes_of(block, e);
      const Index bad = *std::find_if(node, node + block.nodes_each, [](Index i) { return i < 0; });
      add("elements that name nodes which do not exist", 1,
          fmt::format("{} names node {}", element(block, e), document_.named(bad)), true);
    }
  }

  // Medit counts the elements of each kind from 1, and says no order of the kinds.
  bool has_no_numbers() const {
    return document_.format == "medit" && document_.element_tags.empty() && document_.first_element == 1;
  }

  // The order changes where the writer puts elements of one kind together.
  void order() {
    if (has_no_numbers()) return;
    const std::vector<Written>& blocks = written_.blocks();
    for (std::size_t i = 1; i < blocks.size(); ++i)
      if (blocks[i].block < blocks[i - 1].block)
        return add("order of elements", 1,
                   fmt::format("{} comes before those above it", element(*blocks[i - 1].block)));
  }

  void nodes() {
    if (written_.all_nodes()) return;
    std::vector<bool> kept(document_.points.size());
    for (std::size_t i = 0; i < written_.nodes(); ++i) kept[written_.node(i)] = true;
    const auto lost = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), false));
    const auto first = static_cast<std::size_t>(std::find(kept.begin(), kept.end(), false) - kept.begin());
    if (lost > 0)
      add("nodes of no element that is written", lost, fmt::format("node {}", document_.node_tag(first)));
    if (holds_.nodes_by_place) nodes_by_place();
  }

  // Nodes come back one for each place, in the order in which elements name them.
  void nodes_by_place() {
    std::vector<Eigen::Vector3d> places;
    bool in_order = true;
    for (std::size_t i = 0; i < written_.nodes(); ++i) {
      places.push_back(document_.points[written_.node(i)]);
      if (holds_.single) places.back() = places.back().cast<float>().cast<double>().eval();
      in_order = in_order && (i == 0 || written_.node(i - 1) < written_.node(i));
    }
    if (!in_order)
      add("order of nodes", 1, fmt::format("the first is node {}", document_.node_tag(written_.node(0))));
    const std::size_t all = places.size();
    weld(places);
    add("nodes at the place of another one", all - places.size(), fmt::format("of {}", all));
    if (std::any_of(places.begin(), places.end(), [](const auto& p) { return p.hasNaN(); })) nodes_at_nan();
  }

  // A node at NaN equals no place, not even its own, so it comes back once for each corner.
  void nodes_at_nan() {
    std::map<Index, std::size_t> corners;
    for (const Written& written : written_.blocks())
      for (std::size_t e = 0; e < written.block->count; ++e)
        if (written_.comes_back(written, e))
          for (int k = 0; k < written.nodes_each; ++k)
            if (const Index node = written_.nodes_of(*written.block, e)[k];
                document_.points[static_cast<std::size_t>(node)].hasNaN())
              ++corners[node];
    for (const auto& [node, count] : corners)
      if (count > 1)
        add("nodes at NaN, which become one for each corner", 1,
            fmt::format("node {}", document_.node_tag(static_cast<std::size_t>(node))));
  }

  // The numbers are lost unless those of the written nodes count up from 0 or 1.
  void node_numbers() {
    if (holds_.node_tags || written_.nodes() == 0) return;
    if (written_.all_nodes() && document_.node_tags.empty() && is_plain(document_.first_node)) return;
    const std::int64_t first = document_.node_tag(written_.node(0));
    std::int64_t next = first;
    bool plain = is_plain(first);
    for (std::size_t i = 0; i < written_.nodes() && plain; ++i)
      plain = document_.node_tag(written_.node(i)) == next++;
    if (!plain) add("numbers of nodes", written_.nodes(), fmt::format("the first is {}", first));
  }

  // Numbers that no node has are lost where the writer has to write others.
  void unknown_numbers() {
    if (!holds_.unknown_nodes || !holds_.unknown_number) return;
    for (std::size_t k = 0; k < document_.unknown.size(); ++k)
      if (const std::int64_t number = holds_.unknown_number(k); number != document_.unknown[k])
        add("numbers of nodes that do not exist", 1,
            fmt::format("{} becomes {}", document_.unknown[k], number));
  }

  // The elements that come back as they were or by their corners, as `each(place, number in the file)`.
  template <class Each>
  void each_numbered(const Each& each) const {
    std::int64_t position = 0;
    auto cut = written_.cut().begin();
    const auto cut_before = [&](const ElementBlock* block) {
      for (; cut != written_.cut().end() && (!block || cut->block < block); ++cut) {
        if (cut->as_it_was) each(cut->block->first + cut->element, position + 1);
        position += static_cast<std::int64_t>(cut->count);
      }
    };
    for (const Written& written : written_.blocks()) {
      cut_before(written.block);
      for (std::size_t e = 0; e < written.block->count; ++e) {
        if (!written_.comes_back(written, e)) continue;
        const std::size_t place = written.block->first + e;
        ++position;
        each(place, holds_.numbers_all_elements ? static_cast<std::int64_t>(place) + 1 : position);
      }
    }
    cut_before(nullptr);
  }

  void element_numbers() {
    if (holds_.element_tags || has_no_numbers()) return;
    std::int64_t first = 0, first_in_file = 0;
    bool plain = true;  // they count up from 0 or 1, and so do the file's
    bool same = true;   // they are equal to the file's, which start from 1
    std::size_t count = 0;
    each_numbered([&](std::size_t place, std::int64_t in_file) {
      const std::int64_t tag = document_.element_tag(place), before = static_cast<std::int64_t>(count);
      if (count++ == 0) first = tag, first_in_file = in_file;
      plain = plain && is_plain(first) && tag == first + before && is_plain(first_in_file) &&
              in_file == first_in_file + before;
      same = same && tag == in_file;
    });
    if (!plain && !same) add("numbers of elements", count, fmt::format("the first is {}", first));
  }

  void coordinates() {
    if (!holds_.single) return;
    std::size_t rounded = 0;
    std::string example;
    for (std::size_t i = 0; i < written_.nodes(); ++i)
      for (const double x : document_.points[written_.node(i)])
        if (!std::isnan(x) && static_cast<double>(static_cast<float>(x)) != x && rounded++ == 0)
          example = fmt::format("{} becomes {}", x, static_cast<double>(static_cast<float>(x)));
    add("coordinates rounded to 32 bits", rounded, example);
  }
};

}  // namespace

void find_losses_of_mesh(const Document& document, const Holds& holds, const WrittenPart& written,
                         std::vector<Loss>& losses) {
  MeshLosses(document, holds, written, losses).find();
}

std::vector<Loss> dangling(const Document& document, const Holds& holds) {
  std::vector<Loss> found;
  if (holds.unknown_nodes && !document.unknown.empty())
    MeshLosses(document, holds, WrittenPart(document, holds), found).find_dangling();
  return found;
}

}  // namespace tetproof::io
