// SPDX-License-Identifier: GPL-3.0-or-later
// Small valid documents with groups, names and data, which are then written and damaged.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "io/document.hpp"

namespace tetproof::corpus {

/// A document and what is in it, for reports.
struct SampleDocument {
  std::string name;  ///< "tetrahedra", "surface", "second order", "mixed"
  Document document;
};

/// The documents of a seed: the same on every machine. Each format writes of them what it has a place for.
std::vector<SampleDocument> sample_documents(std::uint64_t seed);

/// A sample as files of one format: the first one is the one that a reader is given.
struct SampleFile {
  std::string document;  ///< the name of the sample
  std::string format;
  bool binary = false;
  std::string ending;  ///< of the first file
  struct Part {
    std::string ending, bytes;
  };
  std::vector<Part> parts;                    ///< files with the same stem
  std::shared_ptr<const Document> content{};  ///< as our own reader reads it

  std::string form() const;   ///< "msh41 binary"
  std::int64_t size() const;  ///< bytes of all parts
};

/// The samples in the formats, in text and binary where the format has both. What a format has no place for
/// at all is left out. InputError for an unknown format. `formats` empty: all that are written.
std::vector<SampleFile> sample_files(std::uint64_t seed, const std::vector<std::string>& formats);

}  // namespace tetproof::corpus
