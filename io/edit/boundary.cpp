// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of a document's solids.
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>
#include <set>

#include "io/bytes/words.hpp"
#include "io/edit/edits.hpp"
#include "io/edit/free_numbers.hpp"
#include "io/edit/new_elements.hpp"
#include "io/edit/outer_faces.hpp"
#include "io/edit/solid_faces.hpp"
#include "io/edit/solid_sign.hpp"
#include "io/error.hpp"
#include "io/loss/loss_list.hpp"
#include "io/model/block_of.hpp"
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

std::int64_t free_number(const std::set<std::int64_t>& taken) {
  return FreeNumbers({taken.begin(), taken.end()}).next();
}

class Boundary {
 public:
  explicit Boundary(Document& document) : document_(document), elements_(document), tag_sets_(document) {}

  Edit make();

 private:
  const Index* nodes_of(const ElementBlock& block, std::size_t e) const {
    return document_.connectivity.data() + block.nodes + e * static_cast<std::size_t>(block.nodes_each);
  }
  void collect();
  void add(const ElementBlock& block, std::size_t e, const SolidFace& face, bool inverted);
  bool add_element_there(std::span<const Index> corners, std::size_t wanted);
  void unite_groups(ElementBlock& like, const ElementBlock& further);
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
  std::vector<Loss> lost_;
};

void Boundary::collect() {
  for (const ElementBlock& block : document_.blocks) {
    const std::span<const SolidFace> faces = solid_faces(block.type);
    const ElementType* type = element_type(block.type);
    if (block.dim == 2) taken_entities_.insert(block.entity);
    if (block.dim == 2)
      for (const std::int64_t group : document_.tag_sets[static_cast<std::size_t>(block.groups)])
        taken_groups_.insert(std::abs(group));
    if (faces.empty()) {
      if ((type ? type->dim : block.type == polyhedron ? 3 : block.dim) == 3) others_ += block.count;
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
      if (taken_groups_.contains(place->second)) place->second = free_number(taken_groups_);
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
    if (taken_entities_.contains(entity)) place->second = free_number(taken_entities_);
    taken_entities_.insert(place->second);
  }
  return place->second;
}

void Boundary::unite_groups(ElementBlock& like, const ElementBlock& further) {
  std::vector<std::int64_t> groups = document_.tag_sets[static_cast<std::size_t>(like.groups)];
  for (const std::int64_t group : document_.tag_sets[static_cast<std::size_t>(further.groups)])
    if (std::find(groups.begin(), groups.end(), group) == groups.end()) groups.push_back(group);
  like.groups = tag_sets_(groups);
}

// Adds the element of the document that has these corners, if there is one, wound as they are. Of several, it
// is the first, with the groups of all: a face stands in a surface once. `wanted`: how many nodes show the
// solid's side.
bool Boundary::add_element_there(std::span<const Index> corners, std::size_t wanted) {
  const auto found = find_face(there_, Face(corners, 0));
  if (found == there_.end()) return false;
  const ElementBlock& block = block_of(document_.blocks, found->id);
  const Index* nodes = nodes_of(block, found->id - block.first);
  const ElementType& type = *element_type(block.type);
  const auto n = static_cast<std::size_t>(type.corners);
  const auto at = static_cast<std::size_t>(std::find(nodes, nodes + n, corners[0]) - nodes);
  const bool same_way = nodes[(at + 1) % n] == corners[1] || nodes[(at + n - 1) % n] != corners[1];
  std::vector<std::int32_t> local(static_cast<std::size_t>(type.nodes));
  std::iota(local.begin(), local.end(), 0);
  ElementBlock like = block;
  for (auto further = std::next(found); further != there_.end() && further->corners == found->corners;
       ++further) {
    unite_groups(like, block_of(document_.blocks, further->id));
    add_loss(lost_, "further elements on a face", 1,
             fmt::format("element {} on that of element {}, which has the groups of both",
                         document_.element_tag(further->id), document_.element_tag(found->id)),
             true);
  }
  if (!same_way) {
    if (type.nodes > type.corners && type.nodes > 2 * type.corners + 1) {
      local.resize(n);
      like.type = n == 3 ? triangle3 : quadrangle4;
    }
    std::reverse(local.begin() + 1, local.begin() + type.corners);
    if (local.size() > n) std::reverse(local.begin() + type.corners, local.begin() + 2 * type.corners);
  }
  by_corners_ += local.size() < wanted || (local.size() == n && type.nodes > type.corners);
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
    if (static_cast<std::ptrdiff_t>(local.size()) >= 2 * n)
      std::reverse(local.begin() + n, local.begin() + 2 * n);
  }
  const auto corners =
      different_corners(static_cast<std::size_t>(n), [&](std::size_t k) { return nodes[local[k]]; });
  const ElementType& solid = *element_type(block.type);
  const bool collapsed = corners.size() < static_cast<std::size_t>(n);
  const std::size_t wanted = solid.nodes == solid.corners ? 0
                             : collapsed                  ? corners.size() + 1
                                                          : std::max(local.size(), corners.size() + 1);
  if (add_element_there(corners, wanted)) return;
  ElementBlock like = block;
  like.dim = 2;
  like.type = face.type;
  like.entity = entity_of(block.entity);
  like.groups = groups_of(block.groups);
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
      const bool inverted = any && is_inverted(document_, block, nodes_of(block, e));
      inverted_ += inverted;
      for (const SolidFace& face : faces)
        if (outer_[id++]) add(block, e, face, inverted);
    }
  }
  Edit edit;
  const std::size_t made = elements_.size();
  document_.facets.clear();
  edit.lost = std::move(elements_).replace(document_, NewElements::Numbers::anew);
  edit.lost.insert(edit.lost.end(), lost_.begin(), lost_.end());
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
  add_loss(edit.lost, "faces by their corners", by_corners_, "their other nodes are left out");
  add_loss(edit.lost, "solids without faces", others_, "their boundary is left out", true);
  return edit;
}

}  // namespace

Edit boundary(Document& document) {
  return Boundary(document).make();
}

}  // namespace tetproof::io
