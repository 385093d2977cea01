// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/writing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "io/codecs.hpp"
#include "io/loss/file_plan.hpp"
#include "io/loss/loss_list.hpp"
#include "io/loss/written_part.hpp"
#include "io/model/group_signs.hpp"
#include "io/model/groups_of_values.hpp"
#include "io/model/polylines.hpp"
#include "io/supplement/supplement.hpp"

namespace tetproof {

PlannedFile::PlannedFile(std::string path, const Document& document, const WriteOptions& options)
    : path_(std::move(path)), document_(document), encoding_(encoding_of(path_, options)) {}

PlannedFile::~PlannedFile() = default;
PlannedFile::PlannedFile(PlannedFile&&) noexcept = default;

io::FilePlan& PlannedFile::plan() {
  if (plan_) return *plan_;
  const io::Codec& codec = io::codec_named(encoding_.format);
  if (!codec.keeps_aside && io::has_signed_groups(document_)) {
    changed_ = std::make_unique<Document>(io::with_unsigned_groups(document_));
    unsigned_groups_ = true;
  } else if (codec.groups_below_zero) {
    if (std::optional<Document> changed = io::with_groups_below_zero(document_))
      changed_ = std::make_unique<Document>(*std::move(changed));
  }
  if (!codec.polylines && io::has_polylines(document_))
    changed_ = std::make_unique<Document>(io::with_polylines_cut(written(), lost_by_cutting_));
  plan_ = codec.plan(written(), encoding_.binary);
  return *plan_;
}

// Whatever the format does not hold is either kept aside or lost, all of it.
void PlannedFile::find_losses() {
  if (losses_) return;
  const io::Holds& holds = plan().holds();
  std::vector<Loss> unheld = io::unheld(written(), holds);
  losses_ = lost_by_cutting_;
  if (unsigned_groups_) find_lost_signs(holds);
  if (holds.kept_in.empty())
    losses_->insert(losses_->end(), unheld.begin(), unheld.end());
  else
    kept_aside_ = {holds.kept_in, std::move(unheld)};
}

// Where groups are written: their signs are gone, and the elements are not turned.
void PlannedFile::find_lost_signs(const io::Holds& holds) {
  const io::WrittenPart part(written(), holds);
  for (const io::WrittenPart::Block& one : part.blocks()) {
    const ElementBlock& was = document_.blocks[static_cast<std::size_t>(one.block - written().blocks.data())];
    if (was.groups == one.block->groups) continue;
    if (holds.groups_of ? !holds.groups_of(*one.block) : holds.groups == io::Holds::Groups::none) continue;
    const auto& groups = document_.tag_sets[static_cast<std::size_t>(was.groups)];
    if (holds.groups == io::Holds::Groups::first && groups.front() >= 0) continue;
    io::add_loss(*losses_, "signs of physical groups", one.count,
                 fmt::format("element {} in group {}", document_.element_tag(was.first),
                             *std::min_element(groups.begin(), groups.end())));
  }
}

const std::vector<Loss>& PlannedFile::losses() {
  find_losses();
  return *losses_;
}

const KeptAside& PlannedFile::kept_aside() {
  find_losses();
  return kept_aside_;
}

std::vector<Loss> PlannedFile::dangling() {
  return io::dangling(written(), plan().holds());
}

const std::string& PlannedFile::warning() {
  if (!warning_) warning_ = plan().warning(path_);
  return *warning_;
}

std::vector<std::string> PlannedFile::files() {
  return plan().files(path_);
}

void PlannedFile::write() {
  std::string supplement;
  if (const io::Holds& holds = plan().holds(); !holds.kept_in.empty() && !kept_aside().items.empty())
    supplement = io::supplement_of(written(), holds);
  plan().write(path_, supplement);
}

std::vector<Loss> losses(const std::string& path, const Document& document, const WriteOptions& options) {
  return PlannedFile(path, document, options).losses();
}

KeptAside kept_aside(const std::string& path, const Document& document, const WriteOptions& options) {
  return PlannedFile(path, document, options).kept_aside();
}

std::string write_warning(const std::string& path, const Document& document, const WriteOptions& options) {
  return PlannedFile(path, document, options).warning();
}

void write_document(const std::string& path, const Document& document, const WriteOptions& options) {
  PlannedFile(path, document, options).write();
}

}  // namespace tetproof
