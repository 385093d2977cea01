// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/surfaces.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "corpus/fuzz/fuzz_spec.hpp"
#include "corpus/fuzz_surface.hpp"
#include "corpus/generators/generators.hpp"
#include "io/error.hpp"
#include "io/surface_files.hpp"

namespace tetproof::corpus {
namespace {

const Generator* find_generator(const std::string& spec) {
  const std::string name = spec.substr(0, spec.find(':'));
  for (const Generator& generator : generators())
    if (name == generator.name) return &generator;
  return nullptr;
}

std::string names() {
  std::string all;
  for (const Generator& generator : generators()) all += std::string(generator.name) + ", ";
  return all + "fuzz";
}

const Generator& generator_of(const std::string& spec) {
  if (const Generator* generator = find_generator(spec)) return *generator;
  throw InputError(fmt::format("{}: no such generated surface (known: {})", spec, names()));
}

}  // namespace

const std::vector<Generator>& generators() {
  static const std::vector<Generator> all = [] {
    std::vector<Generator> list{sphere_generator(), torus_generator(),  wing_generator(),
                                random_generator(), shells_generator(), octahedron_generator()};
    for (Generator& block : block_generators()) list.push_back(std::move(block));
    return list;
  }();
  return all;
}

bool is_generated(const std::string& spec) {
  return find_generator(spec) != nullptr || is_fuzz_spec(spec);
}

TriangleSurface make_surface(const std::string& spec) {
  if (is_fuzz_spec(spec)) return fuzz_surface_of(spec).surface;
  const Generator& generator = generator_of(spec);
  return generator.make(parse_values(generator, spec));
}

std::optional<double> exact_volume(const std::string& spec) {
  if (is_fuzz_spec(spec)) return fuzz_surface_of(spec).volume;
  const Generator& generator = generator_of(spec);
  return generator.volume(parse_values(generator, spec));
}

SurfaceFile open_surface_file(const std::string& file_or_spec, const ReadOptions& options) {
  if (is_generated(file_or_spec)) return {make_surface(file_or_spec), {}, {}, {}};
  std::error_code unknown;
  if (file_or_spec != "-" && !std::filesystem::exists(file_or_spec, unknown) &&
      file_or_spec.find_first_of("./") == std::string::npos)
    throw InputError(
        fmt::format("{}: no such file, and no such generated surface (known: {})", file_or_spec, names()));
  return read_surface_file(file_or_spec, options);
}

TriangleSurface open_surface(const std::string& file_or_spec, const ReadOptions& options) {
  return open_surface_file(file_or_spec, options).surface;
}

std::string list_surfaces() {
  std::string text;
  for (const Generator& generator : generators()) {
    text += fmt::format("{}: {}\n", generator.name, generator.meaning);
    std::string keys;
    for (std::size_t i = 0; i < generator.parameters.size(); ++i) {
      const Parameter& p = generator.parameters[i];
      const bool digits = p.kind == Kind::four_digits;
      keys += fmt::format("{}{}={}", keys.empty() ? "" : ",", p.key,
                          digits ? fmt::format("{:04}", static_cast<int>(p.preset)) : number_text(p.preset));
      // Parameters that mean the same, as coordinates do, share a line.
      if (i + 1 < generator.parameters.size() &&
          std::string_view(p.meaning) == generator.parameters[i + 1].meaning)
        continue;
      const std::string range =
          digits ? "four digits" : fmt::format("{} to {}", number_text(p.least), number_text(p.most));
      text += fmt::format("    {:<14} {} ({})\n", keys, p.meaning, range);
      keys.clear();
    }
    text += fmt::format("    volume: {}\n", generator.volume_text);
  }
  text +=
      "fuzz: a random surface that is hard for meshers, by its case or by its recipe\n"
      "    seed=1,case=0  case `case` of the seed (0 to 18446744073709551615)\n"
      "    RECIPE         as cylinder(n=32,h=0.001)+offset(x=1e+06)\n"
      "    volume: of the triangulated body, exact, rounded once\n";
  text += list_fuzz_kinds();
  return text;
}

}  // namespace tetproof::corpus
