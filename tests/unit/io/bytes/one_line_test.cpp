// SPDX-License-Identifier: GPL-3.0-or-later
// Texts in messages: one line, whatever they hold.
#include "io/bytes/one_line.hpp"

#include <gtest/gtest.h>

#include "io/error.hpp"

namespace tetproof::io {
namespace {

TEST(OneLine, EscapesWhatSteersATerminalOrBreaksALine) {
  EXPECT_EQ(in_one_line("a\nb\r\tc\x1b[31m\x7f"), "a\\x0Ab\\x0D\\x09c\\x1B[31m\\x7F");
  EXPECT_EQ(in_one_line(std::string("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(in_one_line("\xC2\x85|\xC2\x9B|\xE2\x80\xA8|\xE2\x80\xA9|\xE2\x80\xAE|\xEF\xBB\xBF"),
            "\\x85|\\x9B|\\u2028|\\u2029|\\u202E|\\uFEFF");
}

TEST(OneLine, LeavesOtherTexts) {
  for (const char* text :
       {"", "plain \\x1B", "\xC3\xA9t\xC3\xA9", "\xE4\xBD\x93", "\xF0\x9F\x94\xBA", "\xC2\xA0"})
    EXPECT_EQ(in_one_line(text), text);
}

TEST(OneLine, EscapesBytesThatAreNoText) {
  EXPECT_EQ(in_one_line("\xFF\xE9!"), "\\xFF\\xE9!");
  EXPECT_EQ(in_one_line("\xC3"), "\\xC3");                    // cut
  EXPECT_EQ(in_one_line("\xC0\x8A"), "\\xC0\\x8A");           // a line feed in too many bytes
  EXPECT_EQ(in_one_line("\xE0\x80\x8A"), "\\xE0\\x80\\x8A");  // the same in three
  EXPECT_EQ(in_one_line("\xED\xA0\x80"), "\\xED\\xA0\\x80");  // half of a pair
  EXPECT_EQ(in_one_line("\xF4\x90\x80\x80"), "\\xF4\\x90\\x80\\x80");
}

TEST(OneLine, StartsEndBetweenCharacters) {
  EXPECT_EQ(start_in_one_line("abc", 3), "abc");
  EXPECT_EQ(start_in_one_line("abcd", 3), "abc...");
  EXPECT_EQ(start_in_one_line("ab\xC3\xA9", 3), "ab...");
}

TEST(OneLine, JsonKeepsItsLines) {
  EXPECT_EQ(escape_controls_of_json("{\n\"a\": \"\x7f\xC2\x9B\xC3\xA9\"\n}"),
            "{\n\"a\": \"\\u007f\\u009b\xC3\xA9\"\n}");
}

TEST(OneLine, OfErrors) {
  EXPECT_STREQ(InputError("a.ply: \x1b[2Jred\n").what(), "a.ply: \\x1B[2Jred\\x0A");
}

}  // namespace
}  // namespace tetproof::io
