// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-convert IN OUT: converts a mesh file and lists what is lost on the way.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "corpus/surfaces.hpp"
#include "io/error.hpp"
#include "io/mesh_files.hpp"
#include "io/program/describe.hpp"
#include "io/program/files_in_use.hpp"
#include "io/program/mesh_formats.hpp"
#include "io/program/program.hpp"
#include "io/program/report_losses.hpp"

namespace {

using namespace tetproof;
using Json = nlohmann::ordered_json;

struct Choices {
  std::string in, out, losses_file;
  ReadOptions read;
  WriteOptions write;
  bool ascii = false, binary = false, strict = false, strict_native = false, info = false;
};

// Reads the file, or makes the surface of a specification.
Document input(const Choices& choices) {
  if (!corpus::is_generated(choices.in)) return read_document(choices.in, choices.read);
  if (!choices.read.format.empty()) throw InputError("--from needs an IN that is a file");
  Document document = document_of(corpus::make_surface(choices.in));
  document.path = choices.in;
  document.format = "generated";
  return document;
}

// What --strict, or --strict-native, does not permit: what is not read or lost; elements that only our reader
// takes back; and under --strict-native everything else that only our reader takes back.
struct Refusal {
  std::vector<Loss> not_read, lost, kept;

  Refusal(const Choices& choices, const std::vector<Loss>& dropped, const std::vector<Loss>& losses,
          const KeptAside& aside) {
    if (!choices.strict && !choices.strict_native) return;
    not_read = dropped, lost = losses;
    for (const Loss& loss : aside.items)
      if (choices.strict_native || loss.elements) kept.push_back(loss);
  }
  std::size_t items() const { return not_read.size() + lost.size() + kept.size(); }

  // "would be lost", "are not read or only in comments", ...
  std::string why(const std::string& kept_in) const {
    const bool one = items() == 1;
    std::vector<std::string> reasons;
    if (!not_read.empty()) reasons.push_back(one ? "is not read" : "are not read");
    if (!lost.empty()) reasons.push_back("would be lost");
    if (!kept.empty())
      reasons.push_back(fmt::format("would stand in {} only, which other programs do not read", kept_in));
    return fmt::format("{}", fmt::join(reasons, " or "));
  }
};

int convert(const Choices& choices, const program::Common& common) {
  if (choices.out.empty() && !choices.info) throw InputError("OUT is missing (or ask for --info)");
  if (!choices.out.empty() && choices.info) throw InputError("--info writes no file: leave out OUT");
  WriteOptions write = choices.write;
  if (choices.ascii || choices.binary) write.binary = choices.binary;
  program::FilesInUse files(common);
  if (!corpus::is_generated(choices.in)) files.reads_mesh("IN", choices.in, choices.read);
  files.writes_mesh("OUT", choices.out, write);
  files.writes("--losses", choices.losses_file);

  const Document document = input(choices);
  program::report_reading(common, document.warnings, document.dropped);
  Json result{{"input", describe_json(document)}, {"dropped", program::losses_json(document.dropped)}};
  if (choices.info) {
    if (!files.standard_output_is_taken()) fmt::print("{}", describe_text(document));
    if (!common.json.empty()) program::write_json(common.json, result);
    return program::sound;
  }

  program::MeshOutput output(common, files, "OUT", choices.out, document, write);
  const std::vector<Loss>& lost = output.losses();
  const KeptAside& kept = output.kept_aside();
  const Refusal refusal(choices, document.dropped, lost, kept);
  const bool refused = refusal.items() > 0;
  if (!refused) output.write();
  result["output"] = {{"file", choices.out},
                      {"format", output.encoding().format},
                      {"binary", output.encoding().binary},
                      {"written", !refused}};
  result["losses"] = program::losses_json(lost);
  result["kept_aside"] = program::losses_json(kept.items);
  if (!kept.items.empty()) result["output"]["kept_in"] = kept.where;
  if (!choices.losses_file.empty())
    program::write_json(choices.losses_file, Json{{"dropped", result["dropped"]},
                                                  {"losses", result["losses"]},
                                                  {"kept_aside", result["kept_aside"]}});
  if (!common.json.empty()) program::write_json(common.json, result);
  if (!refused) return program::sound;
  program::say(common,
               fmt::format("{}: not written, since {} of {} {} ({})", choices.out,
                           refusal.items() == 1 ? "something" : "several things", choices.in,
                           refusal.why(kept.where), choices.strict_native ? "--strict-native" : "--strict"));
  return program::wrong;
}

}  // namespace

int main(int argc, char** argv) {
  return program::run(
      argc, argv,
      {.purpose = "Converts meshes and surfaces between formats, and says what the target cannot hold.",
       .examples =
           "  tetproof-convert grid.msh grid.1.ele              for TetGen: grid.1.node and grid.1.ele\n"
           "  tetproof-convert grid.1.node grid.msh --binary    Gmsh 4.1, binary\n"
           "  tetproof-convert grid.msh old.msh --to msh22\n"
           "  tetproof-convert grid.msh grid.vtu --strict       exit 1 and no file if anything is lost\n"
           "  tetproof-convert --info grid.msh\n"
           "  tetproof-convert torus:R=1,r=0.4 torus.obj        a generated surface; OBJ holds its (u,v), "
           "too\n"
           "  tetproof-convert part.step part.msh               a format that only Gmsh reads; geometry is "
           "meshed\n"
           "  zcat grid.vtk.gz | tetproof-convert - grid.msh    from standard input\n",
       .libraries = {}},
      [&](CLI::App& app, program::Common& common) -> std::function<int()> {
        auto choices = std::make_shared<Choices>();
        app.add_option(
               "IN", choices->in,
               "a mesh or a surface, or a generated surface (tetproof-mesh --list-surfaces); - is standard "
               "input. Endings: " +
                   program::endings_read())
            ->required();
        app.add_option("OUT", choices->out,
                       fmt::format("the file to write, in the format that its ending says; never IN itself. "
                                   "Endings: {}",
                                   fmt::join(known_endings(), " ")));
        app.add_option(
               "--from", choices->read.format,
               "read IN as this format, whatever its ending and content say: " + program::format_names())
            ->type_name("FORMAT");
        app.add_option("--to", choices->write.format,
                       "OUT's format, where its ending does not tell: " + program::format_names())
            ->type_name("FORMAT");
        auto* ascii = app.add_flag("--ascii", choices->ascii, "write text");
        app.add_flag("--binary", choices->binary, "write binary")->excludes(ascii);
        app.add_option("--losses", choices->losses_file,
                       "write what is not read or lost as JSON; - is standard output")
            ->type_name("FILE");
        app.add_flag("--strict", choices->strict,
                     "lose nothing, in reading and in writing, or exit 1 and write nothing. What only "
                     "tetproof reads back from a comment or a section is no loss, unless it is elements");
        app.add_flag("--strict-native", choices->strict_native,
                     "likewise, and any program that reads the format gets all of it");
        app.add_flag("--info", choices->info, "print what the file holds; no OUT");
        return [choices, &common] { return convert(*choices, common); };
      });
}
