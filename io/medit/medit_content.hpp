// SPDX-License-Identifier: GPL-3.0-or-later
// What both forms of Medit's files come to: numbers by keyword, put together when all have been read.
#pragma once

#include <bit>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/medit/medit_keywords.hpp"
#include "io/model/tag_sets.hpp"

namespace tetproof::io {

Document read_medit_text(const InputFile& file);
Document read_medit_binary(const InputFile& file, std::endian order);

/// Collects what a file says, in the file's order, which need not be that in which one needs the other.
class MeditContent {
 public:
  explicit MeditContent(const std::string& path);

  struct Elements {
    const MeditKeyword* keyword = nullptr;
    std::vector<std::int64_t> numbers{};  ///< nodes and reference of each
  };

  bool has_vertices() const { return has_vertices_; }
  /// To be called once, in front of the vertices.
  void start_vertices(std::size_t count);
  void add_vertex(const Eigen::Vector3d& point, double reference);
  void add_vertex(const Eigen::Vector3d& point, std::int64_t reference);
  void add_elements(Elements list) { elements_.push_back(std::move(list)); }
  /// Any other keyword (null: one of no known form) and what follows it, as text of `dimension` coordinates.
  void add_section(const MeditKeyword* keyword, std::string_view name, std::string body, int dimension);
  /// Adds a warning; `text` goes on behind the path.
  void warn(std::string_view text);

  Document finish();

 private:
  void make_elements(const Elements& list, TagSets& sets);
  void make_references();
  void make_mark(const MeditMark& mark, const std::vector<std::int64_t>& numbers);
  bool take_order(std::string_view name, const std::vector<std::int64_t>& lattice);
  Index node(std::int64_t number);
  Index element(std::int64_t number, int type);
  Index unknown(std::int64_t number);

  /// Elements of one type, one after the other.
  struct Run {
    int type;
    std::size_t first, count;
  };

  Document document_;
  bool has_vertices_ = false;
  std::vector<double> references_;
  std::vector<std::pair<std::size_t, std::int64_t>> large_references_;  // those that are no doubles
  std::vector<Elements> elements_;
  std::vector<std::pair<const MeditMark*, std::vector<std::int64_t>>> marks_;
  std::unordered_map<int, std::vector<int>> orders_;  // of nodes, by type, where the file tells one
  std::vector<Run> runs_;
  std::unordered_map<std::int64_t, Index> unknown_;
};

}  // namespace tetproof::io
