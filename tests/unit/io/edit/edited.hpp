// SPDX-License-Identifier: GPL-3.0-or-later
// Small documents for tests of edits, and what is left of them as text.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "io/edit/edits.hpp"
#include "io/mesh_files.hpp"
#include "io/model/document_positions.hpp"
#include "tests/support/test_files.hpp"
#include "tests/unit/io/surface/surface_document_text.hpp"

namespace tetproof::test {

inline std::string msh22(const std::string& nodes, const std::string& elements,
                         const std::string& rest = "") {
  const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
  return fmt::format(
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n{}$Nodes\n{}\n{}$EndNodes\n$Elements\n{}\n{}$EndElements\n",
      rest, lines(nodes), nodes, lines(elements), elements);
}

/// A line, a triangle and two tetrahedra, of which the second is wound inwards if `inverted`. The triangle is
/// the bottom of the first tetrahedron, wound inwards. Each has a group, a value and a node value.
inline std::string two_tets_text(bool inverted = false) {
  return msh22("10 0 0 0\n20 1 0 0\n30 0 1 0\n40 0 0 1\n50 1 1 1\n60 9 9 9\n",
               std::string("6 1 2 5 1 10 20\n7 2 2 9 6 10 20 30\n8 4 2 1 3 10 20 30 40\n") +
                   (inverted ? "9 4 2 2 4 30 20 40 50\n" : "9 4 2 2 4 20 30 40 50\n"),
               "$PhysicalNames\n2\n3 1 \"steel\"\n2 9 \"bottom\"\n$EndPhysicalNames\n") +
         "$NodeData\n1\n\"t\"\n1\n0\n3\n0\n1\n6\n10 1\n20 2\n30 3\n40 4\n50 5\n60 6\n$EndNodeData\n"
         "$ElementData\n1\n\"q\"\n1\n0\n3\n0\n1\n3\n7 70\n8 80\n9 90\n$EndElementData\n";
}

inline Document document_of_text(const std::string& name, const std::string& text) {
  const TestFiles files;
  Document document = read_document(files.write(name, text));
  document.path = name;
  return document;
}
inline Document two_tets(bool inverted = false) {
  return document_of_text("a.msh", two_tets_text(inverted));
}

/// The document is in order; its text.
inline std::string left_of(const Document& document) {
  EXPECT_EQ(io::misplaced(document), nullptr);
  return told(document);
}

inline std::string said(const io::Edit& edit) {
  std::string text = edit.did;
  for (const Loss& loss : edit.lost)
    text += fmt::format(" | {} {} ({})", loss.item, loss.count, loss.example);
  return text;
}

}  // namespace tetproof::test
