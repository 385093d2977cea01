// SPDX-License-Identifier: GPL-3.0-or-later
// What the parser fuzz test knows of the project: a table of readers.
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace tetproof::test {

struct Reader {
  std::string name;    ///< of the test; letters and digits
  std::string sample;  ///< a good file, in corpus/formats; its name is kept
  std::function<void(const std::string&)>
      read;  ///< of a path; throws std::logic_error if the result is not in order
  std::vector<std::string> companions{};  ///< further files in corpus/formats that stay whole beside it

  friend void PrintTo(const Reader& reader, std::ostream* out) { *out << reader.name; }
};

/// Reads what a file of this ending holds, by all the ways there are, and checks it.
std::function<void(const std::string&)> reader_of(const std::string& ending);

/// One row for each reader and flavour of its format.
std::vector<Reader> readers();

}  // namespace tetproof::test
