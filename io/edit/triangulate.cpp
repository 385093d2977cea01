// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts the polygons of a document into triangles.
#include <fmt/core.h>

#include <algorithm>
#include <span>

#include "io/bytes/words.hpp"
#include "io/edit/edits.hpp"
#include "io/edit/new_elements.hpp"
#include "io/error.hpp"
#include "io/model/element_types.hpp"
#include "io/model/weld.hpp"
#include "io/surface/cutting.hpp"
#include "io/surface/surface_document.hpp"

namespace tetproof::io {
namespace {

class Triangulator {
 public:
  explicit Triangulator(Document& document)
      : document_(document), facets_(document), elements_(document), places_(document.points) {
    welded_ = weld(places_);
    node_of_.assign(places_.size(), -1);
    for (std::size_t i = welded_.size(); i-- > 0;)
      node_of_[static_cast<std::size_t>(welded_[i])] = static_cast<Index>(i);
  }

  Edit triangulate() {
    const Facet* last = nullptr;
    for (const ElementBlock& block : document_.blocks) {
      const Index* nodes = document_.connectivity.data() + block.nodes;
      for (std::size_t e = 0; e < block.count; ++e, nodes += block.nodes_each) {
        const std::size_t element = block.first + e;
        const Facet* facet = document_.facets.empty() ? nullptr : facets_.of(element);
        if (facet && corners_kept(block) >= 3) {
          if (facet != last) cut_facet(block, *facet, element);
          last = facet;
          ++cut_count_;
        } else if (!facet && corners_kept(block) > 3) {
          cut(block, element, nodes);
          ++cut_count_;
        } else if (!facet) {
          keep(block, element, nodes);
        } else {
          ++edges_;  // of a facet, and in its triangles now
        }
      }
    }
    document_.facets.clear();
    Edit edit;
    edit.lost = std::move(elements_).replace(document_);
    edit.did = fmt::format("{} cut into {}", counted(cut_count_, "polygons"), counted(made_, "triangles"));
    if (edges_ > 0)
      edit.did += fmt::format("; {} in their facets left out", counted(edges_, "edges and points"));
    if (const std::string bends = bends_.text(); !bends.empty()) edit.did += "; " + bends;
    if (by_corners_ > 0)
      edit.lost.push_back({.item = "nodes between the corners of quadrangles",
                           .count = static_cast<std::int64_t>(by_corners_),
                           .example = "the quadrangles are cut by their corners"});
    return edit;
  }

 private:
  [[noreturn]] void fail(std::size_t element, const std::string& what) const {
    throw InputError(fmt::format("{}: element {} {}", document_.path, document_.element_tag(element), what));
  }

  void keep(const ElementBlock& block, std::size_t element, const Index* nodes) {
    local_.resize(static_cast<std::size_t>(block.nodes_each));
    for (std::size_t k = 0; k < local_.size(); ++k) local_[k] = static_cast<std::int32_t>(k);
    elements_.add(block, element, nodes, local_);
  }

  void cut(const ElementBlock& block, std::size_t element, const Index* nodes) {
    const int corners = corners_kept(block);
    places_at_.clear();
    for (int k = 0; k < corners; ++k) {
      if (nodes[k] < 0)
        fail(element, fmt::format("names node {}, which does not exist", document_.named(nodes[k])));
      const Index place = welded_[static_cast<std::size_t>(nodes[k])];
      if (places_at_.empty() || places_at_.back() != place) places_at_.push_back(place);
    }
    while (places_at_.size() > 1 && places_at_.back() == places_at_.front()) places_at_.pop_back();
    ElementBlock like = block;
    like.type = triangle3;
    by_corners_ += static_cast<std::size_t>(block.nodes_each - corners);
    if (places_at_.size() < 3) {  // collapsed
      local_ = {0, 1, 2};
      elements_.add(like, element, nodes, local_);
      ++made_;
      return;
    }
    cut_polygon(places_at_, places_, cut_);
    if (!cut_.fault.empty())
      fail(element, fmt::format("with {} {}", counted(corners, "corners"), cut_.fault));
    bends_.add(cut_, places_at_.size());
    for (const auto& triangle : cut_.triangles) {
      local_.clear();
      for (const Index place : triangle) {
        int k = 0;
        while (welded_[static_cast<std::size_t>(nodes[k])] != place) ++k;
        local_.push_back(k);
      }
      elements_.add(like, element, nodes, local_);
      ++made_;
    }
  }

  void cut_facet(const ElementBlock& block, const Facet& facet, std::size_t element) {
    facets_.cut(facet, welded_, places_, cut_);
    if (!cut_.fault.empty())
      fail(element, fmt::format("of a facet of {} and {} {}", counted(facet.polygons, "polygons"),
                                counted(facet.holes.size(), "holes"), cut_.fault));
    bends_.add(cut_, 0);
    ElementBlock like = block;
    like.type = triangle3;
    for (auto triangle : cut_.triangles) {
      for (Index& place : triangle) place = node_of_[static_cast<std::size_t>(place)];
      elements_.add_free(like, element, triangle);
      ++made_;
    }
  }

  Document& document_;
  const Facets facets_;
  NewElements elements_;
  std::vector<Eigen::Vector3d> places_;  // the different points
  std::vector<Index> welded_, node_of_;  // of each node its place; of each place its first node
  std::vector<Index> places_at_;         // of the polygon at hand
  std::vector<std::int32_t> local_;
  Cut cut_;
  Bends bends_;
  std::size_t cut_count_ = 0, made_ = 0, edges_ = 0, by_corners_ = 0;
};

}  // namespace

Edit triangulate(Document& document) {
  return Triangulator(document).triangulate();
}

}  // namespace tetproof::io
