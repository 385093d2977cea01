// SPDX-License-Identifier: GPL-3.0-or-later
// Each status of the C interface, with its message; and what the boundary makes of exceptions.
#include <cfenv>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>
#include <stdexcept>

#include "io/error.hpp"
#include "tests/c/handles.hpp"
#include "tests/support/meshes.hpp"
#include "verify/c/boundary.hpp"
#include "verify/deadline.hpp"

namespace tetproof::test {
namespace {

constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();

struct CArguments : ::testing::Test {
  const Arrays cube{lattice_mesh({1, 1, 1})};

  // Judges the cube after `change`, which must be refused; returns the message.
  template <class Change>
  std::string refusal(tetproof_status expected, const Change& change) const {
    tetproof_points points = cube.points;
    tetproof_integers tets = cube.tets;
    tetproof_judge_options options = judge_options();
    change(points, tets, options);
    return refused<tetproof_report>(expected, [&](auto** out, auto* error) {
      return tetproof_judge(&points, &tets, nullptr, nullptr, &options, out, error);
    });
  }
  std::string of_points(const tetproof_points& changed,
                        tetproof_status expected = TETPROOF_BAD_ARGUMENT) const {
    return refusal(expected, [&](auto& points, auto&, auto&) { points = changed; });
  }
  std::string of_tets(const tetproof_integers& changed,
                      tetproof_status expected = TETPROOF_BAD_ARGUMENT) const {
    return refusal(expected, [&](auto&, auto& tets, auto&) { tets = changed; });
  }
  template <class Change>
  std::string of_options(const Change& change, tetproof_status expected = TETPROOF_BAD_ARGUMENT) const {
    return refusal(expected, [&](auto&, auto&, auto& options) { change(options); });
  }
};

TEST_F(CArguments, RefusesArraysThatCannotBe) {
  const void* const xyz = cube.xyz.data();
  const void* const corners = cube.corners.data();
  EXPECT_EQ(of_points({nullptr, 8, 0, 0}), "points: count is 8, and data is null");
  EXPECT_EQ(of_points({xyz, -1, 0, 0}), "points: count is -1, expected 0 or more");
  EXPECT_EQ(of_points({xyz, std::int64_t{1} << 31, 0, 0}, TETPROOF_TOO_LARGE),
            "points: count is 2147483648, at most 2147483647 can be numbered");
  EXPECT_EQ(of_points({xyz, 8, most, 0}),
            "points: 8 items with strides 9223372036854775807 and 8 lie outside of all addresses");
  EXPECT_NE(of_points({xyz, 8, most / 8, 0}), "");
  EXPECT_NE(of_points({xyz, 8, -most, 0}), "");
  EXPECT_NE(of_points({xyz, 8, std::numeric_limits<std::int64_t>::min(), 0}), "");
  EXPECT_NE(of_points({xyz, 8, 0, most / 3}), "");
  EXPECT_NE(of_points({xyz, 8, 24, most / 2}), "");
  EXPECT_NE(of_points({xyz, 8, -(std::int64_t{1} << 58), 0}), "");
  EXPECT_EQ(of_tets({corners, 6, 0, 0, 0, 16}), "tets: bits is 16, expected 32 or 64");
  EXPECT_EQ(of_tets({corners, 6, 0, 0, 0, 0}), "tets: bits is 0, expected 32 or 64");
  EXPECT_EQ(of_tets({corners, 6, 0, 0, (std::int64_t{1} << 62) + 1, 64}),
            "tets: base is 4611686018427387905, expected -2^62 to 2^62");
  EXPECT_EQ(of_tets({corners, most, 0, 0, 0, 64}, TETPROOF_TOO_LARGE),
            "tets: count is 9223372036854775807, at most 2147483647 can be numbered");
  EXPECT_EQ(of_tets({corners, 0, 0, 0, 0, 64}, TETPROOF_BAD_INPUT), "the mesh: holds no tetrahedra");
}

TEST_F(CArguments, RefusesOptionsOutOfTheirRange) {
  EXPECT_EQ(of_options([](auto& o) { o.size = 0; }).substr(0, 44),
            "the size of tetproof_judge_options is 0, exp");
  EXPECT_NE(of_options([](auto& o) { ++o.size; }), "");
  EXPECT_NE(of_options([](auto& o) { o.size = SIZE_MAX; }), "");
  EXPECT_EQ(of_options([](auto& o) { o.region = 17; }), "region is 17, expected one of TETPROOF_REGION_...");
  EXPECT_EQ(of_options([](auto& o) { o.region = TETPROOF_REGION_INSIDE; }),
            "region is inside or outside, which needs a surface");
  EXPECT_EQ(of_options([](auto& o) { o.voxels = 1025; }), "voxels is 1025, expected 0 to 1024");
  EXPECT_EQ(of_options([](auto& o) { o.fidelity = NAN; }), "fidelity is nan, expected a number, 0 or more");
  EXPECT_EQ(of_options([](auto& o) { o.deadline = -1; }), "deadline is -1, expected seconds, 0 or more");
  EXPECT_EQ(of_options([](auto& o) { o.threads = -2; }), "threads is -2, expected 0 to 4096");
  EXPECT_EQ(of_options([](auto& o) { o.quality = 2; }), "quality is 2, expected 0 to 1");
  EXPECT_NE(of_options([](auto& o) { o.check = "inverted,nonsense"; }).find("nonsense"), std::string::npos);
  EXPECT_NE(of_options([](auto& o) { o.skip = ","; }), "");
  EXPECT_EQ(of_options([](auto& o) { o.allow = "crack,flat"; }),
            "allow: findings of flat cannot be meant, only those of crack and non-conforming-interface");
  EXPECT_EQ(of_options([](auto& o) { o.region_kind = "colour"; }),
            "region_kind is 'colour', expected physical, entity, attribute or reference");
}

TEST_F(CArguments, GivesUpAfterTheDeadline) {
  EXPECT_EQ(of_options([](auto& o) { o.deadline = 1e-9; }, TETPROOF_OUT_OF_TIME),
            "the verdict took longer than allowed");
  const Surface ball = opened("sphere:r=1,n=500");
  tetproof_mesh_options options = mesh_options();
  options.cells[0] = 16;  // some 6,000 insertions, seconds of them
  options.v0 = options.v1 = 0.01;
  for (const double deadline : {1e-9, 0.2}) {
    options.deadline = deadline;
    refused<tetproof_document>(TETPROOF_OUT_OF_TIME, [&](auto** out, auto* error) {
      return tetproof_mesh(ball.get(), &options, out, error);
    });
  }
}

TEST_F(CArguments, RefusesTagsOfOtherMeshes) {
  const std::int32_t tags[6] = {0, 0, 0, 1, 1, 1};
  const auto judge = [&](const tetproof_integers& regions) {
    return refused<tetproof_report>(TETPROOF_BAD_ARGUMENT, [&](auto** out, auto* error) {
      return tetproof_judge(&cube.points, &cube.tets, &regions, nullptr, nullptr, out, error);
    });
  };
  EXPECT_EQ(judge({tags, 5, 0, 0, 0, 32}), "regions: count is 5, expected 6, that of tets");
  EXPECT_EQ(judge({tags, 6, 0, 0, 1, 32}), "regions: base is 1, expected 0 for tags");
  const auto document = [&](const tetproof_integers* triangles, const tetproof_integers* groups) {
    return refused<tetproof_document>(TETPROOF_BAD_ARGUMENT, [&](auto** out, auto* error) {
      return tetproof_document_from_arrays(&cube.points, &cube.tets, groups, triangles, nullptr, out, error);
    });
  };
  const std::int32_t negative[6] = {0, 0, 0, -1, 1, 1};
  const tetproof_integers five{tags, 5, 0, 0, 0, 32}, signs{negative, 6, 0, 0, 0, 32},
      from_one{tags, 2, 0, 0, 1, 32};
  EXPECT_EQ(document(nullptr, &five), "tet_groups: count is 5, expected 6, that of tets");
  EXPECT_EQ(document(nullptr, &signs), "tet_groups: a tag is -1, expected 0 to 2147483647");
  EXPECT_EQ(document(&from_one, nullptr),
            "the base of tets is 0, and that of triangles 1: expected the same");
}

TEST_F(CArguments, RefusesBadSurfacesAndFiles) {
  const auto open = [](const char* what, const char* format, tetproof_status expected = TETPROOF_BAD_INPUT) {
    return refused<tetproof_surface>(
        expected, [&](auto** out, auto* error) { return tetproof_surface_open(what, format, out, error); });
  };
  EXPECT_EQ(open("/nowhere/part.stl", nullptr), "/nowhere/part.stl: cannot open: No such file or directory");
  EXPECT_NE(open("sphere:colour=red", nullptr).find("colour"), std::string::npos);
  EXPECT_NE(open("-", nullptr).find("cannot open"), std::string::npos);  // and does not wait for input
  EXPECT_NE(open("part.stl", "nonsense").find("nonsense"), std::string::npos);

  const std::int32_t corners[6] = {0, 2, 1, 0, 1, 99};
  const tetproof_integers triangles{corners, 2, 0, 0, 0, 32}, one{corners, 1, 0, 0, 0, 32},
      none{corners, 0, 0, 0, 0, 32};
  const auto surface = [&](const tetproof_integers& of) {
    return refused<tetproof_surface>(TETPROOF_BAD_INPUT, [&](auto** out, auto* error) {
      return tetproof_surface_from_arrays(&cube.points, &of, out, error);
    });
  };
  EXPECT_EQ(surface(triangles), "element 1 names node 99, which does not exist");
  EXPECT_EQ(surface(none), "expected a surface, found no triangles or polygons");
  const Surface open_one = made<tetproof_surface>(
      [&](auto** out, auto* error) { return tetproof_surface_from_arrays(&cube.points, &one, out, error); });
  const auto fault =
      made<char>([&](char** out, auto* error) { return tetproof_surface_fault(open_one.get(), out, error); });
  ASSERT_TRUE(fault);
  EXPECT_EQ(std::string(fault.get()).substr(0, 19), "the surface is open");
  const std::string judged = refused<tetproof_report>(TETPROOF_BAD_INPUT, [&](auto** out, auto* error) {
    return tetproof_judge(&cube.points, &cube.tets, nullptr, open_one.get(), nullptr, out, error);
  });
  EXPECT_EQ(judged, std::string("the surface: ") + fault.get());
  const std::string meshed = refused<tetproof_document>(TETPROOF_BAD_INPUT, [&](auto** out, auto* error) {
    return tetproof_mesh(open_one.get(), nullptr, out, error);
  });
  EXPECT_EQ(meshed, judged);
}

TEST_F(CArguments, RefusesOptionsOfTheMesher) {
  const Surface ball = opened("sphere:r=1,n=100");
  const auto mesh = [&](const auto& change, tetproof_status expected = TETPROOF_BAD_ARGUMENT) {
    tetproof_mesh_options options = mesh_options();
    change(options);
    return refused<tetproof_document>(
        expected, [&](auto** out, auto* error) { return tetproof_mesh(ball.get(), &options, out, error); });
  };
  EXPECT_NE(mesh([](auto& o) { o.size = 8; }), "");
  EXPECT_EQ(mesh([](auto& o) { o.region = TETPROOF_REGION_DEFAULT; }),
            "region is 0, expected TETPROOF_REGION_INSIDE or _OUTSIDE");
  EXPECT_EQ(mesh([](auto& o) { o.p = NAN; }), "p: expected a positive number, found nan");
  EXPECT_EQ(mesh([](auto& o) { o.improve = 3; }), "improve is 3, expected 0 to 2");
  EXPECT_EQ(mesh([](auto& o) { o.points = -2; }), "points: expected a number, not negative, found -2");
  EXPECT_NE(mesh([](auto& o) { o.cells[0] = -5; }, TETPROOF_BAD_INPUT).find("-5"), std::string::npos);
  EXPECT_NE(mesh([](auto& o) { o.cells[0] = 2147483647; }, TETPROOF_BAD_INPUT).find("too large"),
            std::string::npos);
  EXPECT_NE(mesh([](auto& o) { o.box_scale = 0.5; }, TETPROOF_BAD_INPUT).find("box scale"),
            std::string::npos);
}

TEST(CBoundary, GivesEachExceptionItsStatus) {
  tetproof_error error;
  const auto status = [&](const auto& thrown) { return c::guarded(&error, [&] { throw thrown; }); };
  EXPECT_EQ(status(InputError("a.off:3: expected a number")), TETPROOF_BAD_INPUT);
  EXPECT_STREQ(error.message, "a.off:3: expected a number");
  EXPECT_EQ(status(std::bad_alloc()), TETPROOF_OUT_OF_MEMORY);
  EXPECT_STREQ(error.message, "out of memory");
  EXPECT_EQ(status(verify::OutOfTime()), TETPROOF_OUT_OF_TIME);
  EXPECT_EQ(status(std::logic_error("two\nlines")), TETPROOF_INTERNAL);
  EXPECT_STREQ(error.message, "internal error, please report it with the input: two\\x0Alines");
  EXPECT_EQ(status(7), TETPROOF_INTERNAL);
  EXPECT_EQ(c::guarded(nullptr, [] { throw std::bad_alloc(); }), TETPROOF_OUT_OF_MEMORY);
  EXPECT_EQ(c::guarded(&error, [] {}), TETPROOF_OK);
  EXPECT_EQ(error.status, TETPROOF_OK);
  EXPECT_STREQ(error.message, "");
}

TEST(CBoundary, CutsLongMessagesAtACharacter) {
  tetproof_error error;
  for (std::size_t shift = 0; shift < 5; ++shift) {
    std::string message(shift, 'a');
    while (message.size() < 1100) message += "\u20AC";  // three bytes
    EXPECT_EQ(c::report_error(&error, TETPROOF_BAD_INPUT, message.c_str()), TETPROOF_BAD_INPUT);
    const std::string cut = error.message;
    EXPECT_GE(cut.size(), sizeof error.message - 4);
    EXPECT_LT(cut.size(), sizeof error.message);
    ASSERT_EQ(cut.substr(cut.size() - 3), "...");
    EXPECT_EQ((cut.size() - 3 - shift) % 3, 0u);
    EXPECT_EQ(message.substr(0, cut.size() - 3), cut.substr(0, cut.size() - 3));
  }
  const std::string fits(sizeof error.message - 1, 'x');
  c::report_error(&error, TETPROOF_BAD_INPUT, fits.c_str());
  EXPECT_EQ(error.message, fits);
}

TEST(CBoundary, KeepsTheCallersEnvironment) {
  std::fesetround(FE_UPWARD);
  int inside = -1;
  c::guarded(nullptr, [&] { inside = std::fegetround(); });
  const int after = std::fegetround();
  std::fesetround(FE_TONEAREST);
  EXPECT_EQ(inside, FE_TONEAREST);
  EXPECT_EQ(after, FE_UPWARD);
}

TEST(CBoundary, NamesEachStatus) {
  EXPECT_STREQ(tetproof_status_name(TETPROOF_OK), "TETPROOF_OK");
  EXPECT_STREQ(tetproof_status_name(TETPROOF_INTERNAL), "TETPROOF_INTERNAL");
  EXPECT_STREQ(tetproof_status_name(8), "unknown status");
  EXPECT_STREQ(tetproof_status_name(-1), "unknown status");
}

}  // namespace
}  // namespace tetproof::test
