// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a document as texts that are equal when the parts are: so they can be compared in any order.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "io/document.hpp"

namespace tetproof::test {

/// A part as a text, and how many of what its loss is counted in it has.
struct Text {
  std::string text;
  std::int64_t count = 1;
  std::string item;   ///< what its loss is called
  bool gone = false;  ///< it belonged to nodes or elements that are not there any more

  /// Its parts, by what they belong to: lines of values by node or element, columns of a table, the title.
  struct Line {
    std::string of, content;
    bool empty = false;  ///< of values: nothing but NaN or 0
  };
  std::string name{}, subject{};         ///< `subject`: as the example of a loss names it
  int components = 0;                    ///< of values
  std::string kind{}, labels{}, step{};  ///< of values: real or integer, and what is not numbers
  std::vector<Line> lines{};
};

/// What a node or an element is called in texts: the same for the same one in both documents; empty for one
/// that the other document does not have.
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
