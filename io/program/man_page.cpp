// SPDX-License-Identifier: GPL-3.0-or-later
// Manual pages, from what --help knows.
#include <fmt/format.h>

#include <algorithm>

#include "io/program/arguments.hpp"

namespace tetproof::program {
namespace {

// A text as roff prints it: a hyphen stays the character that a user types.
std::string plain(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '\\':
        out += "\\e";
        break;
      case '-':
        out += "\\-";
        break;
      case '\'':
        out += "\\(aq";
        break;
      case '`':
        out += "\\(ga";
        break;
      case '^':
        out += "\\(ha";
        break;
      case '~':
        out += "\\(ti";
        break;
      case '"':
        out += "\\(dq";
        break;
      case '|':
        out += "|\\:";
        break;  // long choices may break here
      default:
        out += c;
    }
  }
  return out.starts_with('.') ? "\\&" + out : out;
}

// Each sentence begins a line, as man(7) wants it.
std::string sentences(const std::string& text) {
  std::string out = plain(text);
  for (std::size_t at = 0; (at = out.find(". ", at)) != out.npos; ++at)
    if (at + 2 < out.size() && out[at + 2] >= 'A' && out[at + 2] <= 'Z') out[at + 1] = '\n';
  return out;
}

std::string bold(const std::string& text) {
  return "\\fB" + plain(text) + "\\fR";
}
std::string italic(const std::string& text) {
  return "\\fI" + plain(text) + "\\fR";
}

std::string upper(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return text;
}

// The first clause of a sentence, as whatis(1) shows it.
std::string in_short(const std::string& purpose) {
  std::string text = purpose.substr(0, std::min(purpose.find_first_of(":;"), purpose.find(". ")));
  while (text.ends_with('.')) text.pop_back();
  if (!text.empty() && text[0] >= 'A' && text[0] <= 'Z') text[0] = static_cast<char>(text[0] - 'A' + 'a');
  return text;
}

std::string synopsis(const std::string& name, const std::vector<Argument>& arguments) {
  std::string line = bold(name) + " [" + italic("OPTIONS") + "]";
  for (const Argument& argument : arguments) {
    if (!argument.names.empty()) continue;
    const std::string word = italic(argument.value) + (argument.repeats ? " ..." : "");
    const std::string dashes = argument.kind == Argument::Kind::command ? bold("--") + " " : "";
    line += argument.required ? " " + word : " [" + dashes + word + "]";
  }
  return line;
}

std::string entry(const Argument& argument) {
  std::string head;
  for (const std::string& name : argument.names) head += (head.empty() ? "" : ", ") + bold(name);
  if (!argument.value.empty()) head += (head.empty() ? "" : " ") + italic(argument.value);
  std::string more = argument.limits;
  if (!argument.standard.empty()) more += (more.empty() ? "" : "; ") + ("default " + argument.standard);
  if (!argument.choices.empty() && argument.choices.size() < 12 && argument.kind == Argument::Kind::list)
    more += (more.empty() ? "" : "; ") + fmt::format("of {}", fmt::join(argument.choices, ", "));
  return ".TP\n" + head + "\n" + sentences(argument.help) + (more.empty() ? "" : "\n(" + plain(more) + ")") +
         "\n";
}

}  // namespace

std::string man_page(const CLI::App& app, const Choices& choices, const std::string& purpose,
                     const std::string& examples, const std::string& closing, const std::string& version) {
  const std::string name = app.get_name();
  const std::vector<Argument> arguments = arguments_of(app, choices);
  // A page without a date: the version says what it describes, and the same source gives the same page.
  std::string page =
      fmt::format(".\\\" made by {0} --help-man\n.TH {1} 1 \"\" \"tetproof {2}\" \"User Commands\"\n", name,
                  plain(upper(name)), plain(version));
  page += fmt::format(".SH NAME\n{} \\- {}\n.SH SYNOPSIS\n{}\n.SH DESCRIPTION\n{}\n", plain(name),
                      plain(in_short(purpose)), synopsis(name, arguments), sentences(purpose));
  std::vector<std::string> groups;
  for (const Argument& argument : arguments)
    if (std::find(groups.begin(), groups.end(), argument.group) == groups.end())
      groups.push_back(argument.group);
  std::stable_partition(groups.begin(), groups.end(), [](const auto& group) { return group.empty(); });
  for (const std::string& group : groups) {
    page += ".SH " + plain(group.empty() ? "ARGUMENTS" : upper(group)) + "\n";
    for (const Argument& argument : arguments)
      if (argument.group == group) page += entry(argument);
  }
  page += ".SH EXAMPLES\n.nf\n" + plain(examples) + ".fi\n.SH NOTES\n" + sentences(closing) + "\n";
  return page;
}

}  // namespace tetproof::program
