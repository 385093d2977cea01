// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/vtk/vtu_skeleton.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "io/bytes/scanner.hpp"

namespace tetproof::io {
namespace {

constexpr int most_nested = 64;

class Cutter {
 public:
  explicit Cutter(const InputFile& file)
      : path_(file.path()), bytes_(file.bytes()), at_(bytes_.starts_with("\xEF\xBB\xBF") ? 3 : 0) {}

  VtuSkeleton cut() {
    while (at_ < bytes_.size() && skeleton_.appended == 0) bytes_[at_] == '<' ? markup() : text();
    return std::move(skeleton_);
  }

 private:
  [[noreturn]] void fail(std::string_view message) const {
    Scanner(path_, bytes_, at_).fail_in_line(message);
  }

  void skip_to(std::string_view end) {
    const std::size_t found = bytes_.find(end, at_);
    if (found == std::string_view::npos) fail(fmt::format("expected {}, found the end of the file", end));
    at_ = found + end.size();
  }

  void text() {
    const std::size_t begin = at_;
    at_ = std::min(bytes_.find('<', at_), bytes_.size());
    if (bytes_.substr(begin, at_ - begin).find_first_not_of(" \t\r\n") == std::string_view::npos) return;
    if (depth_ == 0 && !skeleton_.tags.empty()) fail("expected the end of the file behind </VTKFile>");
    // A comment between two texts leaves a comma, which becomes an error when the number is read.
    if (!skeleton_.xml.empty() && skeleton_.xml.back() != '>') skeleton_.xml += ',';
    skeleton_.xml += fmt::format("{}", skeleton_.texts.size());
    skeleton_.texts.push_back({begin, at_});
  }

  void markup() {
    const std::string_view rest = bytes_.substr(at_);
    if (rest.starts_with("<!--")) return skip_to("-->");
    if (rest.starts_with("<?")) return skip_to("?>");
    if (rest.starts_with("<![")) fail("expected no CDATA section");
    if (rest.starts_with("<!")) return skip_to(">");
    const std::size_t begin = at_;
    char quote = '\0';
    std::size_t attributes = 0;
    for (++at_; at_ < bytes_.size(); ++at_) {
      const char c = bytes_[at_];
      if (quote ? c == quote : c == '"' || c == '\'') {
        attributes += quote == '\0';
        quote = quote ? '\0' : c;
      } else if (!quote && c == '>') {
        break;
      }
    }
    if (at_ == bytes_.size()) fail("expected the end of a tag, found the end of the file");
    std::string_view tag = bytes_.substr(begin, ++at_ - begin);
    // A rough estimate of the memory that pugixml needs.
    memory_ += 64 + 40 * attributes + tag.size();
    if (memory_ > (std::size_t{64} << 20) + 8 * bytes_.size())
      fail("more tags than a file of this size needs");
    skeleton_.tags.emplace_back(skeleton_.xml.size(), begin);
    const bool closing = tag[1] == '/', alone = tag[tag.size() - 2] == '/';
    if (tag.starts_with("<AppendedData") && !alone) {
      skeleton_.xml += tag;
      skeleton_.xml += "</AppendedData></VTKFile>";
      at_ = bytes_.find_first_not_of(" \t\r\n", at_);
      if (at_ >= bytes_.size() || bytes_[at_] != '_') {
        at_ = std::min(at_, bytes_.size());
        fail("expected the _ in front of appended data");
      }
      skeleton_.appended = at_ + 1;
      return;
    }
    skeleton_.xml += tag;
    depth_ += closing ? -1 : alone ? 0 : 1;
    if (depth_ > most_nested) fail(fmt::format("tags are nested more than {} deep", most_nested));
  }

  const std::string& path_;
  std::string_view bytes_;
  std::size_t at_, memory_ = 0;
  int depth_ = 0;
  VtuSkeleton skeleton_;
};

}  // namespace

std::size_t VtuSkeleton::place(std::ptrdiff_t in_xml) const {
  std::size_t found = 0;
  for (const auto& [here, there] : tags)
    if (static_cast<std::ptrdiff_t>(here) <= in_xml) found = there + static_cast<std::size_t>(in_xml) - here;
  return found;
}

VtuSkeleton vtu_skeleton(const InputFile& file) {
  return Cutter(file).cut();
}

}  // namespace tetproof::io
