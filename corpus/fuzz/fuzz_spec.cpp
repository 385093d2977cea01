// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/fuzz/fuzz_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string_view>

#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

constexpr std::string_view name = "fuzz";

struct Case {
  std::uint64_t seed = 1, index = 0;
};

// Reads "seed=7,case=12". Doubles do not hold all seeds, so that these are no recipe's values.
Case parse_case(std::string_view text) {
  Case result;
  bool has_seed = false, has_index = false;
  while (!text.empty()) {
    const std::string_view item = text.substr(0, text.find(','));
    text.remove_prefix(std::min(text.size(), item.size() + 1));
    const std::string_view key = item.substr(0, item.find('='));
    const bool is_seed = key == "seed";
    if ((!is_seed && key != "case") || key.size() == item.size())
      throw InputError(fmt::format("expected seed=NUMBER or case=NUMBER, found '{}'", item));
    bool& has = is_seed ? has_seed : has_index;
    if (has) throw InputError(fmt::format("the key '{}' is given twice", key));
    has = true;
    const std::string_view digits = item.substr(key.size() + 1);
    std::uint64_t& value = is_seed ? result.seed : result.index;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size())
      throw InputError(
          fmt::format("{}: expected a whole number below 18446744073709551616, found '{}'", key, digits));
  }
  return result;
}

}  // namespace

bool is_fuzz_spec(const std::string& spec) {
  return spec == name || spec.rfind("fuzz:", 0) == 0;
}

FuzzSurface fuzz_surface_of(const std::string& spec) {
  const std::string_view rest = std::string_view(spec).substr(std::min(spec.size(), name.size() + 1));
  try {
    // A recipe's first '=' stands inside parentheses, or behind a modifier's name.
    const std::size_t end = rest.find_first_of("=(+");
    if (rest.empty() || (end != std::string_view::npos && rest[end] == '=')) {
      const Case at = parse_case(rest);
      return fuzz_surface(at.seed, at.index);
    }
    return build(parse_recipe(rest));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", spec.substr(0, 200), error.what()));
  }
}

}  // namespace tetproof::corpus
