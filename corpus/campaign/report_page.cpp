// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/campaign_page.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "corpus/campaign/group_text.hpp"
#include "corpus/campaign/tallies.hpp"
#include "corpus/report/finding_page.hpp"
#include "io/error.hpp"
#include "io/page/page.hpp"

namespace tetproof::corpus {
namespace {

namespace fs = std::filesystem;
using io::PageCell;
using io::PageRow;

// A path as an address: all but letters, digits and a few marks as %XX.
std::string address_of(const std::string& path) {
  std::string address;
  for (const char c : path) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("/._-~").find(c) != std::string_view::npos;
    address += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return address;
}

PageCell number(std::int64_t n) {
  return {.text = fmt::format("{}", n), .number = true};
}

void add_tally(io::Page& page, const char* id, const char* title, const std::vector<TallyRow>& tally,
               const std::vector<Outcome>& outcomes) {
  std::vector<std::string> columns{"", "cases"};
  for (const Outcome outcome : outcomes) columns.emplace_back(name_of(outcome));
  std::vector<PageRow> rows;
  for (const auto& [name, counts] : tally) {
    PageRow row{{.text = name}, number(counts.cases())};
    for (const Outcome outcome : outcomes) {
      PageCell cell = number(counts.count(outcome));
      if (is_finding(outcome) && counts.count(outcome) > 0) cell.kind = "fail";
      row.push_back(std::move(cell));
    }
    rows.push_back(std::move(row));
  }
  page.part(std::string(id) + "-part", title);
  page.table(id, columns, rows);
}

// Writes the page of a finding. Returns its address for the campaign's page, or why there is none.
std::pair<std::string, std::string> finding_page_of(const ShrunkCase& shrunk, const CampaignPages& pages,
                                                    std::string& picture) {
  if (shrunk.folder.empty()) return {"", "not shrunk to a folder"};
  for (const std::string& root : pages.folders) {
    const fs::path folder = fs::path(root) / shrunk.folder;
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored)) continue;
    try {
      const std::string page = finding_page(folder.string());
      picture = picture_address(folder.string());
      pages.write((folder / "page.html").string(), page);
    } catch (const InputError& error) {
      pages.say(fmt::format("no page for a finding: {}", error.what()));
      return {"", error.what()};
    }
    const fs::path from = pages.path == "-" ? fs::current_path() : fs::absolute(pages.path).parent_path();
    return {address_of(fs::relative(folder, from, ignored).string() + "/page.html"), ""};
  }
  return {"", "its folder " + shrunk.folder + " is not found"};
}

}  // namespace

void write_campaign_pages(const CampaignResult& result, const CampaignPages& pages) {
  const std::int64_t fresh = new_groups(result);
  PageCell verdict{.text = "nothing new", .kind = "pass"};
  if (is_incomplete(result)) verdict = {.text = "nothing new, but not all was judged", .kind = "warning"};
  if (fresh > 0) verdict = {.text = fmt::format("{} new", fresh), .kind = "fail"};
  io::Page page("Fuzz campaign", verdict);
  page.paragraph(summary_line(result));
  for (const std::string& line : result.missing) page.paragraph("Missing: " + line);
  std::vector<PageRow> rows;
  for (const FailureGroup& group : result.groups) {
    PageRow row{
        {.text = group.mesher},    {.text = name_of(group.outcome), .kind = group.known ? "warning" : "fail"},
        {.text = group.signature}, number(static_cast<std::int64_t>(group.cases.size())),
        number(group.surfaces),    number(group.cases.front().triangles)};
    const ShrunkCase* shrunk = shrunk_of_group(result, group);
    if (shrunk) {
      std::string picture;
      const auto [address, why] = finding_page_of(*shrunk, pages, picture);
      row.push_back(number(shrunk->triangles));
      row.push_back({.text = address.empty() ? why : shrunk->folder, .link = address});
      row.push_back({.text = picture.empty() ? "" : "picture of the defect", .image = picture});
    } else {
      row.push_back({.text = "not shrunk", .number = true});
      row.push_back({});
      row.push_back({});
    }
    row.push_back({.text = group.known ? "known" : "new"});
    rows.push_back(std::move(row));
  }
  page.part("failures", "Groups of failures");
  if (rows.empty())
    page.paragraph("No failure.");
  else
    page.table("groups",
               {"mesher", "outcome", "signature", "cases", "surfaces", "smallest [triangles]", "shrunk to",
                "finding", "picture", ""},
               rows);
  std::size_t number = 0;
  for (const FailureGroup& group : result.groups) page.lines(group_text(result, group, ++number));
  for (const std::string& id : result.known_unseen) page.paragraph("Known, and did not occur: " + id);
  const std::vector<Outcome> outcomes = shown_outcomes(result);
  add_tally(page, "by-mesher", "By mesher", tally_by_mesher(result), outcomes);
  add_tally(page, "by-kind", "By kind of surface", tally_by_kind(result), outcomes);
  pages.write(pages.path, page.text());
}

}  // namespace tetproof::corpus
