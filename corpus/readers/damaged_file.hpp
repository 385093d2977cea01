// SPDX-License-Identifier: GPL-3.0-or-later
// The files that a reader is given: first all valid samples, then damaged ones. Not installed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "corpus/readers/damage.hpp"
#include "corpus/readers/read_campaign.hpp"
#include "corpus/readers/sample_documents.hpp"

namespace tetproof::corpus {

struct DamagedFile {
  SampleFile sample;         ///< with the damaged bytes
  std::string damage, done;  ///< as in `ReadCase`
  std::size_t part = 0;      ///< the damaged one
};

/// A pure function from an index to a file.
class DamagedFiles {
 public:
  /// InputError for an unknown format or kind of damage, or if no sample is left.
  explicit DamagedFiles(const DamageOptions& options);
  std::uint64_t size() const { return samples_.size() + cases_; }
  DamagedFile file(std::uint64_t index) const;

 private:
  std::uint64_t seed_, cases_;
  std::vector<SampleFile> samples_;
  std::vector<DamageKind> kinds_;
};

/// Writes the parts of a file into a folder and returns the path of the first one.
std::string write_parts(const SampleFile& file, const std::string& folder);

}  // namespace tetproof::corpus
