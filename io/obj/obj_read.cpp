// SPDX-License-Identifier: GPL-3.0-or-later
// The second of two passes over an OBJ file: faces, lines and points, with the statements that hold for them.
#include <fmt/core.h>

#include <algorithm>
#include <string>

#include "io/bytes/scanner.hpp"
#include "io/bytes/tokens.hpp"
#include "io/bytes/words.hpp"
#include "io/loss/loss_list.hpp"
#include "io/model/node_index.hpp"
#include "io/obj/obj.hpp"
#include "io/obj/obj_names.hpp"
#include "io/obj/obj_points.hpp"
#include "io/obj/obj_state.hpp"
#include "io/obj/obj_statements.hpp"
#include "io/surface/surface_document.hpp"
#include "io/surface/text_of_file.hpp"
#include "io/surface/titles.hpp"

namespace tetproof::io {
namespace {

constexpr const char* a_corner = "a vertex as in 7, 7/1, 7//3, 7/1/3 or -1";

class Reader {
 public:
  Reader(const InputFile& file, Wanted wanted)
      : file_(file), surface_(wanted == Wanted::surface), text_(text_of_file(file, source_.document)) {
    source_.document.path = file.path(), source_.document.format = "obj";
  }

  ReadDocument read() {
    Document& document = source_.document;
    if (!surface_) document.title = leading_comments(start_of_text(file_, text_));
    points_ = read_obj_points(file_, text_, surface_ ? Wanted::surface : Wanted::document, names_,
                              document.dropped);
    document.points = std::move(points_.points);
    check_countable(file_.path(), document.points.size());
    read_elements();
    if (!surface_) finish();
    return std::move(source_);
  }

 private:
  // From a number in i, i/t, i//n or i/t/n to a position, where `above` of what it counts stand above it.
  static std::int64_t position(std::int64_t number, std::int64_t above) {
    return number > 0 ? number - 1 : above + number;
  }

  // The number, from 1, of one corner's point. What the corner names of texture and normals goes into their
  // lists.
  std::int64_t corner(std::string_view field, const Scanner& scanner, bool& slashes) {
    const std::string_view number = field.substr(0, field.find('/'));
    const std::string_view rest = field.substr(number.size());
    std::int64_t value;
    if (!parse_integer(number, value) || value == 0 || rest.find_first_not_of("/-0123456789") != rest.npos ||
        std::count(rest.begin(), rest.end(), '/') > 2)
      scanner.fail(a_corner, field);
    if (value < -points_.points_above)
      scanner.fail_in_line(
          fmt::format("face names vertex {}, but only {} stand above it", value, points_.points_above));
    if (!surface_) {
      const std::size_t second = rest.find('/', 1);
      const auto named = [&](ObjCorners& corners, std::string_view text) {
        std::int64_t i;
        const bool is_number = parse_integer(text, i);
        if (!is_number && !text.empty()) scanner.fail(a_corner, field);
        corners.named.push_back(is_number && i != 0 ? std::max<std::int64_t>(position(i, corners.above), -1)
                                : text.empty()      ? ObjCorners::none_named
                                                    : -1);
        slashes = slashes || !text.empty();
      };
      named(points_.texture,
            rest.empty() ? rest : rest.substr(1, second == rest.npos ? rest.npos : second - 1));
      named(points_.normal, second == rest.npos ? std::string_view() : rest.substr(second + 1));
    }
    return value > 0 ? value : points_.points_above + value + 1;
  }

  // Reads the corners of an element. True if any of them names more than a point.
  bool read_corners(Scanner& scanner, NodeIndex& nodes) {
    corners_.clear(), points_.texture.named.clear(), points_.normal.named.clear();
    bool slashes = false;
    for (std::string_view field = next_field(scanner); !field.empty(); field = next_field(scanner))
      corners_.push_back(nodes(corner(field, scanner, slashes)));
    return slashes;
  }

  void add(std::span<const Index> nodes, std::size_t place, bool is_line = false) {
    Document& document = source_.document;
    const std::size_t element = document.elements();
    if (surface_)
      source_.places.push_back(place);
    else
      for (ObjState* state : {&object_, &material_, &smoothing_}) state->add_element(element);
    const std::int32_t groups = names_.of(nodes.size() == 1 ? 0 : nodes.size() == 2 || is_line ? 1 : 2);
    is_line ? io::add_line(document, nodes, groups) : io::add_element(document, nodes, groups);
  }

  void read_face(Scanner& scanner, std::size_t place, NodeIndex& nodes) {
    const bool slashes = read_corners(scanner, nodes);
    if (corners_.size() < 3) {
      const Scanner start(file_.path(), text_, place);
      start.fail_in_line(
          fmt::format("face has {}, expected at least 3", counted(corners_.size(), "corners")));
    }
    if (!surface_ && slashes)
      for (ObjCorners* values : {&points_.texture, &points_.normal})
        if (!values->add_element(source_.document.elements()))
          drop(fmt::format("{} of faces that name some that do not exist, or not at every corner",
                           values == &points_.texture ? "texture coordinates" : "normals"),
               1, place);
    add(corners_, place);
  }

  // A line or polyline, or points.
  void read_thin(Scanner& scanner, std::size_t place, NodeIndex& nodes, std::size_t corners_each) {
    const bool slashes = read_corners(scanner, nodes);
    if (corners_.size() < corners_each)
      scanner.fail_in_line(
          fmt::format("expected at least {}, found {}", counted(corners_each, "vertices"), corners_.size()));
    if (slashes) drop("texture coordinates and normals of lines and points", 1, place);
    if (corners_each == 2) return add(corners_, place, true);
    const std::vector<Index> all = corners_;
    for (std::size_t i = 0; i + corners_each <= all.size(); ++i)
      add(std::span(all).subspan(i, corners_each), place);
  }

  void read_elements() {
    Document& document = source_.document;
    NodeIndex nodes(document);
    if (!surface_) names_.take_comments(file_);
    names_.start(document);
    points_.texture.start("texture"), points_.normal.start("normal");
    Scanner scanner(file_.path(), text_, points_.first_element);
    while (!scanner.at_end('#')) {
      const std::size_t place = scanner.offset();
      const std::string_view statement = next_field(scanner);
      if (is_face(statement)) {
        read_face(scanner, place, nodes);
      } else if (statement == "v") {
        ++points_.points_above;
        skip_statement(scanner);
      } else if (surface_) {  // NOLINT(bugprone-branch-clone): what a surface does not need comes before the
                              // rest
        skip_statement(scanner);
      } else if (statement == "vt" || statement == "vn") {
        ++(statement == "vt" ? points_.texture : points_.normal).above;
        skip_statement(scanner);
      } else if (statement == "l") {
        read_thin(scanner, place, nodes, 2);
      } else if (statement == "p") {
        read_thin(scanner, place, nodes, 1);
      } else if (statement == "g") {
        groups_.clear();
        for (std::string_view field = next_field(scanner); !field.empty(); field = next_field(scanner))
          groups_.emplace_back(field);
        names_.set(groups_);
      } else if (statement == "o") {
        object_.set(name_field(scanner));
      } else if (statement == "usemtl") {
        material_.set(name_field(scanner));
      } else if (statement == "s") {
        read_smoothing(scanner, place);
      } else if (statement == "mtllib") {
        for (std::string_view field = next_field(scanner); !field.empty(); field = next_field(scanner))
          libraries_.push_back(decode_name(field));
      } else {
        skip_statement(scanner);
      }
    }
  }

  void read_smoothing(Scanner& scanner, std::size_t place) {
    const std::string text = name_field(scanner);
    std::int64_t number = 0;
    if (!text.empty() && text != "off" && text != "default" && !parse_integer(text, number))
      drop("smoothing groups that are neither a number nor off", 1, place);
    smoothing_.said = true;
    smoothing_.number = number;
  }

  void finish() {
    Document& document = source_.document;
    const std::size_t nodes = document.points.size();
    std::move(points_.weights).give(document.node_values, "weight", nodes);
    const std::size_t first_color = document.node_values.size();
    std::move(points_.colors).give(document.node_values, "color", nodes);
    for (std::size_t i = first_color; i < document.node_values.size(); ++i)
      warn_of_colours(document, document.node_values[i], "vertices");
    give_state(object_, "object", true);
    give_state(material_, "material", true);
    give_state(smoothing_, "smoothing", false);
    give_corners(points_.texture, "texture coordinates", "vt");
    give_corners(points_.normal, "normals", "vn");
    if (!libraries_.empty()) {
      Table& table = document.tables.emplace_back();
      table.name = "mtllib", table.rows = libraries_.size();
      Column& column = table.columns.emplace_back();
      column.name = "file", column.type = "text", column.texts = std::move(libraries_);
    }
  }

  void give_corners(ObjCorners& corners, const char* what, const char* statement) {
    Document& document = source_.document;
    const auto unused = std::find(corners.used.begin(), corners.used.end(), false);
    if (unused != corners.used.end())
      add_loss(document.dropped, fmt::format("{} (`{}`) that no face uses", what, statement),
               static_cast<std::size_t>(std::count(unused, corners.used.end(), false)),
               fmt::format("`{}` number {}", statement, unused - corners.used.begin() + 1));
    Values& values = corners.values;
    if (values.at.empty()) return;
    if (values.at.size() == document.elements()) values.at.clear();
    document.element_node_values.push_back(std::move(values));
  }

  void give_state(ObjState& state, const char* name, bool labelled) {
    const bool any = labelled ? !state.of_elements.empty()
                              : std::any_of(state.of_elements.begin(), state.of_elements.end(),
                                            [](std::int64_t n) { return n != 0; });
    if (!any) return;
    Values& values = source_.document.element_values.emplace_back();
    values.name = name;
    values.integers = std::move(state.of_elements);
    if (labelled) values.labels = state.labels.take();
  }

  // The example costs a count of the lines above, which only the first one of an item is worth.
  void drop(const std::string& item, std::size_t count, std::size_t place) {
    std::vector<Loss>& dropped = source_.document.dropped;
    const bool is_new =
        std::none_of(dropped.begin(), dropped.end(), [&](const Loss& loss) { return loss.item == item; });
    add_loss(dropped, item, count, is_new ? example_line(file_.path(), text_, place) : "");
  }

  const InputFile& file_;
  const bool surface_;
  ReadDocument source_;
  const std::string_view text_;
  ObjPoints points_;
  ObjState object_, material_, smoothing_;
  GroupNumbers names_;
  std::vector<std::string> groups_;  // of the statement at hand
  std::vector<std::string> libraries_;
  std::vector<Index> corners_;
};

}  // namespace

ReadDocument read_obj(const InputFile& file, Wanted wanted) {
  return Reader(file, wanted).read();
}

}  // namespace tetproof::io
