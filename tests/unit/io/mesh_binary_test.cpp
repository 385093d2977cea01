// SPDX-License-Identifier: GPL-3.0-or-later
// Binary .msh in both byte orders, built here byte by byte.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <tuple>

#include "io/mesh_files.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof {
namespace {

class Bytes {
 public:
  explicit Bytes(bool swapped) : swapped_(swapped) {}
  Bytes& text(const std::string& text) {
    bytes_ += text;
    return *this;
  }
  Bytes& ints(std::initializer_list<std::int32_t> values) { return all(values); }
  Bytes& sizes(std::initializer_list<std::int64_t> values) { return all(values); }
  Bytes& reals(std::initializer_list<double> values) { return all(values); }
  const std::string& bytes() const { return bytes_; }

 private:
  template <class T>
  Bytes& all(std::initializer_list<T> values) {
    for (T value : values) {
      char raw[sizeof(T)];
      std::memcpy(raw, &value, sizeof(T));
      if (swapped_) std::reverse(raw, raw + sizeof(T));
      bytes_.append(raw, sizeof(T));
    }
    return *this;
  }
  const bool swapped_;
  std::string bytes_;
};

class BinaryMsh : public testing::TestWithParam<bool> {};

TEST_P(BinaryMsh, Version41) {
  Bytes bytes(GetParam());
  bytes.text("$MeshFormat\n4.1 1 8\n").ints({1}).text("\n$EndMeshFormat\n");
  bytes.text("$PhysicalNames\n1\n3 7 \"steel\"\n$EndPhysicalNames\n$Entities\n").sizes({1, 0, 1, 1});
  bytes.ints({5}).reals({0.1, -0.0, 1e300}).sizes({0});
  bytes.ints({2}).reals({0, 0, 0, 1, 1, 0}).sizes({0}).sizes({0});
  bytes.ints({1})
      .reals({0, 0, 0, 1, 1, 1})
      .sizes({2})
      .ints({7, -8})
      .sizes({1})
      .ints({-2})
      .text("\n$EndEntities\n");
  bytes.text("$Nodes\n").sizes({2, 5, 1, 1LL << 40});
  bytes.ints({2, 2, 1}).sizes({1}).sizes({1LL << 40}).reals({0.1, 0.2, 0.3, 5e-324, 17.000000000000004});
  bytes.ints({3, 1, 0}).sizes({4}).sizes({1, 2, 3, 4}).reals({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
  bytes.text("\n$EndNodes\n$Elements\n").sizes({2, 3, 9, 11});
  bytes.ints({3, 1, 4}).sizes({2}).sizes({9, 1, 2, 3, 4, 10, 1, 2, 3, 1LL << 40});
  bytes.ints({2, 2, 2}).sizes({1}).sizes({11, 1, 2, 77}).text("\n$EndElements\n");
  bytes.text("$NodeData\n1\n\"T\"\n0\n3\n0\n1\n1\n").ints({2}).reals({0.5}).text("\n$EndNodeData\n");
  const test::TestFiles files;
  const Document document = read_document(files.write("a.msh", bytes.bytes()));
  EXPECT_EQ(
      test::text_of(document),
      "msh41\nG 3 7 steel\nE 0/5 0.1 -0 1e+300 0.1 -0 1e+300 g b\nE 2/2 0 0 0 1 1 0 g b\n"
      "E 3/1 0 0 0 1 1 1 g7,-8 b-2\nn 1099511627776 0.1 0.2 0.3\nn 1 0 0 0\nn 2 1 0 0\nn 3 0 1 0\nn 4 0 0 1\n"
      "N 2/2 1: 5e-324 17.000000000000004\nN 3/1 4: \ne 9 4 3/1 g7,-8 p: 1 2 3 4\n"
      "e 10 4 3/1 g7,-8 p: 1 2 3 1099511627776\ne 11 2 2/2 g p: 1 2 ?77\n"
      "v nodes T 1 at 2: 0.5\n");
  // Writing uses this machine's byte order. The content is the same; if that is the file's order, so are the
  // bytes.
  write_document(files.path("b.msh"), document, {.binary = true});
  EXPECT_EQ(test::text_of(read_document(files.path("b.msh"))), test::text_of(document));
  if (!GetParam()) {
    EXPECT_EQ(test::TestFiles::read(files.path("b.msh")), bytes.bytes());
  }
}

TEST_P(BinaryMsh, Version22) {
  Bytes bytes(GetParam());
  bytes.text("$MeshFormat\n2.2 1 8\n").ints({1}).text("\n$EndMeshFormat\n$Nodes\n4\n");
  for (int k = 0; k < 4; ++k)
    bytes.ints({10 + k}).reals({k == 1 ? 1. : -0., k == 2 ? 0.1 : 0, k == 3 ? 5e-324 : 0});
  bytes.text("\n$EndNodes\n$Elements\n5\n");
  bytes.ints({4, 2, 2}).ints({1, 7, 5, 10, 11, 12, 13}).ints({2, -7, 5, 10, 11, 12, 99});
  bytes.ints({2, 1, 0}).ints({3, 10, 11, 12});
  bytes.ints({4, 1, 5}).ints({4, 7, 5, 2, 1, -2, 10, 11, 12, 13});  // partition 1, ghost in 2
  bytes.ints({15, 1, 1}).ints({5, 3, 10}).text("\n$EndElements\n");
  const test::TestFiles files;
  const Document document = read_document(files.write("a.msh", bytes.bytes()));
  EXPECT_EQ(test::text_of(document),
            "msh22\nn 10 -0 0 0\nn 11 1 0 0\nn 12 -0 0.1 0\nn 13 -0 0 5e-324\ne 1 4 3/5 g7 p: 10 11 12 13\n"
            "e 2 4 3/5 g-7 p: 10 11 12 ?99\ne 3 2 2/0 g p: 10 11 12\ne 4 4 3/5 g7 p1: 10 11 12 13\n"
            "e 5 15 0/0 g3 p: 10\nghost element 4 1: 2\n");
}

TEST_P(BinaryMsh, Version22WithoutLineEndsBeforeTheEnds) {  // as some programs write it
  Bytes bytes(GetParam());
  bytes.text("$MeshFormat\n2.2 1 8\n")
      .ints({1})
      .text("$EndMeshFormat\n$Nodes\n1\n")
      .ints({7})
      .reals({1, 2, 3});
  bytes.text("$EndNodes\n$Elements\n1\n").ints({15, 1, 2, 1, 0, 4, 7}).text("$EndElements\n");
  const test::TestFiles files;
  EXPECT_EQ(test::text_of(read_document(files.write("a.msh", bytes.bytes()))),
            "msh22\nn 7 1 2 3\ne 1 15 0/4 g p: 7\n");
}

// Gmsh passes over what stands behind the announced rows up to the end of a section.
TEST_P(BinaryMsh, RowsBehindThoseAnnouncedAreDropped) {
  Bytes old(GetParam()), now(GetParam());
  old.text("$MeshFormat\n2.2 1 8\n").ints({1}).text("\n$EndMeshFormat\n$Nodes\n1\n").ints({7});
  old.reals({1, 2, 3}).ints({8}).reals({4, 5, 6}).text("\n$EndNodes\n$Elements\n1\n");
  old.ints({15, 1, 2, 1, 0, 4, 7, 15, 1, 2, 2, 0, 4, 7}).text("\n$EndElements\n");
  now.text("$MeshFormat\n4.1 1 8\n").ints({1}).text("\n$EndMeshFormat\n$Nodes\n").sizes({1, 1, 7, 7});
  now.ints({0, 4, 0}).sizes({1, 7}).reals({1, 2, 3}).text("\n$Nodes\n\n$EndNodes\n$Elements\n");
  now.sizes({1, 1, 1, 1}).ints({0, 4, 15}).sizes({1, 1, 7, 2, 7}).text("$EndElements\n$NodeData\n1\n\"T\"\n");
  now.text("0\n3\n0\n1\n1\n").ints({7}).reals({0.5}).ints({8}).reals({1.5}).text("\n$EndNodeData\n");
  const test::TestFiles files;
  for (const auto& [bytes, content, lost] :
       {std::tuple(old.bytes(), "msh22\nn 7 1 2 3\ne 1 15 0/4 g p: 7\n",
                   "28 bytes of $Nodes (byte 77), 28 bytes of $Elements (byte 156), "),
        {now.bytes(), "msh41\nn 7 1 2 3\nN 0/4 1: \ne 1 15 0/4 g p: 7\nv nodes T 1: 0.5\n",
         "8 bytes of $Nodes (byte 131), 16 bytes of $Elements (byte 228), 12 bytes of $NodeData (byte "
         "295), "}}) {
    const Document document = read_document(files.write("a.msh", bytes));
    EXPECT_EQ(test::text_of(document), content);
    std::string dropped;
    for (const Loss& loss : document.dropped) {
      dropped += fmt::format("{} {} ({}), ", loss.count, loss.item.substr(0, loss.item.find(" behind")),
                             loss.example);
      EXPECT_EQ(loss.elements, loss.item.find("$Elements") != loss.item.npos) << loss.item;
    }
    EXPECT_EQ(dropped, lost);
  }
}

// Gmsh reads all elements of a header, also beyond the number that the section announces.
TEST_P(BinaryMsh, AHeaderWithMoreElementsThanAnnounced) {
  Bytes bytes(GetParam());
  bytes.text("$MeshFormat\n2.2 1 8\n").ints({1}).text("\n$EndMeshFormat\n$Nodes\n1\n").ints({7});
  bytes.reals({1, 2, 3}).text("\n$EndNodes\n$Elements\n1\n");
  bytes.ints({15, 2, 2, 1, 0, 4, 7, 2, 0, 4, 7}).text("\n$EndElements\n");
  const test::TestFiles files;
  const Document document = read_document(files.write("a.msh", bytes.bytes()));
  EXPECT_EQ(document.elements(), 2u);
  EXPECT_TRUE(document.dropped.empty());
  ASSERT_FALSE(document.warnings.empty());
  EXPECT_EQ(document.warnings[0].substr(files.path("").size()),
            "a.msh: byte 100: 1 element is announced, and 2 are there");
}

TEST_P(BinaryMsh, Version40) {
  Bytes bytes(GetParam());
  bytes.text("$MeshFormat\n4 1 8\n").ints({1}).text("\n$EndMeshFormat\n$Entities\n").sizes({1, 0, 0, 1});
  bytes.ints({5}).reals({0.1, -0.0, 1, 0.1, -0.0, 1}).sizes({0});
  bytes.ints({1}).reals({0, 0, 0, 1, 1, 1}).sizes({2}).ints({7, -8}).sizes({1}).ints({-2});
  bytes.text("\n$EndEntities\n$Nodes\n").sizes({2, 5});
  bytes.ints({9, 2, 1}).sizes({1}).ints({12}).reals({0.1, 0.2, 0.3, 5e-324, 0.75});
  bytes.ints({1, 3, 0}).sizes({4}).ints({1}).reals({0, 0, 0}).ints({2}).reals({1, 0, 0});
  bytes.ints({3}).reals({0, 1, 0}).ints({4}).reals({0, 0, 1}).text("\n$EndNodes\n$Elements\n");
  bytes.sizes({1, 2}).ints({1, 3, 4}).sizes({2}).ints({9, 1, 2, 3, 4, 10, 1, 2, 3, 77});
  bytes.text("\n$EndElements\n");
  const test::TestFiles files;
  EXPECT_EQ(test::text_of(read_document(files.write("a.msh", bytes.bytes()))),
            "msh40\nE 0/5 0.1 -0 1 0.1 -0 1 g b\nE 3/1 0 0 0 1 1 1 g7,-8 b-2\nn 12 0.1 0.2 0.3\nn 1 0 0 0\n"
            "n 2 1 0 0\nn 3 0 1 0\nn 4 0 0 1\nN 2/9 1: 5e-324 0.75\nN 3/1 4: \ne 9 4 3/1 g7,-8 p: 1 2 3 4\n"
            "e 10 4 3/1 g7,-8 p: 1 2 3 ?77\n");
}

TEST_P(BinaryMsh, Version3) {
  Bytes bytes(GetParam());
  bytes.text("$MeshFormat\n3 1 8\n").ints({1}).text("\n$EndMeshFormat\n$Entities\n0 0 0 1\n2 0 1 7\n");
  bytes.text("$EndEntities\n$Nodes\n3\n").ints({1}).reals({0, -0.0, 0.1}).ints({0});
  bytes.ints({2}).reals({1, 0, 0}).ints({4, 1}).reals({0.5}).ints({3}).reals({0, 1, 0}).ints({0});
  bytes.text("\n$EndNodes\n$Elements\n2\n").ints({1, 2, 9, 3, 1, 2, 3});
  bytes.ints({2, 4, 2, 7, 1, 2, 3, 8, 2, 1, -2}).text("\n$EndElements\n");
  const test::TestFiles files;
  EXPECT_EQ(test::text_of(read_document(files.write("a.msh", bytes.bytes()))),
            "msh3\nE 3/2 0 0 0 0 0 0 g7 b\nn 1 0 -0 0.1\nn 2 1 0 0\nn 3 0 1 0\nN 1/4 1: 0.5\n"
            "e 1 2 2/9 g p: 1 2 3\ne 2 4 3/2 g7 p1: 1 2 3 ?8\nghost element 2 1: 2\n");
}

INSTANTIATE_TEST_SUITE_P(ByteOrder, BinaryMsh, testing::Bool(),
                         [](const auto& test) { return test.param ? "Other" : "Ours"; });

}  // namespace
}  // namespace tetproof
