// SPDX-License-Identifier: GPL-3.0-or-later
// Facts: vtkDataWriter::WriteInformation and vtkXMLWriter of VTK 9.1.
#include "io/vtk/vtk_information.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/bytes/scanner.hpp"
#include "io/bytes/tokens.hpp"
#include "io/loss/loss_list.hpp"
#include "io/vtk/vtk_words.hpp"

namespace tetproof::io {
namespace {

// What anybody can compute from the array's values.
constexpr std::string_view computed_keys[] = {"L2_NORM_RANGE",
                                              "L2_NORM_FINITE_RANGE",
                                              "COMPONENT_RANGE",
                                              "PER_COMPONENT",
                                              "PER_FINITE_COMPONENT",
                                              "DISCRETE_VALUES",
                                              "DISCRETE_VALUE_SAMPLE_PARAMETERS"};

}  // namespace

void add_vtk_role(std::vector<Loss>& dropped, const std::string& array, std::string_view role) {
  add_loss(dropped, "attribute roles of values", 1, fmt::format("\"{}\" as {}", array, role));
}

void add_vtk_component_name(std::vector<Loss>& dropped, const std::string& array, std::string_view name) {
  if (!name.empty())
    add_loss(dropped, "names of components", 1, fmt::format("\"{}\" of \"{}\"", name, array));
}

void add_vtk_information(std::vector<Loss>& dropped, const std::string& array, std::string_view key) {
  if (std::find(std::begin(computed_keys), std::end(computed_keys), key) != std::end(computed_keys)) return;
  add_loss(dropped, fmt::format("information {}", key), 1, fmt::format("\"{}\"", array));
}

// VTK writes COMPONENT_NAMES and a name in each line, then INFORMATION and the number of keys, and for each
// key a line "NAME key LOCATION class" and one that begins with DATA.
void read_vtk_metadata(Scanner& in, const std::string& array, std::vector<Loss>& dropped) {
  bool names = false;
  for (in.next_line(); in.remaining() > 0 && !in.ends_line(); in.next_line()) {
    const std::string_view line = in.rest_of_line();
    const std::string no_path;
    Scanner words(no_path, line);
    const std::string first = lower_case(words.word());
    if (first == "component_names") {
      names = true;
    } else if (first == "information") {
      names = false;
    } else if (names) {
      add_vtk_component_name(dropped, array, vtk_decoded(line));
    } else if (first == "name") {
      add_vtk_information(dropped, array, words.word());
    } else if (first != "data" && !first.empty()) {
      add_loss(dropped, "lines of METADATA", 1, fmt::format("line {}", in.line()));
    }
  }
}

}  // namespace tetproof::io
