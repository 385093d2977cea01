// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/page/scene.hpp"

#include <bit>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

#include "io/bytes/base64.hpp"

namespace tetproof::io {
namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "the page's arrays are little-endian");

template <class T>
std::string bytes_of(const std::vector<T>& values) {
  return base64({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
}

// Three bytes each.
std::string short_bytes_of(const std::vector<std::array<Index, 4>>& tets) {
  std::string bytes;
  bytes.reserve(tets.size() * 12);
  for (const auto& tet : tets)
    for (const Index v : tet)
      for (const int shift : {0, 8, 16}) bytes += static_cast<char>(v >> shift & 255);
  return base64(bytes);
}

Json point(const Eigen::Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}

// Numbers that mostly count up are runs: for each its first position and its first number. Others are an
// array of 32 bits where they fit, else of doubles.
Json numbers_of(const std::vector<std::int64_t>& numbers) {
  Json runs = Json::array();
  bool fit = true;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const bool starts = i == 0 || numbers[i - 1] == std::numeric_limits<std::int64_t>::max() ||
                        numbers[i] != numbers[i - 1] + 1;
    if (starts) runs.push_back({i, numbers[i]});
    fit = fit && numbers[i] == static_cast<std::int32_t>(numbers[i]);
  }
  if (runs.size() < 16 || runs.size() < numbers.size() / 4) return runs;
  if (fit) return {{"int32", bytes_of(std::vector<std::int32_t>(numbers.begin(), numbers.end()))}};
  return {{"float64", bytes_of(std::vector<double>(numbers.begin(), numbers.end()))}};
}

Json json(const SceneLayer& layer) {
  return {{"id", layer.id},
          {"name", layer.name},
          {"colour", layer.colour},
          {"opacity", layer.opacity},
          {"shown", layer.shown},
          {"boundary", layer.boundary},
          {"triangles", bytes_of(layer.triangles)},
          {"tets", bytes_of(layer.tets)},
          {"faces", bytes_of(layer.faces)},
          {"values", bytes_of(layer.values)}};
}

}  // namespace

std::vector<std::array<Index, 3>> triangles_of(const Scene& scene, const SceneLayer& layer) {
  std::vector<std::array<Index, 3>> triangles = layer.triangles;
  for (const std::uint32_t face : layer.faces) {
    const std::array<Index, 4>& tet = scene.tets[face >> 2];
    const std::array<int, 3>& corners = tet_faces[face & 3];
    triangles.push_back({tet[static_cast<std::size_t>(corners[0])], tet[static_cast<std::size_t>(corners[1])],
                         tet[static_cast<std::size_t>(corners[2])]});
  }
  return triangles;
}

std::string scene_json(const Scene& scene) {
  if (scene.points.size() > std::size_t{1} << 24) throw std::logic_error("a scene of more than 2^24 points");
  Json all = {{"points", bytes_of(scene.points)},
              {"tets", short_bytes_of(scene.tets)},
              {"cut_tets", scene.cut_tets},
              {"cut_axes", scene.cut_axes},
              {"cut_anywhere", scene.cut_anywhere},
              {"cut_middle", point(scene.cut_middle)},
              {"tet_numbers", numbers_of(scene.tet_numbers)},
              {"point_numbers", numbers_of(scene.point_numbers)},
              {"tet_regions", bytes_of(scene.tet_regions)},
              {"regions", scene.regions},
              {"value_name", scene.value_name},
              {"layers", Json::array()},
              {"edges", Json::array()},
              {"marks", Json::array()},
              {"targets", Json::array()}};
  for (const SceneLayer& layer : scene.layers) all["layers"].push_back(json(layer));
  for (const SceneEdges& edges : scene.edges)
    all["edges"].push_back({{"id", edges.id},
                            {"name", edges.name},
                            {"colour", edges.colour},
                            {"shown", edges.shown},
                            {"edges", bytes_of(edges.edges)}});
  for (const SceneMark& mark : scene.marks)
    all["marks"].push_back({{"point", point(mark.point)}, {"text", mark.text}, {"colour", mark.colour}});
  for (const SceneTarget& target : scene.targets)
    all["targets"].push_back({{"middle", point(target.middle)},
                              {"radius", target.radius},
                              {"text", target.text},
                              {"tets", target.tets},
                              {"nodes", target.nodes},
                              {"faces", target.faces}});
  const std::string text = all.dump(-1, ' ', false, Json::error_handler_t::replace);
  // "</script>" and "<!--" mean something to a browser even inside of a text of JSON.
  std::string safe;
  safe.reserve(text.size());
  for (const char c : text)
    if (c == '<')
      safe += "\\u003c";
    else
      safe += c;
  return safe;
}

}  // namespace tetproof::io
