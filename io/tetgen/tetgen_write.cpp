// SPDX-License-Identifier: GPL-3.0-or-later
// Writes TetGen's files of a mesh.
#include <fmt/format.h>

#include <algorithm>

#include "io/error.hpp"
#include "io/model/node_order.hpp"
#include "io/supplement/supplement.hpp"
#include "io/tetgen/tetgen.hpp"
#include "io/tetgen/tetgen_files.hpp"
#include "io/tetgen/tetgen_write_parts.hpp"

namespace tetproof::io {
namespace {

// Writes the lines of an .ele, .face or .edge: number, nodes, tags, values.
void write_elements(AtomicFile& file, const Document& document, const TetgenPlan& plan,
                    const TetgenList& list, const TetgenTags& tags, const Values* behind = nullptr) {
  const auto each = static_cast<std::size_t>(list.nodes_each);
  const std::size_t longest = (2 + each + columns(tags) + columns(behind)) * (longest_real + 1) + 1;
  // TetGen has an order of its own for the nodes of tetrahedra of second order, and only for these.
  const std::span<const int> order =
      each == 10 ? node_order(tetrahedron10, NodeOrder::tetgen) : std::span<const int>{};
  std::size_t written = 0;
  for (const ElementBlock* block : list.blocks) {
    write_items(file, block->count, longest, [&](std::size_t i, char* to) {
      to = put(to, plan.base + static_cast<std::int64_t>(written + i));
      const Index* node =
          document.connectivity.data() + block->nodes + i * static_cast<std::size_t>(block->nodes_each);
      for (std::size_t k = 0; k < each; ++k)
        to = put(put(to, ' '),
                 plan.number(document, node[order.empty() ? k : static_cast<std::size_t>(order[k])]));
      to = put_tags(to, tags, document, *block, i, written + i);
      return put(put_values(to, behind, written + i), '\n');
    });
    written += block->count;
  }
}

// Writes lines of a number and values.
void write_values(AtomicFile& file, const TetgenPlan& plan, std::size_t count, const Values& values) {
  write_items(file, count, (1 + columns(&values)) * (longest_real + 1) + 1, [&](std::size_t i, char* to) {
    return put(put_values(put(to, plan.base + static_cast<std::int64_t>(i)), &values, i), '\n');
  });
}

// Which files a mesh is written to. `named`: the one that the writer was asked for.
std::vector<std::string> endings_of(const TetgenPlan& plan, const std::string& named) {
  std::vector<std::string> endings{".node", ".ele"};
  if (plan.faces.count > 0 || named == ".face") endings.push_back(".face");
  if (plan.edges.count > 0 || named == ".edge") endings.push_back(".edge");
  if (plan.neighbours) endings.push_back(".neigh");
  if (plan.tet_faces) endings.push_back(".t2f");
  if (plan.tet_edges) endings.push_back(".t2e");
  if (plan.face_edges) endings.push_back(".f2e");
  if (plan.volume_bounds) endings.push_back(".vol");
  if (plan.sizes) endings.push_back(".mtr");
  if (plan.bounds) endings.push_back(".var");
  if (plan.voronoi) endings.insert(endings.end(), {".v.node", ".v.edge", ".v.face", ".v.cell"});
  return endings;
}

bool is_among(const std::vector<std::string>& endings, const std::string& ending) {
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

}  // namespace

AtomicFile& TetgenFiles::add(const std::string& ending) {
  const std::string path = set_.member(ending);
  endings_.push_back(path.substr(set_.stem.size()));
  AtomicFile& file = files_.emplace_back(path);
  if (!supplement_.empty()) file.keep_checksum();
  return file;
}

void TetgenFiles::commit() {
  if (!supplement_.empty()) {
    std::vector<Checksum> checksums;
    for (std::size_t i = 0; i < files_.size(); ++i)
      checksums.push_back({i == 0 ? "" : endings_[i], files_[i].checksum()});
    files_.front().write(as_comments(supplement_head(checksums) + supplement_));
  }
  for (AtomicFile& file : files_) file.commit();
}

TetgenPath tetgen_path_to_write(const std::string& path, const std::string& format) {
  const TetgenPath set = tetgen_path(path);
  if (format != "tetgen")
    return set.ending == "." + format ? set : TetgenPath{path + "." + format, path, "." + format};
  static const std::vector<std::string> known{".node", ".ele",    ".face",   ".edge",   ".neigh",
                                              ".t2f",  ".t2e",    ".f2e",    ".vol",    ".mtr",
                                              ".var",  ".v.node", ".v.edge", ".v.face", ".v.cell"};
  return is_among(known, set.ending) ? set : TetgenPath{path, path, ""};
}

void write_tetgen_nodes(AtomicFile& file, const Document& document, const TetgenPlan& plan) {
  file.write(
      fmt::format("{} 3 {} {}\n", document.points.size(), columns(plan.attributes), columns(plan.markers)));
  const std::size_t longest = (4 + columns(plan.attributes) + columns(plan.markers)) * (longest_real + 1) + 1;
  write_items(file, document.points.size(), longest, [&](std::size_t i, char* to) {
    to = put(to, plan.base + static_cast<std::int64_t>(i));
    for (double x : document.points[i]) to = put(put(to, ' '), x);
    return put(put_values(put_values(to, plan.attributes, i), plan.markers, i), '\n');
  });
}

void write_tetgen_edges(AtomicFile& file, const Document& document, const TetgenPlan& plan) {
  file.write(fmt::format("{} {}\n", plan.edges.count, columns(plan.edge_tags)));
  write_elements(file, document, plan, plan.edges, plan.edge_tags, plan.edge_tets);
}

void write_tetgen_fields(TetgenFiles& files, const Document& document, const TetgenPlan& plan) {
  if (plan.sizes) {
    AtomicFile& file = files.add(".mtr");
    file.write(fmt::format("{} {}\n", document.points.size(), columns(plan.sizes)));
    const std::size_t each = columns(plan.sizes);
    write_items(file, document.points.size(), each * (longest_real + 1), [&](std::size_t i, char* to) {
      for (std::size_t k = 0; k < each; ++k)
        to = put(put(to, plan.sizes->reals[i * each + k]), k + 1 < each ? ' ' : '\n');
      return to;
    });
  }
  if (!plan.bounds) return;
  AtomicFile& file = files.add(".var");
  file.write(fmt::format("{}\n", document.area_bounds.size()));
  write_items(file, document.area_bounds.size(), 3 * (longest_real + 1), [&](std::size_t i, char* to) {
    const AreaBound& bound = document.area_bounds[i];
    to = put(put(to, plan.base + static_cast<std::int64_t>(i)), ' ');
    return put(put(put(put(to, bound.marker), ' '), bound.area), '\n');
  });
  file.write(fmt::format("{}\n", document.length_bounds.size()));
  write_items(file, document.length_bounds.size(), 4 * (longest_real + 1), [&](std::size_t i, char* to) {
    const LengthBound& bound = document.length_bounds[i];
    to = put(to, plan.base + static_cast<std::int64_t>(i));
    for (const Index node : bound.nodes) to = put(put(to, ' '), plan.number(document, node));
    return put(put(put(to, ' '), bound.length), '\n');
  });
}

std::string tetgen_left_over(const TetgenPath& set, const std::vector<std::string>& written,
                             const std::vector<std::string>& read) {
  std::vector<std::string> left;
  for (const std::string& ending : read)
    if (!is_among(written, ending) && file_exists(set.member(ending))) left.push_back(set.member(ending));
  if (left.empty()) return {};
  return fmt::format("{}: {} not written, but will be read together with it", fmt::join(left, ", "),
                     left.size() == 1 ? "is there already and is" : "are there already and are");
}

namespace {

void write_mesh(const std::string& path, const Document& document, const TetgenPlan& plan,
                const std::string& supplement) {
  const TetgenPath set = tetgen_path_to_write(path, "tetgen");
  const std::vector<std::string> endings = endings_of(plan, set.ending);
  if (!set.ending.empty() && !is_among(endings, set.ending))
    throw InputError(fmt::format("{}: cannot write it: there is nothing in {} to stand in it", path,
                                 document.path.empty() ? "the mesh" : document.path));
  TetgenFiles files(set, supplement);
  write_tetgen_nodes(files.add(".node"), document, plan);
  AtomicFile& ele = files.add(".ele");
  ele.write(fmt::format("{} {} {}\n", plan.tets.count, plan.tets.nodes_each, columns(plan.tet_tags)));
  write_elements(ele, document, plan, plan.tets, plan.tet_tags);
  if (is_among(endings, ".face")) {
    AtomicFile& file = files.add(".face");
    file.write(fmt::format("{} {}\n", plan.faces.count, columns(plan.face_tags)));
    write_elements(file, document, plan, plan.faces, plan.face_tags, plan.face_tets);
  }
  if (is_among(endings, ".edge")) write_tetgen_edges(files.add(".edge"), document, plan);
  if (plan.neighbours) {
    AtomicFile& file = files.add(".neigh");
    file.write(fmt::format("{} 4\n", plan.tets.count));
    write_values(file, plan, plan.tets.count, *plan.neighbours);
  }
  if (plan.tet_faces) write_values(files.add(".t2f"), plan, plan.tets.count, *plan.tet_faces);
  if (plan.tet_edges) write_values(files.add(".t2e"), plan, plan.tets.count, *plan.tet_edges);
  if (plan.face_edges) write_values(files.add(".f2e"), plan, plan.faces.count, *plan.face_edges);
  if (plan.volume_bounds) {
    AtomicFile& file = files.add(".vol");
    file.write(fmt::format("{}\n", plan.tets.count));
    write_values(file, plan, plan.tets.count, *plan.volume_bounds);
  }
  write_tetgen_fields(files, document, plan);
  if (plan.voronoi) write_tetgen_voronoi(files, document.voronoi);
  files.commit();
}

class MeshFilePlan : public FilePlan {
 public:
  explicit MeshFilePlan(const Document& document) : FilePlan(document), plan_(tetgen_mesh_plan(document)) {
    holds_ = tetgen_mesh_holds(document, plan_);
  }
  std::vector<std::string> files(const std::string& path) override {
    const TetgenPath set = tetgen_path_to_write(path, "tetgen");
    return set.members(endings_of(plan_, set.ending));
  }
  std::string warning(const std::string& path) override {
    const TetgenPath set = tetgen_path_to_write(path, "tetgen");
    return tetgen_left_over(
        set, endings_of(plan_, set.ending),
        {".face", ".edge", ".neigh", ".t2f", ".t2e", ".f2e", ".vol", ".mtr", ".var", ".v.cell"});
  }
  void write(const std::string& path, const std::string& supplement) override {
    write_mesh(path, document_, plan_, supplement);
  }

 private:
  const TetgenPlan plan_;
};

}  // namespace

std::unique_ptr<FilePlan> plan_tetgen(const Document& document, bool) {
  return std::make_unique<MeshFilePlan>(document);
}

std::vector<std::string> tetgen_files_always_written(const std::string& path, const std::string& format) {
  const TetgenPath set = tetgen_path_to_write(path, format);
  std::vector<std::string> files;
  if (!set.ending.empty()) files.push_back(set.path);
  if (!set.is_plc())
    for (const char* ending : {".node", ".ele"})
      if (ending != set.ending) files.push_back(set.member(ending));
  return files;
}

}  // namespace tetproof::io
