// SPDX-License-Identifier: GPL-3.0-or-later
// A shard that is killed at any moment and started again goes on where it was and loses nothing. This test
// program starts itself: the child runs the campaign of the test CampaignOfAChild.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <random>
#include <set>
#include <sstream>
#include <thread>

#include "corpus/campaign/journal.hpp"
#include "tests/support/run_program.hpp"
#include "tests/unit/corpus/campaign/fake_campaign.hpp"

namespace tetproof::corpus {
namespace {

using namespace corpus::test;
using tetproof::test::ScratchFolder;

constexpr std::uint64_t cases = 1500;
constexpr const char* folder_variable = "TETPROOF_TEST_KILLED_CAMPAIGN";

CampaignResult campaign(const std::string& folder) {
  const FakeMesher a("fake,a", usual_script), b("fake,b", usual_script);
  CampaignOptions options = fake_options(cases, folder);
  // What the child has been told is done: its line must be in the journal afterwards.
  options.progress = [&](const CaseResult& result) {
    if (folder.empty()) return;
    std::ofstream(folder + "/told", std::ios::app) << result.index << ' ' << result.mesher << std::endl;
  };
  return run_campaign({&a, &b}, options);
}

TEST(CampaignOfAChild, Runs) {
  const char* folder = std::getenv(folder_variable);
  if (!folder) GTEST_SKIP() << "the child of KilledCampaign";
  campaign(folder);
}

pid_t start_child(const std::string& folder) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  ::setenv(folder_variable, folder.c_str(), 1);
  ::execl("/proc/self/exe", "unit_campaign", "--gtest_filter=CampaignOfAChild.*", "--gtest_brief=1", nullptr);
  ::_exit(127);
}

// Waits until the journal has grown, so that the kill does not only hit the start; at most 10 s.
void wait_for_growth(const std::string& path) {
  const auto size = [&] {
    std::error_code none;
    const auto bytes = std::filesystem::file_size(path, none);
    return none ? 0 : bytes;
  };
  const auto before = size();
  for (int k = 0; k < 10000 && size() <= before; ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

// The cases that the child was told are done; a torn last line says nothing.
std::set<std::pair<std::uint64_t, std::string>> told(const ScratchFolder& folder) {
  std::set<std::pair<std::uint64_t, std::string>> all;
  if (!folder.has("told")) return all;
  std::istringstream text(folder.read("told"));
  std::string line;
  while (std::getline(text, line)) {
    std::istringstream words(line);
    std::uint64_t index = 0;
    std::string mesher;
    if (words >> index >> mesher && mesher.size() == 6) all.emplace(index, mesher);
  }
  return all;
}

TEST(KilledCampaign, LosesNothingAtFiftyMoments) {
  const ScratchFolder folder;
  const std::string journal = folder / "journal-0-of-1.jsonl";
  std::mt19937 random(16);
  int killed = 0;
  for (int k = 0; k < 50; ++k) {
    const pid_t child = start_child(folder.path());
    ASSERT_GT(child, 0);
    if (k % 5 != 0) wait_for_growth(journal);  // every fifth is killed while it starts
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 15000));
    ::kill(child, SIGKILL);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    if (!WIFSIGNALED(status)) break;  // it was done before
    ++killed;
    if (!folder.has("journal-0-of-1.jsonl")) continue;
    std::set<std::pair<std::uint64_t, std::string>> kept;
    for (const CaseResult& one : read_journal(journal).cases) kept.emplace(one.index, one.mesher);
    for (const auto& one : told(folder)) ASSERT_TRUE(kept.contains(one)) << one.first << one.second;
  }
  EXPECT_EQ(killed, 50) << "the campaign is too short for this machine";
  const pid_t last = start_child(folder.path());
  int status = 0;
  ASSERT_EQ(::waitpid(last, &status, 0), last);
  ASSERT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);

  const ScratchFolder other;
  const CampaignResult whole = campaign(other.path()), merged = merge_campaign({folder.path()});
  EXPECT_TRUE(merged.missing.empty());
  EXPECT_EQ(campaign_text(merged), campaign_text(whole));
  EXPECT_EQ(campaign_json(merged), campaign_json(whole));
  EXPECT_EQ(campaign_junit(merged), campaign_junit(whole));
}

}  // namespace
}  // namespace tetproof::corpus
