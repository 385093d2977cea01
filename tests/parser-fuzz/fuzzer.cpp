// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer's view of the readers: `parser_fuzzer --ending=.msh FOLDER`. An input is a file with that ending;
// or several of the same stem, each behind a line `@@.ending`, of which the first is read. run.sh runs it.
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "fault.hpp"
#include "readers.hpp"

namespace {

namespace fs = std::filesystem;

std::string ending = ".msh";
fs::path folder;

constexpr std::string_view mark = "@@.";

void write_file(std::string_view file_ending, std::string_view bytes) {
  std::ofstream(folder / ("x" + std::string(file_ending)), std::ios::binary) << bytes;
}

bool is_ending(std::string_view text) {
  if (text.size() < 2 || text.size() > 10) return false;
  for (const char c : text)
    if (c != '.' && !(c >= 'a' && c <= 'z') && !(c >= '0' && c <= '9')) return false;
  return true;
}

// The ending of the file to be read.
std::string write_files(std::string_view input) {
  if (!input.starts_with(mark)) {
    write_file(ending, input);
    return ending;
  }
  std::string first;
  while (!input.empty()) {
    const std::size_t line_end = std::min(input.find('\n'), input.size());
    std::string_view name = input.substr(2, line_end - 2);
    input.remove_prefix(std::min(line_end + 1, input.size()));
    const std::size_t next = std::min(input.find(mark), input.size());
    if (!is_ending(name)) name = ending;
    write_file(name, input.substr(0, next));
    if (first.empty()) first = name;
    input.remove_prefix(next);
  }
  return first;
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  constexpr std::string_view option = "--ending=";
  for (int i = 1; i < *argc; ++i)
    if (std::string_view((*argv)[i]).starts_with(option)) ending = (*argv)[i] + option.size();
  folder = fs::temp_directory_path() / ("tetproof-fuzzer-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  std::atexit([] { fs::remove_all(folder); });
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  for (const auto& old : fs::directory_iterator(folder)) fs::remove_all(old.path());
  const std::string first = write_files({reinterpret_cast<const char*>(data), size});
  const std::string wrong = tetproof::test::fault(tetproof::test::reader_of(first), folder / ("x" + first));
  if (wrong.empty()) return 0;
  std::fprintf(stderr, "%s\n", wrong.c_str());
  std::abort();
}
