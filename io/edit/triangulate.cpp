// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts the polygons of a document into triangles.
#include <fmt/core.h>

#include <algorithm>
#include <span>

#include "io/bytes/words.hpp"
#include "io/edit/edits.hpp"
#include "io/edit/new_elements.hpp"
#include "io/error.hpp"
#include "io/loss/loss_list.hpp"
#include "io/model/block_of.hpp"
#include "io/model/element_types.hpp"
#include "io/model/weld.hpp"
#include "io/surface/cutting.hpp"
#include "io/surface/surface_document.hpp"

namespace tetproof::io {
namespace {

// The number of corners of each element of a block; 0 if these are no faces.
int corners_of_faces(const ElementBlock& block) {
  return dimension_of_type(block.type) == 2 ? corners_kept(block) : 0;
}

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
    bool is_cut = false;
    for (const ElementBlock& block : document_.blocks) {
      const Index* nodes = document_.connectivity.data() + block.nodes;
      const int corners = corners_of_faces(block);
      for (std::size_t e = 0; e < block.count; ++e, nodes += block.nodes_each) {
        const std::size_t element = block.first + e;
        const Facet* facet = document_.facets.empty() ? nullptr : facets_.of(element);
        if (facet != last) is_cut = facet && cut_facet(*facet);
        last = facet;
        if (is_cut) continue;  // with its facet
        if (!facet && corners > 3) {
          cut(block, element, nodes);
          ++cut_count_;
        } else {
          keep(block, element, nodes);
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
    add_loss(edit.lost, "nodes between the corners of quadrangles", by_corners_,
             "the quadrangles are cut by their corners");
    add_loss(edit.lost, "polygons, edges and points of facets without area", without_area_,
             first_without_area_, true);
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
    const int corners = corners_of_faces(block);
    places_at_.clear();
    for (int k = 0; k < corners; ++k) {
      if (nodes[k] < 0)
        fail(element, fmt::format("names node {}, which does not exist", document_.named(nodes[k])));
      const Index place = welded_[static_cast<std::size_t>(nodes[k])];
      if (places_at_.empty() || places_at_.back() != place) places_at_.push_back(place);
    }
    while (places_at_.size() > 1 && places_at_.back() == places_at_.front()) places_at_.pop_back();
    const ElementBlock like = triangles_like(block);
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

  static ElementBlock triangles_like(const ElementBlock& block) {
    ElementBlock like = block;
    like.type = triangle3;
    like.dim = 2;
    return like;
  }

  // False: the facet has only edges and points, which stay.
  bool cut_facet(const Facet& facet) {
    std::size_t element = 0, polygons = 0;  // the first polygon: triangles are like it
    for (std::size_t e = facet.first + facet.polygons; e-- > facet.first;)
      if (corners_of_faces(block_of(document_.blocks, e)) >= 3) ++polygons, element = e;
    if (polygons == 0) return false;
    facets_.cut(facet, welded_, places_, cut_);
    if (!cut_.fault.empty())
      fail(element, fmt::format("of a facet of {} and {} {}", counted(facet.polygons, "polygons"),
                                counted(facet.holes.size(), "holes"), cut_.fault));
    bends_.add(cut_, 0);
    if (cut_.triangles.empty()) {
      if (without_area_ == 0)
        first_without_area_ = fmt::format("element {}", document_.element_tag(facet.first));
      without_area_ += facet.polygons;
      return true;
    }
    cut_count_ += polygons;
    edges_ += facet.polygons - polygons;  // they are in its triangles now
    const ElementBlock like = triangles_like(block_of(document_.blocks, element));
    for (auto triangle : cut_.triangles) {
      for (Index& place : triangle) place = node_of_[static_cast<std::size_t>(place)];
      elements_.add_free(like, element, triangle);
      ++made_;
    }
    return true;
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
  std::size_t cut_count_ = 0, made_ = 0, edges_ = 0, by_corners_ = 0, without_area_ = 0;
  std::string first_without_area_;
};

}  // namespace

Edit triangulate(Document& document) {
  return Triangulator(document).triangulate();
}

}  // namespace tetproof::io
