// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/figure/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>

namespace tetproof::reference::svg {

std::string escaped(const std::string& text) {
  std::string all;
  for (const char c : text)
    all += c == '&'             ? "&amp;"
           : c == '<'           ? "&lt;"
           : c == '>'           ? "&gt;"
           : c < ' ' || c > '~' ? "?"
                                : std::string(1, c);
  return all;
}

void PathData::add(const std::vector<Pixel>& points, bool closed) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    text_ += i == 0 ? "m" : i == 1 ? "l" : points[i][0] < at_[0] ? "" : " ";
    text_ +=
        fmt::format("{}{}{}", points[i][0] - at_[0], points[i][1] < at_[1] ? "" : " ", points[i][1] - at_[1]);
    at_ = points[i];
  }
  if (closed) {
    text_ += 'z';
    at_ = points.front();
  }
}

void PathData::add_polygon(const std::vector<Pixel>& points) {
  std::vector<Pixel> different;
  for (const Pixel& point : points)
    if (different.empty() || different.back() != point) different.push_back(point);
  if (different.size() > 1 && different.front() == different.back()) different.pop_back();
  if (different.size() > 2) add(different, true);
}

PathData chained(const std::vector<std::array<Pixel, 2>>& segments) {
  std::map<Pixel, std::vector<std::size_t>> at;
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (const Pixel& end : segments[i]) at[end].push_back(i);
  std::vector<bool> used(segments.size(), false);
  PathData data;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (used[i]) continue;
    used[i] = true;
    std::vector<Pixel> line{segments[i][0], segments[i][1]};
    for (bool going = true; going;) {
      going = false;
      for (const std::size_t next : at[line.back()])
        if (!used[next]) {
          used[next] = going = true;
          line.push_back(segments[next][segments[next][0] == line.back() ? 1 : 0]);
          break;
        }
    }
    const bool closed = line.size() > 2 && line.front() == line.back();
    if (closed) line.pop_back();
    data.add(line, closed);
  }
  return data;
}

std::string page(const Page& page) {
  constexpr int margin = 20, header = 46, beside = 175, line = 17,
                letter = 7;  // a letter's width, generously
  const int drawn = std::max(page.width, 400), lines = static_cast<int>(page.caption.size()),
            width = margin + drawn + margin + beside;
  std::size_t longest = 0;
  for (const std::string& text : page.caption) longest = std::max(longest, text.size());
  const bool under_drawing = static_cast<int>(longest) * letter <= drawn;  // else under the legend, too
  const int text_top = header + (under_drawing ? page.height : std::max(page.height, page.legend_height)) + 8,
            height = std::max(text_top + line * lines, header + page.legend_height) + 12;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"Helvetica, Arial, sans-serif\" fill=\"#222\">\n"
      "<title>{2}</title>\n<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n"
      "<text x=\"{3}\" y=\"29\" font-size=\"19\">{2}</text>\n"
      "<g transform=\"translate({4} {5}) scale({6})\" stroke-linejoin=\"round\">\n{7}</g>\n"
      "<g transform=\"translate({8} {5})\" font-size=\"12\">\n{9}</g>\n",
      width, height, escaped(page.title), margin, margin + (drawn - page.width) / 2, header, 1.0 / fineness,
      page.drawing, margin + drawn + margin, page.legend);
  for (int i = 0; i < lines; ++i)
    svg += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"12\">{}</text>\n", margin,
                       text_top + line * (i + 1), escaped(page.caption[i]));
  return svg + "</svg>\n";
}

}  // namespace tetproof::reference::svg
