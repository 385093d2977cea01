// SPDX-License-Identifier: GPL-3.0-or-later
// Small files that a test writes, in a folder of its own that goes with the test; and the message of an
// InputError.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "io/error.hpp"

namespace tetproof::test {

class TestFiles {
 public:
  TestFiles() {
    std::string pattern = (std::filesystem::temp_directory_path() / "tetproof-test-XXXXXX").string();
    if (!::mkdtemp(pattern.data())) throw std::runtime_error("cannot make a folder for test files");
    folder_ = pattern;
  }
  ~TestFiles() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  TestFiles(const TestFiles&) = delete;
  TestFiles& operator=(const TestFiles&) = delete;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string write(const std::string& name, std::string_view bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }
  static std::string read(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  /// Cuts off what a .msh file keeps aside, so that the native part is left.
  static void leave_out_supplement(const std::string& path) {
    const std::string bytes = read(path);
    std::ofstream(path, std::ios::binary) << bytes.substr(0, bytes.find("$TetproofSupplement"));
  }
  /// What `work` says when it throws an InputError, without this folder's name; "no error" if it does not.
  template <class Work>
  std::string message(const Work& work) const {
    try {
      work();
    } catch (const InputError& error) {
      std::string text = error.what();
      const std::string prefix = folder_.string() + "/";
      for (std::size_t at; (at = text.find(prefix)) != text.npos;) text.erase(at, prefix.size());
      return text;
    }
    return "no error";
  }

 private:
  std::filesystem::path folder_;
};

}  // namespace tetproof::test
