// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/readers/damaged_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/bytes/atomic_file.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {

DamagedFiles::DamagedFiles(const DamageOptions& options)
    : seed_(options.seed), cases_(options.cases), samples_(sample_files(options.seed, options.formats)) {
  if (samples_.empty()) throw InputError("--formats: no sample can be written in these formats");
  for (const std::string& id : options.damages) {
    const auto& all = damage_kinds();
    const auto kind =
        std::find_if(all.begin(), all.end(), [&](const DamageKind& one) { return one.id == id; });
    if (kind == all.end())
      throw InputError(fmt::format("unknown kind of damage '{}' (see --list-kinds)", id));
    kinds_.push_back(*kind);
  }
  if (kinds_.empty()) kinds_ = damage_kinds();
}

DamagedFile DamagedFiles::file(std::uint64_t index) const {
  if (index < samples_.size()) return {.sample = samples_[index], .damage = "none", .done = "valid"};
  const std::uint64_t k = index - samples_.size();
  Random random(seed_ * 0x9e3779b97f4a7c15 + index);
  DamagedFile file{
      .sample = samples_[k % samples_.size()], .damage = "none", .done = "no damage applies to it"};
  file.part = static_cast<std::size_t>(random.below(static_cast<int>(file.sample.parts.size())));
  std::string& bytes = file.sample.parts[file.part].bytes;
  // What does not apply to this file, or leaves it as it was, gives way to the next kind.
  const std::string before = bytes;
  const std::uint64_t first = k / samples_.size() + k % samples_.size();
  for (std::uint64_t d = 0; d < kinds_.size(); ++d) {
    const DamageKind& kind = kinds_[(first + d) % kinds_.size()];
    if (const auto done = kind.apply(bytes, random); done && bytes != before) {
      file.damage = kind.id;
      file.done = *done;
      if (file.sample.parts.size() > 1) file.done += " of " + file.sample.parts[file.part].ending;
      break;
    }
  }
  return file;
}

std::string write_parts(const SampleFile& file, const std::string& folder) {
  for (const SampleFile::Part& part : file.parts) {
    AtomicFile out(folder + "/file" + part.ending);
    out.write(part.bytes);
    out.commit();
  }
  return folder + "/file" + file.parts.front().ending;
}

}  // namespace tetproof::corpus
