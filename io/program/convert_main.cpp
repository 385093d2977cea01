// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-convert IN... OUT: converts mesh files, edits them on the way, and lists what is lost.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "corpus/surfaces.hpp"
#include "io/bytes/words.hpp"
#include "io/edit/edits.hpp"
#include "io/error.hpp"
#include "io/mesh_files.hpp"
#include "io/program/describe.hpp"
#include "io/program/edit_options.hpp"
#include "io/program/files_in_use.hpp"
#include "io/program/mesh_formats.hpp"
#include "io/program/program.hpp"
#include "io/program/refusal.hpp"
#include "io/program/report_losses.hpp"

namespace {

using namespace tetproof;
using Json = nlohmann::ordered_json;

struct Choices {
  std::vector<std::string> files;  // IN..., and OUT as the last
  std::vector<std::string> in;
  std::string out, losses_file;
  ReadOptions read;
  WriteOptions write;
  program::EditOptions edits;
  bool ascii = false, binary = false, strict = false, strict_native = false, info = false;
};

// Tells the inputs from the output.
void sort_files(Choices& choices) {
  if (!choices.out.empty()) choices.files.push_back(choices.out);
  if (choices.info) {
    if (choices.files.size() > 1) throw InputError("--info writes no file: leave out OUT");
    if (choices.edits.split_by_group) throw InputError("--info writes no file: leave out --split-by-group");
  } else if (choices.files.size() < 2) {
    throw InputError("OUT is missing (or ask for --info)");
  }
  choices.in = choices.files;
  if (choices.info) return;
  choices.out = choices.in.back();
  choices.in.pop_back();
}

// Reads a file, or makes the surface of a specification.
Document input(const std::string& in, const ReadOptions& options) {
  if (!corpus::is_generated(in)) return read_document(in, options);
  if (!options.format.empty()) throw InputError("--from needs an IN that is a file");
  Document document = document_of(corpus::make_surface(in));
  document.path = in;
  document.format = "generated";
  return document;
}

program::Strictness strictness_of(const Choices& choices) {
  return choices.strict_native ? program::Strictness::native
         : choices.strict      ? program::Strictness::strict
                               : program::Strictness::lax;
}

// All inputs as one document. `result` gets what they hold.
Document joined_input(const Choices& choices, const program::Common& common, program::Progress& progress,
                      Json& result, std::vector<program::DoneEdit>& done) {
  Document document;
  for (std::size_t i = 0; i < choices.in.size(); ++i) {
    progress.enter(choices.in.size() == 1 ? "reading" : "reading " + choices.in[i]);
    Document next = input(choices.in[i], choices.read);
    program::report_reading(common, next.warnings, next.dropped);
    if (choices.in.size() > 1) result["inputs"].push_back(describe_json(next));
    if (i == 0) {
      document = std::move(next);
      continue;
    }
    done.push_back({"IN " + choices.in[i], io::join(document, std::move(next))});
    program::say_edit(common, done.back());
  }
  result["input"] = describe_json(document);
  return document;
}

std::vector<Loss> losses_of(const std::vector<program::DoneEdit>& done) {
  std::vector<Loss> lost;
  for (const program::DoneEdit& edit : done)
    lost.insert(lost.end(), edit.edit.lost.begin(), edit.edit.lost.end());
  return lost;
}

// A file that is going to be written, and what of the document it will not hold.
struct Output {
  std::string path;
  std::unique_ptr<program::MeshOutput> file;
};

Json output_json(Output& output, bool written) {
  const KeptAside& kept = output.file->kept_aside();
  Json json{{"file", output.path},
            {"format", output.file->encoding().format},
            {"binary", output.file->encoding().binary},
            {"written", written}};
  if (!kept.items.empty()) json["kept_in"] = kept.where;
  return json;
}

// What was read and edited, in words and as JSON.
int print_information(const Choices& choices, const program::Common& common, const Document& document,
                      const std::vector<program::DoneEdit>& done, bool is_room, Json& result) {
  const std::vector<Loss> lost = losses_of(done);
  if (!done.empty()) result["edits"] = program::edits_json(done), result["edited"] = describe_json(document);
  if (is_room) fmt::print("{}", describe_text(document));
  if (!choices.losses_file.empty())
    program::write_json(choices.losses_file, Json{{"dropped", result["dropped"]},
                                                  {"losses", program::losses_json(lost)},
                                                  {"kept_aside", Json::array()},
                                                  {"dangling", Json::array()}});
  if (!common.json.empty()) program::write_json(common.json, result);
  const program::Refusal refusal(strictness_of(choices), document.dropped, lost, {}, {});
  if (refusal.items() == 0) return program::sound;
  program::say(common, fmt::format("{}: {} {} ({})", fmt::join(choices.in, ", "),
                                   refusal.items() == 1 ? "something" : "several things", refusal.why(""),
                                   choices.strict_native ? "--strict-native" : "--strict"));
  return program::wrong;
}

int convert(Choices& choices, const program::Common& common) {
  sort_files(choices);
  program::check_edits(choices.edits);
  WriteOptions write = choices.write;
  if (choices.ascii || choices.binary) write.binary = choices.binary;
  program::FilesInUse files(common);
  for (std::size_t i = 0; i < choices.in.size(); ++i)
    if (!corpus::is_generated(choices.in[i]))
      files.reads_mesh(i == 0 ? "IN" : fmt::format("IN {}", i + 1), choices.in[i], choices.read);
  files.writes_mesh("OUT", choices.out, write);
  files.writes("--losses", choices.losses_file);

  Json result;
  std::vector<program::DoneEdit> done;
  program::Progress progress(common,
                             {{"reading", 0.35}, {"editing", 0}, {"planning", 0.1}, {"writing", 0.55}});
  choices.read.progress = progress.part_listener();
  Document document = joined_input(choices, common, progress, result, done);
  result["dropped"] = program::losses_json(document.dropped);
  progress.enter("editing");
  for (program::DoneEdit& edit : program::apply_edits(common, choices.edits, document))
    done.push_back(std::move(edit));
  if (choices.info) {
    progress.end();
    return print_information(choices, common, document, done, !files.standard_output_is_taken(), result);
  }
  progress.enter("planning");

  std::vector<io::GroupPart> parts;
  std::vector<Output> outputs;
  const auto add_output = [&](const std::string& argument, const std::string& path, const Document& part) {
    outputs.push_back(
        {path, std::make_unique<program::MeshOutput>(common, files, argument, path, part, write)});
  };
  if (choices.edits.split_by_group) {
    parts = io::split_by_group(document);
    done.push_back({"--split-by-group", {fmt::format("{} files", parts.size()), {}}});
    for (io::GroupPart& part : parts)
      for (Loss& loss : part.lost) done.back().edit.lost.push_back(std::move(loss));
    program::say_edit(common, done.back());
    for (const io::GroupPart& part : parts) {
      const std::string path = program::path_of_part(choices.out, part.word);
      program::say(common,
                   fmt::format("{}: {} and {}", path, io::counted(part.document.points.size(), "nodes"),
                               io::counted(part.document.elements(), "elements")));
      add_output("OUT of " + part.word, path, part.document);
    }
  } else {
    add_output("OUT", choices.out, document);
  }

  std::vector<Loss> lost = losses_of(done), kept, dangling;
  std::string kept_in;
  for (Output& output : outputs) {
    const std::vector<Loss>& losses = output.file->losses();
    lost.insert(lost.end(), losses.begin(), losses.end());
    const KeptAside& aside = output.file->kept_aside();
    kept.insert(kept.end(), aside.items.begin(), aside.items.end());
    if (!aside.items.empty()) kept_in = aside.where;
    const std::vector<Loss>& without_nodes = output.file->dangling();
    dangling.insert(dangling.end(), without_nodes.begin(), without_nodes.end());
  }
  const program::Refusal refusal(strictness_of(choices), document.dropped, lost, kept, dangling);
  const bool refused = refusal.items() > 0;
  progress.enter("writing");
  for (Output& output : outputs)
    if (!refused) output.file->write();
  progress.end();
  if (!done.empty()) result["edits"] = program::edits_json(done);
  if (choices.edits.split_by_group)
    for (Output& output : outputs) result["outputs"].push_back(output_json(output, !refused));
  else
    result["output"] = output_json(outputs.front(), !refused);
  result["losses"] = program::losses_json(lost);
  result["kept_aside"] = program::losses_json(kept);
  result["dangling"] = program::losses_json(dangling);
  if (!choices.losses_file.empty())
    program::write_json(choices.losses_file, Json{{"dropped", result["dropped"]},
                                                  {"losses", result["losses"]},
                                                  {"kept_aside", result["kept_aside"]},
                                                  {"dangling", result["dangling"]}});
  if (!common.json.empty()) program::write_json(common.json, result);
  if (!refused) return program::sound;
  program::say(common,
               fmt::format("{}: not written, since {} of {} {} ({})", choices.out,
                           refusal.items() == 1 ? "something" : "several things", fmt::join(choices.in, ", "),
                           refusal.why(kept_in), choices.strict_native ? "--strict-native" : "--strict"));
  return program::wrong;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> words = program::with_joined_tolerance(argc, argv);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  return program::run(
      static_cast<int>(words.size()), arguments.data(),
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
           "  zcat grid.vtk.gz | tetproof-convert - grid.msh    from standard input\n"
           "  tetproof-convert grid.msh skin.stl --boundary     the surface of the solids\n"
           "  tetproof-convert a.msh b.msh ab.msh --merge-points   two meshes as one\n"
           "  tetproof-convert grid.msh part.vtu --split-by-group  part_steel.vtu, part_air.vtu, ...\n",
       .libraries = {}},
      [&](CLI::App& app, program::Common& common) -> std::function<int()> {
        auto choices = std::make_shared<Choices>();
        app.add_option(
               "IN", choices->files,
               "a mesh or a surface, or a generated surface (tetproof-mesh --list-surfaces); - is standard "
               "input. Several are joined into one. Endings: " +
                   program::endings_read())
            ->default_str("")
            ->required();
        app.add_option(
            "OUT", choices->out,
            fmt::format("the last of the files: the file to write, in the format that its ending says; "
                        "never an IN itself. Endings: {}",
                        fmt::join(known_endings(), " ")));
        app.add_option(
               "--from", choices->read.format,
               "read IN as this format, whatever its ending and content say: " + program::format_names())
            ->check(program::not_empty)
            ->type_name("FORMAT");
        app.add_option("--to", choices->write.format,
                       "OUT's format, where its ending does not tell: " + program::format_names())
            ->check(program::not_empty)
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
                     "likewise, and any program that reads the format gets all of it: nothing kept aside, no "
                     "element that names a node which does not exist");
        app.add_flag("--info", choices->info, "print what the file holds, after the edits; no OUT");
        program::declare_edits(app, choices->edits);
        return [choices, &common] { return convert(*choices, common); };
      });
}
