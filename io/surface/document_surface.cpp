// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface/document_surface.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>

#include "io/bytes/large_pages.hpp"
#include "io/bytes/scanner.hpp"
#include "io/bytes/words.hpp"
#include "io/error.hpp"
#include "io/model/element_types.hpp"
#include "io/model/weld.hpp"
#include "io/surface/cutting.hpp"
#include "io/surface/solid_boundary.hpp"
#include "io/surface/surface_numbers.hpp"

namespace tetproof {
namespace io {
namespace {

// Where the elements stand in a file.
struct Places {
  const InputFile& file;
  const std::vector<std::size_t>& bytes;
  bool text;
};

// The number of corners of each element of a block; 0 if these are no faces that can be cut.
int corners_of_faces(const ElementBlock& block) {
  if (block.type == polygon) return block.nodes_each;
  const ElementType* type = element_type(block.type);
  return type && (type->shape == Shape::triangle || type->shape == Shape::quadrangle) ? type->corners : 0;
}

int dimension(const ElementBlock& block) {
  const ElementType* type = element_type(block.type);
  return type ? type->dim : block.dim;
}

// Polygons of fewer than three corners are read as lines and points. In an OFF or a .poly they are faces that
// went wrong.
bool is_thin_face(const Document& document, const ElementBlock& block) {
  return dimension(block) < 2 && (block.of_boundary || document.format == "off");
}

// Welds the points and cuts the faces one by one.
class Cutter {
 public:
  Cutter(const Document& document, std::vector<Eigen::Vector3d> points, const Places* places)
      : document_(document),
        places_(places),
        facets_(document),
        points_(points.size()),
        numbers_(document, points_, corners_of_faces) {
    surface_.vertices = std::move(points);
  }

  TriangleSurface take(bool welded, std::vector<std::string>& warnings) {
    cut_all(welded);
    const std::string path = document_.path.empty() ? "" : document_.path + ": ";
    if (const std::string bends = bends_.text(); !bends.empty()) warnings.push_back(path + bends);
    if (const std::string solids = keep_boundary_of_solids(); !solids.empty())
      warnings.push_back(path + solids);
    return std::move(surface_);
  }
  bool is_boundary_of_solids() {
    cut_all(false);
    return are_solid_boundary(surface_.vertices, surface_.triangles, document_.holes);
  }
  SurfaceNumbering numbering() { return std::move(numbers_).take(); }

 private:
  void cut_all(bool welded) {
    std::size_t triangles = 0;
    for (const ElementBlock& block : document_.blocks) {
      check(block);
      if (const int corners = corners_of_faces(block); corners >= 3)
        triangles += block.count * static_cast<std::size_t>(corners - 2);
    }
    if (triangles == 0)
      throw InputError(fmt::format("{}expected a surface, found no triangles or polygons",
                                   document_.path.empty() ? "" : document_.path + ": "));
    leave_out_others();
    if (!welded) weld_points();
    reserve_in_large_pages(surface_.triangles, triangles);
    for (const ElementBlock& block : document_.blocks) {
      const int corners = corners_of_faces(block);
      if (corners == 0) continue;
      const Index* node = document_.connectivity.data() + block.nodes;
      for (std::size_t e = 0; e < block.count; ++e, node += block.nodes_each)
        add({node, static_cast<std::size_t>(corners)}, block.first + e);
    }
  }

  // "element 8 WHAT", or "face WHAT" in its place in the file.
  [[noreturn]] void fail(std::size_t element, const std::string& what) const {
    if (places_) {
      const Scanner scanner(places_->file.path(), places_->file.bytes(), places_->bytes[element]);
      if (places_->text) scanner.fail_in_line("face " + what);
      scanner.fail_at_byte("face " + what);
    }
    throw InputError(fmt::format("{}element {} {}", document_.path.empty() ? "" : document_.path + ": ",
                                 document_.element_tag(element), what));
  }

  void check(const ElementBlock& block) const {
    if (block.count == 0) return;
    if (is_thin_face(document_, block))
      for (std::size_t e = block.first; e < block.first + block.count; ++e)
        if (!facet_of(e))
          fail(e, fmt::format("has {}, expected at least 3", counted(block.nodes_each, "corners")));
    if (dimension(block) == 2 && corners_of_faces(block) == 0)
      fail(block.first,
           fmt::format("of type {} is neither a triangle, a quadrangle nor a polygon", block.type));
  }

  // Leaves out points that elements use, but none of them as the corner of a face.
  void leave_out_others() {
    const bool all_are_faces =
        std::all_of(document_.blocks.begin(), document_.blocks.end(), [](const ElementBlock& block) {
          return block.count == 0 || corners_of_faces(block) == block.nodes_each;
        });
    if (all_are_faces) return;
    enum : unsigned char { unused, used, corner };
    std::vector<unsigned char> uses(surface_.vertices.size(), unused);
    for (const ElementBlock& block : document_.blocks) {
      const int corners = corners_of_faces(block);
      const Index* node = document_.connectivity.data() + block.nodes;
      for (std::size_t e = 0; e < block.count; ++e) {
        const bool all_corners = facet_of(block.first + e) != nullptr;
        for (int k = 0; k < block.nodes_each; ++k, ++node)
          if (*node >= 0)
            uses[*node] = std::max<unsigned char>(uses[*node], k < corners || all_corners ? corner : used);
      }
    }
    moved_.resize(uses.size());
    Index kept = 0;
    for (std::size_t i = 0; i < uses.size(); ++i) {
      moved_[i] = kept;
      if (uses[i] == used) continue;
      numbers_.move(static_cast<std::size_t>(kept), i);
      surface_.vertices[static_cast<std::size_t>(kept++)] = surface_.vertices[i];
    }
    surface_.vertices.resize(static_cast<std::size_t>(kept));
    numbers_.keep(surface_.vertices.size());
  }

  void weld_points() {
    std::vector<Index> welded = weld(surface_.vertices);
    numbers_.weld(welded, surface_.vertices.size());
    if (moved_.empty()) {
      moved_ = std::move(welded);
      return;
    }
    // Points that are left out may have a position behind the last one; no face names them.
    for (Index& moved : moved_)
      if (static_cast<std::size_t>(moved) < welded.size()) moved = welded[static_cast<std::size_t>(moved)];
  }

  const Facet* facet_of(std::size_t element) const {
    return document_.facets.empty() ? nullptr : facets_.of(element);
  }
  void add(std::span<const Index> face, std::size_t element) {
    if (const Facet* facet = facet_of(element)) {  // cut once, with its first face
      if (facet == last_facet_) return;
      last_facet_ = facet;
      cut_facet_of(*facet, element);
    } else {
      cut(face, element);
    }
    numbers_.add(element, surface_.triangles.size());
  }
  void cut_facet_of(const Facet& facet, std::size_t element);
  std::string keep_boundary_of_solids();
  void take_cut(std::size_t element, const std::string& what, std::size_t corners);
  void cut(std::span<const Index> face, std::size_t element);
  std::string unknown_corner(Index corner) const;

  Index position(Index node) const { return moved_.empty() ? node : moved_[static_cast<std::size_t>(node)]; }

  const Document& document_;
  const Places* places_;
  const Facets facets_;
  const Facet* last_facet_ = nullptr;
  Cut cut_;  // of the face at hand
  Bends bends_;
  const std::size_t points_;    // how many the document has
  std::vector<Index> moved_;    // the new position of each point; empty: as it was
  std::vector<Index> corners_;  // of the face at hand
  SurfaceNumbers numbers_;
  TriangleSurface surface_;
};

std::string Cutter::unknown_corner(Index corner) const {
  const std::int64_t named = document_.named(corner);
  if (!places_) return fmt::format("names node {}, which does not exist", named);
  if (points_ == 0) return fmt::format("names vertex {}, but there are no vertices", named);
  return fmt::format("names vertex {}, expected {} to {}", named, document_.first_node,
                     static_cast<std::int64_t>(points_) - 1 + document_.first_node);
}

void Cutter::cut(std::span<const Index> face, std::size_t element) {
  if (face.size() == 3 && face[0] >= 0 && face[1] >= 0 && face[2] >= 0) {  // nearly all faces
    surface_.triangles.push_back({position(face[0]), position(face[1]), position(face[2])});
    return;
  }
  if (face.size() < 3)
    fail(element, fmt::format("has {}, expected at least 3", counted(face.size(), "corners")));
  corners_.clear();
  for (const Index corner : face) {
    if (corner < 0) fail(element, unknown_corner(corner));
    corners_.push_back(position(corner));
  }
  const std::array<Index, 3> as_named{corners_[0], corners_[1], corners_[2]};
  corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
  while (corners_.size() > 1 && corners_.back() == corners_.front()) corners_.pop_back();
  const std::size_t n = corners_.size();
  if (n < 3) {
    surface_.triangles.push_back(as_named);
    return;
  }
  cut_polygon(corners_, surface_.vertices, cut_);
  take_cut(element, fmt::format("with {}", counted(face.size(), "corners")), n);
}

void Cutter::cut_facet_of(const Facet& facet, std::size_t element) {
  facets_.cut(facet, moved_, surface_.vertices, cut_);
  take_cut(element,
           fmt::format("of a facet of {} and {}", counted(facet.polygons, "polygons"),
                       counted(facet.holes.size(), "holes")),
           0);
}

void Cutter::take_cut(std::size_t element, const std::string& what, std::size_t corners) {
  if (!cut_.fault.empty()) fail(element, what + " " + cut_.fault);
  bends_.add(cut_, corners);
  surface_.triangles.insert(surface_.triangles.end(), cut_.triangles.begin(), cut_.triangles.end());
}

// In a .poly or .smesh the direction of facets has no meaning, and they may stand inside. Returns what was
// done.
std::string Cutter::keep_boundary_of_solids() {
  const bool of_boundary =
      std::any_of(document_.blocks.begin(), document_.blocks.end(),
                  [](const ElementBlock& block) { return block.of_boundary && block.count > 0; });
  if (!of_boundary) return {};
  std::optional<SolidBoundary> solids =
      solid_boundary(surface_.vertices, surface_.triangles, document_.holes);
  if (!solids) return {};
  const std::size_t left_out = surface_.triangles.size() - solids->triangles.size();
  if (left_out == 0 && solids->turned == 0) return {};
  surface_.triangles = std::move(solids->triangles);
  numbers_.keep_triangles(solids->from);
  std::string did = "the surface of the solids: ";
  if (left_out > 0)
    did += fmt::format("{} inside of them or of holes left out", counted(left_out, "triangles"));
  if (solids->turned > 0)
    did +=
        fmt::format("{}{} turned outwards", left_out > 0 ? ", " : "", counted(solids->turned, "triangles"));
  return did;
}

}  // namespace

TriangleSurface surface_of_read(ReadDocument&& read, const InputFile& file, SurfaceNumbering& numbering,
                                std::vector<std::string>& warnings) {
  const Places places{file, read.places, read.text};
  std::vector<Eigen::Vector3d> points = std::move(read.document.points);
  Cutter cutter(read.document, std::move(points), read.places.empty() ? nullptr : &places);
  TriangleSurface surface = cutter.take(read.welded, warnings);
  numbering = cutter.numbering();
  return surface;
}

}  // namespace io

TriangleSurface surface_of(const Document& document) {
  std::vector<std::string> warnings;
  return surface_of(document, warnings);
}

TriangleSurface surface_of(const Document& document, std::vector<std::string>& warnings) {
  return io::Cutter(document, document.points, nullptr).take(false, warnings);
}

bool facets_are_surface(const Document& document) {
  if (std::any_of(document.blocks.begin(), document.blocks.end(),
                  [](const ElementBlock& block) { return block.count > 0 && io::dimension(block) == 3; }))
    return false;
  try {
    return io::Cutter(document, document.points, nullptr).is_boundary_of_solids();
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace tetproof
