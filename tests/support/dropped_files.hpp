// SPDX-License-Identifier: GPL-3.0-or-later
// A small file for each kind of thing that a reader drops, and the whole list that it must give.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "io/mesh_files.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof::test {

struct DroppedFiles {
  std::string name;
  std::vector<std::pair<std::string, std::string>> files;  ///< the first one is read
  std::vector<std::string> dropped;                        ///< "ITEM: COUNT (EXAMPLE)", without the folder

  friend void PrintTo(const DroppedFiles& test, std::ostream* out) { *out << test.name; }
};

inline void expect_dropped(const DroppedFiles& test) {
  const TestFiles files;
  for (const auto& [name, bytes] : test.files) files.write(name, bytes);
  std::vector<std::string> listed;
  for (const Loss& loss : read_document(files.path(test.files[0].first)).dropped) {
    std::string line = fmt::format("{}: {} ({})", loss.item, loss.count, loss.example);
    const std::string folder = files.path("");
    for (std::size_t at; (at = line.find(folder)) != line.npos;) line.erase(at, folder.size());
    listed.push_back(line);
  }
  EXPECT_EQ(listed, test.dropped);
}

}  // namespace tetproof::test
