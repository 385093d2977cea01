// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/page/page.hpp"

#include <fmt/format.h>

#include <array>
#include <iterator>

#include "io/bytes/base64.hpp"
#include "io/bytes/xml_text.hpp"
#include "io/page/resources.hpp"

namespace tetproof::io {
namespace {

// three.js is in every copy of a page with a view, and its licence asks to be there too.
constexpr std::string_view three_licence = R"(<!--
This page holds three.js and its OrbitControls, under the MIT licence:
Copyright 2010-2019 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated
documentation files (the "Software"), to deal in the Software without restriction, including without limitation the
rights to use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and to permit
persons to whom the Software is furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all copies or substantial portions of the
Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE
WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR
COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR
OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.
-->
)";

// A hash as a security policy names it.
std::string source_of(const Resource& resource) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < resource.sha256.size(); i += 2)
    bytes += static_cast<char>(std::stoi(std::string(resource.sha256.substr(i, 2)), nullptr, 16));
  return "'sha256-" + base64(bytes) + "'";
}

// In the order in which they use each other.
const std::array<const Resource*, 8> page_scripts{&three_js,   &orbit_js,   &scene_js,  &cut_js,
                                                  &drawing_js, &overlay_js, &viewer_js, &controls_js};

// A browser drops a line end that follows the tag of a script, and the hash is of all that remains; so
// nothing is put around the text.
std::string script(const Resource& resource) {
  return fmt::format("<script>{}</script>\n", resource.text);
}

std::string kind_of(const PageCell& cell) {
  std::string kind = cell.kind;
  if (cell.number) kind += kind.empty() ? "number" : " number";
  return kind.empty() ? "" : fmt::format(" class=\"{}\"", xml_escaped(kind));
}

std::string content_of(const PageCell& cell) {
  const std::string text = xml_escaped(cell.text, XmlLines::keep);
  if (!cell.image.empty())
    return fmt::format("<img src=\"{}\" alt=\"{}\">", xml_escaped(cell.image), xml_escaped(cell.text));
  if (!cell.link.empty()) return fmt::format("<a href=\"{}\">{}</a>", xml_escaped(cell.link), text);
  if (cell.target >= 0)
    return fmt::format("<button type=\"button\" data-target=\"{}\">{}</button>", cell.target, text);
  return text;
}

}  // namespace

Page::Page(std::string_view title, const PageCell& verdict) : title_(title) {
  body_ = fmt::format("<h1>{}", xml_escaped(title, XmlLines::keep));
  if (!verdict.text.empty())
    body_ += fmt::format(" <span id=\"verdict\"{}>{}</span>", kind_of(verdict), content_of(verdict));
  body_ += "</h1>\n";
}

void Page::part(std::string_view id, std::string_view heading) {
  body_ += fmt::format("<h2 id=\"{}\">{}</h2>\n", xml_escaped(id), xml_escaped(heading, XmlLines::keep));
}

void Page::paragraph(std::string_view text) {
  body_ += fmt::format("<p>{}</p>\n", xml_escaped(text, XmlLines::keep));
}

void Page::lines(std::string_view text) {
  body_ += fmt::format("<pre>{}</pre>\n", xml_escaped(text, XmlLines::keep));
}

void Page::table(std::string_view id, const std::vector<std::string>& columns,
                 const std::vector<PageRow>& rows) {
  body_ += fmt::format("<div class=\"wide\"><table id=\"{}\">\n<thead><tr>", xml_escaped(id));
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const bool number = !rows.empty() && c < rows.front().size() && rows.front()[c].number;
    body_ += fmt::format("<th scope=\"col\"{}>{}</th>", number ? " class=\"number\"" : "",
                         xml_escaped(columns[c], XmlLines::keep));
  }
  body_ += "</tr></thead>\n<tbody>\n";
  for (const PageRow& row : rows) {
    body_ += "<tr>";
    for (const PageCell& cell : row) body_ += fmt::format("<td{}>{}</td>", kind_of(cell), content_of(cell));
    body_ += "</tr>\n";
  }
  body_ += "</tbody>\n</table></div>\n";
}

void Page::svg(std::string_view text) {
  body_ += fmt::format("<figure>{}</figure>\n", text);
}

void Page::view(const Scene& scene, std::string_view picture) {
  has_view_ = true;
  body_ += fmt::format(
      "<section id=\"view\" aria-label=\"view in three dimensions\" hidden>\n<div id=\"stage\">"
      "<svg id=\"axes\" viewBox=\"-42 -42 84 84\" aria-hidden=\"true\"></svg></div>\n"
      "<div id=\"controls\"></div>\n<div id=\"told\" role=\"status\"></div>\n</section>\n"
      "<figure id=\"picture\">{}<figcaption id=\"no-view\"><noscript>Without scripts this picture stands for "
      "the "
      "view, and a click flies nowhere. All tables are complete.</noscript></figcaption></figure>\n"
      "<script type=\"application/json\" id=\"scene\">{}</script>\n",
      picture, scene_json(scene));
}

std::string Page::text() const {
  std::string admitted, scripts;
  if (has_view_)
    for (const Resource* one : page_scripts) {
      if (!admitted.empty()) admitted += ' ';
      admitted += source_of(*one);
      scripts += script(*one);
    }
  std::string page;
  fmt::format_to(std::back_inserter(page),
                 "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                 "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src {}; "
                 "style-src {}; "
                 "img-src 'self' file: data:; base-uri 'none'; form-action 'none'\">\n"
                 "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                 "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n{}</main>\n",
                 has_view_ ? admitted : "'none'", source_of(page_css), xml_escaped(title_, XmlLines::keep),
                 page_css.text, body_);
  if (has_view_) page += std::string(three_licence) + scripts;
  page += "</body>\n</html>\n";
  return page;
}

}  // namespace tetproof::io
