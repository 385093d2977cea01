// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/loss/loss_list.hpp"

#include <fmt/format.h>

namespace tetproof::io {
namespace {

// Terminals also obey the control characters U+0080 to U+009F, which are two bytes in UTF-8.
std::string in_one_line(const std::string& text) {
  std::string line;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0U;
    const bool two_bytes = byte == 0xC2 && next >= 0x80 && next < 0xA0;
    if (byte >= ' ' && byte != 0x7F && !two_bytes)
      line += text[i];
    else
      line += fmt::format("\\x{:02X}", two_bytes ? next : byte);
    i += two_bytes;
  }
  return line;
}

}  // namespace

void add_loss(std::vector<Loss>& losses, const std::string& item, std::size_t count,
              const std::string& example, bool elements) {
  if (count == 0) return;
  const std::string name = in_one_line(item);
  for (Loss& loss : losses)
    if (loss.item == name) {
      loss.count += static_cast<std::int64_t>(count);
      loss.elements = loss.elements || elements;
      return;
    }
  losses.push_back({name, static_cast<std::int64_t>(count), in_one_line(example), elements});
}

}  // namespace tetproof::io
