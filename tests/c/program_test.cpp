// SPDX-License-Identifier: GPL-3.0-or-later
// The C interface gives the bytes of the programs for the same files, and prints nothing.
#include <nlohmann/json.hpp>

#include "corpus/bad_meshes.hpp"
#include "tests/c/handles.hpp"
#include "tests/support/run_program.hpp"

namespace tetproof::test {
namespace {

using nlohmann::json;

std::string bad_mesh(const std::string& name) {
  return TETPROOF_SOURCE_DIR "/corpus/bad-meshes/" + name;
}

std::string json_of_program(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), program("tetproof-verify"));
  arguments.insert(arguments.end(), {"--json", "-", "--quiet"});
  return run_program(arguments).out;
}

std::string json_of_file(const std::string& path, const Surface& surface,
                         const tetproof_judge_options* options) {
  const FileDocument document = made<tetproof_document>(
      [&](auto** out, auto* error) { return tetproof_document_read(path.c_str(), nullptr, out, error); });
  return json_of(made<tetproof_report>([&](auto** out, auto* error) {
    return tetproof_judge_document(document.get(), surface.get(), options, out, error);
  }));
}

TEST(CProgram, GivesTheBytesOfTetproofVerify) {
  const std::vector<corpus::BadMesh> meshes = corpus::bad_meshes();
  for (const char* name :
       {"sound-ball", "sound-block", "inverted-and-hanging", "index-far-too-high", "nan-inside",
        "crack-through-mesh", "inverted-all", "blocks-interpenetrate", "tet-three-times"}) {
    SCOPED_TRACE(name);
    const std::string expected = json_of_program({bad_mesh(name) + ".node"});
    ASSERT_NE(expected.find("\"verdict\""), std::string::npos);
    EXPECT_EQ(json_of_file(bad_mesh(name) + ".node", nullptr, nullptr), expected);
    for (const corpus::BadMesh& bad : meshes)
      if (bad.name == name) {
        const Arrays arrays(bad.planted.mesh, 1);
        EXPECT_EQ(json_of(judged(arrays.points, arrays.tets)), expected);
      }
  }
}

TEST(CProgram, GivesTheBytesOfTetproofVerifyWithASurface) {
  const ScratchFolder files;
  const std::string spec = "sphere:r=1,n=500";
  const Surface ball = opened(spec.c_str());
  tetproof_mesh_options cut = mesh_options();
  cut.cells[0] = 8;
  const FileDocument grid = made<tetproof_document>(
      [&](auto** out, auto* error) { return tetproof_mesh(ball.get(), &cut, out, error); });
  ASSERT_EQ(tetproof_document_write(grid.get(), (files / "grid.msh").c_str(), nullptr, nullptr), TETPROOF_OK);
  tetproof_judge_options options = judge_options();
  EXPECT_EQ(json_of_file(files / "grid.msh", ball, &options), json_of_program({files / "grid.msh", spec}));
  options.fidelity = 0.3;
  options.voxels = 20;
  options.strict_topology = 1;
  options.skip = "normals,topology";
  const std::string with_options = json_of_program({files / "grid.msh", spec, "--fidelity", "0.3", "--voxels",
                                                    "20", "--strict-topology", "--skip", "normals,topology"});
  EXPECT_EQ(json_of_file(files / "grid.msh", ball, &options), with_options);
  const tetproof_document_arrays* a = nullptr;
  ASSERT_EQ(tetproof_document_view(grid.get(), &a, nullptr), TETPROOF_OK);
  std::vector<std::int64_t> from_one(a->tets, a->tets + 4 * a->tet_count);
  for (std::int64_t& corner : from_one) ++corner;
  EXPECT_EQ(json_of(judged({a->points, a->point_count, 0, 0}, {from_one.data(), a->tet_count, 0, 0, 1, 64},
                           ball.get(), &options)),
            with_options);
  options = judge_options();
  options.region = TETPROOF_REGION_OUTSIDE;
  options.check = "inverted,volume-surface";
  EXPECT_EQ(json_of_file(files / "grid.msh", ball, &options),
            json_of_program(
                {files / "grid.msh", spec, "--region", "outside", "--check", "inverted,volume-surface"}));
}

TEST(CProgram, ShowsTheDefectsThatTetproofVerifyShows) {
  const ScratchFolder files;
  const std::string path = bad_mesh("inverted-and-hanging.node");
  ASSERT_EQ(run_program({program("tetproof-verify"), path, "--defects", files / "expected.vtu"}).exit_code,
            1);
  const FileDocument document = made<tetproof_document>(
      [&](auto** out, auto* error) { return tetproof_document_read(path.c_str(), nullptr, out, error); });
  const tetproof_document_arrays* a = nullptr;
  ASSERT_EQ(tetproof_document_view(document.get(), &a, nullptr), TETPROOF_OK);
  std::vector<std::int64_t> from_one(a->tets, a->tets + 4 * a->tet_count);
  for (std::int64_t& corner : from_one) ++corner;
  const tetproof_points points{a->points, a->point_count, 0, 0};
  tetproof_integers tets{from_one.data(), a->tet_count, 0, 0, 1, 64};
  const Report of_arrays = judged(points, tets),
               of_document = made<tetproof_report>([&](auto**out, auto*error) {
                 return tetproof_judge_document(document.get(), nullptr, nullptr, out, error);
               });
  const auto bytes = [&](const FileDocument& defects) {
    EXPECT_EQ(tetproof_document_write(defects.get(), (files / "defects.vtu").c_str(), nullptr, nullptr),
              TETPROOF_OK);
    return files.read("defects.vtu");
  };
  EXPECT_EQ(bytes(made<tetproof_document>([&](auto** out, auto* error) {
              return tetproof_report_defects(of_arrays.get(), &points, &tets, out, error);
            })),
            files.read("expected.vtu"));
  EXPECT_EQ(bytes(made<tetproof_document>([&](auto** out, auto* error) {
              return tetproof_report_document_defects(of_document.get(), document.get(), out, error);
            })),
            files.read("expected.vtu"));
  --tets.count;
  EXPECT_NE(refused<tetproof_document>(TETPROOF_BAD_ARGUMENT,
                                       [&](auto** out, auto* error) {
                                         return tetproof_report_defects(of_arrays.get(), &points, &tets, out,
                                                                        error);
                                       })
                .find("the report is of"),
            std::string::npos);
}

TEST(CProgram, GivesTheBytesOfTetproofVerifyWithRegions) {
  const ScratchFolder files;
  const corpus::BadMesh sound = [] {
    for (corpus::BadMesh& bad : corpus::bad_meshes())
      if (bad.name == "sound-block") return bad;
    throw std::runtime_error("sound-block is missing");
  }();
  const Arrays arrays(sound.planted.mesh, 1);
  std::vector<std::int32_t> tags(sound.planted.mesh.tets.size(), 3);
  for (std::size_t i = 0; i < tags.size() / 2; ++i) tags[i] = 5;
  const tetproof_integers groups{tags.data(), static_cast<std::int64_t>(tags.size()), 0, 0, 0, 32};
  const FileDocument document = made<tetproof_document>([&](auto** out, auto* error) {
    return tetproof_document_from_arrays(&arrays.points, &arrays.tets, &groups, nullptr, nullptr, out, error);
  });
  ASSERT_EQ(tetproof_document_write(document.get(), (files / "two.msh").c_str(), nullptr, nullptr),
            TETPROOF_OK);
  const std::string expected = json_of_program({files / "two.msh"});
  EXPECT_EQ(json::parse(expected)["regions"].size(), 2u);
  tetproof_judge_options options = judge_options();
  options.region_kind = "physical";
  EXPECT_EQ(json_of(made<tetproof_report>([&](auto** out, auto* error) {
              return tetproof_judge(&arrays.points, &arrays.tets, &groups, nullptr, &options, out, error);
            })),
            expected);
  EXPECT_EQ(json_of(made<tetproof_report>([&](auto** out, auto* error) {
              return tetproof_judge_document(document.get(), nullptr, nullptr, out, error);
            })),
            expected);
}

TEST(CProgram, MakesThePageOfTetproofVerify) {
  const ScratchFolder files;
  const std::string path = TETPROOF_SOURCE_DIR "/corpus/formats/meshes/two_41_text.msh";
  const FileDocument document = made<tetproof_document>(
      [&](auto** out, auto* error) { return tetproof_document_read(path.c_str(), nullptr, out, error); });
  const Surface octahedron = opened("octahedron");
  const Report report = made<tetproof_report>([&](auto** out, auto* error) {
    return tetproof_judge_document(document.get(), octahedron.get(), nullptr, out, error);
  });
  const auto page = made<char>([&](char** out, auto* error) {
    return tetproof_report_document_html(report.get(), document.get(), octahedron.get(), path.c_str(), out,
                                         error);
  });
  run_program({program("tetproof-verify"), path, "octahedron", "--html", files / "page.html"});
  EXPECT_EQ(page.get(), files.read("page.html"));

  // Two regions of arrays that count from 1.
  const tetproof_document_arrays* a = nullptr;
  ASSERT_EQ(tetproof_document_view(document.get(), &a, nullptr), TETPROOF_OK);
  ASSERT_EQ(a->tet_count, 2);
  const std::vector<std::int64_t> tags{8, 9};
  const tetproof_integers regions{tags.data(), 2, 0, 0, 0, 64};
  const tetproof_points points{a->points, a->point_count, 0, 0};
  const tetproof_integers tets{a->tets, a->tet_count, 0, 0, 0, 32};
  const Report of_arrays = made<tetproof_report>([&](auto** out, auto* error) {
    return tetproof_judge(&points, &tets, &regions, nullptr, nullptr, out, error);
  });
  const auto html = made<char>([&](char** out, auto* error) {
    return tetproof_report_html(of_arrays.get(), &points, &tets, nullptr, "</title><b>", out, error);
  });
  const std::string of_two = html.get();
  EXPECT_NE(of_two.find("<td>region 9</td>"), std::string::npos);
  EXPECT_EQ(of_two.find("</title><b>"), std::string::npos);
  const tetproof_surface_arrays* const eight = tetproof_surface_view(octahedron.get());
  const tetproof_points corners{eight->vertices, eight->vertex_count, 0, 0};
  const tetproof_integers triangles{eight->triangles, eight->triangle_count, 0, 0, 0, 32};
  const Surface unnamed = made<tetproof_surface>([&](auto** out, auto* error) {
    return tetproof_surface_from_arrays(&corners, &triangles, out, error);
  });
  const Report against = made<tetproof_report>([&](auto** out, auto* error) {
    return tetproof_judge(&points, &tets, nullptr, unnamed.get(), nullptr, out, error);
  });
  const auto titled = made<char>([&](char** out, auto* error) {
    return tetproof_report_html(against.get(), &points, &tets, unnamed.get(), "two", out, error);
  });
  EXPECT_NE(std::string(titled.get()).find("<title>two against surface</title>"), std::string::npos);
  EXPECT_EQ(refused<char>(TETPROOF_BAD_ARGUMENT,
                          [&](char** out, auto* error) {
                            return tetproof_report_html(of_arrays.get(), &points, &tets, octahedron.get(),
                                                        "a", out, error);
                          }),
            "the report is of a mesh without a surface, and a surface of 8 triangles is given");
}

TEST(CProgram, MakesTheGridOfTetproofMesh) {
  const ScratchFolder files;
  const Surface torus = opened("torus:R=1,r=0.4,n=800");
  tetproof_mesh_options options = mesh_options();
  options.region = TETPROOF_REGION_OUTSIDE;
  options.cells[0] = 10, options.cells[1] = 9, options.cells[2] = 6;
  options.points = 40;
  options.v0 = 0.1;
  options.diagonals = TETPROOF_DIAGONALS_SHORTEST;
  options.curvature = 1;
  options.improve = TETPROOF_IMPROVE_ASPECT_RATIO;
  const auto write = [&](const tetproof_mesh_options* given, const char* name) {
    const FileDocument grid = made<tetproof_document>(
        [&](auto** out, auto* error) { return tetproof_mesh(torus.get(), given, out, error); });
    EXPECT_EQ(tetproof_document_write(grid.get(), (files / name).c_str(), nullptr, nullptr), TETPROOF_OK);
    return files.read(name);
  };
  std::vector<std::string> command{
      program("tetproof-mesh"), "torus:R=1,r=0.4,n=800", "-o", files / "other.msh", "--voxels", "0"};
  EXPECT_EQ(run_program(command).signal, 0);
  EXPECT_EQ(write(nullptr, "grid.msh"), files.read("other.msh"));
  command.insert(command.end(), {"--region", "outside", "--cells", "10,9,6", "--points", "40", "--v0", "0.1",
                                 "--diagonals", "shortest", "--curvature", "--improve", "aspect-ratio"});
  EXPECT_EQ(run_program(command).signal, 0);
  EXPECT_EQ(write(&options, "grid.msh"), files.read("other.msh"));
}

TEST(CProgram, SaysOfFilesWhatTetproofConvertSays) {
  const ScratchFolder files;
  const std::string path = TETPROOF_SOURCE_DIR "/corpus/formats/meshes/two_41_text.msh";
  const Outcome info =
      run_program({program("tetproof-convert"), "--info", path, "--json", files / "info.json"});
  ASSERT_EQ(info.exit_code, 0) << info;
  const FileDocument document = made<tetproof_document>(
      [&](auto** out, auto* error) { return tetproof_document_read(path.c_str(), nullptr, out, error); });
  const auto text =
      made<char>([&](char** out, auto* error) { return tetproof_document_json(document.get(), out, error); });
  EXPECT_EQ(json::parse(text.get()), json::parse(files.read("info.json"))["input"]);
  const Outcome convert = run_program(
      {program("tetproof-convert"), path, files / "two.stl", "--quiet", "--losses", files / "losses.json"});
  ASSERT_EQ(convert.exit_code, 0) << convert;
  const auto losses = made<char>([&](char** out, auto* error) {
    return tetproof_document_losses(document.get(), (files / "two.stl").c_str(), nullptr, out, error);
  });
  json said = json::parse(losses.get());
  said.erase("warning");
  EXPECT_EQ(said, json::parse(files.read("losses.json")));
  EXPECT_FALSE(said["losses"].empty());
}

TEST(CProgram, PrintsNothing) {
  const Outcome header = run_program({C_HEADER_PROGRAM});
  EXPECT_EQ(header.exit_code, 0) << "the line of tests/c/header.c, modulo 256: " << header;
  EXPECT_EQ(header.out + header.err, "");
  const Outcome fuzz =
      run_program({C_FUZZ_PROGRAM, "--gtest_brief=1", "--gtest_filter=CFuzz.Reads*:CFuzz.Makes*"});
  EXPECT_EQ(fuzz.exit_code, 0) << fuzz;
  EXPECT_EQ(fuzz.err, "");
  EXPECT_LE(lines(fuzz.out), 5u) << fuzz;  // GoogleTest's own
}

TEST(CProgram, RunsTheExampleOfTheReadme) {
  const Outcome example = run_program({C_README_PROGRAM});
  EXPECT_EQ(example.exit_code, 1) << example;
  std::ifstream file(TETPROOF_SOURCE_DIR "/verify/c/README.md");
  const std::string readme{std::istreambuf_iterator<char>(file), {}};
  ASSERT_NE(example.out, "");
  EXPECT_NE(readme.find("\n    " + example.out), std::string::npos) << example.out;
}

}  // namespace
}  // namespace tetproof::test
