// SPDX-License-Identifier: GPL-3.0-or-later
// The journal of a shard: what is done, on the disk, so that a campaign goes on after a kill. Not installed.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/fuzz_campaign.hpp"

namespace tetproof::corpus {

/// What a journal says. Its first line has the settings; each further line is a case or a shrunk case.
struct JournalContent {
  CampaignSettings settings;
  std::vector<CaseResult> cases;  ///< as they were finished
  std::vector<ShrunkCase> shrunk;
  std::size_t bytes = 0;  ///< without what was torn at the end; 0: not even the settings are there
};

/// "journal-3-of-8.jsonl".
std::string journal_name(std::uint64_t shard, std::uint64_t shards);

/// The paths of all journals in a folder, sorted; none if it cannot be read.
std::vector<std::string> journals_in(const std::string& folder);

/// Reads a journal. What a kill left of the last lines is not in it. InputError, with the line's number, if a
/// line before valid ones is damaged.
JournalContent read_journal(const std::string& path);

/// The case as it comes back from a journal: text that is no UTF-8 is replaced, long text is cut. Results
/// pass through it before anything else sees them, so that an interrupted campaign has the same ones.
CaseResult as_journalled(const CaseResult& result);

/// A journal that is open for appending. It is locked: InputError if another process, or this one, has it
/// open.
class Journal {
 public:
  /// Opens the journal of `settings`' shard in `folder`, or makes both. InputError if it has other settings.
  Journal(const std::string& folder, const CampaignSettings& settings);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// What it said when it was opened.
  const JournalContent& content() const { return content_; }

  /// Append, and return when the line is on the disk. May be called by several threads: lines that wait at
  /// the same time share one fsync.
  void append(const CaseResult& result);
  void append(const ShrunkCase& shrunk);

 private:
  void lock();
  void append_line(const std::string& line);
  void write_through(std::string_view bytes);
  [[noreturn]] void fail(const char* what) const;

  std::string path_;
  int file_ = -1;
  JournalContent content_;
  std::mutex mutex_;
  std::condition_variable written_;
  std::string waiting_;                               // lines that nobody writes yet
  std::uint64_t lines_waiting_ = 0, lines_done_ = 0;  // counted from the start
  bool writing_ = false;
  std::exception_ptr failure_;
};

}  // namespace tetproof::corpus
