// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/campaign/plain_page.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "io/page/page.hpp"

namespace tetproof::corpus {
namespace {

bool is_number(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

std::string plain_page(const PlainPage& report) {
  io::Page page(report.title, {.text = report.verdict, .kind = report.verdict_kind});
  page.paragraph(report.summary);
  page.part("findings-part", "Findings");
  if (report.findings.empty()) page.paragraph("None.");
  for (const std::string& finding : report.findings) page.lines(finding);
  for (const PlainPage::Table& table : report.tables) {
    std::vector<io::PageRow> rows;
    for (std::size_t r = 1; r < table.rows.size(); ++r) {
      io::PageRow& row = rows.emplace_back();
      for (const std::string& cell : table.rows[r]) row.push_back({.text = cell, .number = is_number(cell)});
    }
    page.part(table.id + "-part", table.heading);
    page.table(table.id, table.rows.front(), rows);
  }
  if (!report.remarks.empty()) page.part("remarks", "Remarks");
  for (const std::string& line : report.remarks) page.paragraph(line);
  return page.text();
}

std::string readme_beside(const std::string& root, const std::string& file) {
  if (root.empty() || file.empty()) return "";
  std::ifstream readme((std::filesystem::path(root) / file).parent_path() / "README.txt", std::ios::binary);
  return {std::istreambuf_iterator<char>(readme), {}};
}

}  // namespace tetproof::corpus
