// SPDX-License-Identifier: GPL-3.0-or-later
// The report on a fuzz campaign as pages of HTML.
#pragma once

#include <functional>
#include <string>

#include "corpus/fuzz_campaign.hpp"

namespace tetproof::corpus {

/// Writes pages, and says where they are.
struct CampaignPages {
  std::string path;  ///< of the campaign's page; "-": standard output
  std::vector<std::string>
      folders;  ///< of the campaign, or of its shards, in which the findings are looked for
  std::function<void(const std::string& path, const std::string& page)> write;
  std::function<void(const std::string& line)> say;  ///< what could not be shown
};

/// The campaign's page: counts by mesher and by kind of surface, and the groups of failures with their
/// pictures; and a page `page.html` in the folder of each finding, to which it links. A finding whose folder
/// is not found or not whole has no page, which is said in the table.
void write_campaign_pages(const CampaignResult& result, const CampaignPages& pages);

}  // namespace tetproof::corpus
