// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <bit>

#include "io/bytes/byte_order.hpp"
#include "io/bytes/tokens.hpp"
#include "io/ply/ply.hpp"
#include "io/ply/ply_header.hpp"
#include "io/ply/ply_plan.hpp"
#include "io/surface/kept_part.hpp"
#include "io/surface/surface_lines.hpp"
#include "io/surface/titles.hpp"

namespace tetproof::io {
namespace {

char* put_number(char* to, const PlySource& source, std::size_t at, bool binary) {
  if (source.reals) {
    const double value = source.reals[at];
    return binary ? source.type->store(to, value) : put(put(to, value), ' ');
  }
  const std::int64_t value = source.integers[at];
  return binary ? source.type->store(to, static_cast<double>(value)) : put(put(to, value), ' ');
}

char* put_source(char* to, const PlySource& source, std::size_t i, bool binary) {
  if (!source.count) return put_number(to, source, i * source.stride, binary);
  const std::size_t from = source.starts[i], end = source.starts[i + 1];
  to = binary ? source.count->store(to, static_cast<double>(end - from))
              : put(put(to, static_cast<std::int64_t>(end - from)), ' ');
  for (std::size_t at = from; at < end; ++at) to = put_number(to, source, at, binary);
  return to;
}

class Writer {
 public:
  Writer(AtomicFile& file, const Document& document, const PlyPlan& plan, bool binary)
      : file_(file), document_(document), plan_(plan), binary_(binary) {}

  void write() {
    header();
    points();
    faces();
    lines();
    for (const PlyPart& part : plan_.others)
      if (!part.sources.empty()) rows(part, 0, [](std::size_t, char* to) { return to; });
  }

 private:
  void header() {
    std::string text = fmt::format("ply\nformat {} 1.0\n", binary_ ? "binary_little_endian" : "ascii");
    if (title_in_lines(document_.title))
      for (const std::string& line : title_lines(document_.title)) {
        if (!line.starts_with("obj_info ")) text += line.empty() ? "comment" : "comment ";
        text += line;
        text += "\n";
      }
    const auto element = [&](const PlyPart& part) {
      for (const PlySource& source : part.sources)
        text += fmt::format("property {} {}\n", source.type_words, source.name);
    };
    point_type_ = point_type();
    text += fmt::format("element vertex {0}\nproperty {1} x\nproperty {1} y\nproperty {1} z\n",
                        plan_.vertex.rows, point_type_->name);
    element(plan_.vertex);
    for (const KeptElement& face : plan_.faces) corners_ = std::max(corners_, face.corners);
    count_type_ = type_for(std::vector<std::int64_t>{corners_});
    text += fmt::format("element face {}\nproperty list {} int vertex_indices\n", plan_.face.rows,
                        count_type_->name);
    element(plan_.face);
    if (plan_.edge.rows > 0 || !plan_.edge.sources.empty()) {
      text += fmt::format("element edge {}\nproperty int vertex1\nproperty int vertex2\n", plan_.edge.rows);
      element(plan_.edge);
    }
    for (const PlyPart& part : plan_.others) {
      text += fmt::format("element {} {}\n", part.name, part.rows);
      element(part);
    }
    file_.write(text + "end_header\n");
  }

  // Float if every coordinate is exact as a float.
  const PlyType* point_type() const {
    const PlyType* type = document_.points.empty() ? ply_type("double") : ply_type("float");
    for (const Eigen::Vector3d& point : document_.points)
      for (const double x : point)
        if (std::bit_cast<std::uint64_t>(static_cast<double>(static_cast<float>(x))) !=
            std::bit_cast<std::uint64_t>(x))
          return ply_type("double");
    return type;
  }

  // Writes the rows of an element: what `start` puts, at most `longest_start` bytes, then the properties.
  template <class Start>
  void rows(const PlyPart& part, std::size_t longest_start, const Start& start) {
    write_items(file_, part.rows, longest_start + part.longest() + 1, [&](std::size_t i, char* to) {
      to = start(i, to);
      for (const PlySource& source : part.sources) to = put_source(to, source, i, binary_);
      if (!binary_) to[-1] = '\n';  // in place of the last blank
      return to;
    });
  }

  char* put_index(char* to, Index node) const {
    return binary_ ? store(to, node, std::endian::little) : put(put(to, node), ' ');
  }

  void points() {
    rows(plan_.vertex, 3 * (longest_real + 1), [&](std::size_t i, char* to) {
      for (const double x : document_.points[i])
        to = binary_ ? point_type_->store(to, x) : put(put(to, x), ' ');
      return to;
    });
  }

  void faces() {
    rows(plan_.face, 12 * (static_cast<std::size_t>(corners_) + 1), [&](std::size_t i, char* to) {
      const KeptElement& face = plan_.faces[i];
      to = binary_ ? count_type_->store(to, face.corners) : put(put(to, face.corners), ' ');
      for (int k = 0; k < face.corners; ++k) to = put_index(to, face.nodes[k]);
      return to;
    });
  }

  void lines() {
    rows(plan_.edge, 24, [&](std::size_t i, char* to) {
      return put_index(put_index(to, plan_.lines[i].nodes[0]), plan_.lines[i].nodes[1]);
    });
  }

  AtomicFile& file_;
  const Document& document_;
  const PlyPlan& plan_;
  const bool binary_;
  const PlyType *point_type_ = nullptr, *count_type_ = nullptr;
  int corners_ = 0;
};

// The elements in the order of the file.
std::vector<std::size_t> faces_and_lines(const Document& document) {
  std::vector<std::size_t> all = kept_elements(document, [](const KeptElement& e) { return e.corners >= 3; });
  const auto lines = kept_elements(document, [](const KeptElement& e) { return e.corners == 2; });
  all.insert(all.end(), lines.begin(), lines.end());
  return all;
}

class PlyFilePlan : public OneFilePlan {
 public:
  PlyFilePlan(const Document& document, bool binary)
      : OneFilePlan(document),
        part_(document, faces_and_lines, KeptPart::Form::runs),
        plan_(part_.document(), binary),
        binary_(binary) {
    holds_ = part_.holds(ply_holds(part_.document(), plan_));
  }

 private:
  void write_into(AtomicFile& file) override { Writer(file, part_.document(), plan_, binary_).write(); }

  const KeptPart part_;
  const PlyPlan plan_;
  const bool binary_;
};

}  // namespace

std::unique_ptr<FilePlan> plan_ply(const Document& document, bool binary) {
  return std::make_unique<PlyFilePlan>(document, binary);
}

}  // namespace tetproof::io
