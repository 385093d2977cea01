// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a checker's answer from its exit code and its words.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <regex>
#include <string_view>

#include "corpus/checkers/checker.hpp"
#include "corpus/meshing/end_class.hpp"
#include "corpus/meshing/output_lines.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

// The library's matcher needs stack for each byte that an expression passes.
constexpr std::size_t longest_line = 2000;

std::optional<std::regex> compiled(const std::string& expression) {
  if (expression.empty()) return std::nullopt;
  try {
    return std::regex(expression, std::regex::ECMAScript | std::regex::optimize);
  } catch (const std::regex_error& error) {
    throw InputError(fmt::format("'{}': expected a regular expression: {}", expression, error.what()));
  }
}

const std::string* line_with(const std::vector<std::string>& lines, const std::optional<std::regex>& what) {
  if (!what) return nullptr;
  for (const std::string& line : lines) {
    const std::string_view part = std::string_view(line).substr(0, longest_line);
    if (std::regex_search(part.begin(), part.end(), *what)) return &line;
  }
  return nullptr;
}

// The ends that are no answers. A checker's words on a mesh can sound like a mesher's refusal.
std::optional<Answer> no_answer(Outcome outcome) {
  switch (outcome) {
    case Outcome::crashed:
      return Answer::crashed;
    case Outcome::slow:
      return Answer::slow;
    case Outcome::out_of_memory:
      return Answer::out_of_memory;
    case Outcome::not_compiled_in:
      return Answer::not_compiled_in;
    default:
      return std::nullopt;
  }
}

}  // namespace

struct AnswerReader::Expressions {
  std::optional<std::regex> defective, sound, unread;
};

AnswerReader::AnswerReader(const AnswerRule& rule)
    : expressions_(new Expressions{compiled(rule.defective), compiled(rule.sound), compiled(rule.unread)}),
      rule_(rule) {}
AnswerReader::~AnswerReader() = default;
AnswerReader::AnswerReader(AnswerReader&&) noexcept = default;

CheckerRun AnswerReader::read(const ProcessEnd& end) const {
  const EndClass ended = classify_end(end);
  CheckerRun run{.signature = ended.signature, .message = ended.message, .output = end.output};
  if (ended.failure)
    if (const auto answer = no_answer(*ended.failure)) {
      run.answer = *answer;
      return run;
    }
  const std::vector<std::string> lines = output_lines(end.output);
  const auto says = [&](Answer answer, const std::string* line) {
    run.answer = answer;
    if (line) run.message = *line;
    if (run.message.empty() && end.exit_code != 0) run.message = fmt::format("exit code {}", end.exit_code);
    run.signature = without_numbers(run.message);
    return run;
  };
  const auto& exits = rule_.unread_exits;
  if (std::find(exits.begin(), exits.end(), end.exit_code) != exits.end())
    return says(Answer::refused, nullptr);
  if (const std::string* line = line_with(lines, expressions_->unread)) return says(Answer::refused, line);
  if (const std::string* line = line_with(lines, expressions_->defective))
    return says(Answer::defective, line);
  if (expressions_->sound) {
    if (const std::string* line = line_with(lines, expressions_->sound)) return says(Answer::sound, line);
    return says(expressions_->defective ? Answer::refused : Answer::defective, nullptr);
  }
  return says(end.exit_code == 0 ? Answer::sound : Answer::defective, nullptr);
}

}  // namespace tetproof::corpus
