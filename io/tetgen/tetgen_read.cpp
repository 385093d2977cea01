// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the files of a set of TetGen's.
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "io/bytes/large_pages.hpp"
#include "io/bytes/scanner.hpp"
#include "io/error.hpp"
#include "io/loss/loss_list.hpp"
#include "io/mesh_files.hpp"
#include "io/model/groups_of_values.hpp"
#include "io/model/read_document.hpp"
#include "io/supplement/supplement.hpp"
#include "io/tetgen/tetgen.hpp"
#include "io/tetgen/tetgen_node_order.hpp"
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
    const std::string supplement =
        supplement_in_comments(InputFile(set_.member(".node")), set_.stem, document_);
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
    make_groups();
    take_back(supplement, set_.member(".node"), document_);
  }

  // As TetGen does with its switch -p. `file` is the .poly or .smesh; standard input has no files beside it.
  void plc(const InputFile& file, std::vector<std::size_t>* places) {
    const bool smesh = set_.ending == ".smesh", named = file.is_named();
    if (smesh && named && file_exists(set_.stem + ".poly"))
      document_.warnings.push_back(
          fmt::format("{}: there is {}.poly too, which TetGen would read instead", set_.path, set_.stem));
    Records in(file, document_);
    const bool points_elsewhere = read_plc(in, named ? set_.stem + ".node" : "", smesh, document_, places);
    NodeIndex index(document_);
    if (const auto edge = named ? open(".edge") : nullptr) {
      const TetgenElementFile header = read_edge_header(edge->in, 4);
      read_elements(edge->in, header, index, document_);
    }
    if (named) fields(points_elsewhere ? set_.stem + ".node" : set_.path, index);
    make_groups();
    if (!places)  // the supplement may move elements
      take_back(supplement_in_comments(file, set_.stem, document_), set_.path, document_);
  }

 private:
  // What TetGen calls attributes and markers are the groups of other tools.
  void make_groups() {
    make_groups_of_values(document_, "attributes");
    make_groups_of_values(document_, "markers");
  }

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

Document start_document(const TetgenPath& set) {
  Document document;
  document.format = "tetgen";
  document.path = set.path;
  return document;
}

ReadDocument read_plc_set(const InputFile& file, const char* ending, Wanted wanted) {
  TetgenPath set = file.is_named() ? tetgen_path(file.path()) : TetgenPath{file.path(), file.path(), ""};
  set.ending = ending;  // whatever the file is called
  ReadDocument read{start_document(set)};
  SetReader(set, read.document).plc(file, wanted == Wanted::surface ? &read.places : nullptr);
  return read;
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

ReadDocument read_tetgen(const InputFile& file, Wanted) {
  if (!file.is_named())
    throw InputError(fmt::format(
        "{0}: TetGen's mesh is several files, of which {0} can be only one; name the .node or .ele",
        file.path()));
  const TetgenPath set = tetgen_path(file.path());
  if (set.ending == ".cell") throw InputError(fmt::format("{}: expected .v.cell, found .cell", file.path()));
  const std::vector<std::string>& endings = format_named("tetgen").endings;
  if (std::find(endings.begin(), endings.end(), ending_of(file.path())) == endings.end())
    throw InputError(fmt::format("{}: TetGen's files are known by their endings, expected one of {}",
                                 file.path(), fmt::join(endings, " ")));
  ReadDocument read{start_document(set)};
  SetReader(set, read.document).mesh();
  return read;
}

ReadDocument read_poly(const InputFile& file, Wanted wanted) {
  return read_plc_set(file, ".poly", wanted);
}

ReadDocument read_smesh(const InputFile& file, Wanted wanted) {
  return read_plc_set(file, ".smesh", wanted);
}

}  // namespace tetproof::io
