// SPDX-License-Identifier: GPL-3.0-or-later
// What a file of VTK loses of a document, and whether it gives it back.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "io/losses.hpp"
#include "io/mesh_files.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof::test {

/// A line for each loss of the document in this file.
inline std::string losses_in_words(const std::string& path, const Document& document) {
  std::string text;
  for (const Loss& loss : losses(path, document))
    text += fmt::format("{}: {} ({})\n", loss.item, loss.count, loss.example);
  return text;
}

/// Writes the document as `name` and reads it again: it is the same, and nothing is lost.
inline void expect_back(const TestFiles& files, const std::string& name, const Document& document) {
  const std::string path = files.path(name);
  EXPECT_EQ(losses_in_words(path, document), "") << name;
  write_document(path, document);
  const Document back = read_document(path);
  EXPECT_EQ(text_of(back, false), text_of(document, false)) << name;
  EXPECT_TRUE(back.dropped.empty()) << name;
  ASSERT_EQ(back.blocks.size(), document.blocks.size());
  for (std::size_t b = 0; b < back.blocks.size(); ++b)
    EXPECT_EQ(back.blocks[b].faces, document.blocks[b].faces) << name;
  for (std::size_t k = 0; k < back.node_values.size(); ++k)
    EXPECT_EQ(back.node_values[k].roles, document.node_values[k].roles) << name;
  for (std::size_t k = 0; k < back.element_values.size(); ++k)
    EXPECT_EQ(back.element_values[k].roles, document.element_values[k].roles) << name;
}

}  // namespace tetproof::test
