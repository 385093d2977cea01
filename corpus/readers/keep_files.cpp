// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/readers/keep_files.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "corpus/campaign/scratch_folder.hpp"
#include "corpus/meshing/command_words.hpp"
#include "corpus/readers/shrink_file.hpp"
#include "io/bytes/atomic_file.hpp"

namespace tetproof::corpus {
namespace {

namespace fs = std::filesystem;

// Whether a candidate still fails in the same group. A crash is told from others by its backtrace, which is
// taken only where the rest agrees.
class StillFails {
 public:
  StillFails(const Reader& reader, const DamageOptions& options, const ReadGroup& group, DamagedFile file)
      : reader_(reader), options_(options), group_(group), file_(std::move(file)), scratch_("") {}

  bool operator()(const std::string& bytes) {
    file_.sample.parts[file_.part].bytes = bytes;
    const std::string folder = fmt::format("{}/{}", scratch_.path(), number_++);
    fs::create_directories(folder);
    const std::string path = write_parts(file_.sample, folder);
    ReaderRun run = run_reader(reader_, path, folder, options_.limits, false);
    bool same = run.reading == group_.reading && group_.signature.starts_with(run.signature);
    if (same && group_.reading == Reading::crashed && run.signature != group_.signature) {
      run = run_reader(reader_, path, folder, options_.limits, true);
      same = run.reading == group_.reading && run.signature == group_.signature;
    }
    fs::remove_all(folder);
    return same;
  }

 private:
  const Reader& reader_;
  const DamageOptions& options_;
  const ReadGroup& group_;
  DamagedFile file_;
  ScratchFolder scratch_;
  int number_ = 0;
};

std::string readme(const ReadResult& result, const ReadGroup& group, const std::string& name) {
  const ReadCase& first = group.cases.front();
  std::string text = fmt::format("{}\n\n", group.id());
  text += fmt::format("The file was valid {} ({}); then: {}: {}.\n", first.form, first.document, first.damage,
                      first.done);
  if (group.shrunk)
    text += fmt::format("Lines and bytes were left out as long as it failed: {} of {} bytes are left.\n",
                        *group.shrunk, first.bytes);
  if (group.unseen_again) text += "It did not fail again in one further run.\n";
  text += fmt::format("It says: {}\nAgain: {}\n", first.run.message,
                      command_line(replaced(result.reader.words,
                                            {{"{file}", name}, {"{stem}", fs::path(name).stem().string()}})));
  return text;
}

}  // namespace

void keep_files(ReadResult& result, const DamageOptions& options, const DamagedFiles& files) {
  int number = 0;
  for (ReadGroup& group : result.groups) {
    DamagedFile file = files.file(group.cases.front().index);
    const std::string folder =
        fmt::format("findings/{}-{}-{}", ++number, name_of(group.reading), file.sample.format);
    const fs::path place = fs::path(options.folder) / folder;
    fs::remove_all(place);
    fs::create_directories(place);
    if (options.shrink_s > 0 && !group.known) {
      StillFails fails(result.reader, options, group, file);
      std::string& bytes = file.sample.parts[file.part].bytes;
      // A failure that does not come again cannot be made smaller.
      if (fails(bytes)) {
        bytes = shrink_file(
            bytes, [&](const std::string& fewer) { return fails(fewer); }, options.shrink_s);
        group.shrunk = file.sample.size();
      } else {
        group.unseen_again = true;
      }
    }
    const std::string path = write_parts(file.sample, place.string());
    const std::string name = fs::path(path).filename().string();
    group.file = folder + "/" + name;
    AtomicFile text((place / "README.txt").string());
    text.write(readme(result, group, name));
    text.commit();
  }
}

}  // namespace tetproof::corpus
