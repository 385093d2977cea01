// SPDX-License-Identifier: GPL-3.0-or-later
// A list of differences that adds up those of the same item.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "documents_compare.hpp"
#include "io/bytes/one_line.hpp"

namespace tetproof::test {

class DifferenceList {
 public:
  /// `subject`: the node, element or part that differs; empty: the whole document does.
  void add(const std::string& named, std::int64_t count, const std::string& example, bool unsure = false,
           const std::string& part = "") {
    const std::string item = io::in_one_line(named), subject = io::in_one_line(part);  // as losses have them
    for (Difference& d : differences_)
      if (d.item == item) {
        d.count += count;
        d.unsure = d.unsure && unsure;
        if (!subject.empty()) d.subjects.push_back(subject);
        return;
      }
    differences_.push_back({item, count, example, {}, unsure});
    if (!subject.empty()) differences_.back().subjects.push_back(subject);
  }

  /// One difference of `subject`, which is also the example; `more` is added to the example.
  void add_one(const std::string& item, const std::string& subject, const std::string& more = "") {
    add(item, 1, subject + more, false, subject);
  }

  std::vector<Difference> take() { return std::move(differences_); }

 private:
  std::vector<Difference> differences_;
};

}  // namespace tetproof::test
