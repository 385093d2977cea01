// SPDX-License-Identifier: GPL-3.0-or-later
// Traces: every record is equal after writing and reading; every error message is tested in full.
#include "io/trace.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <ostream>
#include <stdexcept>

#include "tests/support/test_files.hpp"

namespace tetproof::trace {
namespace {

using test::TestFiles;

constexpr double tiny = std::numeric_limits<double>::denorm_min();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double third = 1.0 / 3, wordy = 0.1 + 0.2, huge_integer = 18446744073709551616.0 * 3;

const Tet tet{Point(third, -wordy, tiny), Point(-0.0, 1, 2), Point(largest, -largest, 1e22),
              Point(9007199254740993.0, huge_integer, -9223372036854775808.0)};

const std::vector<Record> all{
    Settings{.program = "mine \"2\"\\\n\t\x01 \xC3\xA9",
             .surface = "a b.off",
             .region = "outside",
             .box_scale = 1 + third,
             .on_surface = 0,
             .diagonals = "shortest",
             .literal = true,
             .p = 0.25,
             .curvature = true,
             .parametric = true,
             .improve = "aspect-ratio",
             .improve_below = wordy,
             .points = "12",
             .past_dilution = true},
    Lattice{{tet[0], tet[1]}, {1, 2, std::numeric_limits<int>::max()}},
    Indicators{3, 4, "-0+", "--+"},
    Moved{{5, 6, 7}, tet[2], true},
    Cut{{{{0, 1, 2}, {1, 1, 2}}}, tet[3]},
    Rows{{1, 2, 3}, {"1", "10a", "5-", "E8", "12f", "14"}},
    Mapped{tet[0], tet[2]},
    FirstGrid{1, std::numeric_limits<std::int64_t>::max(), third, tiny, largest, wordy, -0.0, 1e-300, 2},
    FirstGrid{1, 2, 3, 4, 5, 6, {}, {}, 7},
    Weight{tet, third, 0.5, 0.1, -tiny, 1e100, wordy},
    Weight{tet, third, {}, 1, 2, 3, 4},
    Insertion{17, tet, "3b", {3, 0, 2}, tet[0], wordy},
    Flip{true, {tet[0], tet[1], tet[2]}, {tet[3], tet[0]}, third, wordy, tiny},
    Flip{false, {tet[3], tet[1], tet[2]}, {tet[0], tet[1]}, 1, 2, 3},
    End{"no-gain", 1, 2, 3, 4, 5, third},
};

std::vector<Record> read_all(const std::string& path) {
  std::vector<Record> records;
  Reader reader(path);
  while (std::optional<Record> record = reader.next()) records.push_back(*record);
  return records;
}

// If both texts are equal, every number has survived. The values below show that the text means the right
// thing.
TEST(Trace, EveryRecordReadsBackEqual) {
  const TestFiles files;
  std::string text;
  for (const Record& record : all) text += to_line(record) + "\n";
  const std::vector<Record> read = read_all(files.write("t.jsonl", text));
  ASSERT_EQ(read.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(read[i].index(), all[i].index());
    EXPECT_EQ(to_line(read[i]), to_line(all[i]));
  }
  const Tet& back = std::get<Insertion>(read[11]).tet;
  for (int i = 0; i < 4; ++i) EXPECT_EQ(back[i], tet[i]);
  EXPECT_TRUE(std::signbit(back[1][0]));
  EXPECT_EQ(std::get<Settings>(read[0]).program, std::get<Settings>(all[0]).program);
  EXPECT_EQ(std::get<Flip>(read[13]).two_to_three, false);
  EXPECT_FALSE(std::get<Weight>(read[10]).kappa);
  EXPECT_EQ(std::get<FirstGrid>(read[7]).kappa_max, 1e-300);
}

TEST(Trace, LinesAreAsDocumented) {
  EXPECT_EQ(to_line(Insertion{.n = 2,
                              .tet = {Point(0, 0, 0), Point(1, 0, 0), Point(0, 0.1, 0), Point(0, 0, 1e300)},
                              .row = "2b",
                              .replaced = {0, 2},
                              .point = Point(0, 0.05, -0.0),
                              .e_avg = 0.5}),
            R"({"record":"insertion","n":2,"tet":[[0,0,0],[1,0,0],[0,0.1,0],[0,0,1e+300]],"row":"2b",)"
            R"("replaced":[0,2],"point":[0,0.05,-0.0],"e_avg":0.5})");
  EXPECT_EQ(to_line(Flip{.two_to_three = true,
                         .face = {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)},
                         .edge = {Point(0, 0, 1), Point(0, 0, -1)},
                         .quality_before = 0.25,
                         .quality_after = 0.5,
                         .e_avg = 3}),
            R"({"record":"flip","kind":"2-3","face":[[0,0,0],[1,0,0],[0,1,0]],"edge":[[0,0,1],[0,0,-1]],)"
            R"("quality":[0.25,0.5],"e_avg":3})");
  for (const Record& record : all) {
    const std::string line = to_line(record);
    EXPECT_EQ(line.find('\n'), std::string::npos);
    EXPECT_EQ(line.substr(0, line.find(',')), std::string("{\"record\":\"") + name_of(record) + "\"");
  }
}

TEST(Trace, NumbersThatAreNotFiniteAreNotWritten) {
  End end{.stopped = "no-gain"};
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    end.e_avg = bad;
    EXPECT_THROW(to_line(end), std::logic_error);
  }
}

TEST(Trace, WhatAReaderDoesNotKnowIsSkipped) {
  const TestFiles files;
  const std::string path =
      files.write("t.jsonl",
                  "\xEF\xBB\xBF{\"record\":\"banner\",\"deep\":[[[[1]]]]}\r\n\r\n \t\n"
                  "  { \"mine\" : {\"a\":null}, \"mended\":true, \"point\":[1,2.5,3e0], \"record\":\"moved\","
                  " \"vertex\":[1,2,3] }\r\n{\"record\":\"settings\"}\n"
                  "{\"record\":\"weight\",\"tet\":[[0,0,0],[0,0,0],[0,0,0],[0,0,0]],\"d\":1,\"kappa\":null,"
                  "\"omega\":1,\"volume\":1,\"desired\":1,\"error\":1}");  // no line end
  Reader reader(path);
  const std::optional<Record> moved = reader.next();
  ASSERT_TRUE(moved);
  EXPECT_EQ(reader.line(), 4);
  EXPECT_EQ(std::get<Moved>(*moved).point, Point(1, 2.5, 3));
  EXPECT_TRUE(std::get<Moved>(*moved).mended);
  EXPECT_EQ(to_line(*reader.next()), to_line(Settings{}));
  EXPECT_EQ(std::get<Weight>(*reader.next()).kappa, std::nullopt);
  EXPECT_EQ(reader.line(), 6);
  EXPECT_FALSE(reader.next());
  EXPECT_FALSE(reader.next());
  EXPECT_TRUE(read_all(files.write("empty.jsonl", "")).empty());
}

struct Case {
  std::string name, line, message;  // the message without "t.jsonl:2: "

  friend void PrintTo(const Case& test, std::ostream* out) { *out << test.name; }
};

const std::string insertion =
    R"({"record":"insertion","n":1,"tet":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]],"row":"1","replaced":[0,1,2,3],"point":[0,0,0],"e_avg":1})";

// A line of the trace in which one part is replaced.
std::string with(const std::string& part, const std::string& other, std::string line = insertion) {
  return line.replace(line.find(part), part.size(), other);
}

const std::vector<Case> cases{
    {"NotJson", "$MeshFormat", "expected a record as JSON in one line, found '$MeshFormat' at column 1"},
    {"Cut", "{\"record\":\"end\",",
     "expected a record as JSON in one line, found the end of the line at column 17"},
    {"TwoInALine", "{\"record\":\"x\"} {\"record\":\"y\"}",
     "expected a record as JSON in one line, found '{\"record\":\"y\"}' at column 16"},
    {"Nan", with("\"e_avg\":1", "\"e_avg\":NaN"),
     "expected a record as JSON in one line, found 'NaN}' at column 124"},
    {"TooLarge", with("\"e_avg\":1", "\"e_avg\":1e999"),
     "expected numbers that a double can hold, found a larger one"},
    {"NotUtf8", "{\"record\":\"\xFF\"}", "expected a record as JSON in one line, found '?\"}' at column 12"},
    {"ControlCharacter", std::string("{\"record\0\":1}", 13),
     "expected a record as JSON in one line, found '?\":1}' at column 9"},
    {"Array", "[1,2]", "expected a record as a JSON object, found [1,2]"},
    {"Number", "17", "expected a record as a JSON object, found 17"},
    {"Unnamed", "{\"kind\":\"end\"}",
     "expected a key \"record\" that names the kind of this record, found none"},
    {"NameIsNoText", "{\"record\":[\"end\"]}",
     "expected a key \"record\" that names the kind of this record, found [\"end\"]"},
    {"KeyMissing", with("\"e_avg\":1", "\"E\":1"),
     "expected a key \"e_avg\" in the insertion record, found none"},
    {"TextForANumber", with("\"e_avg\":1", "\"e_avg\":\"1\""),
     "expected a number as \"e_avg\" of the insertion record, found \"1\""},
    {"NullForANumber", with("\"e_avg\":1", "\"e_avg\":null"),
     "expected a number as \"e_avg\" of the insertion record, found null"},
    {"NumberForText", with("\"row\":\"1\"", "\"row\":1"),
     "expected a string as \"row\" of the insertion record, found 1"},
    {"UnknownRow", with("\"row\":\"1\"", "\"row\":\"5\""),
     "expected a row of Table 4 (0, 1, 2a, 2b, 3a, 3b, 4a, 4b, 4c, 4d, 4e) as \"row\" of the insertion "
     "record, found \"5\""},
    {"ShortPoint", with("\"point\":[0,0,0]", "\"point\":[0,0]"),
     "expected a point [x, y, z] as \"point\" of the insertion record, found [0,0]"},
    {"PointIsAnObject", with("\"point\":[0,0,0]", "\"point\":{\"x\":[0,[1,2]]}"),
     "expected a point [x, y, z] as \"point\" of the insertion record, found {\"x\":[0,[...]]}"},
    {"LongFind", with("\"point\":[0,0,0]", "\"point\":\"" + std::string(500, 'a') + "\""),
     "expected a point [x, y, z] as \"point\" of the insertion record, found \"" + std::string(59, 'a') +
         "..."},
    {"ThreeCorners", with(",[0,0,1]]", "]"),
     "expected four points [x, y, z] as \"tet\" of the insertion record, found [[0,0,0],[1,0,0],[0,1,0]]"},
    {"OnePosition", with("[0,1,2,3]", "[2]"),
     "expected two to four different positions from 0 to 3 as \"replaced\" of the insertion record, found "
     "[2]"},
    {"NoPosition", with("[0,1,2,3]", "[]"),
     "expected two to four different positions from 0 to 3 as \"replaced\" of the insertion record, found "
     "[]"},
    {"Position4", with("[0,1,2,3]", "[1,4]"),
     "expected two to four different positions from 0 to 3 as \"replaced\" of the insertion record, found "
     "[1,4]"},
    {"PositionTwice", with("[0,1,2,3]", "[1,2,1]"),
     "expected two to four different positions from 0 to 3 as \"replaced\" of the insertion record, found "
     "[1,2,1]"},
    {"FivePositions", with("[0,1,2,3]", "[0,1,2,3,0]"),
     "expected two to four positions as \"replaced\" of the insertion record, found [0,1,2,3,0]"},
    {"NumberZero", with("\"n\":1", "\"n\":0"),
     "expected an integer from 1 on as \"n\" of the insertion record, found 0"},
    {"NumberNegative", with("\"n\":1", "\"n\":-1"),
     "expected an integer from 0 on as \"n\" of the insertion record, found -1"},
    {"NumberBroken", with("\"n\":1", "\"n\":1.5"),
     "expected an integer from 0 on as \"n\" of the insertion record, found 1.5"},
    {"NumberBeyond64Bits", with("\"n\":1", "\"n\":9223372036854775808"),
     "expected an integer from 0 on as \"n\" of the insertion record, found 9223372036854775808"},
    {"Beyond32Bits", R"({"record":"lattice","box":[[0,0,0],[1,1,1]],"cells":[1,2,2147483648]})",
     "expected three integers from 0 on as \"cells\" of the lattice record, found [1,2,2147483648]"},
    {"NoCells", R"({"record":"lattice","box":[[0,0,0],[1,1,1]],"cells":[1,0,2]})",
     "expected three integers from 1 on as \"cells\" of the lattice record, found [1,0,2]"},
    {"OneCorner", R"({"record":"lattice","box":[[0,0,0]],"cells":[1,1,2]})",
     "expected two points [x, y, z] as \"box\" of the lattice record, found [[0,0,0]]"},
    {"Indicator", R"({"record":"indicators","j":0,"k":0,"initial":"+1-","after":"+0-"})",
     "expected a string of -, 0 and + as \"initial\" of the indicators record, found \"+1-\""},
    {"NoIndicators", R"({"record":"indicators","j":0,"k":0,"initial":"","after":""})",
     "expected a string of -, 0 and + as \"initial\" of the indicators record, found \"\""},
    {"FewerAfter", R"({"record":"indicators","j":0,"k":0,"initial":"+0-","after":"+0"})",
     "expected 3 indicators as in \"initial\" as \"after\" of the indicators record, found 2"},
    {"Edge", R"({"record":"cut","edge":[[0,0,0],[0,0,0.5]],"point":[0,0,0]})",
     "expected two lattice vertices [i, j, k] as \"edge\" of the cut record, found [[0,0,0],[0,0,0.5]]"},
    {"FiveRows", R"({"record":"rows","cell":[0,0,0],"rows":["1","1","1","1","1"]})",
     "expected six strings as \"rows\" of the rows record, found [\"1\",\"1\",\"1\",\"1\",\"1\"]"},
    {"Kind",
     R"({"record":"flip","kind":"4-4","face":[[0,0,0],[1,0,0],[0,1,0]],"edge":[[0,0,1],[0,0,2]],"quality":[0,1],"e_avg":1})",
     "expected \"2-3\" or \"3-2\" as \"kind\" of the flip record, found \"4-4\""},
    {"Quality",
     R"({"record":"flip","kind":"3-2","face":[[0,0,0],[1,0,0],[0,1,0]],"edge":[[0,0,1],[0,0,2]],"quality":1,"e_avg":1})",
     "expected two numbers as \"quality\" of the flip record, found 1"},
    {"Mended", R"({"record":"moved","vertex":[0,0,0],"point":[0,0,0],"mended":1})",
     "expected true or false as \"mended\" of the moved record, found 1"},
    {"Kappa",
     R"({"record":"weight","tet":[[0,0,0],[0,0,0],[0,0,0],[0,0,0]],"d":1,"kappa":"high","omega":1,"volume":1,"desired":1,"error":1})",
     "expected a number as \"kappa\" of the weight record, found \"high\""},
    {"SettingsPoints", R"({"record":"settings","points":100})",
     "expected a string as \"points\" of the settings record, found 100"},
    {"TooDeep", "{\"record\":\"x\",\"a\":" + std::string(20, '[') + std::string(20, ']') + "}",
     "expected at most 16 nested brackets, found more"},
    {"FarTooDeep", std::string(8 << 20, '['), "expected at most 16 nested brackets, found more"},
    {"FarTooDeepObjects",
     [] {
       std::string text;
       for (int i = 0; i < 1000000; ++i) text += "{\"a\":";
       return text;
     }(),
     "expected at most 16 nested brackets, found more"},
    {"TooLong", "{\"record\":\"" + std::string(9 << 20, 'a') + "\"}",
     "expected a line of at most 8388608 bytes, found a longer one"},
};

class TraceErrors : public ::testing::TestWithParam<Case> {};

INSTANTIATE_TEST_SUITE_P(All, TraceErrors, ::testing::ValuesIn(cases),
                         [](const auto& test) { return test.param.name; });

TEST_P(TraceErrors, SayWhereAndWhat) {
  const TestFiles files;
  const std::string path = files.write("t.jsonl", "{\"record\":\"settings\"}\n" + GetParam().line + "\n");
  EXPECT_EQ(files.message([&] { read_all(path); }), "t.jsonl:2: " + GetParam().message);
}

TEST(Trace, FilesThatCannotBeRead) {
  const TestFiles files;
  EXPECT_EQ(files.message([&] { Reader{files.path("no.jsonl")}; }),
            "no.jsonl: cannot open: No such file or directory");
  EXPECT_EQ(files.message([&] { Reader{files.path("")}; }), ": cannot read: Is a directory");
}

// A line of the greatest allowed length, which is read in parts, and the line after it.
TEST(Trace, LongLinesAreReadWhole) {
  const TestFiles files;
  for (const std::size_t count :
       {std::size_t{16380}, std::size_t{16383}, std::size_t{16384}, std::size_t{4000000}}) {
    const Indicators row{0, 1, std::string(count, '+'), std::string(count, '-')};
    const std::vector<Record> read =
        read_all(files.write("t.jsonl", to_line(row) + "\n" + to_line(End{.stopped = "no-gain"}) + "\n"));
    ASSERT_EQ(read.size(), 2u);
    EXPECT_EQ(std::get<Indicators>(read[0]).after, row.after);
  }
}

}  // namespace
}  // namespace tetproof::trace
