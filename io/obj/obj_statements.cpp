// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/obj/obj_statements.hpp"

#include <algorithm>
#include <array>

#include "io/bytes/scanner.hpp"
#include "io/bytes/tokens.hpp"

namespace tetproof::io {
namespace {

constexpr std::array<std::string_view, 12> read{"v", "vt", "vn", "f", "fo",     "l",
                                                "p", "g",  "o",  "s", "usemtl", "mtllib"};
// Free-form curves and surfaces, and what only a renderer needs.
constexpr std::array<std::string_view, 35> not_read{
    "vp",       "cstype", "deg",    "bmat",   "step",       "curv",      "curv2", "surf",    "parm",
    "trim",     "hole",   "scrv",   "sp",     "end",        "con",       "mg",    "bevel",   "c_interp",
    "d_interp", "lod",    "usemap", "maplib", "shadow_obj", "trace_obj", "ctech", "stech",   "bsp",
    "bzp",      "cdc",    "cdp",    "res",    "call",       "csh",       "mtlib", "usemtlib"};

}  // namespace

std::string_view next_field(Scanner& scanner) {
  while (!scanner.at_line_end('#')) {
    std::string_view field = scanner.word('#');
    if (field.back() != '\\' || !scanner.ends_line()) return field;
    scanner.next_line();
    field.remove_suffix(1);
    if (!field.empty()) return field;
  }
  return {};
}

std::string name_field(Scanner& scanner) {
  std::string name;
  for (std::string_view field = next_field(scanner); !field.empty(); field = next_field(scanner))
    name.append(name.empty() ? "" : " ").append(field);
  return decode_name(name);
}

void skip_statement(Scanner& scanner) {
  for (;;) {
    const std::string_view line = scanner.rest_of_line();
    if (line.empty() || line.back() != '\\' || line.find('#') != line.npos || scanner.remaining() == 0)
      return;
    scanner.next_line();
  }
}

bool is_statement(std::string_view word) {
  const auto has = [word](const auto& all) { return std::find(all.begin(), all.end(), word) != all.end(); };
  return has(read) || has(not_read);
}

}  // namespace tetproof::io
