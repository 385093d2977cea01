// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a page of HTML in one file, which opens from disk, without a network and in any browser.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/page/scene.hpp"

namespace tetproof::io {

/// One cell of a table.
struct PageCell {
  std::string text{};
  bool number = false;  ///< aligned to the right
  std::string kind{};   ///< "pass", "warning", "fail", "skipped": the colour of a verdict; else empty
  int target = -1;      ///< a position in `Scene::targets`: a click flies to it
  std::string link{};   ///< another page, as a relative address
  std::string image{};  ///< the address of a picture, instead of the text; the text tells what it shows
};
using PageRow = std::vector<PageCell>;

/// A page that grows from top to bottom. Every text may hold anything, from names in files for example: it is
/// shown as it is, and never becomes part of the page's code. Besides, a security policy in the page forbids
/// all scripts and styles that are not the page's own, and all addresses but pictures beside it. The same
/// calls give the same bytes.
class Page {
 public:
  /// `title`: of the window and at the top. `verdict`: a word with the kind of a cell, beside the title;
  /// empty: none.
  explicit Page(std::string_view title, const PageCell& verdict = {});

  /// A heading. `id` names the part that follows: letters and "-".
  void part(std::string_view id, std::string_view heading);
  void paragraph(std::string_view text);
  /// Text in its lines, as on a terminal.
  void lines(std::string_view text);
  /// A table. `id` as for `part`. The heading of a column of numbers stands to the right as well.
  void table(std::string_view id, const std::vector<std::string>& columns, const std::vector<PageRow>& rows);
  /// An SVG that was made by this room's functions (plots.hpp, picture.hpp).
  void svg(std::string_view text);
  /// The view in three dimensions; at most one a page. `picture`: an SVG that stands for it where a browser
  /// has no WebGL. A target's cells in tables are buttons that fly to it.
  void view(const Scene& scene, std::string_view picture);

  /// The whole page.
  std::string text() const;

 private:
  std::string title_, body_;
  bool has_view_ = false;
};

}  // namespace tetproof::io
