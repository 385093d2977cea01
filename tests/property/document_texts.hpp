// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a document as texts. Equal parts have equal texts, so they can be compared in any order.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "io/document.hpp"

namespace tetproof::test {

/// A part as text.
struct Text {
  std::string text;
  std::int64_t count = 1;              ///< how much the list of losses counts for it
  std::string item;                    ///< the name of its loss
  bool gone = false;                   ///< it belonged to nodes or elements that are lost
  bool may_be_said_otherwise = false;  ///< the rest may say it, so that it may be no loss
  std::string format{};                ///< of the file that the document was read from

  /// Its lines: values by node or element, columns of a table, or the title.
  struct Line {
    std::string of, content;
    bool empty = false;  ///< of values: only NaN or 0
  };
  std::string name{}, subject{};         ///< `subject`: the words in the example of a loss
  int components = 0;                    ///< of values
  std::string kind{}, labels{}, step{};  ///< of values
  std::vector<Line> lines{};
};

/// The name of a node or an element in texts. It is the same in both documents; it is empty if the other
/// document does not have the node or element.
using Names = std::function<std::string(Index)>;

std::string bits(double x);  ///< -0 is not 0; any NaN is like any other
std::string quoted(const std::string& text);

std::vector<Text> texts_of_values(const std::vector<Values>& all, const char* whose, const Names& name);
std::vector<Text> texts_of_links(const Document& document, const Names& node);
std::vector<Text> texts_of_ghosts(const Document& document, const Names& element);
std::vector<Text> texts_of_names(const Document& document);
/// Facets, holes, regions, bounds.
std::vector<Text> texts_of_boundary(const Document& document, const Names& node, const Names& element);
std::vector<Text> texts_of_voronoi(const Document& document);
/// Tables, sections, the title.
std::vector<Text> texts_of_rest(const Document& document);
/// Everything of an entity.
std::string text_of_entity(const Document& document, const Entity& entity);

}  // namespace tetproof::test
