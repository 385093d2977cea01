// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/obj/obj_points.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "io/bytes/scanner.hpp"
#include "io/loss/loss_list.hpp"
#include "io/obj/obj_statements.hpp"
#include "io/surface/group_names.hpp"
#include "io/surface/text_of_file.hpp"

namespace tetproof::io {
namespace {

class PointsReader {
 public:
  PointsReader(const InputFile& file, std::string_view text, Wanted wanted, GroupNumbers& names,
               std::vector<Loss>& dropped)
      : file_(file),
        text_(text),
        scanner_(start_of_text(file, text)),
        surface_(wanted == Wanted::surface),
        names_(names),
        dropped_(dropped) {
    found_.first_element = text.size();
  }

  ObjPoints read() {
    while (!scanner_.at_end('#')) {
      const std::size_t place = scanner_.offset();
      statement(next_field(scanner_), place);
    }
    if (!any_known_ && first_unknown_) {
      Scanner start(file_.path(), text_, *first_unknown_);
      const std::string_view word = start.word('#');
      start.fail("a statement of OBJ (v, f, ...)", word);
    }
    return std::move(found_);
  }

 private:
  void statement(std::string_view word, std::size_t place) {
    if (word.empty()) return;
    if (word == "v") {
      point(place);
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
    } else {
      drop_statement(word, place);
      return;
    }
    any_known_ = true;
  }

  void drop_statement(std::string_view word, std::size_t place) {
    const bool known = is_statement(word);
    any_known_ = any_known_ || known;
    if (!known && !first_unknown_) first_unknown_ = place;
    drop(known ? fmt::format("statements `{}`", word) : "statements that OBJ does not have", place);
    skip_statement(scanner_);
  }

  // The example costs a count of the lines above, which only the first one of an item is worth.
  void drop(const std::string& item, std::size_t place) {
    const bool is_new =
        std::none_of(dropped_.begin(), dropped_.end(), [&](const Loss& loss) { return loss.item == item; });
    add_loss(dropped_, item, 1, is_new ? example_line(file_.path(), text_, place) : "");
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

  void point(std::size_t place) {
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
      drop("numbers behind x y z of vertices, neither a weight nor a colour", place);
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

  const InputFile& file_;
  const std::string_view text_;
  Scanner scanner_;
  const bool surface_;
  GroupNumbers& names_;
  std::vector<Loss>& dropped_;
  ObjPoints found_;
  std::vector<double> numbers_;
  std::optional<std::size_t> first_unknown_;
  bool any_known_ = false;
};

}  // namespace

ObjPoints read_obj_points(const InputFile& file, std::string_view text, Wanted wanted, GroupNumbers& names,
                          std::vector<Loss>& dropped) {
  return PointsReader(file, text, wanted, names, dropped).read();
}

}  // namespace tetproof::io
