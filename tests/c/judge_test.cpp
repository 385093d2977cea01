// SPDX-License-Identifier: GPL-3.0-or-later
// The judge of the C interface gives the report that C++ gives, however the arrays lie in memory.
#include <cmath>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "corpus/bad_meshes.hpp"
#include "io/mesh_files.hpp"
#include "tests/c/handles.hpp"
#include "tests/support/meshes.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using nlohmann::json;

// As tetproof-verify judges a file.
std::string json_by_cpp(const std::string& path) {
  const Document document = read_document(path);
  verify::Options options;
  TetRegions regions = tet_regions(document);
  options.regions = std::move(regions.of_tet);
  options.region_tags = std::move(regions.tags);
  options.unjudged = verify::unjudged(document);
  return verify::report_json(verify::verify(tet_mesh(document), options), numbering(document));
}

TEST(CJudge, GivesTheReportOfEveryBadMesh) {
  const auto meshes = corpus::bad_meshes();
  ASSERT_GT(meshes.size(), 100u);
  int defective = 0, sound = 0;
  for (const corpus::BadMesh& bad : meshes) {
    const Arrays arrays(bad.planted.mesh, 1);
    const Report report = judged(arrays.points, arrays.tets);
    ASSERT_TRUE(report) << bad.name;
    ASSERT_EQ(json_of(report), json_by_cpp(TETPROOF_SOURCE_DIR "/corpus/bad-meshes/" + bad.name + ".node"))
        << bad.name;
    defective += tetproof_report_records(report.get())->verdict == TETPROOF_DEFECTIVE;
    sound += tetproof_report_records(report.get())->verdict == TETPROOF_SOUND;
  }
  EXPECT_GT(defective, 60);
  EXPECT_GT(sound, 5);
}

// The same mesh, whose arrays lie in memory in any way.
TEST(CJudge, TakesEveryLayout) {
  TetMesh mesh = lattice_mesh({2, 2, 2});
  std::swap(mesh.tets[7][0], mesh.tets[7][1]);
  mesh.tets[9][2] = 1000;
  mesh.points[4].x() = NAN;
  const auto n = static_cast<std::int64_t>(mesh.points.size()),
             m = static_cast<std::int64_t>(mesh.tets.size());
  struct Case {
    const char* name;
    std::int64_t point_stride, point_component, tet_stride, tet_component, base;
    int bits;
  };
  const Case cases[] = {
      {"packed, 32 bits", 24, 8, 16, 4, 0, 32},
      {"packed, 64 bits", 24, 8, 32, 8, 0, 64},
      {"Fortran's columns", 8, 8 * n, 4, 4 * m, 1, 32},
      {"Fortran's columns, 64 bits", 8, 8 * n, 8, 8 * m, 1, 64},
      {"records, not aligned", 37, 9, 31, 5, -7, 32},
      {"backwards", -24, 8, -32, 8, 1, 64},
      {"all backwards", -40, -12, -64, -13, 1'000'000'000'000, 64},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    const std::int64_t room = 200'000;
    std::vector<char> memory(static_cast<std::size_t>(2 * room), 0x5A);
    char* const points = memory.data() + room / 2;
    char* const tets = memory.data() + room + room / 2;
    const auto put = [](char* to, auto value) { std::memcpy(to, &value, sizeof value); };
    for (std::int64_t i = 0; i < n; ++i)
      for (std::int64_t k = 0; k < 3; ++k)
        put(points + i * c.point_stride + k * c.point_component, mesh.points[static_cast<std::size_t>(i)][k]);
    for (std::int64_t i = 0; i < m; ++i)
      for (std::int64_t k = 0; k < 4; ++k) {
        char* const place = tets + i * c.tet_stride + k * c.tet_component;
        const std::int64_t number =
            mesh.tets[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] + c.base;
        if (c.bits == 32)
          put(place, static_cast<std::int32_t>(number));
        else
          put(place, number);
      }
    const Report report = judged({points, n, c.point_stride, c.point_component},
                                 {tets, m, c.tet_stride, c.tet_component, c.base, c.bits});
    const Arrays packed(mesh, c.base);
    EXPECT_EQ(json_of(report), json_of(judged(packed.points, packed.tets)));
    const json read = json::parse(json_of(report));
    EXPECT_EQ(read["checks"][0]["id"], "index-range");
    EXPECT_EQ(read["checks"][0]["findings"][0]["tets"][0], 9 + c.base);
    EXPECT_EQ(read["checks"][0]["findings"][0]["vertices"][0], 1000 + c.base);
    EXPECT_EQ(read["mesh"]["tets"], m);
  }
}

TEST(CJudge, ComparesWithSurfacesOfEveryOrigin) {
  TetMesh mesh = lattice_mesh({2, 2, 2});
  const TriangleSurface cube = boundary_surface(mesh);
  // A soup: each triangle has vertices of its own, as in an STL.
  std::vector<double> xyz;
  std::vector<std::int32_t> corners;
  for (const auto& triangle : cube.triangles)
    for (const Index v : triangle) {
      corners.push_back(static_cast<std::int32_t>(corners.size()) + 1);
      for (int k = 0; k < 3; ++k) xyz.push_back(cube.vertices[static_cast<std::size_t>(v)][k]);
    }
  const auto triangles = static_cast<std::int64_t>(cube.triangles.size());
  const tetproof_points vertices{.data = xyz.data(), .count = 3 * triangles};
  const tetproof_integers indices{.data = corners.data(), .count = triangles, .base = 1, .bits = 32};
  const Surface of_arrays = made<tetproof_surface>(
      [&](auto** out, auto* error) { return tetproof_surface_from_arrays(&vertices, &indices, out, error); });
  EXPECT_EQ(tetproof_surface_view(of_arrays.get())->vertex_count, 26);
  EXPECT_EQ(tetproof_surface_view(of_arrays.get())->triangle_count, 48);
  const FileDocument document = made<tetproof_document>([&](auto** out, auto* error) {
    return tetproof_document_from_arrays(&vertices, nullptr, nullptr, &indices, nullptr, out, error);
  });
  const Surface of_document = made<tetproof_surface>(
      [&](auto** out, auto* error) { return tetproof_surface_from_document(document.get(), out, error); });

  mesh.tets.pop_back();
  const Arrays arrays(mesh);
  tetproof_judge_options options = judge_options();
  options.voxels = 16;
  options.fidelity = 0;
  const std::string by_cpp = verify::report_json(
      verify::verify(mesh, cube, {.region = verify::Region::inside, .fidelity = 0, .voxels = 16}));
  EXPECT_EQ(json_of(judged(arrays.points, arrays.tets, of_arrays.get(), &options)), by_cpp);
  EXPECT_EQ(json_of(judged(arrays.points, arrays.tets, of_document.get(), &options)), by_cpp);
  EXPECT_NE(by_cpp.find("missing-region"), std::string::npos);
}

// The records say what the JSON says.
void expect_same_checks(const tetproof_check* const* checks, std::int64_t count, const json& all) {
  ASSERT_EQ(count, static_cast<std::int64_t>(all.size()));
  const char* const verdicts[] = {"pass", "warning", "fail", "undecided", "skipped"};
  for (std::int64_t c = 0; c < count; ++c) {
    const tetproof_check& check = *checks[c];
    const json& in = all[static_cast<std::size_t>(c)];
    SCOPED_TRACE(check.id);
    EXPECT_EQ(check.id, in["id"]);
    EXPECT_EQ(verdicts[check.verdict], in["verdict"]);
    EXPECT_EQ(check.exact == 1, in["exact"]);
    EXPECT_EQ(check.count, in["count"]);
    EXPECT_EQ(check.consequences, in["consequences"]);
    EXPECT_EQ(std::isnan(check.measured), in["measured"].is_null());
    EXPECT_TRUE(std::isnan(check.measured) || check.measured == in["measured"]);
    EXPECT_EQ(std::isnan(check.allowed), in["allowed"].is_null());
    EXPECT_EQ(check.why, in.value("why", ""));
    ASSERT_EQ(check.finding_count, static_cast<std::int64_t>(in["findings"].size()));
    for (std::int64_t f = 0; f < check.finding_count; ++f) {
      const tetproof_finding& finding = *check.findings[f];
      const json& one = in["findings"][static_cast<std::size_t>(f)];
      EXPECT_EQ(json(std::vector<std::int64_t>(finding.tets, finding.tets + finding.tet_count)), one["tets"]);
      EXPECT_EQ(json(std::vector<std::int64_t>(finding.vertices, finding.vertices + finding.vertex_count)),
                one["vertices"]);
      ASSERT_EQ(finding.face_count, static_cast<std::int64_t>(one["faces"].size()));
      for (std::int64_t k = 0; k < 3 * finding.face_count; ++k)
        EXPECT_EQ(finding.faces[k],
                  one["faces"][static_cast<std::size_t>(k / 3)][static_cast<std::size_t>(k % 3)]);
      EXPECT_EQ(finding.has_point == 0, one["point"].is_null());
      for (std::size_t k = 0; k < 3 && finding.has_point; ++k) EXPECT_EQ(finding.point[k], one["point"][k]);
      EXPECT_EQ(finding.point_exact[0] == nullptr, one["point_exact"].is_null());
      for (std::size_t k = 0; k < 3 && finding.point_exact[0]; ++k)
        EXPECT_EQ(finding.point_exact[k], one["point_exact"][k]);
      EXPECT_EQ(finding.what, one["what"]);
      ASSERT_EQ(finding.consequence_count, static_cast<std::int64_t>(one["consequences"].size()));
      for (std::int64_t k = 0; k < finding.consequence_count; ++k)
        EXPECT_EQ(finding.consequences[k]->check, one["consequences"][static_cast<std::size_t>(k)]["check"]);
      EXPECT_EQ(finding.tet_run_count > 0, one.contains("tet_runs"));
      for (std::int64_t k = 0; k < 2 * finding.tet_run_count; ++k)
        EXPECT_EQ(finding.tet_runs[k],
                  one["tet_runs"][static_cast<std::size_t>(k / 2)][static_cast<std::size_t>(k % 2)]);
    }
  }
}

void expect_same(const Report& report) {
  const tetproof_records& r = *tetproof_report_records(report.get());
  const json all = json::parse(json_of(report));
  const char* const words[] = {"sound", "defective", "incomplete"};
  EXPECT_EQ(words[r.verdict], all["verdict"]);
  EXPECT_EQ(r.certificate, all["certificate"].is_null() ? -1 : all["certificate"] ? 1 : 0);
  expect_same_checks(r.checks, r.check_count, all["checks"]);
  const auto expect_shape = [](const tetproof_shape& shape, const json& in) {
    EXPECT_EQ(shape.points, in["points"]);
    EXPECT_EQ(shape.boundary_faces, in.contains("tets") ? in["boundary_faces"] : in["triangles"]);
    EXPECT_EQ(shape.components, in["components"].is_null() ? json(-1) : in["components"]);
    EXPECT_EQ(shape.cavities, in["cavities"].is_null() ? json(-1) : in["cavities"]);
    EXPECT_EQ(shape.genus, in["genus"].is_null() ? json(-1) : in["genus"]);
    EXPECT_EQ(json(std::vector<std::int64_t>(shape.genus_per_component,
                                             shape.genus_per_component + shape.genus_count)),
              in["genus_per_component"]);
    EXPECT_TRUE(std::isnan(shape.volume) || shape.volume == in["volume"]);
    EXPECT_EQ(std::isnan(shape.volume), in["volume"].is_null());
  };
  expect_shape(*r.mesh, all["mesh"]);
  ASSERT_EQ(r.surface == nullptr, all["surface"].is_null());
  if (r.surface) expect_shape(*r.surface, all["surface"]);
  ASSERT_EQ(r.region_count, static_cast<std::int64_t>(all["regions"].size()));
  for (std::int64_t i = 0; i < r.region_count; ++i) {
    const json& in = all["regions"][static_cast<std::size_t>(i)];
    EXPECT_EQ(r.regions[i]->tag, in["tag"]);
    EXPECT_EQ(r.regions[i]->kind, in["kind"]);
    expect_shape(r.regions[i]->shape, in);
  }
  EXPECT_EQ(r.not_judged_count, static_cast<std::int64_t>(all["not_judged"].size()));
  for (std::int64_t i = 0; i < r.not_judged_count; ++i)
    EXPECT_EQ(r.not_judged[i]->what, all["not_judged"][static_cast<std::size_t>(i)]["what"]);
  EXPECT_EQ(r.left_out_count, static_cast<std::int64_t>(all["left_out"].size()));
  ASSERT_EQ(r.fidelity == nullptr, !all.contains("fidelity"));
  EXPECT_TRUE(!r.fidelity || r.fidelity->allowed == all["fidelity"]["allowed"]);
  ASSERT_EQ(r.quality == nullptr, !all.contains("quality"));
  if (r.quality) {
    EXPECT_EQ(r.quality->tets, all["quality"]["tets"]);
    const tetproof_distribution& angles = r.quality->dihedral_angles;
    const json& min = all["quality"]["dihedral_angles"]["min"];
    EXPECT_TRUE(min.is_null() ? std::isnan(angles.min) : angles.min == min);
    EXPECT_EQ(json(std::vector<std::int64_t>(angles.counts, angles.counts + angles.bin_count)),
              all["quality"]["dihedral_angles"]["histogram"]["counts"]);
  }
  EXPECT_EQ(r.note_count, static_cast<std::int64_t>(all["notes"].size()));
  EXPECT_EQ(std::isnan(r.volume->voxel_inside), all["volume"]["voxel_inside"].is_null());
  ASSERT_EQ(r.mended_how == nullptr, !all.contains("if_mended"));
  if (!r.mended_how) return;
  EXPECT_EQ(r.mended_how, all["if_mended"]["how"]);
  expect_same_checks(r.mended_checks, r.mended_check_count, all["if_mended"]["checks"]);
}

TEST(CJudge, HasRecordsThatSayWhatTheJsonSays) {
  int mended = 0;
  for (const corpus::BadMesh& bad : corpus::bad_meshes()) {
    SCOPED_TRACE(bad.name);
    const Arrays arrays(bad.planted.mesh, 1);
    tetproof_judge_options options = judge_options();
    options.check = bad.name == "sound-block" ? "inverted,flat" : nullptr;
    const Report report = judged(arrays.points, arrays.tets, nullptr, &options);
    expect_same(report);
    mended += tetproof_report_records(report.get())->mended_how != nullptr;
  }
  EXPECT_GT(mended, 2);
  const Surface ball = opened("sphere:r=1,n=500");
  tetproof_mesh_options cut = mesh_options();
  cut.cells[0] = 8;
  cut.points = 0;
  const FileDocument grid = made<tetproof_document>(
      [&](auto** out, auto* error) { return tetproof_mesh(ball.get(), &cut, out, error); });
  expect_same(made<tetproof_report>([&](auto** out, auto* error) {
    return tetproof_judge_document(grid.get(), ball.get(), nullptr, out, error);
  }));
}

TEST(CJudge, GivesRegionsAnAccountEach) {
  const TetMesh mesh = lattice_mesh({2, 1, 1});
  const Arrays arrays(mesh);
  std::vector<std::int32_t> tags(12, -3);
  for (std::size_t i = 6; i < 12; ++i) tags[i] = 40;
  const tetproof_integers regions{.data = tags.data(), .count = 12, .bits = 32};
  tetproof_judge_options options = judge_options();
  options.region_kind = "attribute";
  const Report report = made<tetproof_report>([&](auto** out, auto* error) {
    return tetproof_judge(&arrays.points, &arrays.tets, &regions, nullptr, &options, out, error);
  });
  expect_same(report);
  const tetproof_records& r = *tetproof_report_records(report.get());
  ASSERT_EQ(r.region_count, 2);
  EXPECT_EQ(r.regions[0]->tag, -3);
  EXPECT_EQ(r.regions[1]->tag, 40);
  EXPECT_STREQ(r.regions[1]->kind, "attribute");
  EXPECT_EQ(r.regions[1]->shape.tets, 6);
  EXPECT_EQ(r.regions[1]->shape.volume, 1);
}

TEST(CJudge, HasTheTableOfChecks) {
  int position = 0;
  for (; const tetproof_check_info* info = tetproof_check_info_at(position); ++position) {
    const verify::CheckInfo& of = verify::info(static_cast<verify::Check>(position));
    EXPECT_STREQ(info->id, of.id);
    EXPECT_EQ(info->needs_surface == 1, of.needs_surface);
    EXPECT_EQ(info->for_certificate == 1, of.certificate);
  }
  EXPECT_EQ(position, verify::check_count);
}

}  // namespace
}  // namespace tetproof::test
