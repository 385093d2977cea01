// SPDX-License-Identifier: GPL-3.0-or-later
// The first pass over an OBJ file.
#include "io/obj/obj_points.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "io/bytes/scanner.hpp"
#include "io/obj/obj_statements.hpp"

namespace tetproof::io {
namespace {

class PointsReader {
 public:
  PointsReader(const InputFile& file, Wanted wanted, GroupNumbers& names)
      : scanner_(file), surface_(wanted == Wanted::surface), names_(names) {
    found_.first_element = file.bytes().size();
  }

  ObjPoints read() {
    while (!scanner_.at_end('#')) {
      const std::size_t place = scanner_.offset();
      statement(next_field(scanner_), place);
    }
    return std::move(found_);
  }

 private:
  void statement(std::string_view word, std::size_t place) {
    if (word == "v") {
      point();
    } else if (is_face(word)) {
      start_here(place);
      skip_statement(scanner_);
    } else if (word == "vt" || word == "vn") {
      if (surface_)
        skip_statement(scanner_);
      else
        corner_value(word == "vt" ? found_.texture : found_.normal, word == "vt" ? 1 : 3);
    } else if (word == "g" || word == "o" || word == "s" || word == "usemtl" || word == "l" || word == "p" ||
               word == "mtllib") {
      if (!surface_) start_here(place);
      if (!surface_ && word == "g")
        groups();
      else
        skip_statement(scanner_);
    } else if (is_skipped_statement(word)) {
      if (!surface_) ++found_.unread.try_emplace(std::string(word)).first->second;
      skip_statement(scanner_);
    } else if (!word.empty()) {
      scanner_.fail("a statement of OBJ (v, f, ...)", word);
    }
  }

  void start_here(std::size_t place) {
    if (place >= found_.first_element) return;
    found_.first_element = place;
    found_.points_above = static_cast<std::int64_t>(found_.points.size());
    for (ObjCorners* corners : {&found_.texture, &found_.normal})
      corners->above = static_cast<std::int64_t>(corners->all.size());
  }

  double coordinate() {
    const std::string_view field = next_field(scanner_);
    double value;
    if (!parse_real(field, value))
      field.empty() ? scanner_.fail_in_line("expected 3 coordinates, found fewer")
                    : scanner_.fail("a coordinate", field);
    return value;
  }

  void point() {
    Eigen::Vector3d& point = found_.points.emplace_back();
    for (int k = 0; k < 3; ++k) point[k] = coordinate();
    numbers_.clear();
    double extra;
    for (std::string_view field = next_field(scanner_); !field.empty(); field = next_field(scanner_)) {
      if (!parse_real(field, extra)) scanner_.fail("a number or the end of the line", field);
      numbers_.push_back(extra);
    }
    if (surface_ || numbers_.empty()) return;
    const std::size_t node = found_.points.size() - 1;
    if (numbers_.size() == 1)
      found_.weights.add(node, numbers_, false);
    else if (numbers_.size() == 3 || numbers_.size() == 4)
      found_.colors.add(node, numbers_, false);
    else
      ++found_.odd_numbers;
  }

  void corner_value(ObjCorners& corners, int least) {
    std::array<double, 3> numbers{};
    int count = 0;
    for (std::string_view field = next_field(scanner_); !field.empty();
         field = next_field(scanner_), ++count) {
      double value;
      if (!parse_real(field, value)) scanner_.fail("a number or the end of the line", field);
      if (count < 3) numbers[static_cast<std::size_t>(count)] = value;
    }
    if (count < least || count > 3)
      scanner_.fail_in_line(fmt::format("expected {} numbers, found {}", least == 3 ? "3" : "1 to 3", count));
    corners.all.push_back(numbers);
    corners.components = std::max({corners.components, count, 2});
  }

  void groups() {
    for (std::string_view field = next_field(scanner_); !field.empty(); field = next_field(scanner_))
      if (const auto number = group_number(field)) names_.take(*number);
  }

  Scanner scanner_;
  const bool surface_;
  GroupNumbers& names_;
  ObjPoints found_;
  std::vector<double> numbers_;
};

}  // namespace

ObjPoints read_obj_points(const InputFile& file, Wanted wanted, GroupNumbers& names) {
  return PointsReader(file, wanted, names).read();
}

}  // namespace tetproof::io
