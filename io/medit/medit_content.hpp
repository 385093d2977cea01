// SPDX-License-Identifier: GPL-3.0-or-later
// The content of a Medit file, text or binary: numbers by keyword. They become a document when all have been
// read.
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
#include "io/medit/medit_solution.hpp"
#include "io/model/tag_sets.hpp"

namespace tetproof::io {

enum class MeditPart { mesh, solution };

/// Collects keywords in the file's order. One may refer to another that comes later, so the document is made
/// at the end.
class MeditContent {
 public:
  explicit MeditContent(const std::string& path);

  struct Elements {
    const MeditKeyword* keyword = nullptr;
    std::vector<std::int64_t> numbers{};  ///< the nodes and then the reference of each element
  };

  bool has_vertices() const { return has_vertices_; }
  /// Must be called once, before the vertices are added.
  void start_vertices(std::size_t count);
  void add_vertex(const Eigen::Vector3d& point, double reference);
  void add_vertex(const Eigen::Vector3d& point, std::int64_t reference);
  void add_elements(Elements list) { elements_.push_back(std::move(list)); }
  void add_solution(MeditSolution solution) { solutions_.push_back(std::move(solution)); }
  /// Adds the solutions of another file, and what was said and dropped there.
  void take_solutions(MeditContent other);
  bool has_solutions() const { return !solutions_.empty(); }
  /// Adds any other keyword (null: unknown form) and what follows it, as text. Points have `dimension`
  /// coordinates.
  void add_section(const MeditKeyword* keyword, std::string_view name, std::string body, int dimension);
  /// Adds a warning: the path, and `text` behind it.
  void warn(std::string_view text);
  /// Adds a warning about another file.
  void warn_of(const std::string& path, std::string_view text);
  /// Lists something that the reader drops.
  void drop(const std::string& item, std::size_t count, const std::string& example, bool elements = false);

  Document finish();

 private:
  void make_elements(const Elements& list, TagSets& sets);
  void make_references();
  void make_mark(const MeditMark& mark, const std::vector<std::int64_t>& numbers);
  void make_solution(const MeditSolution& solution);
  bool take_order(std::string_view name, const std::vector<std::int64_t>& lattice);
  Index node(std::int64_t number);
  Index element(std::int64_t number, int type);
  Index unknown(std::int64_t number);

  /// Consecutive elements of one type.
  struct Run {
    int type;
    std::size_t first, count;
  };

  Document document_;
  bool has_vertices_ = false;
  std::vector<double> references_;
  // References that a double does not hold, with their vertices.
  std::vector<std::pair<std::size_t, std::int64_t>> large_references_;
  std::vector<Elements> elements_;
  std::vector<MeditSolution> solutions_;
  std::vector<std::pair<const MeditMark*, std::vector<std::int64_t>>> marks_;
  std::unordered_map<int, std::vector<int>> orders_;  // of nodes, by type, where the file says one
  std::vector<std::string> orderings_;                // the keywords that said them
  std::vector<Run> runs_;
  std::unordered_map<std::int64_t, Index> unknown_;
};

/// Read a mesh, or only the solutions of a file that has no vertices.
void read_medit_text(const InputFile& file, MeditContent& content, MeditPart part);
void read_medit_binary(const InputFile& file, std::endian order, MeditContent& content, MeditPart part);

}  // namespace tetproof::io
