// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>

#include "io/bytes/byte_order.hpp"
#include "io/bytes/scanner.hpp"
#include "io/bytes/text_encoding.hpp"
#include "io/bytes/tokens.hpp"
#include "io/bytes/words.hpp"
#include "io/error.hpp"
#include "io/loss/loss_list.hpp"
#include "io/model/element_types.hpp"
#include "io/model/tag_sets.hpp"
#include "io/model/weld.hpp"
#include "io/stl/stl.hpp"
#include "io/stl/stl_solids.hpp"
#include "io/surface/text_of_file.hpp"

namespace tetproof::io {
namespace {

bool same_word(std::string_view word, std::string_view lower) {
  if (word.size() != lower.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i)
    if ((word[i] >= 'A' && word[i] <= 'Z' ? word[i] - 'A' + 'a' : word[i]) != lower[i]) return false;
  return true;
}

void expect(Scanner& scanner, std::string_view lower) {
  const std::string_view word = scanner.word();
  if (!same_word(word, lower)) scanner.fail(fmt::format("'{}'", lower), word);
}

// A binary file: its facets, those announced, and bytes behind the last one.
struct Binary {
  std::size_t facets = 0, announced = 0, trailing = 0;
};

// Whether all numbers of the first facets are such as meshes have. Bytes of another kind of file are not.
bool has_facets(std::string_view bytes, std::size_t facets) {
  for (std::size_t i = 0; i < std::min<std::size_t>(facets, 20); ++i)
    for (std::size_t k = 3; k < 12; ++k) {  // the normal may be anything
      const auto x = std::abs(
          load<float>(bytes.data() + stl_header_bytes + stl_facet_bytes * i + 4 * k, std::endian::little));
      if (x != 0 && !(x > 1e-30F && x < 1e30F)) return false;
    }
  return facets > 0;
}

// None if the file is text.
std::optional<Binary> binary_form(const InputFile& file) {
  const std::string_view bytes = file.bytes();
  if (bytes.size() < stl_header_bytes) return {};
  const std::size_t announced = load<std::uint32_t>(bytes.data() + 80, std::endian::little);
  const std::size_t facets = (bytes.size() - stl_header_bytes) / stl_facet_bytes;
  const std::size_t trailing = (bytes.size() - stl_header_bytes) % stl_facet_bytes;
  if (trailing == 0 && (announced == facets || announced == 0)) return Binary{facets, facets, 0};
  // Four characters of a text would announce more facets than any file has.
  if (announced == facets && facets > 0) return Binary{facets, announced, trailing};
  // No text has a zero byte: this is a binary file whose number of facets is wrong, or that lost its end.
  const std::string_view start =
      bytes.substr(0, end_of_text(bytes)).substr(0, stl_header_bytes + 2 * stl_facet_bytes);
  if (start.find('\0') == start.npos) return {};
  if (!has_facets(bytes, facets))
    throw InputError(fmt::format("{}: byte 80: expected {} bytes for the {} announced here, found {}",
                                 file.path(), stl_header_bytes + stl_facet_bytes * announced,
                                 counted(announced, "facets"), bytes.size()));
  // Bytes that make whole facets are taken for facets.
  const std::size_t read = trailing == 0 ? facets : std::min(announced, facets);
  return Binary{read, announced, bytes.size() - stl_header_bytes - stl_facet_bytes * read};
}

class Reader {
 public:
  Reader(const InputFile& file, Wanted wanted) : file_(file), surface_(wanted == Wanted::surface) {
    document_.path = file.path(), document_.format = "stl";
  }

  ReadDocument read() {
    if (const std::optional<Binary> binary = binary_form(file_))
      read_binary(*binary);
    else
      read_text();
    return finish();
  }

 private:
  struct Solid {
    std::string line;  // the words behind "solid"
    std::size_t facets = 0;
  };

  void read_binary(const Binary& binary) {
    const std::size_t facets = binary.facets;
    source_.text = false;
    document_.title = stl_title(file_.bytes().substr(0, 80));
    const std::size_t said = load<std::uint32_t>(file_.bytes().data() + 80, std::endian::little);
    if (said != facets)
      warn(fmt::format("byte 80: {} {} announced, {} {} there", counted(said, "facets"),
                       said == 1 ? "is" : "are", facets, facets == 1 ? "is" : "are"));
    // All ones stand for a number that was not known when the header was written.
    if (said > facets && said != 0xFFFFFFFF)
      add_loss(document_.dropped, "facets that are announced but not there", said - facets,
               fmt::format("{} of {} {} there", facets, said, facets == 1 ? "is" : "are"), true);
    add_loss(document_.dropped, "bytes behind the last facet", binary.trailing,
             fmt::format("byte {}", stl_header_bytes + stl_facet_bytes * facets),
             binary.trailing >= stl_facet_bytes);
    Values attributes{.name = "attribute"};
    points_.reserve(3 * facets);
    for (std::size_t i = 0; i < facets; ++i) {
      const char* const facet = file_.bytes().data() + stl_header_bytes + stl_facet_bytes * i;
      const auto three = [](const char* from) {
        return Eigen::Vector3d(load<float>(from, std::endian::little),
                               load<float>(from + 4, std::endian::little),
                               load<float>(from + 8, std::endian::little));
      };
      for (int corner = 1; corner <= 3; ++corner) points_.push_back(three(facet + 12 * corner));
      check_normal(three(facet), static_cast<std::size_t>(facet - file_.bytes().data()));
      if (surface_) continue;
      const auto attribute = load<std::uint16_t>(facet + 48, std::endian::little);
      if (attribute != 0 && attributes.integers.empty()) attributes.integers.resize(i);
      if (attribute != 0 || !attributes.integers.empty()) attributes.integers.push_back(attribute);
    }
    solids_.push_back({"", facets});
    if (!attributes.integers.empty()) document_.element_values.push_back(std::move(attributes));
  }

  // Reads the words of these names in one, such as "endloop"; or in two, "end loop", which some writers use.
  bool is_end(std::string_view word, std::string_view of, Scanner& scanner) {
    if (word.size() == 3 + of.size() && same_word(word.substr(0, 3), "end") && same_word(word.substr(3), of))
      return true;
    if (!same_word(word, "end") || !same_word(scanner.peek_word(), of)) return false;
    if (ends_in_two_words_++ == 0) first_end_in_two_words_ = scanner.offset();
    scanner.word();
    return true;
  }

  // From behind "facet" to behind "endfacet".
  void read_facet(Scanner& scanner, std::size_t place) {
    std::string_view word = scanner.word();
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    // Three words that are often no numbers: some writers put "-nan(ind)" there.
    if (same_word(word, "normal")) {
      word = scanner.word();
      for (int k = 0; k < 3 && !same_word(word, "outer"); ++k) {
        if (!parse_real(word, normal[k])) normal[k] = std::nan("");
        word = scanner.word();
      }
    }
    if (!same_word(word, "outer")) scanner.fail("'outer loop'", word);
    expect(scanner, "loop");
    int vertices = 0;
    while (same_word(word = scanner.word(), "vertex")) {
      Eigen::Vector3d point;
      for (int k = 0; k < 3; ++k) point[k] = scanner.real("a coordinate");
      if (++vertices <= 3) points_.push_back(point);
    }
    if (!is_end(word, "loop", scanner)) scanner.fail("'vertex' or 'endloop'", word);
    if (vertices != 3)
      scanner.fail_in_line(fmt::format("facet has {}, expected 3", counted(vertices, "vertices")));
    if (word = scanner.word(); !is_end(word, "facet", scanner)) scanner.fail("'endfacet'", word);
    check_normal(normal, place);
  }

  void read_text() {
    text_ = text_of_file(file_, document_);
    Scanner scanner = start_of_text(file_, text_);
    std::string_view word = scanner.word();
    if (!same_word(word, "solid") && !same_word(word, "facet")) scanner.fail("'solid'", word);
    std::size_t colors = 0, first_color = 0;
    for (; !word.empty(); word = scanner.word()) {
      const std::size_t place = scanner.offset() - word.size();
      if (same_word(word, "facet")) {
        if (solids_.empty()) solids_.emplace_back();
        read_facet(scanner, place);
        ++solids_.back().facets;
      } else if (same_word(word, "solid")) {
        solids_.push_back({stl_title(scanner.rest_of_line()), 0});
      } else if (is_end(word, "solid", scanner)) {
        scanner.rest_of_line();  // the name again, or none
        scanner.at_end();
        behind_solid_ = scanner.offset();
      } else if (same_word(word, "color")) {  // of a solid, as some programs write it and VTK passes over it
        scanner.rest_of_line();
        if (colors++ == 0) first_color = place;
      } else if (is_trailing(place)) {
        add_loss(document_.dropped, "bytes behind the last solid", text_.size() - place,
                 fmt::format("line {}", line_of(place)));
        break;
      } else {
        scanner.fail("'facet', 'endsolid' or 'solid'", word);
      }
    }
    if (colors > 0)
      add_loss(document_.dropped, "colours of solids", colors,
               example_line(file_.path(), text_, first_color));
  }

  // Whether the bytes from `place` on follow the end of a solid, and no facet is among them.
  bool is_trailing(std::size_t place) const {
    if (place != behind_solid_) return false;
    return lower_case(text_.substr(place)).find("facet") == text_.npos;
  }

  // Counts normals that point against the order of the last three corners.
  void check_normal(const Eigen::Vector3d& normal, std::size_t place) {
    const Eigen::Vector3d* p = points_.data() + points_.size() - 3;
    if (!(normal.dot((p[1] - p[0]).cross(p[2] - p[0])) < 0)) return;
    if (against_++ == 0) first_against_ = place;
  }

  ReadDocument finish() {
    if (points_.size() > static_cast<std::size_t>(std::numeric_limits<Index>::max()))
      throw InputError(
          fmt::format("{}: {} facets, at most 715827882 can be numbered", file_.path(), points_.size() / 3));
    document_.connectivity = weld(points_);
    document_.points = std::move(points_);
    std::vector<std::string> lines;
    for (const Solid& solid : solids_) lines.push_back(solid.line);
    const std::vector<StlGroup> groups = groups_of_solids(lines);
    TagSets sets(document_);
    std::set<std::pair<std::int64_t, std::string>> named;
    std::size_t first = 0;
    for (std::size_t s = 0; s < solids_.size(); ++s) {
      if (!groups[s].name.empty() && named.insert({groups[s].number, groups[s].name}).second)
        document_.group_names.push_back({2, groups[s].number, groups[s].name});
      if (solids_[s].facets == 0) continue;
      document_.blocks.push_back({.type = triangle3,
                                  .dim = 2,
                                  .groups = groups[s].number == 0 ? 0 : sets({groups[s].number}),
                                  .nodes_each = 3,
                                  .count = solids_[s].facets,
                                  .first = first,
                                  .nodes = 3 * first});
      first += solids_[s].facets;
    }
    if (against_ > 0)
      add_loss(document_.dropped, "normals that point against the order of the corners", against_,
               source_.text ? fmt::format("line {}", line_of(first_against_))
                            : fmt::format("byte {}", first_against_));
    if (ends_in_two_words_ > 0)
      warn(fmt::format("line {}: `end` and its keyword are two words (the first of {} such)",
                       line_of(first_end_in_two_words_), ends_in_two_words_));
    source_.document = std::move(document_);
    source_.welded = true;
    return std::move(source_);
  }

  std::int64_t line_of(std::size_t place) const { return Scanner(file_.path(), text_, place).line(); }

  void warn(const std::string& what) {
    document_.warnings.push_back(fmt::format("{}: {}", file_.path(), what));
  }

  const InputFile& file_;
  const bool surface_;
  Document document_;
  ReadDocument source_;
  std::vector<Eigen::Vector3d> points_;  // three of each facet
  std::vector<Solid> solids_;
  std::string_view text_;         // of a text file
  std::size_t behind_solid_ = 0;  // in the text: where the first word behind the last `endsolid` begins
  std::size_t against_ = 0, first_against_ = 0;
  std::size_t ends_in_two_words_ = 0, first_end_in_two_words_ = 0;
};

}  // namespace

ReadDocument read_stl(const InputFile& file, Wanted wanted) {
  return Reader(file, wanted).read();
}

}  // namespace tetproof::io
