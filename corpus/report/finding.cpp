// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/report/finding.hpp"
#include "corpus/meshing/tool_mesher.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "corpus/report/picture.hpp"
#include "corpus/report/readme.hpp"
#include "corpus/report/statements.hpp"
#include "io/bytes/atomic_file.hpp"
#include "io/bytes/input_file.hpp"
#include "io/bytes/words.hpp"
#include "io/error.hpp"
#include "io/mesh_files.hpp"
#include "io/surface_files.hpp"
#include "verify/verify.hpp"

namespace tetproof::corpus {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// A folder that is filled beside its place. Without `commit` nothing of it stays.
class AtomicFolder {
 public:
  explicit AtomicFolder(const std::string& folder) : place_(fs::path(folder).lexically_normal()) {
    if (!place_.has_filename()) place_ = place_.parent_path();
    if (fs::exists(fs::symlink_status(place_)))
      throw InputError(fmt::format("{}: cannot write the finding: it exists already", place_.string()));
    std::string name =
        (place_.parent_path() / fmt::format(".{}.XXXXXX", place_.filename().string())).string();
    if (!mkdtemp(name.data())) fail(std::strerror(errno));
    beside_ = name;
    fs::permissions(beside_, fs::perms(0755));
  }
  ~AtomicFolder() {
    std::error_code ignored;
    if (!beside_.empty()) fs::remove_all(beside_, ignored);
  }
  AtomicFolder(const AtomicFolder&) = delete;
  AtomicFolder& operator=(const AtomicFolder&) = delete;

  fs::path operator/(const std::string& name) const { return beside_ / name; }
  void write(const std::string& name, std::string_view text) const {
    AtomicFile file((beside_ / name).string());
    file.write(text);
    file.commit();
  }
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(beside_))
      names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }
  void commit() {
    std::error_code error;
    fs::rename(beside_, place_, error);
    if (error) fail(error.message());
    beside_.clear();
  }
  [[noreturn]] void fail(const std::string& why) const {
    throw InputError(fmt::format("{}: cannot write the finding: {}", place_.string(), why));
  }

 private:
  fs::path place_, beside_;
};

bool starts_with_stem(const fs::path& file, const std::string& stem) {
  return file.filename().string().starts_with(stem + ".");
}

// The name without its last ending: of "surface.1.ele" "surface.1".
std::string stem_of(const std::string& path) {
  return fs::path(path).stem().string();
}

// Writes the surface in the mesher's own format. The name of the file; empty: the mesher takes no file.
std::string give_surface(const AtomicFolder& to, const FindingFacts& facts, const TriangleSurface& surface,
                         const fs::path& run_folder) {
  const std::string ending = facts.mesher->surface_ending();
  if (ending.empty()) return "";
  const std::string name = "surface" + ending;
  const std::string mesh_stem = stem_of(facts.run.mesh_file);
  if (!run_folder.empty())
    for (const auto& entry : fs::directory_iterator(run_folder))
      if (entry.is_regular_file() && starts_with_stem(entry.path(), "surface") &&
          (facts.run.mesh_file.empty() || mesh_stem == "surface" ||
           !starts_with_stem(entry.path(), mesh_stem)) &&
          entry.path().filename() != fs::path(facts.run.mesh_file).filename() &&
          !fs::exists(to / entry.path().filename().string()))  // surface.off, for a mesher that reads OFF
        fs::copy_file(entry.path(), to / entry.path().filename().string());
  if (fs::exists(to / name)) return name;
  const auto known = known_endings();
  if (is_surface_file(name))
    write_surface((to / name).string(), surface);
  else if (std::find(known.begin(), known.end(), ending) != known.end())
    write_document((to / name).string(), document_of(surface));
  else
    return "surface.off";  // a format that only the mesher's preset knows
  return name;
}

// Without the folders of this machine, which tell a maintainer nothing.
std::string without_places(std::string text, const MesherRun& run) {
  const auto replace = [&text](const std::string& place, const std::string& by) {
    for (std::size_t at = 0; !place.empty() && (at = text.find(place, at)) != std::string::npos;
         at += by.size())
      text.replace(at, place.size(), by);
  };
  if (const fs::path folder = fs::path(run.mesh_file).parent_path(); folder.is_absolute())
    replace(folder.string() + "/", "");
  if (const fs::path program = run.program; program.is_absolute())
    replace(program.string(), program.filename().string());
  return text;
}

bool can_check(const MesherRun& run, const std::string& ending) {
  const std::string format = run.document ? run.document->format : "";
  const bool other_msh = ending == ".msh" && !format.empty() && format != "msh22" && format != "msh41";
  return !other_msh && (ending == ".ele" || ending == ".node" || ending == ".msh" || ending == ".mesh");
}

GivenMesh give_mesh(const AtomicFolder& to, const MesherRun& run) {
  GivenMesh given{.numbering = run.numbering};
  if (!run.mesh_file.empty() && fs::is_regular_file(run.mesh_file)) {
    const fs::path file = run.mesh_file;
    const std::string ending = file.extension().string(), stem = stem_of(run.mesh_file);
    given.file = "mesh" + ending;
    if (ending == ".ele" || ending == ".node") {  // the two make one mesh; TetGen's last line is its command
      for (const char* one : {".node", ".ele"})
        if (const fs::path part = file.parent_path() / (stem + one); fs::exists(part))
          to.write("mesh" + std::string(one),
                   without_places(std::string(InputFile(part.string()).bytes()), run));
    } else {
      fs::copy_file(file, to / given.file);
    }
    if (can_check(run, ending)) given.checked = ending == ".node" ? "mesh.ele" : given.file;
  }
  if (given.checked.empty() && !run.failure && !run.mesh.tets.empty()) {
    given.checked = given.file.empty() ? "mesh.msh" : "mesh-converted.msh";
    write_document((to / given.checked).string(), document_of(run.mesh), {.format = "msh22"});
    given.numbering = Numbering{.first = 1};
  }
  return given;
}

const char* headline_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::crashed:
      return "a crash on a valid surface";
    case Outcome::refused_valid:
      return "a valid surface is called invalid";
    case Outcome::refused:
      return "a valid surface is refused";
    case Outcome::no_output:
      return "success without a mesh";
    case Outcome::no_tetrahedra:
      return "success without a tetrahedron";
    case Outcome::unreadable:
      return "success with a file that breaks its format";
    case Outcome::slow:
      return "a run that does not end in time";
    case Outcome::out_of_memory:
      return "a run that needs more memory than it may";
    default:
      return "a mesh that is not right";
  }
}

// The check whose finding is stated: the one that the signature names, or the first that failed.
std::optional<verify::Check> root_of(const Judgement& judgement) {
  if (!judgement.report) return std::nullopt;
  for (const verify::CheckResult& result : judgement.report->checks)
    if (judgement.signature == verify::info(result.check).id && !result.findings.empty()) return result.check;
  for (const verify::CheckResult& result : judgement.report->checks)
    if (result.verdict == verify::Verdict::fail && !result.findings.empty()) return result.check;
  return std::nullopt;
}

// What can be said about the outcome: by the judge's report, or by what the mesher did.
Statements statements_for(const FindingFacts& facts, const TriangleSurface& surface, const GivenMesh& mesh) {
  const Outcome outcome = facts.judgement.outcome;
  Statements statements{.headline = headline_of(outcome)};
  const bool of_mesh = outcome == Outcome::wrong || outcome == Outcome::wrong_against_surface;
  if (const auto root = root_of(facts.judgement); root && of_mesh)
    statements = statements_of({facts.run.mesh, mesh.numbering, surface, *facts.judgement.report}, *root);
  if (outcome == Outcome::no_tetrahedra && !mesh.checked.empty())
    statements.list.push_back(
        {{"kind", "tet_count"}, {"text", fmt::format("{} holds no tetrahedron", mesh.file)}, {"count", 0}});
  if (!of_mesh && outcome != Outcome::no_tetrahedra) {
    std::string said = facts.run.message.empty() ? facts.judgement.signature : facts.run.message;
    while (said.ends_with('.')) said.pop_back();
    statements.list.push_back({{"kind", "run"},
                               {"text", fmt::format("the command ends so ({}; {}): {}", name_of(outcome),
                                                    facts.judgement.signature, said)},
                               {"why", "only a run of the mesher shows it"}});
  }
  if (statements.list.empty())
    statements.list.push_back({{"kind", "report"},
                               {"text", "the judge says: " + facts.judgement.what},
                               {"why", "these are the judge's words"}});
  statements.list.push_back(surface_statement(surface));
  return statements;
}

void fill(const AtomicFolder& to, const FindingFacts& given) {
  FindingFacts facts = given;
  facts.run.message = without_places(facts.run.message, facts.run);
  for (std::string& line : facts.run.warnings) line = without_places(line, facts.run);
  TriangleSurface surface = facts.run.given ? *facts.run.given : facts.shrunk;
  surface.parameters.clear();  // OFF would hold (u,v) as texture coordinates
  surface.evaluate = nullptr;
  TriangleSurface original{facts.original.surface.vertices, facts.original.surface.triangles, {}, {}};
  write_surface((to / "surface.off").string(), surface);
  write_surface((to / "original.off").string(), original);
  fs::path run_folder = facts.run_folder;
  if (run_folder.empty() && fs::is_regular_file(facts.run.mesh_file))
    run_folder = fs::absolute(facts.run.mesh_file).parent_path();
  const std::string surface_file = give_surface(to, facts, surface, run_folder);
  const GivenMesh mesh = give_mesh(to, facts.run);
  const std::string version = facts.mesher->version();
  to.write("output.txt", without_places(facts.run.output, facts.run));
  to.write("version.txt", (version.empty() ? "unknown" : version) + "\n");
  if (facts.judgement.report)
    to.write("report.json", verify::report_json(*facts.judgement.report, facts.run.numbering));

  const std::string mesh_name = mesh.file.empty() ? "mesh" : mesh.file;
  // The sizes are those of the surface before its file rounded it.
  const std::string command =
      replaced(facts.mesher->command(), placeholders(facts.shrunk, surface_file, mesh_name));
  const Statements statements = statements_for(facts, surface, mesh);
  std::string title = fmt::format("{}: {}", facts.mesher->name(), statements.headline);
  to.write("picture.svg",
           picture(surface, facts.run.mesh, mesh.numbering, statements.marks,
                   {.title = title, .below = statements.list.front().at("text").get<std::string>()}));
  to.write("finding.json", json{{"format", "tetproof-finding 1"},
                                {"mesher", facts.mesher->name()},
                                {"version", version},
                                {"command", command},
                                {"outcome", name_of(facts.judgement.outcome)},
                                {"signature", facts.judgement.signature},
                                {"judged",
                                 {{"allowed", facts.judgement.allowed},
                                  {"coarse", facts.mesher->coarse()},
                                  {"check", facts.checks}}},
                                {"warnings", facts.run.warnings},
                                {"seed", facts.seed},
                                {"case", facts.index},
                                {"recipe", recipe_text(facts.original.recipe)},
                                {"failed", facts.failed},
                                {"repeats", facts.repeats},
                                {"surface", "surface.off"},
                                {"mesh", mesh.checked},
                                {"statements", statements.list}}
                                   .dump(1, ' ', false, json::error_handler_t::replace) +
                               "\n");
  std::vector<std::string> files = to.files();
  files.insert(std::upper_bound(files.begin(), files.end(), "README.md"), "README.md");
  to.write("README.md", readme({facts, statements, mesh, command, surface, files}));
}

}  // namespace

void write_finding(const std::string& folder, const FindingFacts& facts) {
  AtomicFolder to(folder);
  try {
    fill(to, facts);
  } catch (const fs::filesystem_error& error) {
    to.fail(fmt::format("{}: {}", error.path1().filename().string(), error.code().message()));
  }
  to.commit();
}

}  // namespace tetproof::corpus
