// SPDX-License-Identifier: GPL-3.0-or-later
// The surface of a case, proved to be closed, manifold, oriented and free of self-intersections. Not
// installed.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "corpus/fuzz_campaign.hpp"
#include "verify/surface.hpp"

namespace tetproof::corpus {

class CertifiedSurface {
 public:
  /// std::logic_error, with seed and index, if it cannot be built, or is not what the recipe promises: that
  /// is our own failure.
  CertifiedSurface(const CampaignOptions& options, std::uint64_t index);

  const FuzzSurface& made() const { return *made_; }
  const verify::JudgedSurface& judged() const { return *judged_; }
  std::string recipe() const;  ///< as text; empty for a surface that is not made by a recipe

 private:
  std::unique_ptr<const FuzzSurface> made_;  // in its place: the judgement refers to it
  std::unique_ptr<const verify::JudgedSurface> judged_;
};

}  // namespace tetproof::corpus
