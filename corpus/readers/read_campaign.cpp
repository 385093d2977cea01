// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/readers/read_campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <mutex>
#include <set>

#include "corpus/campaign/known_groups.hpp"
#include "corpus/campaign/scratch_folder.hpp"
#include "corpus/campaign/share_work.hpp"
#include "corpus/readers/damaged_file.hpp"
#include "corpus/readers/keep_files.hpp"
#include "corpus/readers/same_content.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

namespace fs = std::filesystem;

class Campaign {
 public:
  Campaign(const Reader& reader, const DamageOptions& options, const DamagedFiles& files)
      : reader_(reader), options_(options), files_(files), scratch_("") {}

  std::vector<ReadCase> run() {
    if (options_.started) options_.started(files_.size());
    share_work({.end = files_.size()}, options_.threads,
               [this](std::uint64_t index, const std::atomic<bool>&) { keep(run_one(index)); });
    std::vector<ReadCase> all;
    for (auto& [index, one] : cases_) all.push_back(std::move(one));
    return all;
  }

 private:
  ReadCase run_one(std::uint64_t index) {
    const DamagedFile file = files_.file(index);
    const std::string folder = fmt::format("{}/{}", scratch_.path(), index);
    fs::create_directories(folder);
    const std::string path = write_parts(file.sample, folder);
    ReadCase one{.index = index,
                 .form = file.sample.form(),
                 .document = file.sample.document,
                 .damage = file.damage,
                 .done = file.done,
                 .bytes = file.sample.size()};
    one.run = run_reader(reader_, path, folder, options_.limits);
    // A limit says nothing of the place: at least the formats are told apart.
    if (one.run.reading == Reading::hung || one.run.reading == Reading::out_of_memory)
      one.run.signature += ", " + one.form;
    if (one.run.reading == Reading::read && one.run.wordless && one.damage != "none") {
      fs::remove_all(folder);  // the reader may have written there
      fs::create_directories(folder);
      one.unnoticed = !same_content(write_parts(file.sample, folder), *file.sample.content);
    }
    fs::remove_all(folder);
    return one;
  }

  void keep(ReadCase one) {
    const std::lock_guard lock(mutex_);
    if (options_.progress) options_.progress(one);
    cases_.emplace(one.index, std::move(one));
  }

  const Reader& reader_;
  const DamageOptions& options_;
  const DamagedFiles& files_;
  ScratchFolder scratch_;
  std::mutex mutex_;
  std::map<std::uint64_t, ReadCase> cases_;
};

std::vector<ReadGroup> groups_of(const ReadResult& result, const std::vector<std::string>& known) {
  const std::set<std::string> known_ids(known.begin(), known.end());
  std::map<std::pair<Reading, std::string>, ReadGroup> groups;
  for (const ReadCase& one : result.cases) {
    if (!is_finding(one.run.reading)) continue;
    ReadGroup& group = groups[{one.run.reading, one.run.signature}];
    group.reader = result.reader.name;
    group.reading = one.run.reading;
    group.signature = one.run.signature;
    group.cases.push_back(one);
  }
  std::vector<ReadGroup> all;
  for (auto& [key, group] : groups) {
    std::stable_sort(group.cases.begin(), group.cases.end(),
                     [](const ReadCase& a, const ReadCase& b) { return a.bytes < b.bytes; });
    group.known = known_ids.contains(group.id());
    all.push_back(std::move(group));
  }
  return all;
}

}  // namespace

std::string ReadGroup::id() const {
  return group_id(reader, name_of(reading), signature);
}

ReadResult run_reader_campaign(const Reader& reader, const DamageOptions& options) {
  const DamagedFiles files(options);
  ReadResult result{.reader = reader, .seed = options.seed, .cases = Campaign(reader, options, files).run()};
  result.groups = groups_of(result, options.known);
  for (const std::string& id : options.known)
    if (std::none_of(result.groups.begin(), result.groups.end(),
                     [&](const ReadGroup& group) { return group.id() == id; }))
      result.known_unseen.push_back(id);
  for (const std::string& id : options.damages)
    if (std::none_of(result.cases.begin(), result.cases.end(),
                     [&](const ReadCase& one) { return one.damage == id; }))
      result.not_applied.push_back(id);
  if (!options.folder.empty()) keep_files(result, options, files);
  return result;
}

std::vector<const ReadCase*> refused_valid_files(const ReadResult& result) {
  std::vector<const ReadCase*> all;
  for (const ReadCase& one : result.cases)
    if (one.damage == "none" && one.run.reading == Reading::refused) all.push_back(&one);
  return all;
}

}  // namespace tetproof::corpus
