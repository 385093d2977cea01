// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/readers/same_content.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <new>

#include "io/error.hpp"
#include "io/mesh_files.hpp"

namespace tetproof::corpus {
namespace {

bool same_reals(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  });
}

bool same_values(const std::vector<Values>& a, const std::vector<Values>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Values& x, const Values& y) {
    return x.components == y.components && x.integers == y.integers && x.at == y.at &&
           same_reals(x.reals, y.reals);
  });
}

bool same_points(const Document& a, const Document& b) {
  return std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(),
                    [](const Eigen::Vector3d& x, const Eigen::Vector3d& y) {
                      return same_reals({x[0], x[1], x[2]}, {y[0], y[1], y[2]});
                    });
}

bool same_elements(const Document& a, const Document& b) {
  const auto same_block = [&](const ElementBlock& x, const ElementBlock& y) {
    return x.type == y.type && x.entity == y.entity && x.count == y.count && x.nodes_each == y.nodes_each &&
           a.tag_sets[static_cast<std::size_t>(x.groups)] == b.tag_sets[static_cast<std::size_t>(y.groups)];
  };
  return std::equal(a.blocks.begin(), a.blocks.end(), b.blocks.begin(), b.blocks.end(), same_block) &&
         a.connectivity == b.connectivity && a.unknown == b.unknown;
}

bool same_numbers(const Document& a, const Document& b) {
  for (std::size_t i = 0; i < a.points.size(); ++i)
    if (a.node_tag(i) != b.node_tag(i)) return false;
  for (std::size_t e = 0; e < a.elements(); ++e)
    if (a.element_tag(e) != b.element_tag(e)) return false;
  return true;
}

}  // namespace

bool same_content(const std::string& path, const Document& before) {
  try {
    const Document now = read_document(path);
    return same_points(now, before) && same_elements(now, before) && same_numbers(now, before) &&
           same_values(now.node_values, before.node_values) &&
           same_values(now.element_values, before.element_values);
  } catch (const InputError&) {
    return false;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

}  // namespace tetproof::corpus
