// SPDX-License-Identifier: GPL-3.0-or-later
// Writes TetGen's .poly and .smesh.
#include <fmt/format.h>

#include "io/bytes/words.hpp"
#include "io/error.hpp"
#include "io/tetgen/tetgen.hpp"
#include "io/tetgen/tetgen_write_parts.hpp"

namespace tetproof::io {
namespace {

// TetGen cuts lines at 2047 bytes, and accepts polygons that continue in the next line.
constexpr std::size_t corners_a_line = 64;

class PlcWriter {
 public:
  PlcWriter(AtomicFile& file, const Document& document, const TetgenPlan& plan, bool smesh)
      : file_(file), document_(document), plan_(plan), smesh_(smesh) {}

  void write() {
    write_tetgen_nodes(file_, document_, plan_);
    std::size_t count = plan_.polygons.count;
    for (const std::size_t f : plan_.facets) count -= document_.facets[f].polygons - 1;
    file_.write(fmt::format("{} {}\n", count, columns(plan_.facet_tags)));
    // Runs of polygons each of which is a facet, and between them facets of several polygons.
    std::size_t next = 0;
    for (const std::size_t f : plan_.facets) {
      const Facet& facet = document_.facets[f];
      const std::size_t first = facet.first - plan_.polygons.blocks[0]->first;
      facets_of_one(next, first);
      next = first + facet.polygons;
      file_.write(fmt::format("{} {}", facet.polygons, facet.holes.size()));
      each_block(first, first + 1,
                 [&](const ElementBlock& block, std::size_t from, std::size_t, std::size_t) {
                   write_items(file_, 1, longest_integer + 2, [&](std::size_t, char* to) {
                     return put(put_tags(to, plan_.facet_tags, document_, block, from, first), '\n');
                   });
                 });
      each_block(first, next, [&](const ElementBlock& block, std::size_t from, std::size_t to, std::size_t) {
        polygons(block, from, to, false, 0);
      });
      points(facet.holes);
    }
    facets_of_one(next, plan_.polygons.count);
    file_.write(fmt::format("{}\n", document_.holes.size()));
    points(document_.holes);
    file_.write(fmt::format("{}\n", document_.regions.size()));
    for (std::size_t i = 0; i < document_.regions.size(); ++i) {
      const Region& region = document_.regions[i];
      write_items(file_, 1, 6 * (longest_real + 1), [&](std::size_t, char* to) {
        to = put(to, plan_.base + static_cast<std::int64_t>(i));
        for (double x : region.point) to = put(put(to, ' '), x);
        return put(put(put(put(put(to, ' '), region.attribute), ' '), region.max_volume), '\n');
      });
    }
  }

 private:
  void facets_of_one(std::size_t from, std::size_t to) {
    each_block(from, to,
               [&](const ElementBlock& block, std::size_t first, std::size_t last, std::size_t position) {
                 polygons(block, first, last, true, position);
               });
  }

  // Calls `work` for each part of a block that has some of the polygons `from` to `to`.
  template <class Work>
  void each_block(std::size_t from, std::size_t to, const Work& work) {
    for (; from < to;) {
      while (from >= block_starts_ + plan_.polygons.blocks[block_]->count)
        block_starts_ += plan_.polygons.blocks[block_++]->count;
      const ElementBlock& block = *plan_.polygons.blocks[block_];
      const std::size_t end = std::min(to, block_starts_ + block.count);
      work(block, from - block_starts_, end - block_starts_, from);
      from = end;
    }
  }

  // `whole_facets`: each polygon is a facet, and the first is the polygon at `position` among all.
  void polygons(const ElementBlock& block, std::size_t from, std::size_t to, bool whole_facets,
                std::size_t position) {
    const ElementType* type = element_type(block.type);
    const auto corners = static_cast<std::size_t>(type ? type->corners : block.nodes_each);
    const auto put_marker = [&](char* at, std::size_t i) {
      return whole_facets ? put_tags(at, plan_.facet_tags, document_, block, from + i, position + i) : at;
    };
    const std::size_t longest = 8 + (corners + 4) * (longest_integer + 1) + corners / corners_a_line + 2;
    write_items(file_, to - from, longest, [&](std::size_t i, char* at) {
      if (whole_facets && !smesh_) {
        at = put(put(at, '1'), ' ');
        at = put(put_marker(put(at, '0'), i), '\n');
      }
      at = put(at, static_cast<std::int64_t>(corners));
      const Index* node = document_.connectivity.data() + block.nodes +
                          (from + i) * static_cast<std::size_t>(block.nodes_each);
      for (std::size_t k = 0; k < corners; ++k)
        at = put(put(at, k > 0 && k % corners_a_line == 0 ? '\n' : ' '), plan_.number(document_, node[k]));
      return put(smesh_ ? put_marker(at, i) : at, '\n');
    });
  }

  void points(const std::vector<Eigen::Vector3d>& points) {
    write_items(file_, points.size(), 4 * (longest_real + 1), [&](std::size_t i, char* to) {
      to = put(to, plan_.base + static_cast<std::int64_t>(i));
      for (double x : points[i]) to = put(put(to, ' '), x);
      return put(to, '\n');
    });
  }

  AtomicFile& file_;
  const Document& document_;
  const TetgenPlan& plan_;
  const bool smesh_;
  std::size_t block_ = 0, block_starts_ = 0;  // the block that the next polygon is in
};

void write_plc(const TetgenPath& set, const Document& document, const TetgenPlan& plan,
               const std::string& supplement) {
  TetgenFiles files(set, supplement);
  PlcWriter(files.add(set.ending), document, plan, set.ending == ".smesh").write();
  if (document.points.empty())
    write_tetgen_nodes(files.add(".node"), document, plan);  // TetGen then looks for them there
  if (plan.edges.count > 0) write_tetgen_edges(files.add(".edge"), document, plan);
  write_tetgen_fields(files, document, plan);
  files.commit();
}

class PlcFilePlan : public FilePlan {
 public:
  PlcFilePlan(const Document& document, const char* format)
      : FilePlan(document), format_(format), plan_(tetgen_plc_plan(document)) {
    holds_ = tetgen_plc_holds(document, plan_, format_ == "smesh");
  }
  std::vector<std::string> files(const std::string& path) override {
    const TetgenPath set = tetgen_path_to_write(path, format_);
    std::vector<std::string> endings = further_endings();
    endings.insert(endings.begin(), set.ending);
    if (document_.points.empty()) endings.push_back(".node");  // a reader then looks for the points there
    return set.members(endings);
  }
  std::string warning(const std::string& path) override {
    const TetgenPath set = tetgen_path_to_write(path, format_);
    std::vector<std::string> read{".edge", ".mtr", ".var"};
    if (set.ending == ".smesh") read.push_back(".poly");
    return tetgen_left_over(set, further_endings(), read);
  }
  void write(const std::string& path, const std::string& supplement) override {
    if (format_ == "smesh" && !plan_.facets.empty()) {
      const Facet& facet = document_.facets[plan_.facets[0]];
      throw InputError(fmt::format(
          "{}: cannot write it: a facet of {} and {} (element {}) has no place in a .smesh; write a .poly",
          path, counted(facet.polygons, "polygons"), counted(facet.holes.size(), "holes"),
          document_.element_tag(facet.first)));
    }
    write_plc(tetgen_path_to_write(path, format_), document_, plan_, supplement);
  }

 private:
  std::vector<std::string> further_endings() const {
    std::vector<std::string> endings;
    if (plan_.edges.count > 0) endings.push_back(".edge");
    if (plan_.sizes) endings.push_back(".mtr");
    if (plan_.bounds) endings.push_back(".var");
    return endings;
  }

  const std::string format_;  // "poly" or "smesh"
  const TetgenPlan plan_;
};

}  // namespace

std::unique_ptr<FilePlan> plan_poly(const Document& document, bool) {
  return std::make_unique<PlcFilePlan>(document, "poly");
}

std::unique_ptr<FilePlan> plan_smesh(const Document& document, bool) {
  return std::make_unique<PlcFilePlan>(document, "smesh");
}

}  // namespace tetproof::io
