// SPDX-License-Identifier: GPL-3.0-or-later
// Every reader against mutants of good files: a result or an InputError of one line, never a crash, a hang,
// another exception, or more memory than 64 MiB + 10 times the file. Under the sanitizers as well.
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "allocation_peak.hpp"
#include "fault.hpp"
#include "io/error.hpp"
#include "io/surface_files.hpp"
#include "mutants.hpp"
#include "readers.hpp"

// Where a sanitizer tells that it ends the program; absent without one.
extern "C" void __sanitizer_set_death_callback(void (*)()) __attribute__((weak));

namespace tetproof::test {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t seed = 20261122;
constexpr int mutants_each = 700;  // seven kinds, a hundred of each
constexpr unsigned seconds_each = 5;

// What is being read, for the handlers below: nothing may be formatted any more when they run.
char at_work[512];

void tell() {
  if (::write(STDERR_FILENO, at_work, std::char_traits<char>::length(at_work)) < 0) std::_Exit(3);
}

void on_signal(int signal) {
  tell();
  if (signal == SIGALRM) {
    constexpr char hang[] = "it took more than 5 seconds\n";
    if (::write(STDERR_FILENO, hang, sizeof hang - 1) < 0) std::_Exit(3);
    std::_Exit(1);
  }
  ::signal(signal, SIG_DFL);
  ::raise(signal);
}

void install_handlers() {
  ::signal(SIGALRM, on_signal);
  if (__sanitizer_set_death_callback) return __sanitizer_set_death_callback(tell);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) ::signal(signal, on_signal);
}

std::string read_whole(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot open " + path.string());
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_whole(const fs::path& path, const std::string& bytes) {
  fs::remove(path);  // some file systems wait for the disk when a file is overwritten
  std::ofstream(path, std::ios::binary) << bytes;
}

// The same within a time limit.
std::string fault_in_time(const Reader& reader, const fs::path& file) {
  ::alarm(seconds_each);
  const std::string wrong = fault(reader.read, file);
  ::alarm(0);
  return wrong;
}

class ParserFuzz : public testing::TestWithParam<Reader> {
 protected:
  const fs::path samples_ = fs::path(TETPROOF_SOURCE_DIR) / "corpus" / "formats";
  const fs::path folder_ =
      fs::temp_directory_path() / ("tetproof-fuzz-" + std::to_string(::getpid()) + "-" + GetParam().name);
  const fs::path file_ = folder_ / fs::path(GetParam().sample).filename();

  void SetUp() override {
    install_handlers();
    fs::create_directories(folder_);
    for (const std::string& companion : GetParam().companions)
      fs::copy_file(samples_ / companion, folder_ / fs::path(companion).filename(),
                    fs::copy_options::overwrite_existing);
  }
  // What failed stays, to be looked at; so does it after a crash.
  void TearDown() override {
    if (!HasFailure()) fs::remove_all(folder_);
  }
};

TEST_P(ParserFuzz, SampleIsRead) {
  write_whole(file_, read_whole(samples_ / GetParam().sample));
  EXPECT_NO_THROW(GetParam().read(file_.string()));
}

TEST_P(ParserFuzz, Mutants) {
  const std::string sample = read_whole(samples_ / GetParam().sample);
  for (int i = 0; i < mutants_each; ++i) {
    write_whole(file_, mutant(sample, seed, i));
    std::snprintf(at_work, sizeof at_work, "\n%s, seed %llu, mutant %d, left in %s\n",
                  GetParam().name.c_str(), static_cast<unsigned long long>(seed), i, file_.c_str());
    ASSERT_EQ(fault_in_time(GetParam(), file_), "") << at_work;
  }
}

TEST_P(ParserFuzz, EveryTruncation) {
  const std::string sample = read_whole(samples_ / GetParam().sample);
  const std::size_t step = sample.size() / 2000 + 1;
  for (std::size_t size = 0; size < sample.size(); size += step) {
    write_whole(file_, sample.substr(0, size));
    std::snprintf(at_work, sizeof at_work, "\n%s, the first %zu bytes, left in %s\n", GetParam().name.c_str(),
                  size, file_.c_str());
    ASSERT_EQ(fault_in_time(GetParam(), file_), "") << at_work;
  }
}

INSTANTIATE_TEST_SUITE_P(Readers, ParserFuzz, testing::ValuesIn(readers()),
                         [](const auto& test) { return test.param.name; });

// The test must be able to fail.
TEST(ParserFuzzItself, SeesFaults) {
  const fs::path folder = fs::temp_directory_path() / ("tetproof-fuzz-itself-" + std::to_string(::getpid()));
  fs::create_directory(folder);
  const fs::path file = folder / "x.off";
  write_whole(file, "x");
  EXPECT_EQ(fault([](const std::string&) {}, file), "");
  EXPECT_EQ(fault([](const std::string&) { throw InputError("x:1: expected y"); }, file), "");
  EXPECT_EQ(fault([](const std::string&) { throw InputError("x:1:\nexpected y"); }, file), "");
  EXPECT_EQ(fault([](const std::string&) { throw InputError(""); }, file),
            "the message is not one line of text: ");
  EXPECT_EQ(fault([](const std::string&) { throw std::out_of_range("y"); }, file),
            "an exception that is no InputError: y");
  const auto greedy = [](const std::string&) {
    std::vector<double> announced;
    announced.reserve(std::size_t{10} << 20);
    announced.push_back(1);
  };
  EXPECT_NE(fault(greedy, file).find(" bytes of memory for files of 1"), std::string::npos);
  fs::remove_all(folder);
}

TEST(ParserFuzzItself, MutantsDiffer) {
  const std::string sample = "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  int same = 0, huge = 0;
  for (int i = 0; i < mutants_each; ++i) {
    const std::string text = mutant(sample, seed, i);
    EXPECT_EQ(text, mutant(sample, seed, i));
    same += text == sample;
    huge += text.find("2147483648") != text.npos || text.find("99999999999") != text.npos;
  }
  EXPECT_LT(same, mutants_each / 20);
  EXPECT_GT(huge, mutants_each / 50);
}

// Mutants are too small to show that memory stays below 10 times the file.
TEST(Memory, LargeSurfacesStayBelowTenTimesTheFile) {
  TriangleSurface surface;
  for (int i = 0; i < 100000; ++i) surface.vertices.emplace_back(i % 100, i / 100 % 100, i / 10000);
  for (Index i = 0; i < 100000; ++i) surface.triangles.push_back({i, (i + 1) % 100000, (i + 2) % 100000});
  for (const char* name : {"a.off", "a.obj", "a.ply", "a.stl"})
    for (const bool ascii : {false, true}) {
      const fs::path file =
          fs::temp_directory_path() / ("tetproof-memory-" + std::to_string(::getpid()) + "-" + name);
      write_surface(file, surface, {.ascii = ascii});
      const std::size_t before = allocated();
      start_peak();
      EXPECT_EQ(read_surface(file).triangles.size(), 100000u);
      EXPECT_LT(peak_allocated() - before, 10 * fs::file_size(file)) << name;
      fs::remove(file);
    }
}

}  // namespace
}  // namespace tetproof::test
