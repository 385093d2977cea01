// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of the C interface share: objects that free themselves, and meshes as packed arrays.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "io/tet_mesh.hpp"
#include "io/triangle_surface.hpp"
#include "verify/c/tetproof.h"

namespace tetproof::test {

struct Free {
  void operator()(tetproof_surface* surface) const { tetproof_surface_free(surface); }
  void operator()(tetproof_document* document) const { tetproof_document_free(document); }
  void operator()(tetproof_report* report) const { tetproof_report_free(report); }
  void operator()(char* text) const { tetproof_text_free(text); }
};
using Surface = std::unique_ptr<tetproof_surface, Free>;
using FileDocument = std::unique_ptr<tetproof_document, Free>;
using Report = std::unique_ptr<tetproof_report, Free>;

/// The object or text that a call makes, which must succeed: `made([&](auto** out, auto* error) { ... })`.
template <class Object, class Call>
std::unique_ptr<Object, Free> made(const Call& call) {
  Object* object = nullptr;
  tetproof_error error;
  const tetproof_status status = call(&object, &error);
  EXPECT_EQ(status, TETPROOF_OK) << error.message;
  EXPECT_EQ(error.status, status);
  return std::unique_ptr<Object, Free>(object);
}

/// The message of a call that must fail with this status, and make nothing.
template <class Object, class Call>
std::string refused(tetproof_status expected, const Call& call) {
  static char anything;  // results must become null, whatever they were
  Object* object = reinterpret_cast<Object*>(&anything);
  tetproof_error error;
  EXPECT_EQ(call(&object, &error), expected) << error.message;
  EXPECT_EQ(error.status, expected);
  EXPECT_EQ(object, nullptr);
  return error.message;
}

inline Surface opened(const char* spec) {
  return made<tetproof_surface>(
      [&](auto** out, auto* error) { return tetproof_surface_open(spec, nullptr, out, error); });
}

inline std::string json_of(const Report& report) {
  const auto text =
      made<char>([&](char** out, auto* error) { return tetproof_report_json(report.get(), out, error); });
  return text ? text.get() : "";
}

inline tetproof_judge_options judge_options() {
  tetproof_judge_options options;
  EXPECT_EQ(tetproof_judge_options_init(&options, sizeof options, nullptr), TETPROOF_OK);
  return options;
}

inline tetproof_mesh_options mesh_options() {
  tetproof_mesh_options options;
  EXPECT_EQ(tetproof_mesh_options_init(&options, sizeof options, nullptr), TETPROOF_OK);
  return options;
}

/// The arrays of a mesh, with 64-bit indices that count from `base`.
struct Arrays {
  std::vector<double> xyz;
  std::vector<std::int64_t> corners;
  tetproof_points points{};
  tetproof_integers tets{};

  explicit Arrays(const TetMesh& mesh, std::int64_t base = 0) {
    for (const auto& point : mesh.points) xyz.insert(xyz.end(), {point.x(), point.y(), point.z()});
    for (const auto& tet : mesh.tets)
      for (const Index corner : tet) corners.push_back(corner + base);
    points = {.data = xyz.data(), .count = static_cast<std::int64_t>(mesh.points.size())};
    tets = {.data = corners.data(),
            .count = static_cast<std::int64_t>(mesh.tets.size()),
            .base = base,
            .bits = 64};
  }
  Arrays(const Arrays&) = delete;
  Arrays& operator=(const Arrays&) = delete;
};

inline Report judged(const tetproof_points& points, const tetproof_integers& tets,
                     const tetproof_surface* surface = nullptr,
                     const tetproof_judge_options* options = nullptr) {
  return made<tetproof_report>([&](auto** out, auto* error) {
    return tetproof_judge(&points, &tets, nullptr, surface, options, out, error);
  });
}

}  // namespace tetproof::test
