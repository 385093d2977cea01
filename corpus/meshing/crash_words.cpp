// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the words of a crash in a program's output.
#include "corpus/meshing/crash_words.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/meshing/output_lines.hpp"

namespace tetproof::corpus {

namespace {

constexpr std::size_t npos = std::string::npos;

std::string last_part(const std::string& path) {
  return path.substr(path.find_last_of("/\\") + 1);
}

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  return begin == npos ? "" : text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

/// "PROGRAM: FILE:LINE: FUNCTION: Assertion `TEXT' failed." The program's name is absent in some libraries.
std::optional<CrashWords> assertion(const std::string& line) {
  const std::size_t said = line.find(": Assertion ");
  if (said == npos || line.find(" failed", said) == npos) return std::nullopt;
  const std::string text = line.substr(said + 2, line.rfind(" failed") + 7 - said - 2);
  // FILE:LINE is the first place where digits stand between colons.
  for (std::size_t colon = line.find(':'); colon != npos && colon < said; colon = line.find(':', colon + 1)) {
    const std::size_t end = line.find_first_not_of("0123456789", colon + 1);
    if (end == colon + 1 || end == npos || line[end] != ':') continue;
    const std::size_t before = line.rfind(": ", colon);
    const std::size_t begin = before == npos || before >= colon ? 0 : before + 2;
    const std::string place = last_part(line.substr(begin, colon - begin)) + line.substr(colon, end - colon);
    const std::string function = end + 1 < said ? function_name(line.substr(end + 1, said - end - 1)) : "";
    return CrashWords{(function.empty() ? "" : function + ": ") + text + " at " + place, line};
  }
  return CrashWords{without_numbers(text), line};
}

/// The text after `label` in one of the lines from `first` on.
std::string labelled(const std::vector<std::string>& lines, std::size_t first, std::string_view label) {
  for (std::size_t i = first; i < std::min(lines.size(), first + 8); ++i) {
    if (lines[i].compare(0, label.size(), label) != 0) continue;
    const std::size_t colon = lines[i].find(':');
    if (colon != npos) return trimmed(lines[i].substr(colon + 1));
  }
  return "";
}

/// CGAL prints "CGAL error: assertion violation!" and then Expression, File, Line and Explanation.
std::optional<CrashWords> cgal(const std::vector<std::string>& lines, std::size_t i) {
  if (says(lines[i], "cgal warning")) return std::nullopt;  // it goes on
  if (!says(lines[i], "cgal error: ") && !says(lines[i], "violation!")) return std::nullopt;
  std::string expression = labelled(lines, i, "Expr"), explanation = labelled(lines, i, "Expl");
  const std::string file = last_part(labelled(lines, i, "File")), number = labelled(lines, i, "Line");
  if (file.empty()) return std::nullopt;
  return CrashWords{"CGAL: " + (explanation.empty() ? expression : without_numbers(explanation)) + " at " +
                        file + ":" + number,
                    lines[i] + " " + expression};
}

std::optional<CrashWords> uncaught(const std::vector<std::string>& lines, std::size_t i) {
  constexpr std::string_view words = "terminate called after throwing an instance of '";
  const std::size_t at = lines[i].find(words);
  if (at == npos) return std::nullopt;
  const std::size_t begin = at + words.size();
  const std::string type = lines[i].substr(begin, lines[i].rfind('\'') - begin);
  if (type == "int") return std::nullopt;
  std::string what;
  for (std::size_t k = i + 1; k < std::min(lines.size(), i + 3); ++k)
    if (const std::size_t w = lines[k].find("what():"); w != npos) what = trimmed(lines[k].substr(w + 7));
  if (type == "std::bad_alloc") return std::nullopt;  // no memory
  return CrashWords{"uncaught " + type + (what.empty() ? "" : ": " + without_numbers(what)),
                    lines[i] + (what.empty() ? "" : ": " + what), true, what.empty()};
}

/// "==1==ERROR: AddressSanitizer: heap-use-after-free on address ..."; the function is that of frame 0 or 1.
std::optional<CrashWords> sanitizer(const std::vector<std::string>& lines, std::size_t i) {
  const std::string& line = lines[i];
  if (const std::size_t at = line.find(": runtime error: "); at != npos) {
    const std::size_t colon = line.find(':');
    const std::size_t end = line.find_first_not_of("0123456789", colon + 1);
    return CrashWords{"UndefinedBehaviorSanitizer: " + without_numbers(line.substr(at + 17)) + " at " +
                          last_part(line.substr(0, colon)) + line.substr(colon, end - colon),
                      line, false};
  }
  for (const char* name : {"AddressSanitizer", "MemorySanitizer", "ThreadSanitizer", "LeakSanitizer"}) {
    const std::size_t at = line.find(std::string(name) + ": ");
    if (at == npos || (!says(line, "error: ") && !says(line, "warning: "))) continue;
    std::string what = line.substr(at);
    what = what.substr(0, what.find(' ', what.find(": ") + 2));
    for (std::size_t k = i + 1; k < std::min(lines.size(), i + 30); ++k) {
      const std::size_t in = lines[k].find(" in ");
      const std::string frame = trimmed(lines[k]);
      if (frame.empty() || frame[0] != '#' || in == npos) continue;
      const std::string function = function_name(lines[k].substr(in + 4, lines[k].rfind(' ') - in - 4));
      if (says(lines[k], "sanitizer") || function == "malloc" || function == "free" ||
          function == "operator new")
        continue;
      return CrashWords{what + " in " + function, line, false};
    }
    return CrashWords{what, line, false};
  }
  return std::nullopt;
}

/// Words that a library or a crash handler prints as a line of their own.
struct Phrase {
  std::string_view words;  ///< in lower case
  bool needs_signal;
  bool heap = false;  ///< the C library found its heap damaged: by whom, and when, it does not know
};
constexpr std::array phrases{
    Phrase{"double free or corruption", true, true},
    Phrase{"free(): ", true, true},
    Phrase{"malloc(): ", true, true},
    Phrase{"realloc(): ", true, true},
    Phrase{"munmap_chunk(): ", true, true},
    Phrase{"malloc_consolidate(): ", true, true},
    Phrase{"corrupted size vs. prev_size", true, true},
    Phrase{"corrupted double-linked list", true, true},
    Phrase{"stack smashing detected", true},
    Phrase{"buffer overflow detected", true},
    Phrase{"pure virtual method called", true},
    Phrase{"segmentation violation", true},     // Gmsh's handler
    Phrase{"caught sigsegv", true},             // Netgen's
    Phrase{"caught signal", true},              // others'
    Phrase{"please report this bug to", true},  // TetGen, for what it should never come to
};

std::optional<CrashWords> phrase(const std::vector<std::string>& lines, std::size_t i) {
  for (const Phrase& p : phrases) {
    if (!says(lines[i], p.words)) continue;
    // What stands in the line before is what it was doing, and not what went wrong: the backtrace says where.
    if (p.words == "please report this bug to")
      return CrashWords{"internal error", lines[i], p.needs_signal, true};
    // The same fault has other words, at another place, from run to run.
    if (p.heap) return CrashWords{"heap corruption", lines[i], p.needs_signal, false};
    return CrashWords{without_numbers(trimmed(lines[i])), lines[i], p.needs_signal, true};
  }
  return std::nullopt;
}

}  // namespace

std::string function_name(const std::string& declaration) {
  std::string text = trimmed(declaration);
  if (const std::size_t with = text.find(" [with "); with != npos) text.resize(with);
  // The parameters begin at the first parenthesis that is not part of a name: "operator()", "(anonymous
  // ...)".
  std::size_t open = npos;
  int angles = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '<') ++angles;
    if (text[i] == '>' && angles > 0 && (i == 0 || text[i - 1] != '-')) --angles;
    if (text[i] != '(' || angles > 0) continue;
    if (text.compare(i, 11, "(anonymous ") == 0 || (i >= 8 && text.compare(i - 8, 10, "operator()") == 0)) {
      i = text.find(')', i);
      if (i == npos) break;
      continue;
    }
    open = i;
    break;
  }
  if (open != npos) text = trimmed(text.substr(0, open));  // gdb puts a space before the arguments
  // The name follows the last "::" or space outside of angle brackets.
  std::size_t begin = 0;
  angles = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '<') ++angles;
    if (text[i] == '>' && angles > 0) --angles;
    if (angles > 0 || text.compare(begin, 8, "operator") == 0) continue;
    if (text[i] == ' ' || text[i] == '*' || text[i] == '&') begin = i + 1;
    if (text[i] == ':' && i + 1 < text.size() && text[i + 1] == ':') begin = i + 2;
  }
  const std::string name = text.substr(std::min(begin, text.size()));
  const std::size_t angle = name.find('<');
  return angle == 0 || name.compare(0, 8, "operator") == 0 ? name : name.substr(0, angle);
}

std::optional<CrashWords> crash_words(const std::vector<std::string>& lines) {
  std::optional<CrashWords> first;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::optional<CrashWords> found = assertion(lines[i]);
    if (!found) found = cgal(lines, i);
    if (!found) found = sanitizer(lines, i);
    if (found) return found;
    if (!first) first = uncaught(lines, i);
    if (!first) first = phrase(lines, i);
  }
  return first;
}

}  // namespace tetproof::corpus
