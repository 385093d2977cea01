// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/c/arrays.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <new>

#include "io/bytes/large_pages.hpp"
#include "verify/c/boundary.hpp"

namespace tetproof::c {
namespace {

constexpr std::int64_t most_items = std::numeric_limits<Index>::max();
constexpr std::int64_t most_address = std::int64_t{1} << 57;  // no processor gives a process more
constexpr std::int64_t most_base = std::int64_t{1} << 62;     // a position added to it is still a number

// Where the items of an array stand, in bytes.
struct Layout {
  const char* data;
  std::int64_t stride, component_stride;

  const char* at(std::int64_t item, std::int64_t component) const {
    return data + item * stride + component * component_stride;
  }
};

// Computes the layout, once it is known that no address in it overflows.
Layout layout_of(const void* data, std::int64_t count, std::int64_t stride, std::int64_t component_stride,
                 std::int64_t components, std::int64_t bytes, const char* name) {
  if (count < 0) refuse_argument(fmt::format("{}: count is {}, expected 0 or more", name, count));
  if (count > most_items)
    throw Refused(TETPROOF_TOO_LARGE,
                  fmt::format("{}: count is {}, at most {} can be numbered", name, count, most_items));
  if (count > 0 && !data) refuse_argument(fmt::format("{}: count is {}, and data is null", name, count));
  if (component_stride == 0) component_stride = bytes;
  if (stride == 0 && __builtin_mul_overflow(component_stride, components, &stride))
    refuse_argument(fmt::format("{}: component_stride is {}, which is too wide", name, component_stride));
  std::int64_t items = 0, components_end = 0, low = 0, high = 0;
  const std::int64_t last = std::max<std::int64_t>(count - 1, 0);
  const bool overflows = __builtin_mul_overflow(stride, last, &items) ||
                         __builtin_mul_overflow(component_stride, components - 1, &components_end) ||
                         __builtin_add_overflow(std::min<std::int64_t>(items, 0),
                                                std::min<std::int64_t>(components_end, 0), &low) ||
                         __builtin_add_overflow(std::max<std::int64_t>(items, 0),
                                                std::max<std::int64_t>(components_end, 0), &high) ||
                         __builtin_add_overflow(high, bytes, &high);
  const auto start = static_cast<std::int64_t>(reinterpret_cast<std::uintptr_t>(data));
  if (count > 0 &&
      (overflows || start < 0 || start > most_address || low < -start || high > most_address - start))
    refuse_argument(fmt::format("{}: {} items with strides {} and {} lie outside of all addresses", name,
                                count, stride, component_stride));
  return {static_cast<const char*>(data), stride, component_stride};
}

Layout layout_of(const tetproof_integers& array, std::int64_t components, const char* name) {
  if (array.bits != 32 && array.bits != 64)
    refuse_argument(fmt::format("{}: bits is {}, expected 32 or 64", name, array.bits));
  return layout_of(array.data, array.count, array.stride, array.component_stride, components, array.bits / 8,
                   name);
}

template <class Number>
std::int64_t integer_at(const char* place) {
  Number number;
  std::memcpy(&number, place, sizeof number);
  return number;
}

// Calls `take` with the integer at each place, item by item.
template <class Number, class Take>
void each_integer(const Layout& layout, std::int64_t count, std::int64_t components, const Take& take) {
  for (std::int64_t i = 0; i < count; ++i)
    for (std::int64_t k = 0; k < components; ++k)
      take(static_cast<std::size_t>(i), static_cast<std::size_t>(k), integer_at<Number>(layout.at(i, k)));
}

template <class Take>
void each_integer(const tetproof_integers& array, const Layout& layout, std::int64_t components,
                  const Take& take) {
  if (array.bits == 32)
    each_integer<std::int32_t>(layout, array.count, components, take);
  else
    each_integer<std::int64_t>(layout, array.count, components, take);
}

}  // namespace

std::vector<Eigen::Vector3d> points_of(const tetproof_points& array, const char* name) {
  const Layout layout =
      layout_of(array.data, array.count, array.stride, array.component_stride, 3, sizeof(double), name);
  std::vector<Eigen::Vector3d> points;
  io::resize_in_large_pages(points, static_cast<std::size_t>(array.count));
  for (std::int64_t i = 0; i < array.count; ++i)
    for (Eigen::Index k = 0; k < 3; ++k)
      std::memcpy(&points[static_cast<std::size_t>(i)][k], layout.at(i, k), sizeof(double));
  return points;
}

std::vector<std::int64_t> tags_of(const tetproof_integers& array, const char* name) {
  const Layout layout = layout_of(array, 1, name);
  if (array.base != 0) refuse_argument(fmt::format("{}: base is {}, expected 0 for tags", name, array.base));
  std::vector<std::int64_t> tags(static_cast<std::size_t>(array.count));
  each_integer(array, layout, 1, [&](std::size_t i, std::size_t, std::int64_t tag) { tags[i] = tag; });
  return tags;
}

Index UnknownNumbers::position(std::int64_t number) {
  const auto [place, is_new] = positions_.try_emplace(number, -1 - static_cast<Index>(numbers_.size()));
  if (is_new) {
    if (numbers_.size() == static_cast<std::size_t>(most_items)) throw std::bad_alloc();
    numbers_.push_back(number);
  }
  return place->second;
}

template <std::size_t Corners>
std::vector<std::array<Index, Corners>> elements_of(const tetproof_integers& array, std::size_t points,
                                                    UnknownNumbers& unknown, const char* name) {
  const Layout layout = layout_of(array, Corners, name);
  if (array.base < -most_base || array.base > most_base)
    refuse_argument(fmt::format("{}: base is {}, expected -2^62 to 2^62", name, array.base));
  std::vector<std::array<Index, Corners>> elements;
  io::resize_in_large_pages(elements, static_cast<std::size_t>(array.count));
  each_integer(array, layout, Corners, [&](std::size_t i, std::size_t k, std::int64_t number) {
    const std::uint64_t position =
        static_cast<std::uint64_t>(number) - static_cast<std::uint64_t>(array.base);
    elements[i][k] =
        number >= array.base && position < points ? static_cast<Index>(position) : unknown.position(number);
  });
  return elements;
}

template std::vector<std::array<Index, 3>> elements_of<3>(const tetproof_integers&, std::size_t,
                                                          UnknownNumbers&, const char*);
template std::vector<std::array<Index, 4>> elements_of<4>(const tetproof_integers&, std::size_t,
                                                          UnknownNumbers&, const char*);

}  // namespace tetproof::c
