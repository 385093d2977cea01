// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/program/edit_options.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/bytes/scanner.hpp"
#include "io/error.hpp"
#include "io/mesh_files.hpp"
#include "io/program/report_losses.hpp"

namespace tetproof::program {
namespace {

constexpr const char* group = "Edits (they work in this order)";
constexpr const char* exact = "exact";
constexpr const char* nothing = " ";  // for --merge-points=, which CLI11 takes for --merge-points

Eigen::Vector3d vector_of(const std::string& text) {
  Eigen::Vector3d vector;
  std::size_t from = 0;
  for (int k = 0; k < 3; ++k) {
    const std::size_t end = std::min(text.find(',', from), text.size());
    if (from > text.size() || !parse_real(std::string_view(text).substr(from, end - from), vector[k]) ||
        (k == 2 && end != text.size()))
      throw InputError(fmt::format("--translate: expected three numbers X,Y,Z, found '{}'", text));
    from = end + 1;
  }
  if (!vector.allFinite())
    throw InputError(fmt::format("--translate: expected three finite numbers X,Y,Z, found '{}'", text));
  return vector;
}

std::optional<double> tolerance_of(const std::string& text) {
  if (text == exact) return {};
  double tolerance;
  if (!parse_real(text, tolerance))
    throw InputError(
        fmt::format("--merge-points: expected a number, found '{}'", text == nothing ? "" : text));
  if (!(tolerance >= 0 && std::isfinite(tolerance)))
    throw InputError(fmt::format("--merge-points: expected a distance of at least 0, found {}", text));
  return tolerance;
}

}  // namespace

std::string not_empty(const std::string& word) {
  return word.empty() ? "expected a value, found ''" : "";
}

void declare_edits(CLI::App& app, EditOptions& options) {
  app.add_option("--scale", options.scale, "multiply all coordinates by F")
      ->check(not_empty)
      ->type_name("F")
      ->group(group);
  app.add_option("--translate", options.translate, "then move all points by X,Y,Z")
      ->check(not_empty)
      ->type_name("X,Y,Z")
      ->group(group);
  app.add_flag(std::string("--merge-points{") + exact + "}", options.merge_points,
               "merge points with the same coordinates; --merge-points=T: those within the distance T")
      ->group(group);
  app.add_option(
         "--only", options.only,
         "keep elements of these types alone: points, lines, polylines, triangles, quadrangles, polygons, "
         "tetrahedra, hexahedra, prisms, pyramids, polyhedra, or Gmsh's numbers of types")
      ->check(not_empty)
      ->type_name("TYPE,...")
      ->group(group);
  app.add_flag("--boundary", options.boundary,
               "replace all elements by the surface of the solids, wound outwards")
      ->group(group);
  app.add_flag("--triangulate", options.triangulate, "cut quadrangles and polygons into triangles")
      ->group(group);
  app.add_flag("--prune", options.prune, "leave out points that no element has")->group(group);
  app.add_flag("--renumber", options.renumber, "number nodes and elements from 1 on")->group(group);
  app.add_flag(
         "--group-texts", options.group_texts,
         "add the names of groups to the elements, as texts in VTK's files: ParaView shows them, meshio "
         "reads no texts")
      ->group(group);
  app.add_flag("--split-by-group", options.split_by_group,
               "write one file for each physical group, with its points alone: OUT_NAME.ending")
      ->group(group);
}

std::vector<std::string> with_joined_tolerance(int argc, char** argv) {
  std::vector<std::string> words;
  for (int i = 0; i < argc; ++i) {
    double tolerance;
    if (!words.empty() && words.back() == "--merge-points" && parse_real(argv[i], tolerance))
      words.back() += std::string("=") + argv[i];
    else
      words.emplace_back(argv[i]);
    if (words.back() == "--merge-points=") words.back() += nothing;
  }
  return words;
}

void check_edits(const EditOptions& options) {
  if (options.scale && !(*options.scale > 0 && std::isfinite(*options.scale)))
    throw InputError(fmt::format("--scale: expected a factor above 0, found {}", *options.scale));
  if (!options.translate.empty()) vector_of(options.translate);
  if (!options.merge_points.empty()) tolerance_of(options.merge_points);
}

std::vector<DoneEdit> apply_edits(const Common& common, const EditOptions& options, Document& document) {
  std::vector<DoneEdit> all;
  const auto add = [&](const std::string& option, io::Edit edit) {
    all.push_back({option, std::move(edit)});
    say_edit(common, all.back());
  };
  if (options.scale) add(fmt::format("--scale {}", *options.scale), io::scale(document, *options.scale));
  if (!options.translate.empty())
    add("--translate " + options.translate, io::translate(document, vector_of(options.translate)));
  if (!options.merge_points.empty())
    add(options.merge_points == exact ? "--merge-points" : "--merge-points=" + options.merge_points,
        io::merge_points(document, tolerance_of(options.merge_points)));
  if (!options.only.empty()) add("--only " + options.only, io::keep_only(document, options.only));
  if (options.boundary) add("--boundary", io::boundary(document));
  if (options.triangulate) add("--triangulate", io::triangulate(document));
  if (options.prune) add("--prune", io::prune(document));
  if (options.renumber) add("--renumber", io::renumber(document));
  if (options.group_texts) add("--group-texts", io::add_group_texts(document));
  return all;
}

void say_edit(const Common& common, const DoneEdit& done) {
  say(common, fmt::format("{}: {}", done.option, done.edit.did));
  for (const Loss& loss : done.edit.lost) say(common, loss_line("lost", loss));
}

nlohmann::ordered_json edits_json(const std::vector<DoneEdit>& done) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const DoneEdit& one : done)
    list.push_back({{"option", one.option}, {"did", one.edit.did}, {"lost", losses_json(one.edit.lost)}});
  return list;
}

std::string path_of_part(const std::string& out, const std::string& word) {
  std::size_t end = out.size() - ending_of(out).size();
  const std::size_t dot = out.rfind('.', end == 0 ? 0 : end - 1);
  const std::size_t slash = out.rfind('/');
  if (end > 0 && dot != out.npos && dot + 1 < end && (slash == out.npos || dot > slash + 1) &&
      out.find_first_not_of("0123456789", dot + 1) >= end)
    end = dot;  // TetGen's number of the iteration stays before the ending
  return out.substr(0, end) + "_" + word + out.substr(end);
}

}  // namespace tetproof::program
