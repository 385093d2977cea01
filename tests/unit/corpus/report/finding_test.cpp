// SPDX-License-Identifier: GPL-3.0-or-later
// A finding's folder: what is in it, and that corpus/findings/check.py confirms what it says and refutes what
// was changed. The defects are planted ones, one of each kind.
#include "corpus/report/finding.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <set>
#include <sstream>

#include "corpus/block_mesh.hpp"
#include "corpus/plant.hpp"
#include "corpus/report/finding_page.hpp"
#include "corpus/surfaces.hpp"
#include "io/error.hpp"
#include "io/mesh_files.hpp"
#include "io/surface_files.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/run_program.hpp"
#include "verify/verify.hpp"

namespace tetproof::corpus {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class FakeMesher : public Mesher {
 public:
  explicit FakeMesher(std::string ending = ".smesh") : ending_(std::move(ending)) {}
  MesherRun run(const TriangleSurface&, const std::string&, const Limits&) const override { return {}; }
  std::string name() const override { return "fake,pq"; }
  std::string command() const override { return "fake -pq {surface} -o {mesh}"; }
  std::string version() const override { return "Fake 1.2 & <3>"; }
  std::string surface_ending() const override { return ending_; }
  bool may_change_boundary() const override { return lattice; }
  double fidelity() const override { return 0.2; }
  bool coarse() const override { return lattice; }
  int repeats() const override { return 1; }

  bool lattice = false;  ///< as if its meshes were made from a coarse lattice

 private:
  std::string ending_;
};

// A folder of the test's own, gone at its end.
class FindingFolder : public testing::Test {
 protected:
  FindingFolder() {
    std::string name = (fs::temp_directory_path() / "finding.XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    folder = name;
    fs::create_directory(folder / "run");
  }
  ~FindingFolder() override {
    std::error_code ignored;
    if (!std::getenv("TETPROOF_KEEP_FINDINGS")) fs::remove_all(folder, ignored);
  }

  // The facts about a mesher that made this mesh of this surface and wrote it into this file, still without a
  // verdict.
  FindingFacts run(const TetMesh& mesh, const TriangleSurface& surface,
                   const std::string& file = "surface.1.ele", const WriteOptions& options = {}) {
    const std::string path = (folder / "run" / file).string();
    write_document(path, document_of(mesh), options);
    FindingFacts result{.seed = 7,
                        .index = 42,
                        .original = {.surface = surface, .recipe = {.kind = "sphere"}},
                        .shrunk = surface,
                        .shrink_steps = "2 edges collapsed",
                        .mesher = &mesher};
    result.run.document = std::make_shared<const Document>(read_document(path));
    result.run.mesh = tet_mesh(*result.run.document);
    result.run.numbering = numbering(*result.run.document);
    result.run.mesh_file = path;
    result.run.output = "Statistics: fine\n";
    result.repeats = 20;
    result.failed = 3;
    result.cases = 12;
    result.cases_run = 2000;
    return result;
  }
  FindingFacts facts(const TetMesh& mesh, const TriangleSurface& surface,
                     const std::string& file = "surface.1.ele", const WriteOptions& options = {}) {
    FindingFacts result = run(mesh, surface, file, options);
    const verify::JudgedSurface judged(surface);
    result.judgement = judge_run(result.run, mesher, judged);
    return result;
  }
  // As if this check alone had been asked for, and had failed.
  FindingFacts facts_by(const char* id, const TetMesh& mesh, const TriangleSurface& surface) {
    FindingFacts result = run(mesh, surface);
    result.judgement = {
        .outcome = Outcome::wrong_against_surface,
        .signature = id,
        .report = verify::verify(result.run.mesh, surface,
                                 {.region = verify::Region::inside, .fidelity = 1e-9, .check = {id}})};
    EXPECT_GT((*result.judgement.report)[verify::check_of_id(id)].count, 0) << id;
    return result;
  }

  std::string write(const FindingFacts& facts, const std::string& name = "finding") {
    write_finding((folder / name).string(), facts);
    return (folder / name).string();
  }

  // check.py's exit code for a folder; its output is kept.
  int check(const std::string& finding) { return check(std::vector<std::string>{finding}); }
  int check(std::vector<std::string> findings) {
    findings.insert(findings.begin(), {"python3", TETPROOF_SOURCE_DIR "/corpus/findings/check.py"});
    const test::Outcome done = test::run_program(findings, {.environment = {"PYTHONDONTWRITEBYTECODE=1"}});
    said = done.out + done.err;
    return done.exit_code;
  }

  void expect_refuted(const std::string& finding, json wrong, std::size_t statement);

  static std::string text(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::stringstream all;
    all << in.rdbuf();
    return all.str();
  }
  std::set<std::string> names() const {
    std::set<std::string> result;
    for (const auto& entry : fs::directory_iterator(folder)) result.insert(entry.path().filename().string());
    return result;
  }

  fs::path folder;
  FakeMesher mesher;
  std::string said;
};

TetMesh inverted_block(TriangleSurface& surface) {
  TetMesh mesh = block_mesh({2, 2, 2});
  surface = test::boundary_surface(mesh);
  std::swap(mesh.tets[5][0], mesh.tets[5][1]);
  return mesh;
}

TEST_F(FindingFolder, HoldsWhatAMaintainerNeeds) {
  TriangleSurface surface;
  const TetMesh mesh = inverted_block(surface);
  std::ofstream(folder / "run" / "surface.smesh") << "as the mesher got it\n";
  const FindingFacts found = facts(mesh, surface);
  ASSERT_EQ(found.judgement.signature, "inverted");
  const fs::path finding = write(found);
  std::set<std::string> files;
  for (const auto& entry : fs::directory_iterator(finding)) files.insert(entry.path().filename().string());
  EXPECT_EQ(files, (std::set<std::string>{"README.md", "finding.json", "mesh.ele", "mesh.node",
                                          "original.off", "output.txt", "picture.svg", "report.json",
                                          "surface.off", "surface.smesh", "version.txt"}));
  EXPECT_EQ(text(finding / "surface.smesh"), "as the mesher got it\n");
  EXPECT_EQ(text(finding / "mesh.ele"), text(folder / "run" / "surface.1.ele"));
  EXPECT_EQ(text(finding / "output.txt"), "Statistics: fine\n");
  EXPECT_EQ(text(finding / "version.txt"), "Fake 1.2 & <3>\n");
  EXPECT_EQ(read_surface((finding / "surface.off").string()).triangles, surface.triangles);

  const std::string readme = text(finding / "README.md");
  const std::int64_t number = found.run.numbering.tet(5);
  for (const std::string& part :
       {std::string("# fake,pq: a tetrahedron of negative volume"),
        std::string("`fake -pq surface.smesh -o mesh.ele`"), fmt::format("tetrahedron {} (vertices ", number),
        std::string("has volume -0.166667, exactly -1/6"),
        std::string("of the 48 tetrahedra, 47 have positive, 1 negative and 0 zero volume"),
        std::string("48 triangles, 1 component, Euler characteristic 2, volume 8"),
        std::string("3 of 20 runs"), std::string("in 12 of 2,000 random surfaces"),
        std::string("case 42 of seed 7")})
    EXPECT_NE(readme.find(part), std::string::npos) << part << "\n" << readme;
  EXPECT_EQ(readme.find("Since"), std::string::npos) << "the version since when is unknown";
  EXPECT_LE(std::count(readme.begin(), readme.end(), '\n'), 14);
  EXPECT_EQ(check(finding), 0) << said;
}

TEST_F(FindingFolder, IsTheSameEachTime) {
  TriangleSurface surface;
  const FindingFacts found = facts(inverted_block(surface), surface);
  const fs::path one = write(found, "one"), other = write(found, "other");
  for (const auto& entry : fs::directory_iterator(one))
    EXPECT_EQ(text(entry.path()), text(other / entry.path().filename())) << entry.path();
}

// A lattice may lose a cavity, which is only a warning then. A mesher that keeps the boundary may not.
TEST_F(FindingFolder, HasAPageThatJudgesAsTheCampaignDid) {
  const TetMesh with_horn =
      test::lattice_mesh({3, 3, 6}, [](test::Cell c) { return c[2] < 3 || (c[0] == 1 && c[1] == 1); });
  const TetMesh hollow = test::lattice_mesh({3, 3, 3}, [](test::Cell c) { return c != test::Cell{1, 1, 1}; });
  const TriangleSurface surface = test::boundary_surface(hollow);
  for (const bool lattice : {true, false}) {
    mesher.lattice = lattice;
    const FindingFacts found = facts(with_horn, surface);
    ASSERT_EQ(found.judgement.outcome, Outcome::wrong_against_surface);
    const std::string page = finding_page(write(found, lattice ? "lattice" : "exact"));
    const std::string word = lattice ? "warning" : "fail";
    EXPECT_NE(page.find(fmt::format("<td>topology</td><td class=\"{0}\">{0}</td>", word)), std::string::npos)
        << word;
    const bool judged_box = page.find("<td>bounding-box</td><td class=\"skipped\">") == std::string::npos;
    EXPECT_EQ(judged_box, !lattice) << "the box of a coarse grid says nothing";
  }
  mesher.lattice = false;
  FindingFacts found = facts_by("mesh-to-surface", with_horn, surface);
  found.checks = {"mesh-to-surface"};
  const std::string page = finding_page(write(found, "one-check"));
  EXPECT_NE(page.find("<td>topology</td><td class=\"skipped\">"), std::string::npos)
      << "the page judges what nobody asked for";
}

TEST_F(FindingFolder, AppearsCompleteOrNotAtAll) {
  TriangleSurface surface;
  FindingFacts found = facts(inverted_block(surface), surface);
  write(found);
  const std::set<std::string> before = names();
  EXPECT_THROW(write(found), InputError) << "the folder exists";
  EXPECT_EQ(names(), before);
  EXPECT_THROW(write(found, "nowhere/finding"), InputError);
  // It fails after files were written: no vertex has this number.
  found.original.surface.triangles[0][0] = 1000;
  EXPECT_THROW(write(found, "broken"), InputError);
  EXPECT_EQ(names(), before) << "a half of a folder stayed";
}

TEST_F(FindingFolder, SaysWhatOnlyARunCanShow) {
  TriangleSurface surface;
  inverted_block(surface);
  FindingFacts found{
      .original = {.surface = surface, .recipe = {.kind = "sphere"}}, .shrunk = surface, .mesher = &mesher};
  found.run.failure = Outcome::crashed;
  found.run.signature = "insertpoint: Assertion `x' failed";
  found.run.message = "fake: insertpoint: Assertion `x > 0' failed.";
  const verify::JudgedSurface judged(surface);
  found.judgement = judge_run(found.run, mesher, judged);
  found.since = "Fake 1.0";
  const fs::path finding = write(found);
  const std::string readme = text(finding / "README.md");
  EXPECT_NE(readme.find("a crash on a valid surface"), std::string::npos);
  EXPECT_NE(readme.find("Assertion 'x > 0' failed"), std::string::npos) << readme;
  EXPECT_NE(readme.find("**Since**: Fake 1.0"), std::string::npos);
  EXPECT_TRUE(fs::exists(finding / "surface.smesh"));
  EXPECT_EQ(check(finding), 4) << said;
  EXPECT_NE(said.find("confirmed    surface.off is closed"), std::string::npos) << said;
  EXPECT_NE(said.find("not checked  the command ends so (crashed; insertpoint: Assertion `x' failed)"),
            std::string::npos)
      << said;
}

TEST_F(FindingFolder, RefutesASurfaceThatIsNotValid) {
  TriangleSurface surface;
  FindingFacts found = facts(inverted_block(surface), surface);
  const fs::path finding = write(found);
  const auto spoil = [&](auto change) {
    TriangleSurface other = surface;
    change(other);
    write_surface((finding / "surface.off").string(), other);
    const int code = check(finding);
    return fmt::format("{} {}", code, said);
  };
  EXPECT_EQ(spoil([](TriangleSurface&) {}).substr(0, 1), "0");
  const auto expect = [&](const std::string& result, const char* what) {
    EXPECT_EQ(result.substr(0, 1), "1") << result;
    EXPECT_NE(result.find(what), std::string::npos) << result;
  };
  expect(spoil([](TriangleSurface& s) { s.triangles.pop_back(); }), "it has 47 triangles");
  expect(spoil([](TriangleSurface& s) { std::swap(s.triangles[3][0], s.triangles[3][1]); }),
         "an edge has not one triangle on each side");
  expect(spoil([](TriangleSurface& s) {
           for (auto& p : s.vertices) p.x() = -p.x();
         }),
         "its volume is -8");
  const Index corner = test::point_at({surface.vertices, {}}, {0, 0, 0});
  expect(spoil([=](TriangleSurface& s) {
           s.vertices[static_cast<std::size_t>(corner)] = {3, 3, 3};
         }),
         "intersect");
  // A coordinate that is moved by a unit in its last place changes the volume, exactly.
  expect(spoil([=](TriangleSurface& s) { s.vertices[static_cast<std::size_t>(corner)].x() = -5e-324; }),
         "its volume is 8, exactly");
}

// Whether a statement of this kind has a value that can be falsified; changes it.
bool falsify(json& s) {
  for (const char* key : {"volume", "squared_distance", "mesh"})
    if (s.contains(key) && s[key].is_string()) return s[key] = s[key].get<std::string>() + "1", true;
  for (const char* key : {"positive", "count"})
    if (s.contains(key)) return s[key] = s[key].get<int>() + 1, true;
  if (s["kind"] == "boundary_counts") return s["mesh"]["euler"] = 77, true;
  if (s.contains("tets")) return s["tets"][0] = 1000000, true;
  if (s.contains("tet")) return s["tet"] = 1000000, true;
  if (s["kind"] == "same_place") return s["vertices"].erase(0), s["vertices"][0] = 1000000, true;
  if (s.contains("vertex")) return s["vertex"] = 1000000, true;
  return false;  // the judge's own words
}

// With the numbers of one statement wrong, check.py refutes it.
void FindingFolder::expect_refuted(const std::string& finding, json wrong, std::size_t statement) {
  const fs::path file = fs::path(finding) / "finding.json";
  const std::string before = text(file);
  ASSERT_TRUE(falsify(wrong["statements"][statement])) << wrong["statements"][statement];
  std::ofstream(file) << wrong;
  EXPECT_EQ(check(finding), 1) << wrong["statements"][statement] << "\n" << said;
  std::ofstream(file) << before;
}

TEST_F(FindingFolder, ChecksEveryKindOfPlantedDefect) {
  const std::vector<std::pair<const char*, WriteOptions>> files{
      {"surface.1.ele", {}},
      {"out.msh", {.format = "msh41"}},
      {"out.msh", {.format = "msh41", .binary = true}},
      {"out.msh", {.format = "msh22"}},
      {"out.msh", {.format = "msh22", .binary = true}},
      {"out.mesh", {}},
      {"out.vtu", {}},
      {"out.msh", {.format = "msh40"}}};
  std::map<std::string, int> kinds, checks;
  std::vector<std::string> findings;
  for (const PlantKind& kind : plant_kinds()) {
    if (kind.has("campaign")) continue;
    std::optional<Planted> planted;
    TriangleSurface surface;
    for (const TetMesh& base : {block_mesh({2, 1, 1}), block_mesh({2, 2, 2}, 0.1, 3), block_mesh({2, 2, 2}),
                                ball_mesh(3, 0.1, 3), block_mesh({10, 1, 1})}) {
      planted = plant(kind, Ground(base), 1);
      surface = test::boundary_surface(base);
      if (planted) break;
    }
    if (!planted) continue;
    const auto& [file, options] = files[findings.size() % files.size()];
    FindingFacts found;
    try {
      found = facts(planted->mesh, surface, file, options);
    } catch (const InputError&) {  // the format cannot hold such a mesh
      found = facts(planted->mesh, surface);
    }
    if (!is_finding(found.judgement.outcome)) continue;
    ++checks[found.judgement.signature];
    findings.push_back(write(found, kind.id));
    pugi::xml_document picture;
    EXPECT_TRUE(picture.load_file((findings.back() + "/picture.svg").c_str())) << kind.id;
    EXPECT_LT(fs::file_size(findings.back() + "/picture.svg"), 100000u) << kind.id;
  }
  EXPECT_EQ(check(findings), 0) << said;
  EXPECT_GT(findings.size(), 90u);
  for (const char* id :
       {"index-range", "finite-coordinates", "repeated-vertex", "duplicate-tet", "inverted", "flat",
        "face-shared-thrice", "face-orientation", "hanging-node", "crossed-diagonal", "crack", "cavity",
        "boundary-nonmanifold-edge", "boundary-nonmanifold-vertex", "boundary-self-intersection", "overlap"})
    EXPECT_GT(checks[id], 0) << id;

  // Each statement is refuted once its numbers are wrong: two of each kind.
  for (const std::string& finding : findings) {
    const json all = json::parse(text(fs::path(finding) / "finding.json"));
    for (std::size_t i = 0; i < all["statements"].size(); ++i) {
      json wrong = all;
      const std::string kind = wrong["statements"][i]["kind"];
      if (kinds[kind]++ < 2) expect_refuted(finding, wrong, i);
    }
  }
}

TEST_F(FindingFolder, ChecksTheComparisonWithTheSurface) {
  const TetMesh block = block_mesh({2, 2, 2});
  const TriangleSurface surface = test::boundary_surface(block);
  TetMesh moved = block;
  moved.points[static_cast<std::size_t>(test::point_at(block, {1, 1, 2}))].z() += 1e-6;
  TriangleSurface bump = surface;
  bump.vertices[static_cast<std::size_t>(test::point_at({surface.vertices, {}}, {1, 1, 2}))].z() += 0.25;
  TetMesh with_more = block;  // a point of no tetrahedron, in the place of another
  with_more.points.push_back(block.points[3]);
  const TetMesh far_away = corpus::moved(block, 1, {100, 0, 0});
  const TetMesh near =
      test::together(block_mesh({1, 1, 1}), corpus::moved(block_mesh({1, 1, 1}), 1, {0, 0, 1 + 1e-15}));
  struct Case {
    const char *id, *kind;
    const TetMesh* mesh;
    const TriangleSurface* surface;
  };
  for (const Case& c : {Case{"off-surface-vertex", "off_surface", &moved, &surface},
                        Case{"mesh-to-surface", "off_surface", &moved, &surface},
                        Case{"surface-to-mesh", "off_mesh", &block, &bump},
                        Case{"volume-surface", "volumes", &far_away, &bump},
                        Case{"missing-region", "region_point", &block, &bump},
                        Case{"excess-region", "region_point", &far_away, &surface},
                        Case{"bounding-box", "volumes", &far_away, &surface},
                        Case{"near-contact", "near_faces", &near, &surface},
                        Case{"duplicate-point", "same_place", &with_more, &surface},
                        Case{"unused-point", "unused_point", &with_more, &surface}}) {
    SCOPED_TRACE(c.id);
    const std::string finding = write(facts_by(c.id, *c.mesh, *c.surface), c.id);
    EXPECT_EQ(check(finding), 0) << said;
    const json all = json::parse(text(fs::path(finding) / "finding.json"));
    EXPECT_EQ(all["statements"][0]["kind"], c.kind);
    expect_refuted(finding, all, 0);
  }
}

}  // namespace
}  // namespace tetproof::corpus
