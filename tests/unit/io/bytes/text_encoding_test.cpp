// SPDX-License-Identifier: GPL-3.0-or-later
// Byte order marks, ends of texts, and texts in UTF-16, in files of every text format.
#include "io/bytes/text_encoding.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <utility>

#include "io/error.hpp"
#include "io/mesh_files.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof::io {
namespace {

using namespace std::string_literals;

TEST(EndOfText, IsBeforeZerosAndEndsOfDos) {
  EXPECT_EQ(end_of_text(""), 0u);
  EXPECT_EQ(end_of_text("ab\r\n"), 4u);
  EXPECT_EQ(end_of_text("ab\n\x1a"), 3u);
  EXPECT_EQ(end_of_text("ab\n\0\x1a\r\n\0\n"s), 3u);
  EXPECT_EQ(end_of_text("\x1a z"), 3u);
  EXPECT_EQ(end_of_text("\0\0"s), 0u);
}

// Text with two or four bytes for each character.
std::string wide(const std::string& text, std::size_t bytes, bool big, bool mark) {
  std::string all;
  const auto add = [&](unsigned code) {
    for (std::size_t k = 0; k < bytes; ++k)
      all += static_cast<char>(code >> 8 * (big ? bytes - 1 - k : k) & 255);
  };
  if (mark) add(0xFEFF);
  for (const char c : text) add(static_cast<unsigned char>(c));
  return all;
}

const std::pair<std::string, std::string> texts[]{
    {"a.msh",
     "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n1\n1 15 2 0 1 1\n"
     "$EndElements\n"},
    {"a.node", "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n"},
    {"a.ele", "1 4 0\n1 1 2 3 4\n"},
    {"a.face", "1 0\n1 1 2 3\n"},
    {"a.edge", "1 0\n1 1 2\n"},
    {"a.vol", "1\n1 0.5\n"},
    {"a.mtr", "4 1\n1\n1\n1\n1\n"},
    {"a.neigh", "1 4\n1 -1 -1 -1 -1\n"},
    {"a.poly", "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n1 0\n1\n3 1 2 3\n0\n0\n"},
    {"a.smesh", "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n1 0\n3 1 2 3\n0\n0\n"},
    {"a.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices 1\n0 0 0 0\nEnd\n"},
    {"a.sol", "MeshVersionFormatted 2\nDimension 3\nSolAtVertices 1\n1 1\n0.5\nEnd\n"},
    {"a.stl",
     "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
     "endfacet\nendsolid\n"},
    {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
    {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
    {"a.ply",
     "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
     "end_header\n0 0 0\n"},
};

// The other files of a set.
void write_set(const test::TestFiles& files, const std::string& name) {
  const auto write = [&](const std::string& other) {
    for (const auto& [each, text] : texts)
      if (each == other && name != other) files.write(other, text);
  };
  if (name == "a.sol") write("a.mesh");
  for (const char* of_set : {"a.node", "a.ele", "a.face", "a.edge", "a.vol", "a.mtr", "a.neigh"})
    if (name == of_set) write("a.node"), write("a.ele");
}

TEST(TextEncoding, MarksOfUtf8AndEndsOfDosChangeNothing) {
  for (const auto& [name, text] : texts) {
    const test::TestFiles files;
    write_set(files, name);
    const Document plain = read_document(files.write(name, text));
    EXPECT_TRUE(plain.warnings.empty()) << name << ": " << plain.warnings[0];
    const Document marked = read_document(files.write(name, "\xEF\xBB\xBF" + text));
    EXPECT_EQ(marked.points, plain.points) << name;
    EXPECT_EQ(marked.connectivity, plain.connectivity) << name;
    EXPECT_EQ(marked.node_values.size(), plain.node_values.size()) << name;
    EXPECT_TRUE(marked.warnings.empty()) << name << ": " << marked.warnings[0];
    EXPECT_TRUE(marked.dropped.empty()) << name << ": " << marked.dropped[0].item;
    const Document ended = read_document(files.write(name, text + "\x1a"));
    EXPECT_EQ(ended.connectivity, plain.connectivity) << name;
    EXPECT_TRUE(ended.dropped.empty()) << name << ": " << ended.dropped[0].item;
    ASSERT_EQ(ended.warnings.size(), 1u) << name;
    EXPECT_EQ(ended.warnings[0],
              fmt::format("{}: byte {}: ^Z at the end is passed over", files.path(name), text.size()));
  }
}

TEST(TextEncoding, WideTextIsRefusedByName) {
  for (const auto& [name, text] : texts)
    for (const std::size_t bytes : {2, 4})
      for (const bool big : {false, true})
        for (const bool mark : {false, true}) {
          const test::TestFiles files;
          write_set(files, name);
          files.write(name, wide(text, bytes, big, mark));
          const std::string path = files.path(name);
          EXPECT_EQ(files.message([&] { read_document(path); }),
                    fmt::format("{}: text in UTF-{}, which no mesh format has; save it as UTF-8 or ASCII",
                                name, 8 * bytes));
        }
}

}  // namespace
}  // namespace tetproof::io
