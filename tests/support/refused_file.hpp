// SPDX-License-Identifier: GPL-3.0-or-later
// Files that a reader must refuse, and the whole of what it says then.
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "io/mesh_files.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof::test {

struct RefusedFile {
  const char *name, *file;
  std::string bytes;
  const char* message;
  friend void PrintTo(const RefusedFile& test, std::ostream* out) { *out << test.name; }
};

inline void expect_refusal(const RefusedFile& test) {
  const TestFiles files;
  EXPECT_EQ(files.message([&] { read_document(files.write(test.file, test.bytes)); }), test.message);
}

inline std::string name_of(const testing::TestParamInfo<RefusedFile>& test) {
  return test.param.name;
}

}  // namespace tetproof::test
