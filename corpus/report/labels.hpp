// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in a picture, placed where they do not hide each other. Internal.
#pragma once

#include <fmt/format.h>

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "corpus/report/projection.hpp"
#include "io/bytes/xml_text.hpp"

namespace tetproof::corpus {

/// Numbers beside their points, where they do not hide each other.
class Labels {
 public:
  explicit Labels(const Frame& frame) : frame_(frame) {}
  void add(const Pixel& at, const std::string& text, const char* colour) {
    const int w = 7 * static_cast<int>(text.size()) + 2, h = 12;
    const int x = at[0] / 10, y = at[1] / 10;
    std::array<int, 4> best{};
    int least = std::numeric_limits<int>::max();
    for (const int far : {5, 12, 20, 30})
      for (const auto& [dx, dy] :
           {std::array{1, -1}, {-1, -1}, {1, 1}, {-1, 1}, {0, -1}, {0, 1}, {1, 0}, {-1, 0}}) {
        const int left = x + dx * far -
                         (dx < 0    ? w
                          : dx == 0 ? w / 2
                                    : 0),
                  upper = y + dy * far -
                          (dy < 0    ? h
                           : dy == 0 ? h / 2
                                     : 0);
        const std::array box{left, upper, left + w, upper + h};
        int cost = far / 4;
        for (const auto& other : boxes_)
          if (box[0] < other[2] && other[0] < box[2] && box[1] < other[3] && other[1] < box[3]) cost += 100;
        if (box[0] < frame_.left - 12 || box[2] > frame_.left + frame_.width + 14 ||
            box[1] < frame_.top - 10 || box[3] > frame_.top + frame_.height + 14)
          cost += 60;
        if (cost < least) least = cost, best = box;
      }
    boxes_.push_back(best);
    if (best[0] > x + 9 || best[2] < x - 9 || best[1] > y + 9 || best[3] < y - 9)
      lines_ += fmt::format("<path d=\"M{} {}L{} {}\" stroke=\"#888\" stroke-width=\"6\"/>\n", at[0], at[1],
                            5 * (best[0] + best[2]), 5 * (best[1] + best[3]));
    const std::string place = fmt::format("<text x=\"{}\" y=\"{}\"", 10 * best[0] + 10, 10 * best[3] - 20);
    halos_ += fmt::format("{}>{}</text>\n", place, io::xml_escaped(text));
    texts_ += fmt::format("{} fill=\"{}\">{}</text>\n", place, colour, io::xml_escaped(text));
  }
  void keep_free(const Pixel& at) {
    boxes_.push_back({at[0] / 10 - 3, at[1] / 10 - 3, at[0] / 10 + 4, at[1] / 10 + 4});
  }
  // White around the letters keeps them readable on lines. Not all viewers know paint-order.
  std::string svg() const {
    return fmt::format("<g font-size=\"120\">\n{}<g stroke=\"#fff\" stroke-width=\"30\">\n{}</g>\n{}</g>\n",
                       lines_, halos_, texts_);
  }

 private:
  Frame frame_;
  std::vector<std::array<int, 4>> boxes_;
  std::string lines_, halos_, texts_;
};

}  // namespace tetproof::corpus
