// SPDX-License-Identifier: GPL-3.0-or-later
// Writes OBJ: points, then values of corners, then elements, each after the statements that apply to it.
#include <fmt/core.h>

#include <array>
#include <bit>
#include <unordered_map>

#include "io/bytes/tokens.hpp"
#include "io/obj/obj.hpp"
#include "io/obj/obj_plan.hpp"
#include "io/surface/kept_part.hpp"
#include "io/surface/surface_lines.hpp"
#include "io/surface/titles.hpp"

namespace tetproof::io {
namespace {

// Values of corners as OBJ lists them: each row is written once, and every corner names the number of its
// row.
struct CornerRows {
  const Values* values = nullptr;
  std::vector<std::size_t> rows;        // the first item with these numbers
  std::vector<Index> row_of;            // by item; from 0
  std::vector<std::size_t> first_item;  // by element; npos: none
  static constexpr std::size_t npos = static_cast<std::size_t>(-1);

  CornerRows(const Values* of, std::size_t elements) : values(of) {
    if (!values) return;
    const Values& given = *values;
    first_item.assign(elements, npos);
    std::size_t item = 0;
    for (std::size_t i = 0; i < given.nodes.size(); ++i) {
      first_item[given.at.empty() ? i : static_cast<std::size_t>(given.at[i])] = item;
      item += static_cast<std::size_t>(given.nodes[i]);
    }
    using Bits = std::array<std::uint64_t, 3>;
    struct Hash {
      std::size_t operator()(const Bits& bits) const {
        std::uint64_t h = 0;
        for (const std::uint64_t b : bits) h = (h ^ b ^ (h >> 32)) * 0xd6e8feb86659fd93u;
        return h ^ (h >> 32);
      }
    };
    std::unordered_map<Bits, Index, Hash> known;
    const auto each = static_cast<std::size_t>(given.components);
    row_of.reserve(item);
    for (std::size_t i = 0; i < item; ++i) {
      Bits bits{};
      for (std::size_t k = 0; k < each; ++k)
        bits[k] = std::bit_cast<std::uint64_t>(given.reals[i * each + k]);
      const auto [place, is_new] = known.try_emplace(bits, static_cast<Index>(rows.size()));
      if (is_new) rows.push_back(i);
      row_of.push_back(place->second);
    }
  }
};

class Writer {
 public:
  Writer(AtomicFile& file, const Document& document, const ObjPlan& plan)
      : file_(file),
        document_(document),
        plan_(plan),
        texture_(plan.texture, document.elements()),
        normal_(plan.normal, document.elements()) {}

  void write() {
    write_title(file_, "#", title_in_lines(document_.title) ? document_.title : "");
    for (const Table& table : document_.tables)
      if (is_libraries(table))
        for (const std::string& name : table.columns[0].texts)
          file_.write(fmt::format("mtllib {}\n", encode_name(name)));
    write_points();
    write_rows("vt", texture_);
    write_rows("vn", normal_);
    for (const auto& [word, number] : plan_.words.numbered())
      file_.write(fmt::format("{}{} {}\n", group_comment, number, word));
    write_elements();
  }

 private:
  void write_points() {
    write_items(file_, document_.points.size(), 2 + 7 * (longest_real + 1), [&](std::size_t i, char* to) {
      to = put_point(put(to, "v "), document_.points[i]);
      std::size_t row = 0;
      if (const Values* values = plan_.behind.find(i, row))
        for (int k = 0; k < values->components; ++k)
          to = put(put(to, ' '), values->reals[row * static_cast<std::size_t>(values->components) +
                                               static_cast<std::size_t>(k)]);
      return put(to, '\n');
    });
  }

  void write_rows(std::string_view statement, const CornerRows& corners) {
    write_items(file_, corners.rows.size(), 4 + 3 * (longest_real + 1), [&](std::size_t i, char* to) {
      to = put(to, statement);
      const auto each = static_cast<std::size_t>(corners.values->components);
      for (std::size_t k = 0; k < each; ++k)
        to = put(put(to, ' '), corners.values->reals[corners.rows[i] * each + k]);
      return put(to, '\n');
    });
  }

  // Writes the statements that apply from this element on and did not apply before.
  void say_state(const ElementBlock& block, std::size_t element) {
    const auto label = [&](const Values* values, const char* statement, std::int64_t& now) {
      if (!values || values->integers[element] == now) return;
      const std::int64_t before = now;
      now = values->integers[element];
      const std::string& name = values->labels[static_cast<std::size_t>(now)];
      if (before < 0 && name.empty() && values->labels.size() > 1) return;  // the same as no statement
      file_.write(fmt::format("{}{}{}\n", statement, name.empty() ? "" : " ", encode_name(name, true)));
    };
    label(plan_.object, "o", object_);
    const std::pair<int, std::int32_t> groups{block.dim, block.groups};
    if (groups != groups_ && (block.groups != 0 || groups_.second != 0)) {
      std::string line = "g";
      for (const std::int64_t group : document_.tag_sets[static_cast<std::size_t>(block.groups)])
        line.append(" ").append(plan_.words.word(block.dim, group));
      file_.write(line + "\n");
    }
    groups_ = groups;
    label(plan_.material, "usemtl", material_);
    if (plan_.smoothing && plan_.smoothing->integers[element] != smoothing_) {
      smoothing_ = plan_.smoothing->integers[element];
      file_.write(smoothing_ == 0 ? "s off\n" : fmt::format("s {}\n", smoothing_));
    }
  }

  bool same_state(std::size_t a, std::size_t b) const {
    for (const Values* values : {plan_.object, plan_.material, plan_.smoothing})
      if (values && values->integers[a] != values->integers[b]) return false;
    return true;
  }

  void write_elements() {
    std::vector<KeptElement> run;
    for (const ElementBlock& block : document_.blocks) {
      const int corners = corners_kept(block);
      if (corners == 0) continue;
      for (std::size_t e = 0; e < block.count;) {
        const std::size_t first = block.first + e;
        run.clear();
        for (; e < block.count && same_state(first, block.first + e); ++e) {
          const Index* node =
              document_.connectivity.data() + block.nodes + e * static_cast<std::size_t>(block.nodes_each);
          if (nodes_exist(node, block.nodes_each)) run.push_back({block.first + e, corners, node});
        }
        if (run.empty()) continue;
        say_state(block, first);
        write_run(run, block.dim < 2);
      }
    }
  }

  void write_run(const std::vector<KeptElement>& run, bool thin) {
    const int corners = run[0].corners;
    const std::string_view statement = corners == 1 ? "p" : corners == 2 || thin ? "l" : "f";
    write_items(file_, run.size(), 3 + static_cast<std::size_t>(corners) * 36, [&](std::size_t i, char* to) {
      to = put(to, statement);
      const auto row = [&](const CornerRows& rows, int k) -> std::int64_t {
        const std::size_t first = rows.values ? rows.first_item[run[i].element] : CornerRows::npos;
        return first == CornerRows::npos ? 0
                                         : 1 + std::int64_t{rows.row_of[first + static_cast<std::size_t>(k)]};
      };
      for (int k = 0; k < corners; ++k) {
        to = put(put(to, ' '), std::int64_t{run[i].nodes[k]} + 1);
        const std::int64_t t = row(texture_, k), n = row(normal_, k);
        if (t > 0 || n > 0) to = put(to, '/');
        if (t > 0) to = put(to, t);
        if (n > 0) to = put(put(to, '/'), n);
      }
      return put(to, '\n');
    });
  }

  AtomicFile& file_;
  const Document& document_;
  const ObjPlan& plan_;
  const CornerRows texture_, normal_;
  std::int64_t object_ = -1, material_ = -1, smoothing_ = 0;
  std::pair<int, std::int32_t> groups_{2, 0};
};

std::vector<std::size_t> elements_written(const Document& document) {
  return kept_elements(document, [](const KeptElement&) { return true; });
}

class ObjFilePlan : public OneFilePlan {
 public:
  explicit ObjFilePlan(const Document& document)
      : OneFilePlan(document),
        part_(document, elements_written, KeptPart::Form::lists),
        plan_(part_.document()) {
    holds_ = part_.holds(obj_holds(part_.document(), plan_));
  }

 private:
  void write_into(AtomicFile& file) override { Writer(file, part_.document(), plan_).write(); }

  const KeptPart part_;
  const ObjPlan plan_;
};

}  // namespace

std::unique_ptr<FilePlan> plan_obj(const Document& document, bool) {
  return std::make_unique<ObjFilePlan>(document);
}

}  // namespace tetproof::io
