// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <unordered_map>

#include "io/node_index.hpp"
#include "io/obj.hpp"
#include "io/obj_names.hpp"
#include "io/obj_state.hpp"
#include "io/tokens.hpp"

namespace tetproof::io {
namespace {

// Statements whose meaning is not kept. A misspelt `v` must not vanish silently: it would shift all numbers.
constexpr std::array<std::string_view, 34> skipped{
    "vp",   "cstype", "deg",    "bmat",       "step",      "curv",  "curv2",   "parm",     "trim",
    "hole", "scrv",   "sp",     "end",        "con",       "mg",    "bevel",   "c_interp", "d_interp",
    "lod",  "usemap", "maplib", "shadow_obj", "trace_obj", "ctech", "stech",   "bsp",      "bzp",
    "cdc",  "cdp",    "res",    "call",       "csh",       "mtlib", "usemtlib"};

// The next word of a statement, which goes on in the next line where a line ends in a backslash; empty at the
// statement's end.
std::string_view next_field(Scanner& scanner) {
  while (!scanner.at_line_end('#')) {
    std::string_view field = scanner.word('#');
    if (field.back() != '\\' || !scanner.ends_line()) return field;
    scanner.next_line();
    field.remove_suffix(1);
    if (!field.empty()) return field;
  }
  return {};
}

void skip_statement(Scanner& scanner) {
  for (;;) {
    const std::string_view line = scanner.rest_of_line();
    if (line.empty() || line.back() != '\\' || line.find('#') != line.npos || scanner.remaining() == 0)
      return;
    scanner.next_line();
  }
}

// The rest of a statement as one name, its words with one blank between them.
std::string name_field(Scanner& scanner) {
  std::string name;
  for (std::string_view field = next_field(scanner); !field.empty(); field = next_field(scanner))
    name.append(name.empty() ? "" : " ").append(field);
  return decode_name(name);
}

bool is_face(std::string_view statement) {
  return statement == "f" || statement == "fo";
}

class Reader {
 public:
  Reader(const InputFile& file, Wanted wanted) : file_(file), surface_(wanted == Wanted::surface) {
    source_.document.path = file.path(), source_.document.format = "obj";
    texture_.values.name = "texture", normal_.values.name = "normal";
  }

  SurfaceDocument read() {
    if (!surface_) source_.document.title = leading_comments(Scanner(file_));
    read_points();
    check_countable(file_.path(), source_.document.points.size());
    read_elements();
    if (!surface_) finish();
    return std::move(source_);
  }

 private:
  double real_field(Scanner& scanner) {
    const std::string_view field = next_field(scanner);
    double value;
    if (!parse_real(field, value))
      field.empty() ? scanner.fail_in_line("expected 3 coordinates, found fewer")
                    : scanner.fail("a coordinate", field);
    return value;
  }

  void read_point(Scanner& scanner) {
    auto& points = source_.document.points;
    Eigen::Vector3d& point = points.emplace_back();
    for (int k = 0; k < 3; ++k) point[k] = real_field(scanner);
    numbers_.clear();
    double extra;
    for (std::string_view field = next_field(scanner); !field.empty(); field = next_field(scanner)) {
      if (!parse_real(field, extra)) scanner.fail("a number or the end of the line", field);
      numbers_.push_back(extra);
    }
    if (surface_ || numbers_.empty()) return;
    const std::size_t node = points.size() - 1;
    if (numbers_.size() == 1)
      weights_.add(node, numbers_, false);
    else if (numbers_.size() == 3 || numbers_.size() == 4)
      colors_.add(node, numbers_, false);
    else
      ++odd_points_;
  }

  void read_corner_value(Scanner& scanner, ObjCorners& corners, int least) {
    std::array<double, 3> numbers{};
    int count = 0;
    for (std::string_view field = next_field(scanner); !field.empty(); field = next_field(scanner), ++count) {
      double value;
      if (!parse_real(field, value)) scanner.fail("a number or the end of the line", field);
      if (count < 3) numbers[static_cast<std::size_t>(count)] = value;
    }
    if (count < least || count > 3)
      scanner.fail_in_line(fmt::format("expected {} numbers, found {}", least == 3 ? "3" : "1 to 3", count));
    corners.all.push_back(numbers);
    corners.components = std::max({corners.components, count, 2});
  }

  // First the points, since a face may name points that come later.
  void read_points() {
    Scanner scanner(file_);
    first_element_ = file_.bytes().size();
    const auto start_here = [&](std::size_t place) {
      if (place >= first_element_) return;
      first_element_ = place, points_above_ = static_cast<std::int64_t>(source_.document.points.size());
      texture_.above = static_cast<std::int64_t>(texture_.all.size());
      normal_.above = static_cast<std::int64_t>(normal_.all.size());
    };
    std::map<std::string, std::size_t, std::less<>> unread;
    while (!scanner.at_end('#')) {
      const std::size_t place = scanner.offset();
      const std::string_view statement = next_field(scanner);
      if (statement == "v") {
        read_point(scanner);
      } else if (is_face(statement)) {
        start_here(place);
        skip_statement(scanner);
      } else if (statement == "vt" || statement == "vn") {
        if (surface_)
          skip_statement(scanner);
        else
          read_corner_value(scanner, statement == "vt" ? texture_ : normal_, statement == "vt" ? 1 : 3);
      } else if (statement == "g" || statement == "o" || statement == "s" || statement == "usemtl" ||
                 statement == "l" || statement == "p" || statement == "mtllib") {
        if (!surface_) start_here(place);
        if (!surface_ && statement == "g") {
          for (std::string_view field = next_field(scanner); !field.empty(); field = next_field(scanner))
            if (const auto number = group_number(field)) names_.take(*number);
        } else {
          skip_statement(scanner);
        }
      } else if (std::find(skipped.begin(), skipped.end(), statement) != skipped.end()) {
        if (!surface_) ++unread.try_emplace(std::string(statement)).first->second;
        skip_statement(scanner);
      } else if (!statement.empty()) {
        scanner.fail("a statement of OBJ (v, f, ...)", statement);
      }
    }
    for (const auto& [statement, count] : unread)
      warn(fmt::format("{} statements `{}` are not read", count, statement));
  }

  // The number in i, i/t, i//n or i/t/n at a place where so many stand above.
  static std::int64_t position(std::int64_t number, std::int64_t above) {
    return number > 0 ? number - 1 : above + number;
  }

  // One corner: its point's number from 1, and into the lists what it names of texture and normals.
  std::int64_t corner(std::string_view field, const Scanner& scanner, bool& slashes) {
    const std::string_view number = field.substr(0, field.find('/'));
    const std::string_view rest = field.substr(number.size());
    std::int64_t value;
    if (!parse_integer(number, value) || value == 0 || rest.find_first_not_of("/-0123456789") != rest.npos ||
        std::count(rest.begin(), rest.end(), '/') > 2)
      scanner.fail("a vertex as in 7, 7/1, 7//3, 7/1/3 or -1", field);
    if (value < -points_above_)
      scanner.fail_in_line(
          fmt::format("face names vertex {}, but only {} stand above it", value, points_above_));
    if (!surface_) {
      const std::size_t second = rest.find('/', 1);
      const auto named = [&](ObjCorners& corners, std::string_view text) {
        std::int64_t i;
        const bool is_number = parse_integer(text, i);
        if (!is_number && !text.empty()) scanner.fail("a vertex as in 7, 7/1, 7//3, 7/1/3 or -1", field);
        corners.named.push_back(is_number && i != 0 ? std::max<std::int64_t>(position(i, corners.above), -1)
                                : text.empty()      ? ObjCorners::none_named
                                                    : -1);
        slashes = slashes || !text.empty();
      };
      named(texture_, rest.empty() ? rest : rest.substr(1, second == rest.npos ? rest.npos : second - 1));
      named(normal_, second == rest.npos ? std::string_view() : rest.substr(second + 1));
    }
    return value > 0 ? value : points_above_ + value + 1;
  }

  void add(std::span<const Index> nodes, std::size_t place) {
    Document& document = source_.document;
    const std::size_t element = document.elements();
    if (surface_)
      source_.places.push_back(place);
    else
      for (ObjState* state : {&object_, &material_, &smoothing_}) state->add_element(element);
    io::add_element(document, nodes,
                    names_.of(type_of_corners(nodes.size()) == 15 ? 0
                              : nodes.size() == 2                 ? 1
                                                                  : 2));
  }

  void read_face(Scanner& scanner, std::size_t place, NodeIndex& nodes) {
    corners_.clear(), texture_.named.clear(), normal_.named.clear();
    bool slashes = false;
    for (std::string_view field = next_field(scanner); !field.empty(); field = next_field(scanner))
      corners_.push_back(nodes(corner(field, scanner, slashes)));
    if (corners_.size() < 3) {
      const Scanner start(file_.path(), file_.bytes(), place);
      start.fail_in_line(fmt::format("face has {} corners, expected at least 3", corners_.size()));
    }
    if (!surface_ && slashes)
      for (ObjCorners* values : {&texture_, &normal_})
        values->add_element(source_.document.elements(), false);
    add(corners_, place);
  }

  // A line through points, or points.
  void read_thin(Scanner& scanner, std::size_t place, NodeIndex& nodes, std::size_t corners_each) {
    corners_.clear(), texture_.named.clear(), normal_.named.clear();
    bool slashes = false;
    for (std::string_view field = next_field(scanner); !field.empty(); field = next_field(scanner))
      corners_.push_back(nodes(corner(field, scanner, slashes)));
    if (corners_.size() < corners_each)
      scanner.fail_in_line(
          fmt::format("expected at least {} vertices, found {}", corners_each, corners_.size()));
    textured_lines_ += slashes;
    const std::vector<Index> all = corners_;
    for (std::size_t i = 0; i + corners_each <= all.size(); ++i)
      add(std::span(all).subspan(i, corners_each), place);
  }

  void read_elements() {
    Document& document = source_.document;
    NodeIndex nodes(document);
    if (!surface_) read_group_numbers();
    names_.start(document);
    texture_.used.resize(texture_.all.size()), normal_.used.resize(normal_.all.size());
    texture_.values.components = texture_.components, normal_.values.components = 3;
    normal_.components = 3;
    Scanner scanner(file_.path(), file_.bytes(), first_element_);
    while (!scanner.at_end('#')) {
      const std::size_t place = scanner.offset();
      const std::string_view statement = next_field(scanner);
      if (is_face(statement)) {
        read_face(scanner, place, nodes);
      } else if (statement == "v") {
        ++points_above_;
        skip_statement(scanner);
      } else if (surface_) {
        skip_statement(scanner);
      } else if (statement == "vt" || statement == "vn") {
        ++(statement == "vt" ? texture_ : normal_).above;
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
        read_smoothing(scanner);
      } else if (statement == "mtllib") {
        for (std::string_view field = next_field(scanner); !field.empty(); field = next_field(scanner))
          libraries_.push_back(decode_name(field));
      } else {
        skip_statement(scanner);
      }
    }
  }

  // Lines `# group NUMBER WORD`.
  void read_group_numbers() {
    const std::string_view bytes = file_.bytes();
    for (std::size_t at = 0; (at = bytes.find(group_comment, at)) != bytes.npos;) {
      const bool starts_line = at > 0 && (bytes[at - 1] == '\n' || bytes[at - 1] == '\r');
      at += group_comment.size();
      Scanner line(file_.path(), bytes, at);
      const std::string_view text = line.rest_of_line();
      const std::size_t blank = text.find(' ');
      std::int64_t number;
      if (starts_line && blank != text.npos && parse_integer(text.substr(0, blank), number) &&
          blank + 1 < text.size() && text.find_first_of(" \t", blank + 1) == text.npos)
        names_.take(text.substr(blank + 1), number);
    }
  }

  void read_smoothing(Scanner& scanner) {
    const std::string text = name_field(scanner);
    std::int64_t number = 0;
    if (!text.empty() && text != "off" && text != "default" && !parse_integer(text, number)) ++odd_smoothing_;
    smoothing_.said = true;
    smoothing_.number = number;
  }

  void finish() {
    Document& document = source_.document;
    const std::size_t nodes = document.points.size(), elements = document.elements();
    std::move(weights_).give(document.node_values, "weight", nodes);
    const std::size_t first_color = document.node_values.size();
    std::move(colors_).give(document.node_values, "color", nodes);
    for (std::size_t i = first_color; i < document.node_values.size(); ++i)
      warn_of_colours(document, document.node_values[i], "vertices");
    give_state(object_, "object", true);
    give_state(material_, "material", true);
    give_state(smoothing_, "smoothing", false);
    for (ObjCorners* corners : {&texture_, &normal_}) {
      Values& values = corners->values;
      const char* what = corners == &texture_ ? "texture coordinates" : "normals";
      if (corners->bad > 0)
        warn(fmt::format("{} faces name {} that do not exist, or not at every corner", corners->bad, what));
      const auto unused = std::count(corners->used.begin(), corners->used.end(), false);
      if (unused > 0)
        warn(fmt::format("{} {} (`{}`) that no face uses are not kept", unused, what,
                         corners == &texture_ ? "vt" : "vn"));
      if (values.at.empty()) continue;
      if (values.at.size() == elements) values.at.clear();
      document.element_node_values.push_back(std::move(values));
    }
    if (odd_points_ > 0)
      warn(fmt::format("the numbers behind x y z of {} vertices are not read: neither a weight nor a colour",
                       odd_points_));
    if (odd_smoothing_ > 0)
      warn(fmt::format("{} statements `s` with neither a number nor off", odd_smoothing_));
    if (textured_lines_ > 0)
      warn(fmt::format("texture coordinates of {} lines are not read", textured_lines_));
    if (!libraries_.empty()) {
      Table& table = document.tables.emplace_back();
      table.name = "mtllib", table.rows = libraries_.size();
      Column& column = table.columns.emplace_back();
      column.name = "file", column.type = "text", column.texts = std::move(libraries_);
    }
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

  void warn(const std::string& what) {
    source_.document.warnings.push_back(fmt::format("{}: {}", file_.path(), what));
  }

  const InputFile& file_;
  const bool surface_;
  SurfaceDocument source_;
  std::size_t first_element_ = 0;
  std::int64_t points_above_ = 0;
  ObjCorners texture_, normal_;
  ObjState object_, material_, smoothing_;
  Rows weights_, colors_;
  GroupNumbers names_;
  std::vector<std::string> groups_;  // of the statement at hand
  std::vector<std::string> libraries_;
  std::vector<double> numbers_;
  std::vector<Index> corners_;
  std::size_t odd_points_ = 0, odd_smoothing_ = 0, textured_lines_ = 0;
};

}  // namespace

SurfaceDocument read_obj(const InputFile& file, Wanted wanted) {
  return Reader(file, wanted).read();
}

}  // namespace tetproof::io
