// SPDX-License-Identifier: GPL-3.0-or-later
// The page and the fast engine make the same decisions: on random surfaces, with random options.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <iostream>
#include <map>

#include "corpus/random_surface.hpp"
#include "corpus/surfaces.hpp"
#include "tests/property/both_engines.hpp"

namespace tetproof::test {
namespace {

using reference::AdaptOptions;
using reference::Criterion;
using reference::Diagonals;
using reference::Options;
using reference::Region;

struct Case {
  std::string surface;  // the seed of a random surface, or the specification of a generated one
  Options options;
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
  const auto& [nx, ny, nz] = c.options.cells;
  const AdaptOptions& a = *c.options.adapt;
  return out << fmt::format(
             "surface {}, cells {},{},{}, box scale {}, outside {}, shortest {}, on-surface {}, literal {}, "
             "parametric {}, points {}, v0 {}, v1 {}, d1 {}, p {}, e-avg {}, curvature {}, criterion {}, "
             "improve below {}, past dilution {}",
             c.surface, nx, ny, nz, c.options.box_scale, c.options.region == Region::outside,
             c.options.diagonals == Diagonals::shortest, c.options.on_surface, c.options.literal,
             c.options.parametric, a.points, a.v0.value, a.v1.value, a.d1, a.p, a.e_avg.value, a.curvature,
             static_cast<int>(a.improve), a.improve_below, a.past_dilution);
}

// A specification of one of the generators, with parameters from numbers below 1000. All surfaces are small.
std::string generated(int kind, int a, int b, int c) {
  const double x = a / 1000.0, y = b / 1000.0, z = c / 1000.0;
  switch (kind) {
    case 0:
      return fmt::format("sphere:r={},n={},x={},y={},z={}", 0.5 + x, 8 + b / 5, x, y, z);
    case 1:
      return fmt::format("torus:r={},n={},x={}", 0.1 + 0.8 * x, 18 + b / 4, z);
    case 2:
      return fmt::format("wing:naca={:04},span={},n={},x={}", std::array{12, 6, 2412, 4415, 30}[a % 5],
                         0.3 + 3 * z, 20 + b / 4, x);
    case 3:
      return fmt::format("shells:inner={},count=2,n={}", 0.2 + 0.3 * x, 144 + b / 5);
    case 4:
    case 5:
      return fmt::format("random:seed={},n={},roughness={},waves={}", a, 8 + b / 4, 0.9 * z, 4 * x);
    case 6:
      return fmt::format("box:x1={},y1={},z1={},n={}", 0.2 + x, 0.2 + y, 0.2 + z, 1 + a % 3);
    case 7:
      return fmt::format("groove:m={},width=1,depth={},n={}", 3 + a % 2, 1 + b % 2, 1 + c % 2);
    case 8:
      return fmt::format("hollow:m=4,wall={},h={}", 0.1 + x, 0.5 + y);
    case 9:
      return fmt::format("bottle:m=4,wall={},neck={}", 0.5 + x, 0.1 + 0.8 * y);
    default:
      return fmt::format("pair:m={},gap={},x={}", 1 + x, 0.1 + y, z);
  }
}

TriangleSurface surface_of(const std::string& name) {
  if (name.find(':') != std::string::npos) return corpus::make_surface(name);
  return corpus::random_closed_surface(std::stoull(name));
}

// The next seed of a surface with few triangles: the page asks every triangle each time.
std::string small_seed(std::uint64_t seed) {
  while (corpus::random_closed_surface(seed).triangles.size() > 200) ++seed;
  return std::to_string(seed);
}

rc::Gen<std::string> any_surface() {
  const auto number = rc::gen::inRange(0, 1000);
  return rc::gen::oneOf(
      rc::gen::map(rc::gen::inRange<std::uint64_t>(0, 1u << 20), small_seed),
      rc::gen::map(rc::gen::tuple(rc::gen::inRange(0, 11), number, number, number), [](const auto& drawn) {
        const auto& [kind, a, b, c] = drawn;
        return generated(kind, a, b, c);
      }));
}

rc::Gen<Case> any_case() {
  const auto lattice =
      rc::gen::tuple(any_surface(), rc::gen::inRange(3, 7), rc::gen::inRange(3, 7), rc::gen::inRange(3, 7),
                     rc::gen::arbitrary<bool>(), rc::gen::element(1.2, 1.2, 1.5, 2.0, 1.01));
  const auto first_grid = rc::gen::tuple(
      rc::gen::element(Region::inside, Region::outside),
      rc::gen::element(Diagonals::lowest, Diagonals::shortest), rc::gen::element(1e-6, 0.0, 0.15),
      rc::gen::element(false, false, false, false, true), rc::gen::element(true, true, false));
  const auto law = rc::gen::tuple(rc::gen::element(0.2, 0.1, 0.02, 2.0), rc::gen::element(2.0, 1.0, 0.5, 0.1),
                                  rc::gen::element(0.0, 0.0, 0.0, 0.3, 1.0), rc::gen::element(1.0, 0.25, 3.0),
                                  rc::gen::element(0.0, 0.0, 0.0, 0.5), rc::gen::arbitrary<bool>());
  const auto ways =
      rc::gen::tuple(rc::gen::element<std::int64_t>(40, 40, 40, 15, 150, 300),
                     rc::gen::element(Criterion::solid_angle, Criterion::aspect_ratio, Criterion::none),
                     rc::gen::element(0.002, 0.02, 1.0), rc::gen::element(false, false, true));
  const auto made = [](const auto& drawn) {
    const auto& [surface, nx, ny, nz, one_number, box_scale] = std::get<0>(drawn);
    const auto& [region, diagonals, on_surface, literal, parametric] = std::get<1>(drawn);
    const auto& [v0, v1, d1, p, e_avg, curvature] = std::get<2>(drawn);
    const auto& [points, improve, improve_below, past_dilution] = std::get<3>(drawn);
    return Case{surface,
                {.region = region,
                 .cells = one_number ? std::array{nx, 0, 0} : std::array{nx, ny, nz},
                 .box_scale = box_scale,
                 .on_surface = on_surface,
                 .diagonals = diagonals,
                 .literal = literal,
                 .parametric = parametric,
                 .adapt = AdaptOptions{.points = points,
                                       .v0 = {v0},
                                       .v1 = {v1},
                                       .d1 = d1,
                                       .p = p,
                                       .e_avg = {e_avg},
                                       .past_dilution = past_dilution,
                                       .curvature = curvature,
                                       .improve = improve,
                                       .improve_below = improve_below}}};
  };
  // The size of RapidCheck does not matter here: all numbers come from their whole range from the start.
  return rc::gen::resize(100, rc::gen::map(rc::gen::tuple(lattice, first_grid, law, ways), made));
}

// What came up in all cases: their agreement is worth something only if everything did.
struct Tally {
  int cases = 0, equal = 0, tied = 0, refused = 0, adapted = 0;
  std::int64_t ties = 0, insertions = 0, flips = 0, refused_splits = 0, mended = 0, moved = 0, mapped = 0,
               not_mapped = 0, left = 0;
  std::map<std::string, std::int64_t> stops;
  std::array<std::int64_t, reference::tables::table2.size()> table2{};
  std::array<std::int64_t, reference::tables::table3.size()> table3{};
  std::array<std::int64_t, reference::tables::table4.size()> table4{};

  void add(const BothEngines& both);
  void print() const;
};

template <class Table>
void add_to(Table& sum, const Table& table) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += table[i];
}

void Tally::add(const BothEngines& both) {
  ++cases;
  equal += both.equal;
  tied += both.ties > 0;
  ties += both.ties;
  const reference::Generation& made = both.page.made;
  refused += !both.page.refusal.empty();
  mended += made.mended;
  moved += made.moved_to_surface;
  mapped += made.mapped;
  not_mapped += made.not_mapped;
  add_to(table2, made.grid.rows);
  add_to(table3, made.table3);
  if (!made.adaptation) return;
  ++adapted;
  insertions += made.adaptation->insertions;
  flips += made.adaptation->flips;
  refused_splits += made.adaptation->refused;
  left += made.adaptation->left;
  add_to(table4, made.adaptation->rows);
  ++stops[std::string(name_of(made.adaptation->stopped))];
}

template <class Rows, class Counts>
std::string listed(const Rows& rows, const Counts& counts) {
  std::string text;
  for (std::size_t i = 0; i < rows.size(); ++i) text += fmt::format(" {}:{}", rows[i].name, counts[i]);
  return text;
}

void Tally::print() const {
  using namespace reference::tables;
  std::string text = fmt::format(
      "{} cases: {} equal to the byte, {} equal but for {} proven ties; {} refused, {} adapted\n"
      "{} insertions, {} flips, {} refused splits, {} new points left; {} mended, {} moved to the surface, "
      "{} mapped, {} not mapped\nTable 2:{}\nTable 3:{}\nTable 4:{}\nstops:",
      cases, equal, tied, ties, refused, adapted, insertions, flips, refused_splits, left, mended, moved,
      mapped, not_mapped, listed(reference::tables::table2, table2),
      listed(reference::tables::table3, table3), listed(reference::tables::table4, table4));
  for (const auto& [why, times] : stops) text += fmt::format(" {}:{}", why, times);
  std::cout << text << "\n";
}

TEST(Engines, MakeTheSameDecisions) {
  Tally tally;
  const bool all = rc::check("the traces are equal to the byte, or a proven tie", [&] {
    const Case c = *any_case();
    const BothEngines both = run_both(surface_of(c.surface), c.options);
    if (!both.fault.empty()) RC_FAIL(both.fault);
    tally.add(both);
  });
  tally.print();
  EXPECT_TRUE(all);
  if (!all || tally.cases < 500) return;
  EXPECT_GE(tally.equal, tally.cases * 9 / 10);
  EXPECT_GT(tally.insertions, 20 * tally.cases);
  EXPECT_GT(tally.flips, tally.cases);
  EXPECT_GT(tally.mended, 0);
  EXPECT_GT(tally.not_mapped, 0);
}

}  // namespace
}  // namespace tetproof::test
