// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/surfaces.hpp"

#include <fmt/format.h>

#include "corpus/generators.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

const Generator* find_generator(const std::string& spec) {
  const std::string name = spec.substr(0, spec.find(':'));
  for (const Generator& generator : generators())
    if (name == generator.name) return &generator;
  return nullptr;
}

const Generator& generator_of(const std::string& spec) {
  if (const Generator* generator = find_generator(spec)) return *generator;
  std::string names;
  for (const Generator& g : generators()) names += (names.empty() ? "" : ", ") + std::string(g.name);
  throw InputError(fmt::format("{}: no such generated surface (known: {})", spec, names));
}

}  // namespace

const std::vector<Generator>& generators() {
  static const std::vector<Generator> all{sphere_generator(), torus_generator()};
  return all;
}

bool is_generated(const std::string& spec) {
  return find_generator(spec) != nullptr;
}

TriangleSurface make_surface(const std::string& spec) {
  const Generator& generator = generator_of(spec);
  return generator.make(parse_values(generator, spec));
}

std::optional<double> exact_volume(const std::string& spec) {
  const Generator& generator = generator_of(spec);
  return generator.volume(parse_values(generator, spec));
}

TriangleSurface open_surface(const std::string& file_or_spec) {
  return make_surface(file_or_spec);
}

std::string list_surfaces() {
  std::string text;
  for (const Generator& generator : generators()) {
    text += fmt::format("{}: {}\n", generator.name, generator.meaning);
    for (const Parameter& p : generator.parameters) {
      const std::string preset = p.kind == Kind::four_digits
                                     ? fmt::format("{:04}", static_cast<int>(p.preset))
                                     : fmt::format("{}", p.preset);
      const std::string range =
          p.kind == Kind::four_digits ? "four digits" : fmt::format("{} to {}", p.least, p.most);
      text += fmt::format("    {:<12} {} ({})\n", fmt::format("{}={}", p.key, preset), p.meaning, range);
    }
    text += fmt::format("    volume: {}\n", generator.volume_text);
  }
  return text;
}

}  // namespace tetproof::corpus
