// SPDX-License-Identifier: GPL-3.0-or-later
// A report of tables and findings as a page of HTML. Internal.
#pragma once

#include <string>
#include <vector>

#include "corpus/campaign/text_table.hpp"

namespace tetproof::corpus {

struct PlainPage {
  struct Table {
    std::string id, heading;  ///< id: letters and "-"
    TextRows rows;
  };
  std::string title, verdict, verdict_kind;  ///< kind: "pass", "warning" or "fail"
  std::string summary;
  std::vector<Table> tables;
  std::vector<std::string> findings;  ///< lines each
  std::vector<std::string> remarks;
};

/// The page: what was found, the tables, and the remarks. Cells that are whole numbers stand to the right.
std::string plain_page(const PlainPage& report);

/// README.txt beside `file` in the folder `root`, which says how to try it again; empty if there is none.
std::string readme_beside(const std::string& root, const std::string& file);

}  // namespace tetproof::corpus
