// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the files of a set of TetGen's.
#include <fmt/format.h>
#include <sys/stat.h>

#include <memory>
#include <optional>

#include "io/bytes/large_pages.hpp"
#include "io/error.hpp"
#include "io/loss/loss_list.hpp"
#include "io/supplement/supplement.hpp"
#include "io/surface/polygons.hpp"
#include "io/tetgen/tetgen.hpp"
#include "io/tetgen/tetgen_order.hpp"
#include "io/tetgen/tetgen_read_parts.hpp"
#include "io/tetgen/tetgen_set.hpp"

namespace tetproof::io {
namespace {

// A file of the set that exists, with its records.
struct Member {
  InputFile file;
  Records in;
  Member(const std::string& path, Document& document) : file(path), in(file, document) {}
};

class SetReader {
 public:
  SetReader(const TetgenPath& set, Document& document) : set_(set), document_(document) {}

  void mesh() {
    const bool voronoi = file_exists(set_.stem + ".v.cell") || set_.ending.starts_with(".v.");
    const auto ele = open(".ele"), face = open(".face"), edge = open(".edge");
    if (!ele && !face && !edge)
      document_.warnings.push_back(
          fmt::format("{}.node: there is no {}.ele beside it: nodes only", set_.stem, set_.stem));
    const std::string supplement = supplement_in_comments(set_.member(".node"), set_.stem, document_);
    read_node_file(set_.member(".node"), document_);
    NodeIndex index(document_);
    elements(ele.get(), face.get(), edge.get(), !has_no_element_values(supplement), index);

    integers(".neigh", tets_, ".ele", "tetrahedra", "neighbours", 4, true);
    integers(".t2f", tets_, ".ele", "tetrahedra", "faces", 4, false);
    integers(".t2e", tets_, ".ele", "tetrahedra", "edges", 6, false);
    integers(".f2e", faces_, ".face", "faces", "edges", 3, false);
    if (const auto vol = open(".vol"); vol && has(tets_, ".vol", ".ele"))
      read_volume_bounds(vol->in, tets_, document_);
    fields(set_.member(".node"), index);
    if (voronoi) read_voronoi(set_.stem, document_);
    take_back(supplement, set_.member(".node"), document_);
  }

  // Reads what TetGen reads with its switch -p.
  void plc(std::vector<std::size_t>* places) {
    const bool smesh = set_.ending == ".smesh";
    if (smesh && file_exists(set_.stem + ".poly"))
      document_.warnings.push_back(
          fmt::format("{}: there is {}.poly too, which TetGen would read instead", set_.path, set_.stem));
    const auto named = open(set_.ending);
    const bool points_elsewhere = read_plc(named->in, set_.stem + ".node", smesh, document_, places);
    NodeIndex index(document_);
    if (const auto edge = open(".edge")) {
      const TetgenElementFile file = read_edge_header(edge->in, 4);
      read_elements(edge->in, file, index, document_);
    }
    fields(points_elsewhere ? set_.stem + ".node" : set_.path, index);
    if (!places)  // a supplement may move elements
      take_back(supplement_in_comments(set_.path, set_.stem, document_), set_.path, document_);
  }

 private:
  std::unique_ptr<Member> open(const std::string& ending) const {
    const std::string path = set_.member(ending);
    if (ending != set_.ending && !file_exists(path)) return nullptr;
    return std::make_unique<Member>(path, document_);
  }

  // Reads all headers first: they say how much room is needed.
  void elements(Member* ele, Member* face, Member* edge, bool with_values, NodeIndex& index) {
    std::optional<TetgenElementFile> ele_file, face_file, edge_file;
    if (ele) ele_file = read_ele_header(ele->in);
    if (face) face_file = read_face_header(face->in, ele_file ? ele_file->nodes_each : 0);
    const bool second_order = ele_file ? ele_file->nodes_each == 10 : face_file && face_file->nodes_each == 6;
    if (edge) edge_file = read_edge_header(edge->in, second_order ? 10 : 4);
    std::size_t room = 0;
    for (const auto& file : {ele_file, face_file, edge_file})
      if (file) room += file->count * static_cast<std::size_t>(file->nodes_each);
    reserve_in_large_pages(document_.connectivity, room);

    for (auto* file : {&ele_file, &face_file, &edge_file})
      if (*file) (*file)->with_values = with_values;

    document_.first_element = document_.first_node;
    if (ele) tets_ = read_elements(ele->in, *ele_file, index, document_);
    order_tetrahedra_nodes(tets_, document_);
    if (face) faces_ = read_elements(face->in, *face_file, index, document_);
    order_face_nodes(faces_, tets_, document_);
    if (edge) read_elements(edge->in, *edge_file, index, document_);
  }

  void integers(const char* ending, const TetgenElements& of, const char* needed, const char* many,
                const char* name, int each, bool has_header) {
    if (const auto member = open(ending); member && has(of, ending, needed))
      read_element_integers(member->in, of, many, name, each, has_header, document_);
  }

  // Whether the file exists whose elements another one describes.
  bool has(const TetgenElements& of, const std::string& ending, const char* needed) const {
    if (of.nodes_each > 0) return true;
    const std::string message = fmt::format("{}: there is no {}{} beside it, without which it means nothing",
                                            set_.member(ending), set_.stem, needed);
    if (ending == set_.ending) throw InputError(message);
    document_.warnings.push_back(message);
    add_loss(document_.dropped, "files of the set that are not read", 1, set_.member(ending));
    return false;
  }

  void fields(const std::string& node_path, NodeIndex& index) {
    if (const auto mtr = open(".mtr")) read_sizes(mtr->in, node_path, document_);
    if (const auto var = open(".var")) read_bounds(var->in, index, document_);
  }

  const TetgenPath& set_;
  Document& document_;
  TetgenElements tets_, faces_;
};

Document read_set(const TetgenPath& set, std::vector<std::size_t>* places) {
  Document document;
  document.format = "tetgen";
  document.path = set.path;
  SetReader reader(set, document);
  if (set.is_plc())
    reader.plc(places);
  else
    reader.mesh();
  return document;
}

}  // namespace

TetgenPath tetgen_path(const std::string& path) {
  const std::size_t dot = path.find_last_of("./");
  TetgenPath set{path, path, ""};
  if (dot == std::string::npos || path[dot] != '.') return set;
  set.stem = path.substr(0, dot);
  set.ending = path.substr(dot);
  for (char& c : set.ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  const bool of_voronoi =
      set.ending == ".cell" || ((set.ending == ".node" || set.ending == ".edge" || set.ending == ".face") &&
                                file_exists(set.stem + ".cell"));
  if (of_voronoi && set.stem.ends_with(".v")) {
    set.stem.resize(set.stem.size() - 2);
    set.ending = ".v" + set.ending;
  }
  return set;
}

bool file_exists(const std::string& path) {
  struct stat about {};
  return ::stat(path.c_str(), &about) == 0 && !S_ISDIR(about.st_mode);
}

Document read_tetgen(const std::string& path) {
  const TetgenPath set = tetgen_path(path);
  if (set.ending == ".cell") throw InputError(fmt::format("{}: expected .v.cell, found .cell", path));
  return read_set(set, nullptr);
}

TriangleSurface read_tetgen_surface(const std::string& path) {
  std::vector<std::size_t> places;
  Document document = read_set(tetgen_path(path), &places);
  const InputFile file(path);
  const auto fail = [&](std::size_t element, const std::string& message) {
    Scanner(file.path(), file.bytes(), places[element]).fail_in_line(message);
  };
  if (!document.facets.empty()) {
    const Facet& facet = document.facets[0];
    fail(facet.first,
         fmt::format("expected facets of one polygon without holes, found one of {} polygons and "
                     "{} holes; cut it into triangles",
                     facet.polygons, facet.holes.size()));
  }
  for (const ElementBlock& block : document.blocks)
    if (block.of_boundary && block.dim < 2)
      fail(block.first, fmt::format("face has {} corners, expected at least 3", block.nodes_each));
  return surface_of_faces(file, {std::move(document), std::move(places)});
}

}  // namespace tetproof::io
