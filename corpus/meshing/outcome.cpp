// SPDX-License-Identifier: GPL-3.0-or-later
// The names of the outcomes, and which of them are findings.
#include "corpus/meshing/outcome.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace tetproof::corpus {

namespace {

struct Row {
  Outcome outcome;
  const char* name;
  bool finding;
};

constexpr std::array rows{
    Row{Outcome::sound, "sound", false},
    Row{Outcome::wrong, "wrong-answer", true},
    Row{Outcome::wrong_against_surface, "wrong-against-surface", true},
    Row{Outcome::refused, "refused", false},
    Row{Outcome::refused_valid, "refused-valid", true},
    Row{Outcome::crashed, "crashed", true},
    Row{Outcome::slow, "slow", false},
    Row{Outcome::out_of_memory, "out-of-memory", false},
    Row{Outcome::no_output, "no-output", true},
    Row{Outcome::no_tetrahedra, "no-tetrahedra", true},
    Row{Outcome::unreadable, "unreadable", true},
    Row{Outcome::not_compiled_in, "not-compiled-in", false},
    Row{Outcome::not_judged, "not-judged", false},
};

constexpr bool in_order() {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (static_cast<std::size_t>(rows[i].outcome) != i) return false;
  return rows.size() == outcome_count;
}
static_assert(in_order());

const Row& row(Outcome outcome) {
  return rows.at(static_cast<std::size_t>(outcome));
}

}  // namespace

const char* name_of(Outcome outcome) {
  return row(outcome).name;
}

std::optional<Outcome> outcome_of_name(std::string_view name) {
  for (const Row& row : rows)
    if (name == row.name) return row.outcome;
  return std::nullopt;
}

bool is_finding(Outcome outcome) {
  return row(outcome).finding;
}

}  // namespace tetproof::corpus
