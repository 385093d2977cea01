// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of a document's solids.
#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>
#include <set>

#include "io/bytes/words.hpp"
#include "io/edit/edits.hpp"
#include "io/edit/new_elements.hpp"
#include "io/edit/outer_faces.hpp"
#include "io/edit/solid_faces.hpp"
#include "io/error.hpp"
#include "io/model/element_types.hpp"
#include "io/model/tag_sets.hpp"

namespace tetproof::io {
namespace {

// The corners of a face, each once: a collapsed hexahedron has quadrangles that are triangles.
template <class Nodes>
std::vector<Index> different_corners(std::size_t corners, const Nodes& node) {
  std::vector<Index> all;
  for (std::size_t k = 0; k < corners; ++k)
    if (std::find(all.begin(), all.end(), node(k)) == all.end()) all.push_back(node(k));
  return all;
}

class Boundary {
 public:
  explicit Boundary(Document& document) : document_(document), elements_(document), tag_sets_(document) {}

  Edit make();

 private:
  const Index* nodes_of(const ElementBlock& block, std::size_t e) const {
    return document_.connectivity.data() + block.nodes + e * static_cast<std::size_t>(block.nodes_each);
  }
  bool is_inverted(const ElementBlock& block, const Index* nodes) const;
  void collect();
  void add(const ElementBlock& block, std::size_t e, const SolidFace& face, bool inverted);
  bool add_element_there(std::span<const Index> corners);
  std::int32_t groups_of(std::int32_t set);
  std::int64_t entity_of(std::int64_t entity);

  Document& document_;
  NewElements elements_;
  TagSets tag_sets_;
  std::vector<Face> faces_;  // of solids
  std::vector<Face> there_;  // elements that are faces; `id` is the position of the element
  std::vector<bool> outer_;  // by id: the face is on the boundary
  OuterCounts counts_;
  std::map<std::int64_t, std::int64_t> groups_, entities_;  // of volumes: their numbers among surfaces
  std::set<std::int64_t> taken_groups_, taken_entities_;    // among surfaces
  std::size_t solids_ = 0, inverted_ = 0, from_elements_ = 0, by_corners_ = 0, others_ = 0;
};

// The sign of the volume, as a sum over the faces.
bool Boundary::is_inverted(const ElementBlock& block, const Index* nodes) const {
  double volume = 0;
  for (const SolidFace& face : solid_faces(block.type)) {
    for (int k = 0; k < face.corners; ++k)
      if (nodes[face.nodes[static_cast<std::size_t>(k)]] < 0) return false;
    const auto from_first = [&](std::size_t k) -> Eigen::Vector3d {
      return document_.points[static_cast<std::size_t>(nodes[face.nodes[k]])] -
             document_.points[static_cast<std::size_t>(nodes[0])];
    };
    for (std::size_t k = 1; k + 1 < static_cast<std::size_t>(face.corners); ++k)
      volume += from_first(0).dot(from_first(k).cross(from_first(k + 1)));
  }
  return volume < 0;
}

void Boundary::collect() {
  for (const ElementBlock& block : document_.blocks) {
    const std::span<const SolidFace> faces = solid_faces(block.type);
    const ElementType* type = element_type(block.type);
    if (block.dim == 2) taken_entities_.insert(block.entity);
    if (block.dim == 2)
      for (const std::int64_t group : document_.tag_sets[static_cast<std::size_t>(block.groups)])
        taken_groups_.insert(std::abs(group));
    if (faces.empty()) {
      if (has_other_cells(block)) others_ += block.count;
      if (!type || (type->shape != Shape::triangle && type->shape != Shape::quadrangle)) continue;
      for (std::size_t e = 0; e < block.count; ++e) {
        const Index* nodes = nodes_of(block, e);
        const auto corners = different_corners(static_cast<std::size_t>(type->corners),
                                               [&](std::size_t k) { return nodes[k]; });
        if (corners.size() >= 3) there_.emplace_back(corners, block.first + e);
      }
      continue;
    }
    solids_ += block.count;
    std::size_t id = outer_.size();
    outer_.resize(id + block.count * faces.size(), false);
    for (std::size_t e = 0; e < block.count; ++e) {
      const Index* nodes = nodes_of(block, e);
      for (const SolidFace& face : faces) {
        const auto corners = different_corners(static_cast<std::size_t>(face.corners),
                                               [&](std::size_t k) { return nodes[face.nodes[k]]; });
        if (corners.size() >= 3) faces_.emplace_back(corners, id);
        ++id;
      }
    }
  }
  for (const Entity& entity : document_.entities)
    if (entity.dim == 2) taken_entities_.insert(entity.tag);
  for (const GroupName& name : document_.group_names)
    if (name.dim == 2) taken_groups_.insert(name.group);
  std::sort(there_.begin(), there_.end());
  keep_outer_faces(faces_, counts_);
  for (const Face& face : faces_) outer_[face.id] = true;
  faces_ = {};
}

std::int32_t Boundary::groups_of(std::int32_t set) {
  std::vector<std::int64_t> groups = document_.tag_sets[static_cast<std::size_t>(set)];
  for (std::int64_t& group : groups) {
    const auto [place, is_new] = groups_.try_emplace(std::abs(group), std::abs(group));
    if (is_new) {
      if (taken_groups_.contains(place->second)) place->second = *taken_groups_.rbegin() + 1;
      taken_groups_.insert(place->second);
      for (std::size_t i = 0; i < document_.group_names.size(); ++i)
        if (GroupName name = document_.group_names[i]; name.dim == 3 && name.group == place->first)
          document_.group_names.push_back({2, place->second, name.name});
    }
    group = group < 0 ? -place->second : place->second;
  }
  return tag_sets_(groups);
}

std::int64_t Boundary::entity_of(std::int64_t entity) {
  if (entity == 0) return 0;
  const auto [place, is_new] = entities_.try_emplace(entity, entity);
  if (is_new) {
    if (taken_entities_.contains(entity)) place->second = *taken_entities_.rbegin() + 1;
    taken_entities_.insert(place->second);
  }
  return place->second;
}

// Adds the element of the document that has these corners, if there is one, wound as they are.
bool Boundary::add_element_there(std::span<const Index> corners) {
  const auto found = find_face(there_, Face(corners, 0));
  if (found == there_.end()) return false;
  const auto block = std::prev(
      std::upper_bound(document_.blocks.begin(), document_.blocks.end(), found->id,
                       [](std::size_t element, const ElementBlock& b) { return element < b.first; }));
  const Index* nodes = nodes_of(*block, found->id - block->first);
  const ElementType& type = *element_type(block->type);
  const auto n = static_cast<std::size_t>(type.corners);
  const auto at = static_cast<std::size_t>(std::find(nodes, nodes + n, corners[0]) - nodes);
  const bool same_way = nodes[(at + 1) % n] == corners[1] || nodes[(at + n - 1) % n] != corners[1];
  std::vector<std::int32_t> local(static_cast<std::size_t>(type.nodes));
  std::iota(local.begin(), local.end(), 0);
  ElementBlock like = *block;
  if (!same_way) {
    if (type.nodes > type.corners && type.nodes > 2 * type.corners + 1) {
      local.resize(n);
      like.type = n == 3 ? triangle3 : quadrangle4;
      ++by_corners_;
    }
    std::reverse(local.begin() + 1, local.begin() + type.corners);
    if (local.size() > n) std::reverse(local.begin() + type.corners, local.begin() + 2 * type.corners);
  }
  elements_.add(like, found->id, nodes, local);
  ++from_elements_;
  return true;
}

void Boundary::add(const ElementBlock& block, std::size_t e, const SolidFace& face, bool inverted) {
  const Index* nodes = nodes_of(block, e);
  std::vector<std::int32_t> local = face.nodes;
  const auto n = static_cast<std::ptrdiff_t>(face.corners);
  if (inverted) {
    std::reverse(local.begin() + 1, local.begin() + n);
    if (local.size() > face.nodes.size() / 2 && static_cast<std::ptrdiff_t>(local.size()) >= 2 * n)
      std::reverse(local.begin() + n, local.begin() + 2 * n);
  }
  const auto corners =
      different_corners(static_cast<std::size_t>(n), [&](std::size_t k) { return nodes[local[k]]; });
  if (add_element_there(corners)) return;
  ElementBlock like = block;
  like.dim = 2;
  like.type = face.type;
  like.entity = entity_of(block.entity);
  like.groups = groups_of(block.groups);
  const ElementType& solid = *element_type(block.type);
  const bool collapsed = corners.size() < static_cast<std::size_t>(n);
  if (collapsed) {  // the nodes of its edges are of no use
    std::vector<std::int32_t> left;
    for (const Index corner : corners)
      left.push_back(
          *std::find_if(local.begin(), local.end(), [&](std::int32_t k) { return nodes[k] == corner; }));
    local = left;
    like.type = triangle3;
  }
  by_corners_ += solid.nodes > solid.corners && local.size() == corners.size();
  elements_.add(like, block.first + e, nodes, local);
}

Edit Boundary::make() {
  collect();
  if (solids_ == 0)
    throw InputError(fmt::format("{}: there are no solids that have a boundary", document_.path));
  const std::size_t before = document_.elements();
  std::size_t id = 0;
  for (const ElementBlock& block : document_.blocks) {
    const std::span<const SolidFace> faces = solid_faces(block.type);
    for (std::size_t e = 0; e < block.count && !faces.empty(); ++e) {
      const bool any = std::any_of(outer_.begin() + static_cast<std::ptrdiff_t>(id),
                                   outer_.begin() + static_cast<std::ptrdiff_t>(id + faces.size()),
                                   [](bool outer) { return outer; });
      const bool inverted = any && is_inverted(block, nodes_of(block, e));
      inverted_ += inverted;
      for (const SolidFace& face : faces)
        if (outer_[id++]) add(block, e, face, inverted);
    }
  }
  Edit edit;
  const std::size_t made = elements_.size();
  document_.facets.clear();
  edit.lost = std::move(elements_).replace(document_, NewElements::Numbers::anew);
  edit.did = fmt::format("{} of {} in place of {}", counted(made, "boundary faces"),
                         counted(solids_, "solids"), counted(before, "elements"));
  if (from_elements_ > 0)
    edit.did += fmt::format("; {} of them {} an element before", from_elements_,
                            from_elements_ == 1 ? "was" : "were");
  if (inverted_ > 0)
    edit.did += fmt::format("; turned outwards at {}", counted(inverted_, "solids of negative volume"));
  if (counts_.halved > 0)
    edit.did += fmt::format("; {} with two triangles on the other side left out",
                            counted(counts_.halved, "quadrangles"));
  if (counts_.of_many > 0)
    edit.did += fmt::format("; {} of three or more solids left out", counted(counts_.of_many, "faces"));
  const auto lose = [&](const char* item, std::size_t count, const char* example) {
    if (count > 0)
      edit.lost.push_back({.item = item, .count = static_cast<std::int64_t>(count), .example = example});
  };
  lose("faces by their corners", by_corners_, "their other nodes are left out");
  lose("solids without faces", others_, "their boundary is left out");
  return edit;
}

}  // namespace

Edit boundary(Document& document) {
  return Boundary(document).make();
}

}  // namespace tetproof::io
