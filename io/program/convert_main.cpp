// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-convert: from one mesh file to another, with a list of what is lost on the way.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/error.hpp"
#include "io/gmsh/gmsh_import.hpp"
#include "io/mesh_files.hpp"
#include "io/program/describe.hpp"
#include "io/program/program.hpp"
#include "io/writing.hpp"

namespace {

using namespace tetproof;
using Json = nlohmann::ordered_json;

Json json_of(const std::vector<Loss>& losses) {
  Json list = Json::array();
  for (const Loss& loss : losses)
    list.push_back({{"item", loss.item}, {"count", loss.count}, {"example", loss.example}});
  return list;
}

std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";  // names in files need not be UTF-8
}

struct Choices {
  std::string in, out, losses_file;
  WriteOptions write;
  bool ascii = false, binary = false, strict = false, info = false;
};

int convert(const Choices& choices, const program::Common& common) {
  if (choices.out.empty() && !choices.info) throw InputError("OUT is missing (or ask for --info)");
  if (!choices.out.empty() && choices.info) throw InputError("--info writes no file: leave out OUT");
  WriteOptions write = choices.write;
  if (choices.ascii || choices.binary) write.binary = choices.binary;
  if (!choices.info) encoding_of(choices.out, write);  // refuses bad choices before a long read

  const Document document = read_document(choices.in);
  for (const std::string& warning : document.warnings) program::say(common, "warning: " + warning);
  for (const Loss& loss : document.dropped)
    program::say(common, fmt::format("not read: {}: {} ({})", loss.item, loss.count, loss.example));
  Json result{{"input", describe_json(document)}, {"dropped", json_of(document.dropped)}};
  if (choices.info) {
    if (common.json != "-") fmt::print("{}", describe_text(document));
    if (!common.json.empty()) program::write_text(common.json, text_of(result));
    return program::sound;
  }

  PlannedFile file(choices.out, document, write);
  const std::vector<Loss>& lost = file.losses();
  for (const Loss& loss : lost)
    program::say(common, fmt::format("lost: {}: {} ({})", loss.item, loss.count, loss.example));
  const KeptAside& kept = file.kept_aside();
  for (const Loss& item : kept.items)
    program::say(common,
                 fmt::format("kept in {}: {}: {} ({})", kept.where, item.item, item.count, item.example));
  const bool refused = choices.strict && !(lost.empty() && document.dropped.empty());
  if (!refused) {
    if (!file.warning().empty()) program::say(common, "warning: " + file.warning());
    file.write();
  }
  result["output"] = {{"file", choices.out},
                      {"format", file.encoding().format},
                      {"binary", file.encoding().binary},
                      {"written", !refused}};
  result["losses"] = json_of(lost);
  result["kept_aside"] = json_of(kept.items);
  if (!kept.items.empty()) result["output"]["kept_in"] = kept.where;
  if (!choices.losses_file.empty())
    program::write_text(choices.losses_file, text_of(Json{{"dropped", result["dropped"]},
                                                          {"losses", result["losses"]},
                                                          {"kept_aside", result["kept_aside"]}}));
  if (!common.json.empty()) program::write_text(common.json, text_of(result));
  if (!refused) return program::sound;
  const std::size_t items = lost.size() + document.dropped.size();
  program::say(common, fmt::format("{}: not written, since {} of {} {} (--strict)", choices.out,
                                   items == 1 ? "something" : "several things", choices.in,
                                   document.dropped.empty() ? "would be lost"
                                   : !lost.empty()          ? "are not read or would be lost"
                                   : items == 1             ? "is not read"
                                                            : "are not read"));
  return program::wrong;
}

}  // namespace

int main(int argc, char** argv) {
  std::string names;
  for (const Format& format : formats()) names += (names.empty() ? "" : ", ") + format.name;
  return program::run(
      argc, argv,
      {.purpose = "Converts meshes and surfaces between formats, and says what the target cannot hold.",
       .examples =
           "  tetproof-convert grid.msh grid.1.ele              for TetGen: grid.1.node and grid.1.ele\n"
           "  tetproof-convert grid.1.node grid.msh --binary    Gmsh 4.1, binary\n"
           "  tetproof-convert grid.msh old.msh --to msh22\n"
           "  tetproof-convert grid.msh grid.vtu --strict       exit 1 and no file if anything is lost\n"
           "  tetproof-convert --info grid.msh\n"
           "  tetproof-convert part.step part.msh               what only Gmsh reads; geometry is meshed\n",
       .libraries = {}},
      [&](CLI::App& app, program::Common& common) -> std::function<int()> {
        auto choices = std::make_shared<Choices>();
        app.add_option("IN", choices->in,
                       fmt::format("a mesh or a surface: {}; through Gmsh: {}",
                                   fmt::join(known_endings(), " "), fmt::join(io::gmsh_endings(), " ")))
            ->required();
        app.add_option("OUT", choices->out, "the file to write; its ending says the format");
        app.add_option("--to", choices->write.format, "the format, when OUT's ending does not tell: " + names)
            ->type_name("FORMAT");
        auto* ascii = app.add_flag("--ascii", choices->ascii, "write text");
        app.add_flag("--binary", choices->binary, "write binary")->excludes(ascii);
        app.add_option("--losses", choices->losses_file,
                       "write what is not read or lost as JSON; - is standard output")
            ->type_name("FILE");
        app.add_flag("--strict", choices->strict,
                     "lose nothing, in reading and in writing, or exit 1 and write nothing");
        app.add_flag("--info", choices->info, "print what the file holds; no OUT");
        return [choices, &common] { return convert(*choices, common); };
      });
}
