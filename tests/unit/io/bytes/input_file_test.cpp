// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in text, compared with the C library; the lines and words of the scanner; files and pipes.
#include "io/bytes/input_file.hpp"
#include "io/bytes/scanner.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <bit>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/test_files.hpp"

namespace tetproof {
namespace {

// Equal to the last bit; NaN equals NaN.
testing::AssertionResult same(double a, double b) {
  if (std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b)))
    return testing::AssertionSuccess();
  return testing::AssertionFailure() << testing::PrintToString(a) << " is not " << testing::PrintToString(b);
}

// The value that strtod gives for the text. Tests run in the C locale.
void expect_as_strtod(const std::string& text) {
  double value = -7;
  ASSERT_TRUE(parse_real(text, value)) << text;
  EXPECT_TRUE(same(value, std::strtod(text.c_str(), nullptr))) << text;
}

TEST(ParseReal, HardCasesAsStrtod) {
  for (const char* text : {"0",
                           "-0",
                           "0.0",
                           "-0e5",
                           "1",
                           "+1",
                           "+.5",
                           "5.",
                           "-.5e1",
                           "1e0",
                           "1E+05",
                           "1e-05",
                           "007",
                           "0.1",
                           "0.30000000000000004",
                           "9007199254740993",
                           "9007199254740992.9999999999999999",
                           "9007199254740993.00000000000000000000000000000000001",
                           "1.7976931348623157e308",
                           "1.7976931348623158e308",
                           "1.7976931348623159e308",
                           "1e309",
                           "-1e309",
                           "+1e400",
                           "1e999999999999",
                           "-1e999999999999",
                           "1e-999999999999",
                           "2.2250738585072014e-308",
                           "2.2250738585072011e-308",
                           "2.225e-308",
                           "4.9406564584124654e-324",
                           "2.4703282292062328e-324",
                           "2.4703282292062327e-324",
                           "-1e-400",
                           "+1e-400",
                           "1e-320",
                           "8.988465674311580e307",
                           "3.14159265358979323846264338327950288419716939937510582097494459",
                           "inf",
                           "-inf",
                           "+inf",
                           "Infinity",
                           "nan",
                           "-nan",
                           "NAN"})
    expect_as_strtod(text);
}

TEST(ParseReal, FortranExponents) {
  double value = 0;
  for (const auto& [text, expected] : std::vector<std::pair<std::string, double>>{{"1D0", 1},
                                                                                  {"1.5d+03", 1500},
                                                                                  {"-2.5D-1", -0.25},
                                                                                  {"+.1D1", 1},
                                                                                  {"0.1D-399", 0},
                                                                                  {"1D400", HUGE_VAL},
                                                                                  {"-1d400", -HUGE_VAL}}) {
    ASSERT_TRUE(parse_real(text, value)) << text;
    EXPECT_TRUE(same(value, expected)) << text;
  }
}

TEST(ParseReal, LongTexts) {
  expect_as_strtod(std::string("0.") + std::string(600, '0') + "1");
  expect_as_strtod(std::string("0.") + std::string(330, '0') + "1");
  expect_as_strtod(std::string(1000, '9'));
  expect_as_strtod(std::string("1") + std::string(2000, '0') + "e-2000");
  expect_as_strtod(std::string("0.") + std::string(1000, '3') + "e-100");
}

TEST(ParseReal, RefusesWhatIsNoNumber) {
  double value;
  for (const char* text :
       {"",     "+",   "-",   ".",   "e5",  "1e",    "1e+",  "1d",   "1.5.2", "1,5", "1 ",  " 1",
        "0x10", "++1", "+-1", "-+1", "--1", "1e5d3", "nand", "infd", "1_000", "1f",  "one", "1e5e5"})
    EXPECT_FALSE(parse_real(text, value)) << text;
}

TEST(ParseReal, RandomDoublesAsStrtod) {
  constexpr std::uint64_t seed = 20261122;
  std::mt19937_64 random(seed);
  char text[64];
  for (int i = 0; i < 200000; ++i) {
    const double value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    for (const int digits : {17, 15, 19}) {
      std::snprintf(text, sizeof text, "%.*g", digits, value);
      double read;
      ASSERT_TRUE(parse_real(text, read)) << text << ", seed " << seed;
      ASSERT_TRUE(same(read, std::strtod(text, nullptr))) << text << ", seed " << seed;
    }
  }
}

TEST(ParseReal, RandomSubnormalsAsStrtod) {
  constexpr std::uint64_t seed = 4711;
  std::mt19937_64 random(seed);
  char text[64];
  for (int i = 0; i < 50000; ++i) {
    const double value =
        std::bit_cast<double>((random() & 0x800fffffffffffffu) >> (i % 3 == 0 ? random() % 52 : 0));
    std::snprintf(text, sizeof text, "%.*g", 3 + i % 15, value);
    double read;
    ASSERT_TRUE(parse_real(text, read)) << text << ", seed " << seed;
    ASSERT_TRUE(same(read, std::strtod(text, nullptr))) << text << ", seed " << seed;
  }
}

TEST(ParseInteger, Limits) {
  std::int64_t value = 0;
  EXPECT_TRUE(parse_integer("9223372036854775807", value));
  EXPECT_EQ(value, std::numeric_limits<std::int64_t>::max());
  EXPECT_TRUE(parse_integer("-9223372036854775808", value));
  EXPECT_EQ(value, std::numeric_limits<std::int64_t>::min());
  EXPECT_TRUE(parse_integer("+12", value));
  EXPECT_EQ(value, 12);
  EXPECT_TRUE(parse_integer("010", value));
  EXPECT_EQ(value, 10);
  for (const char* text :
       {"", "+", "-", "9223372036854775808", "-9223372036854775809", "1.0", "1e3", "0x1", " 1", "+-1", "--1"})
    EXPECT_FALSE(parse_integer(text, value)) << text;
}

struct Lines {
  const char* name;
  std::string text;
  std::vector<std::int64_t> lines;  // of the words "a", "b", ...
};

class ScannerLines : public testing::TestWithParam<Lines> {};

TEST_P(ScannerLines, Counted) {
  const std::string path = "x";
  Scanner scanner(path, GetParam().text);
  char word = 'a';
  for (const std::int64_t line : GetParam().lines) {
    EXPECT_EQ(scanner.word('#'), std::string(1, word++));
    EXPECT_EQ(scanner.line(), line);
  }
  EXPECT_TRUE(scanner.at_end('#'));
  EXPECT_EQ(scanner.word('#'), "");
}

INSTANTIATE_TEST_SUITE_P(All, ScannerLines,
                         testing::Values(Lines{"Lf", "a\nb\n\nc d\n", {1, 2, 4, 4}},
                                         Lines{"CrLf", "a\r\nb\r\n\r\nc d\r\n", {1, 2, 4, 4}},
                                         Lines{"Cr", "a\rb\r\rc d\r", {1, 2, 4, 4}},
                                         Lines{"Mixed", "a\r\nb\rc\n\rd\n", {1, 2, 3, 5}},
                                         Lines{"CommentsAndBlanks", "# x\n \t a# y\n\v\f\n  b # z", {2, 4}},
                                         Lines{"CommentsWithCr", "# x\ra\r# y\rb", {2, 4}},
                                         Lines{"NoLastLineEnd", "a\nb", {1, 2}}),
                         [](const auto& test) { return test.param.name; });

TEST(Scanner, LineEndsAndRestOfLine) {
  const std::string path = "x", text = "one two # c\r\nthree\rfour";
  Scanner scanner(path, text);
  EXPECT_EQ(scanner.peek_word(), "one");
  EXPECT_EQ(scanner.word(), "one");
  EXPECT_FALSE(scanner.at_line_end('#'));
  EXPECT_EQ(scanner.rest_of_line(), "two # c");
  EXPECT_TRUE(scanner.at_line_end());
  EXPECT_TRUE(scanner.ends_line());
  scanner.next_line();
  EXPECT_EQ(scanner.offset(), 13u);
  EXPECT_EQ(scanner.line(), 2);
  EXPECT_EQ(scanner.rest_of_line(), "three");
  scanner.next_line();
  EXPECT_EQ(scanner.line(), 3);
  EXPECT_EQ(scanner.rest_of_line(), "four");
  EXPECT_TRUE(scanner.ends_line());
  scanner.next_line();
  EXPECT_EQ(scanner.remaining(), 0u);
  EXPECT_EQ(scanner.line(), 3);
}

TEST(Scanner, CountHoldsNoMoreThanTheFile) {
  const test::TestFiles files;
  const std::string path = "x", text = "3 1 2 3";
  Scanner fits(path, text);
  EXPECT_EQ(fits.count("how many", 2), 3);
  const std::string lies = "5 1 2 3";
  Scanner scanner(path, lies);
  EXPECT_EQ(files.message([&] { scanner.count("how many", 2); }),
            "x:1: expected how many, found 5, more than the 6 bytes left can hold");
}

TEST(Scanner, RawBytes) {
  const test::TestFiles files;
  const std::string path = "x", text = "abcdef";
  Scanner scanner(path, text);
  EXPECT_EQ(scanner.raw(4, "four"), "abcd");
  EXPECT_EQ(files.message([&] { scanner.raw(3, "three"); }),
            "x: byte 4: expected three (3 bytes), found 2 bytes and the end of the file");
}

TEST(InputFile, ReadsFilesAndPipes) {
  const test::TestFiles files;
  EXPECT_EQ(InputFile(files.write("empty", "")).bytes(), "");
  const std::string text(200000, 'x');
  EXPECT_EQ(InputFile(files.write("file", text)).bytes(), text);
  const std::string pipe = files.path("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { files.write("pipe", text); });
  const InputFile read(pipe);
  writer.join();
  EXPECT_EQ(read.bytes(), text);
}

}  // namespace
}  // namespace tetproof
