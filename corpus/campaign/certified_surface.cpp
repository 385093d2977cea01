// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/campaign/certified_surface.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace tetproof::corpus {
namespace {

std::string differs(const char* what, std::int64_t is, std::int64_t promised) {
  return is == promised ? "" : fmt::format("{} {}, not {}", is, what, promised);
}

// Which promise the surface breaks; empty: none.
std::string broken_promise(const FuzzSurface& made, const verify::SurfaceReport& report) {
  if (!report.fault.empty()) return report.fault;
  std::string broken;
  if (made.cavities) broken = differs("cavities", report.cavities(), *made.cavities);
  if (broken.empty() && made.components)
    broken = differs("components", static_cast<std::int64_t>(report.components.size()), *made.components);
  if (broken.empty() && made.genus) broken = differs("handles", report.genus, *made.genus);
  return broken;
}

}  // namespace

CertifiedSurface::CertifiedSurface(const CampaignOptions& options, std::uint64_t index) {
  std::string fault;
  try {
    made_ = std::make_unique<const FuzzSurface>(
        options.surface_of ? options.surface_of(index) : fuzz_surface(options.seed, index, options.surfaces));
    judged_ = std::make_unique<const verify::JudgedSurface>(made_->surface);
    fault = broken_promise(*made_, judged_->report());
  } catch (const std::exception& error) {
    fault = error.what();
  }
  if (!fault.empty())
    throw std::logic_error(
        fmt::format("the surface of seed {}, index {} is not valid: {}", options.seed, index, fault));
}

std::string CertifiedSurface::recipe() const {
  return made_->recipe.kind.empty() ? "" : recipe_text(made_->recipe);
}

}  // namespace tetproof::corpus
