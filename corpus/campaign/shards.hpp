// SPDX-License-Identifier: GPL-3.0-or-later
// Which part of a campaign this process runs: from the command line, or from what started it. Not installed.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace tetproof::corpus {

struct Shard {
  std::uint64_t shard = 0, shards = 1;
  std::string source{};  ///< "--shard", "GTEST_SHARD_INDEX", ...; empty: there is only one
  bool operator==(const Shard& other) const { return shard == other.shard && shards == other.shards; }
};

/// Reads an environment variable; none: it is not set.
using Environment = std::function<std::optional<std::string>(const char* name)>;
std::optional<std::string> process_environment(const char* name);

/// `shard` is the value of --shard, "I/N" with I from 0; `shards` that of --shards; both may be empty.
///
/// --shard comes first. Without it the environment decides: GTEST_SHARD_INDEX with GTEST_TOTAL_SHARDS;
/// SLURM_ARRAY_TASK_ID with SLURM_ARRAY_TASK_COUNT (and _MIN and _STEP); JOB_COMPLETION_INDEX with --shards
/// or JOB_COMPLETIONS. Where several of them are set, they must say the same, and the number of shards must
/// be that of --shards. InputError if they do not, if a number is missing, or if a value is none.
Shard find_shard(const std::string& shard, const std::string& shards, const Environment& environment);

}  // namespace tetproof::corpus
