// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/loss/loss_list.hpp"

#include "io/bytes/one_line.hpp"

namespace tetproof::io {
namespace {

void add_to(Loss& loss, std::size_t count, bool elements) {
  loss.count += static_cast<std::int64_t>(count);
  loss.elements = loss.elements || elements;
}

Loss new_loss(const std::string& name, std::size_t count, const std::string& example, bool elements) {
  return {name, static_cast<std::int64_t>(count), in_one_line(example), elements};
}

}  // namespace

void add_loss(std::vector<Loss>& losses, const std::string& item, std::size_t count,
              const std::string& example, bool elements) {
  if (count == 0) return;
  const std::string name = in_one_line(item);
  for (Loss& loss : losses)
    if (loss.item == name) return add_to(loss, count, elements);
  losses.push_back(new_loss(name, count, example, elements));
}

LossList::LossList(std::vector<Loss>& losses) : losses_(losses) {
  for (std::size_t i = 0; i < losses.size(); ++i) places_.emplace(losses[i].item, i);
}

void LossList::add(const std::string& item, std::size_t count, const std::string& example, bool elements) {
  if (count == 0) return;
  const std::string name = in_one_line(item);
  const auto [place, is_new] = places_.emplace(name, losses_.size());
  if (!is_new) return add_to(losses_[place->second], count, elements);
  losses_.push_back(new_loss(name, count, example, elements));
}

}  // namespace tetproof::io
