// SPDX-License-Identifier: GPL-3.0-or-later
// Completion of arguments in bash, zsh and fish, from what --help knows.
#include <fmt/format.h>

#include <algorithm>

#include "io/error.hpp"
#include "io/program/arguments.hpp"

namespace tetproof::program {
namespace {

using Kind = Argument::Kind;

// A text in single quotes, as all three shells read it. (fish alone has escapes in them: \\ and \'.)
std::string in_quotes(const std::string& text, bool fish = false) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'')
      out += fish ? "\\'" : "'\\''";
    else if (c == '\\' && fish)
      out += "\\\\";
    else
      out += c;
  }
  return out + "'";
}

// The first clause of a help text, as a menu has room for it.
std::string in_short(const std::string& help) {
  std::string text = help.substr(0, std::min({help.find_first_of(":;"), help.find(". "), help.find(" (")}));
  constexpr std::size_t width = 70;
  if (text.size() > width) text = text.substr(0, text.rfind(' ', width)) + " ...";
  return text;
}

std::string identifier(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '-' || c == '.'; }, '_');
  return "_" + name;
}

// The argument without a name that is completed where no option stands: all of a program's are of one kind.
const Argument* of_position(const std::vector<Argument>& arguments) {
  const auto found =
      std::find_if(arguments.begin(), arguments.end(), [](const Argument& a) { return a.names.empty(); });
  return found == arguments.end() ? nullptr : &*found;
}

// What bash offers for a value, as one command.
std::string bash_values(const Argument& argument) {
  switch (argument.kind) {
    case Kind::choice:
      return fmt::format("_words {}", fmt::join(argument.choices, " "));
    case Kind::list:
      return fmt::format("_list {}", fmt::join(argument.choices, " "));
    case Kind::file:
      return "_files -f";
    case Kind::folder:
      return "_files -d";
    default:
      return ":";
  }
}

std::string bash(const std::string& name, const std::vector<Argument>& arguments) {
  const std::string function = identifier(name);
  const auto own = [&](std::string command) { return command[0] == '_' ? function + command : command; };
  std::string all, cases;
  for (const Argument& argument : arguments) {
    for (const std::string& option : argument.names) all += (all.empty() ? "" : " ") + option;
    if (argument.kind != Kind::flag && !argument.names.empty())
      cases +=
          fmt::format("    {}) {}; return ;;\n", fmt::join(argument.names, "|"), own(bash_values(argument)));
  }
  const Argument* position = of_position(arguments);
  const bool command = position && position->kind == Kind::command;
  std::string text = fmt::format("# bash completion for {0}, made by {0} --completion bash\n", name);
  text += fmt::format(R"({0}_words() {{ mapfile -t COMPREPLY < <(compgen -W "$*" -- "$cur"); }}
{0}_list() {{  # the last of the words between commas
  local before=""
  [[ $cur == *,* ]] && before=${{cur%,*}},
  mapfile -t COMPREPLY < <(compgen -P "$before" -W "$*" -- "${{cur##*,}}")
  compopt -o nospace 2>/dev/null
}}
{0}_files() {{
  mapfile -t COMPREPLY < <(compgen "$1" -- "$cur")
  compopt -o filenames 2>/dev/null
}}
{0}() {{
  local cur=${{COMP_WORDS[COMP_CWORD]}} option=${{COMP_WORDS[COMP_CWORD - 1]}} i
  # bash takes --option=value for three words
  if [[ $cur == "=" ]]; then
    cur=""
  elif [[ $option == "=" ]]; then
    option=${{COMP_WORDS[COMP_CWORD - 2]}}
  fi
  COMPREPLY=()
)",
                      function);
  if (command)
    text += R"(  for ((i = 1; i < COMP_CWORD; ++i)); do
    [[ ${COMP_WORDS[i]} == -- ]] || continue  # the rest is another program's
    if ((i == COMP_CWORD - 1)); then
      mapfile -t COMPREPLY < <(compgen -c -- "$cur")
    else
      )" + function +
            R"(_files -f
    fi
    return
  done
)";
  text += "  case $option in\n" + cases + "  esac\n";
  text += fmt::format("  if [[ $cur == -* ]]; then\n    {}_words {}\n", function, all);
  if (position && !command) text += fmt::format("  else\n    {}_files -f\n", function);
  text += fmt::format("  fi\n}}\ncomplete -F {} {}\n", function, name);
  return text;
}

std::string zsh_values(const Argument& argument) {
  switch (argument.kind) {
    case Kind::choice:
      return fmt::format("({})", fmt::join(argument.choices, " "));
    case Kind::list:
      return fmt::format("_values -s , {} {}", argument.value, fmt::join(argument.choices, " "));
    case Kind::file:
      return "_files";
    case Kind::folder:
      return "_files -/";
    case Kind::command:
      return "_normal";
    default:
      return "";
  }
}

std::string zsh(const std::string& name, const std::vector<Argument>& arguments) {
  // A specification ends at a colon or a bracket.
  const auto escaped = [](const std::string& text) {
    std::string out;
    for (const char c : text) {
      if (c == ':' || c == '[' || c == ']' || c == '\\') out += '\\';
      out += c;
    }
    return out;
  };
  std::string text =
      fmt::format("#compdef {0}\n# zsh completion, made by {0} --completion zsh\n_arguments -S", name);
  for (const Argument& argument : arguments) {
    const std::string values = zsh_values(argument);
    for (const std::string& option : argument.names) {
      // One that repeats may stand there several times.
      std::string specification = (argument.repeats ? "*" : "") + option;
      if (argument.kind != Kind::flag && option.starts_with("--")) specification += "=";
      specification += "[" + escaped(in_short(argument.help)) + "]";
      if (argument.kind != Kind::flag) specification += ":" + escaped(argument.value) + ":" + values;
      text += " \\\n  " + in_quotes(specification);
    }
    if (argument.names.empty())
      text += " \\\n  " + in_quotes((argument.kind == Kind::command ? "*::"
                                     : argument.repeats             ? "*:"
                                                                    : ":") +
                                    escaped(argument.value) + ":" + values);
  }
  return text + "\n";
}

std::string fish(const std::string& name, const std::vector<Argument>& arguments) {
  std::string text = fmt::format("# fish completion for {0}, made by {0} --completion fish\n", name);
  for (const Argument& argument : arguments) {
    if (argument.names.empty()) continue;
    std::string line = "complete -c " + name;
    for (const std::string& option : argument.names)
      line += option.starts_with("--") ? " -l " + option.substr(2) : " -s " + option.substr(1);
    switch (argument.kind) {
      case Kind::flag:
        break;
      case Kind::file:
        line += " -r -F";
        break;
      case Kind::folder:
        line += " -x -a " + in_quotes("(__fish_complete_directories)", true);
        break;
      case Kind::choice:
        line += fmt::format(" -x -a '{}'", fmt::join(argument.choices, " "));
        break;
      case Kind::list:
        line += fmt::format(" -x -a '(__fish_append , {})'", fmt::join(argument.choices, " "));
        break;
      default:
        line += " -x";
    }
    text += line + " -d " + in_quotes(in_short(argument.help), true) + "\n";
  }
  return text;
}

}  // namespace

std::string completion(const CLI::App& app, const Choices& choices, const std::string& shell) {
  const std::vector<Argument> arguments = arguments_of(app, choices);
  if (shell == "bash") return bash(app.get_name(), arguments);
  if (shell == "zsh") return zsh(app.get_name(), arguments);
  if (shell == "fish") return fish(app.get_name(), arguments);
  throw InputError("--completion: expected bash, zsh or fish, found '" + shell + "'");
}

}  // namespace tetproof::program
