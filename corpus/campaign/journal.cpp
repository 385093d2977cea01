// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/campaign/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "corpus/campaign/journal_lines.hpp"
#include "corpus/campaign/settings.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

using Json = nlohmann::ordered_json;

// A shard that was killed may leave a process of its own for a moment, which has the lock until it ends.
constexpr auto patience = std::chrono::seconds(3);

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(fmt::format("{}: cannot read: {}", path, std::strerror(errno)));
  return {std::istreambuf_iterator<char>(file), {}};
}

// Takes the lines of a journal one by one.
class Reader {
 public:
  explicit Reader(JournalContent& content) : content_(content) {}

  // Throws if the line is none of a journal.
  void take(std::string_view text) {
    const Json json = Json::parse(text);
    if (!has_settings_) {
      if (!is_header(json)) throw InputError("expected the settings of a campaign");
      content_.settings = header_of(json);
      check_shard(content_.settings.shard, content_.settings.shards);
      for (const MesherFacts& mesher : content_.settings.meshers) meshers_.insert(mesher.name);
      has_settings_ = true;
    } else if (is_shrunk(json)) {
      content_.shrunk.push_back(shrunk_of(json));
    } else {
      take(case_of(json));
    }
  }

 private:
  void take(CaseResult result) {
    const CampaignSettings& s = content_.settings;
    if (result.index >= s.cases || result.index % s.shards != s.shard)
      throw InputError(fmt::format("case {} does not belong to this shard", result.index));
    if (!meshers_.contains(result.mesher))
      throw InputError(fmt::format("mesher '{}' does not belong to this campaign", result.mesher));
    if (!seen_.emplace(result.index, result.mesher).second)
      throw InputError(fmt::format("case {} of {} is there twice", result.index, result.mesher));
    content_.cases.push_back(std::move(result));
  }

  JournalContent& content_;
  bool has_settings_ = false;
  std::set<std::string> meshers_;
  std::set<std::pair<std::uint64_t, std::string>> seen_;
};

}  // namespace

std::string journal_name(std::uint64_t shard, std::uint64_t shards) {
  return fmt::format("journal-{}-of-{}.jsonl", shard, shards);
}

std::vector<std::string> journals_in(const std::string& folder) {
  std::vector<std::string> paths;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("journal-") && name.ends_with(".jsonl")) paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

JournalContent read_journal(const std::string& path) {
  const std::string bytes = bytes_of(path);
  JournalContent content;
  Reader reader(content);
  std::string damage;
  std::size_t number = 0;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t end = bytes.find('\n', at);
    if (end == std::string::npos) break;  // torn
    ++number;
    try {
      reader.take(std::string_view(bytes).substr(at, end - at));
    } catch (const Json::parse_error& error) {
      if (damage.empty()) damage = fmt::format("{}:{}: {}", path, number, error.what());
      at = end + 1;
      continue;
    } catch (const std::exception& error) {
      throw InputError(fmt::format("{}:{}: {}", path, number, error.what()));
    }
    // Only the end of a file can be torn. A line that is damaged before others was not torn by a kill.
    if (!damage.empty()) throw InputError(damage);
    content.bytes = end + 1;
    at = end + 1;
  }
  // Another program's file must not be written over.
  if (content.bytes == 0 && !damage.empty()) throw InputError(damage);
  return content;
}

Journal::Journal(const std::string& folder, const CampaignSettings& settings)
    : path_(folder + "/" + journal_name(settings.shard, settings.shards)) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError(fmt::format("{}: cannot make the folder: {}", folder, error.message()));
  file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file_ < 0) fail("cannot open");
  try {
    lock();
    content_ = read_journal(path_);
    if (content_.bytes > 0) {
      const std::string different = differences(content_.settings, settings, true);
      if (!different.empty())
        throw InputError(fmt::format("{}: is of a campaign with other settings: {}", path_, different));
    }
    if (::ftruncate(file_, static_cast<off_t>(content_.bytes)) != 0) fail("cannot shorten");
    if (content_.bytes == 0) {
      content_.settings = settings;
      write_through(header_line(settings));
      const int directory = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
      if (directory >= 0) ::fsync(directory), ::close(directory);  // the file's name, too
    }
  } catch (...) {
    ::close(file_);
    throw;
  }
}

Journal::~Journal() {
  ::close(file_);
}

void Journal::lock() {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK && errno != EINTR) fail("cannot lock");
    if (std::chrono::steady_clock::now() > end)
      throw InputError(fmt::format("{}: another process is running this shard", path_));
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

void Journal::append(const CaseResult& result) {
  append_line(line_of(result));
}

void Journal::append(const ShrunkCase& shrunk) {
  append_line(line_of(shrunk));
}

// The first thread that finds nobody writing writes the lines of all that wait.
void Journal::append_line(const std::string& line) {
  std::unique_lock lock(mutex_);
  waiting_ += line;
  const std::uint64_t mine = ++lines_waiting_;
  while (lines_done_ < mine) {
    if (failure_) std::rethrow_exception(failure_);
    if (writing_) {
      written_.wait(lock);
      continue;
    }
    writing_ = true;
    const std::string bytes = std::exchange(waiting_, {});
    const std::uint64_t last = lines_waiting_;
    lock.unlock();
    std::exception_ptr failure;
    try {
      write_through(bytes);
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    writing_ = false;
    failure_ = failure;
    if (!failure) lines_done_ = last;
    written_.notify_all();
  }
}

void Journal::write_through(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("cannot write");
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  if (::fdatasync(file_) != 0) fail("cannot write");
}

void Journal::fail(const char* what) const {
  throw InputError(fmt::format("{}: {}: {}", path_, what, std::strerror(errno)));
}

}  // namespace tetproof::corpus
