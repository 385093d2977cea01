// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/campaign/shards.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "corpus/campaign/settings.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

std::uint64_t number(std::string_view name, std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    throw InputError(fmt::format("{}: expected a number, found '{}'", name, text));
  return value;
}

Shard checked(Shard shard) {
  try {
    check_shard(shard.shard, shard.shards);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", shard.source, error.what()));
  }
  return shard;
}

Shard shard_of_option(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos)
    throw InputError(fmt::format("--shard: expected I/N with I from 0, as in 3/8, found '{}'", text));
  return checked({number("--shard", std::string_view(text).substr(0, slash)),
                  number("--shard", std::string_view(text).substr(slash + 1)), "--shard"});
}

// Reads the variables of one way to start many processes.
class Variables {
 public:
  Variables(const Environment& environment, std::string shards)
      : environment_(environment), shards_(std::move(shards)) {}

  std::optional<Shard> googletest() const {
    const auto index = environment_("GTEST_SHARD_INDEX"), total = environment_("GTEST_TOTAL_SHARDS");
    if (!index && !total) return std::nullopt;
    if (!index) throw InputError("GTEST_TOTAL_SHARDS is set, but GTEST_SHARD_INDEX is not");
    if (!total) throw InputError("GTEST_SHARD_INDEX is set, but GTEST_TOTAL_SHARDS is not");
    return checked(
        {number("GTEST_SHARD_INDEX", *index), number("GTEST_TOTAL_SHARDS", *total), "GTEST_SHARD_INDEX"});
  }

  std::optional<Shard> slurm() const {
    const auto id = environment_("SLURM_ARRAY_TASK_ID");
    if (!id) return std::nullopt;
    const auto count = environment_("SLURM_ARRAY_TASK_COUNT");
    if (!count) throw InputError("SLURM_ARRAY_TASK_ID is set, but SLURM_ARRAY_TASK_COUNT is not");
    const auto value = [&](const char* name, std::uint64_t missing) {
      const auto text = environment_(name);
      return text ? number(name, *text) : missing;
    };
    const std::uint64_t task = number("SLURM_ARRAY_TASK_ID", *id), least = value("SLURM_ARRAY_TASK_MIN", 0);
    const std::uint64_t step = value("SLURM_ARRAY_TASK_STEP", 1);
    if (task < least || step == 0 || (task - least) % step != 0)
      throw InputError(
          fmt::format("SLURM_ARRAY_TASK_ID: expected {} and every {} above it, found {}; give --shard", least,
                      step, task));
    return checked({(task - least) / step, number("SLURM_ARRAY_TASK_COUNT", *count), "SLURM_ARRAY_TASK_ID"});
  }

  std::optional<Shard> kubernetes() const {
    const auto index = environment_("JOB_COMPLETION_INDEX");
    if (!index) return std::nullopt;
    const auto total = environment_("JOB_COMPLETIONS");
    if (!total && shards_.empty())
      throw InputError(
          "JOB_COMPLETION_INDEX is set: give the number of shards by --shards or JOB_COMPLETIONS");
    return checked({number("JOB_COMPLETION_INDEX", *index),
                    total ? number("JOB_COMPLETIONS", *total) : number("--shards", shards_),
                    "JOB_COMPLETION_INDEX"});
  }

 private:
  const Environment& environment_;
  std::string shards_;
};

}  // namespace

std::optional<std::string> process_environment(const char* name) {
  const char* value = std::getenv(name);
  return value && *value ? std::optional<std::string>(value) : std::nullopt;
}

Shard find_shard(const std::string& shard, const std::string& shards, const Environment& environment) {
  std::optional<Shard> found;
  if (!shard.empty()) {
    found = shard_of_option(shard);
  } else {
    const Variables variables(environment, shards);
    for (const std::optional<Shard>& one :
         {variables.googletest(), variables.slurm(), variables.kubernetes()}) {
      if (!one) continue;
      if (found && !(*found == *one))
        throw InputError(fmt::format("{} says shard {} of {}, and {} shard {} of {}: give --shard",
                                     found->source, found->shard, found->shards, one->source, one->shard,
                                     one->shards));
      if (!found) found = one;
    }
  }
  if (shards.empty()) return found.value_or(Shard{});
  const std::uint64_t wanted = number("--shards", shards);
  if (!found && wanted == 1) return {};
  if (!found)
    throw InputError(fmt::format("--shards {}: which one is this? Give --shard I/{}", shards, shards));
  if (found->shards != wanted)
    throw InputError(
        fmt::format("--shards {}: {} says that there are {}", shards, found->source, found->shards));
  return *found;
}

}  // namespace tetproof::corpus
