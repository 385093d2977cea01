// SPDX-License-Identifier: GPL-3.0-or-later
// Which shard a process runs: --shard, and the environments of GoogleTest, Slurm and Kubernetes.
#include "corpus/campaign/shards.hpp"

#include <gtest/gtest.h>

#include <map>

#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

using Variables = std::map<std::string, std::string>;

Shard found(const std::string& shard, const std::string& shards, const Variables& variables) {
  return find_shard(shard, shards, [&](const char* name) -> std::optional<std::string> {
    const auto place = variables.find(name);
    return place == variables.end() ? std::nullopt : std::optional(place->second);
  });
}

std::string refusal(const std::string& shard, const std::string& shards, const Variables& variables) {
  try {
    found(shard, shards, variables);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Shards, One) {
  EXPECT_EQ(found("", "", {}), (Shard{0, 1}));
  EXPECT_EQ(found("", "1", {}), (Shard{0, 1}));
}

TEST(Shards, TheOptionComesFirst) {
  EXPECT_EQ(found("3/8", "", {}), (Shard{3, 8}));
  EXPECT_EQ(found("3/8", "8", {{"GTEST_SHARD_INDEX", "1"}, {"GTEST_TOTAL_SHARDS", "2"}}), (Shard{3, 8}));
  for (const char* wrong : {"8/8", "3", "3/", "/8", "-1/8", "3/8/2", "a/b", "3/0", "0x1/8", " 3/8"})
    EXPECT_NE(refusal(wrong, "", {}).find("--shard"), std::string::npos) << wrong;
}

TEST(Shards, GoogleTest) {
  EXPECT_EQ(found("", "", {{"GTEST_SHARD_INDEX", "2"}, {"GTEST_TOTAL_SHARDS", "5"}}), (Shard{2, 5}));
  EXPECT_NE(refusal("", "", {{"GTEST_TOTAL_SHARDS", "5"}}).find("GTEST_SHARD_INDEX is not"),
            std::string::npos);
  EXPECT_NE(refusal("", "", {{"GTEST_SHARD_INDEX", "5"}}).find("GTEST_TOTAL_SHARDS is not"),
            std::string::npos);
  EXPECT_NE(refusal("", "", {{"GTEST_SHARD_INDEX", "5"}, {"GTEST_TOTAL_SHARDS", "5"}}).find("5 of 5"),
            std::string::npos);
}

TEST(Shards, SlurmArrayFromAnyFirstTask) {
  EXPECT_EQ(found("", "", {{"SLURM_ARRAY_TASK_ID", "0"}, {"SLURM_ARRAY_TASK_COUNT", "4"}}), (Shard{0, 4}));
  EXPECT_EQ(
      found("", "",
            {{"SLURM_ARRAY_TASK_ID", "12"}, {"SLURM_ARRAY_TASK_COUNT", "4"}, {"SLURM_ARRAY_TASK_MIN", "10"}}),
      (Shard{2, 4}));
  EXPECT_EQ(found("", "4",
                  {{"SLURM_ARRAY_TASK_ID", "16"},
                   {"SLURM_ARRAY_TASK_COUNT", "4"},
                   {"SLURM_ARRAY_TASK_MIN", "10"},
                   {"SLURM_ARRAY_TASK_STEP", "2"}}),
            (Shard{3, 4}));
  // --array=1,5,7: its numbers say nothing of their order.
  EXPECT_NE(
      refusal("", "",
              {{"SLURM_ARRAY_TASK_ID", "7"}, {"SLURM_ARRAY_TASK_COUNT", "3"}, {"SLURM_ARRAY_TASK_MIN", "1"}})
          .find("6 of 3"),
      std::string::npos);
  EXPECT_NE(refusal("", "", {{"SLURM_ARRAY_TASK_ID", "7"}}).find("COUNT is not"), std::string::npos);
  // One task of a job of eight, submitted again by itself, would run all cases.
  EXPECT_NE(
      refusal("", "8",
              {{"SLURM_ARRAY_TASK_ID", "3"}, {"SLURM_ARRAY_TASK_COUNT", "1"}, {"SLURM_ARRAY_TASK_MIN", "3"}})
          .find("there are 1"),
      std::string::npos);
}

TEST(Shards, KubernetesIndexedJob) {
  EXPECT_EQ(found("", "6", {{"JOB_COMPLETION_INDEX", "5"}}), (Shard{5, 6}));
  EXPECT_EQ(found("", "", {{"JOB_COMPLETION_INDEX", "5"}, {"JOB_COMPLETIONS", "6"}}), (Shard{5, 6}));
  EXPECT_NE(refusal("", "", {{"JOB_COMPLETION_INDEX", "5"}}).find("--shards or JOB_COMPLETIONS"),
            std::string::npos);
  EXPECT_NE(refusal("", "7", {{"JOB_COMPLETION_INDEX", "5"}, {"JOB_COMPLETIONS", "6"}}).find("there are 6"),
            std::string::npos);
}

TEST(Shards, ContradictionsAreRefused) {
  const Variables both{{"GTEST_SHARD_INDEX", "2"},
                       {"GTEST_TOTAL_SHARDS", "5"},
                       {"JOB_COMPLETION_INDEX", "2"},
                       {"JOB_COMPLETIONS", "5"}};
  EXPECT_EQ(found("", "", both), (Shard{2, 5}));
  Variables other = both;
  other["JOB_COMPLETION_INDEX"] = "3";
  const std::string message = refusal("", "", other);
  EXPECT_NE(message.find("GTEST_SHARD_INDEX says shard 2 of 5"), std::string::npos) << message;
  EXPECT_NE(message.find("JOB_COMPLETION_INDEX shard 3 of 5"), std::string::npos) << message;
  EXPECT_EQ(found("1/5", "", other), (Shard{1, 5}));
  EXPECT_NE(refusal("", "8", {}).find("Give --shard I/8"), std::string::npos);
}

}  // namespace
}  // namespace tetproof::corpus
