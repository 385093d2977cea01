// SPDX-License-Identifier: GPL-3.0-or-later
// A checker of meshes: a command line, and how its answer is read.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "corpus/meshing/process.hpp"

namespace tetproof::corpus {

/// How a checker says what it thinks of a mesh. The expressions are ECMAScript's and are looked for in each
/// line of its output.
struct AnswerRule {
  std::string defective{};        ///< output that means "defective"; empty: the exit code alone says so
  std::string sound{};            ///< output without which nothing is called sound; empty: the exit code
  std::string unread{};           ///< output that means that it gave no verdict
  std::vector<int> unread_exits;  ///< exit codes that mean that it gave no verdict
};

struct Checker {
  std::string name;
  std::vector<std::string> words;  ///< with {mesh}, and {surface} for those that compare
  std::string format;              ///< of the mesh: a name of `formats()` in io/mesh_files.hpp
  std::string mesh_ending;         ///< ".msh", ".1.ele"
  std::string surface_ending = ".off";
  AnswerRule rule{};
  std::string version{};
};

/// What a checker said of a mesh, or how it ended instead.
enum class Answer { sound, defective, refused, crashed, slow, out_of_memory, not_compiled_in };

struct CheckerRun {
  Answer answer = Answer::sound;
  std::string signature;  ///< of an end that is no answer: as in `MesherRun`
  std::string message;    ///< the line of the output that says most
  std::string output;
};

/// Reads an answer. Without `sound` and `defective` exit code 0 means sound and any other one defective; with
/// `defective` any of the two signs is enough; with `sound` the exit code no longer counts: what is neither
/// called sound nor defective is refused if there is a `defective`, else defective. InputError if an
/// expression is none.
class AnswerReader {
 public:
  explicit AnswerReader(const AnswerRule& rule);
  ~AnswerReader();
  AnswerReader(AnswerReader&&) noexcept;
  CheckerRun read(const ProcessEnd& end) const;

 private:
  struct Expressions;
  std::unique_ptr<const Expressions> expressions_;
  AnswerRule rule_;
};

/// The checker of a known program: gmsh, tetgen, tetproof-verify. InputError, with the known names, if there
/// is none, or if its program is not installed.
Checker preset_checker(const std::string& name);
/// A text for users: the presets, their commands and how their answers are read.
std::string list_checkers();

}  // namespace tetproof::corpus
