// SPDX-License-Identifier: GPL-3.0-or-later
// The modifiers of random surfaces: affine maps with a positive determinant, rounding, and other numbers.
#include <algorithm>
#include <numeric>

#include "corpus/fuzz/decimals.hpp"
#include "corpus/fuzz/kind.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

void offset(TriangleSurface& surface, const Numbers& values) {
  const Eigen::Vector3d by(values["x"], values["y"], values["z"]);
  for (Eigen::Vector3d& v : surface.vertices) v += by;
}

void scale(TriangleSurface& surface, const Numbers& values) {
  const Eigen::Vector3d by(values["x"], values["y"], values["z"]);
  for (Eigen::Vector3d& v : surface.vertices) v = v.cwiseProduct(by);
}

void shear(TriangleSurface& surface, const Numbers& values) {
  const double xy = values["xy"], xz = values["xz"], yz = values["yz"];
  for (Eigen::Vector3d& v : surface.vertices) v = {v[0] + xy * v[1] + xz * v[2], v[1] + yz * v[2], v[2]};
}

// The rotation of the quaternion a + b i + c j + d k: its matrix is rational.
void rotate(TriangleSurface& surface, const Numbers& values) {
  const double a = values["a"], b = values["b"], c = values["c"], d = values["d"];
  const double norm = a * a + b * b + c * c + d * d;
  if (norm == 0) throw InputError("a: expected a number other than 0 among a, b, c, d");
  const double entries[3][3] = {{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
                                {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
                                {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d}};
  const int digits = values.integer("digits");
  double turned[3][3];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      turned[i][j] = entries[i][j] / norm;
      if (digits > 0) turned[i][j] = to_significant_digits(turned[i][j], digits);
    }
  for (Eigen::Vector3d& v : surface.vertices) {
    const Eigen::Vector3d p = v;
    for (int i = 0; i < 3; ++i) v[i] = turned[i][0] * p[0] + turned[i][1] * p[1] + turned[i][2] * p[2];
  }
}

void size(TriangleSurface& surface, const Numbers& values) {
  for (Eigen::Vector3d& v : surface.vertices) v *= values["s"];
}

// g++ 12 leaves out the conversion of the last vertex's x and y where it vectorizes this loop (-O3): the
// number is kept out of its reach.
double as_float(double x) {
  const volatile float single = static_cast<float>(x);
  return single;
}

void floats(TriangleSurface& surface, const Numbers&) {
  for (Eigen::Vector3d& v : surface.vertices)
    for (int k = 0; k < 3; ++k) v[k] = as_float(v[k]);
}

void decimals(TriangleSurface& surface, const Numbers& values) {
  for (Eigen::Vector3d& v : surface.vertices)
    for (int k = 0; k < 3; ++k) v[k] = to_significant_digits(v[k], values.integer("digits"));
}

void renumber(TriangleSurface& surface, const Numbers& values) {
  Random random = values.random();
  std::vector<Index> order(surface.vertices.size());
  std::iota(order.begin(), order.end(), 0);
  shuffle(order, random);
  std::vector<Eigen::Vector3d> vertices(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    vertices[static_cast<std::size_t>(order[i])] = surface.vertices[i];
  surface.vertices = std::move(vertices);
  for (auto& triangle : surface.triangles) {
    for (Index& corner : triangle) corner = order[static_cast<std::size_t>(corner)];
    std::rotate(triangle.begin(), triangle.begin() + random.below(3), triangle.end());
  }
  shuffle(surface.triangles, random);
}

FuzzParameter factor(const char* key) {
  return {key, Draw::length, 1e-9, 1e9, 1e-3, 1e3, 1, "factor"};
}
FuzzParameter slope(const char* key, const char* meaning) {
  return {key, Draw::share, -1e6, 1e6, -3, 3, 0, meaning};
}
FuzzParameter shift(const char* key) {
  return {key, Draw::length, -1e15, 1e15, 1e3, 1e9, 0, "is added"};
}
FuzzParameter quaternion(const char* key, double simplest) {
  return {key, Draw::integer, -1000, 1000, 0, 9, simplest, "of the rotation a + b i + c j + d k"};
}
FuzzParameter digits(double least, double low, double high, double simplest, const char* meaning) {
  return {"digits", Draw::integer, least, 17, low, high, simplest, meaning};
}

}  // namespace

const std::vector<FuzzModifier>& fuzz_modifiers() {
  static const std::vector<FuzzModifier> all{
      {"scale", "scaled along the axes", {factor("x"), factor("y"), factor("z")}, scale, 0},
      {"shear",
       "skewed",
       {slope("xy", "of y, added to x"), slope("xz", "of z, added to x"), slope("yz", "of z, added to y")},
       shear,
       1},
      {"rotate",
       "rotated",
       {quaternion("a", 1), quaternion("b", 0), quaternion("c", 0), quaternion("d", 0),
        digits(0, 0, 4, 0, "of the matrix's entries; 0: all")},
       rotate,
       2},
      {"size",
       "scaled as a whole; random recipes have it only if extreme sizes are asked for",
       {{"s", Draw::length, 1e-90, 1e90, 1e-60, 1e60, 1, "factor"}},
       size,
       3},
      {"offset", "moved away from the origin", {shift("x"), shift("y"), shift("z")}, offset, 4},
      {"floats", "coordinates rounded to single precision", {}, floats, 5},
      {"decimals",
       "coordinates rounded to decimal numbers",
       {digits(1, 4, 16, 17, "significant digits")},
       decimals,
       5},
      {"renumber", "vertices and triangles in another order", {seed_parameter()}, renumber, 6},
  };
  return all;
}

}  // namespace tetproof::corpus
