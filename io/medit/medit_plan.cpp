// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/medit/medit_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <unordered_set>

#include "io/error.hpp"
#include "io/medit/medit.hpp"
#include "io/medit/medit_solution.hpp"
#include "io/mesh_files.hpp"
#include "io/model/block_of.hpp"
#include "io/model/element_types.hpp"
#include "io/model/node_tags.hpp"
#include "io/model/values.hpp"

namespace tetproof::io {
namespace {

// Whether the text reader reads `body` back as it is.
bool is_plain_body(const std::string& body) {
  constexpr const char* blanks = " \t\r\n\v\f";
  if (body.find('\0') != std::string::npos) return false;
  if (!body.empty() && (body.find_first_of(blanks) == 0 || body.find_last_of(blanks) + 1 == body.size()))
    return false;
  for (std::size_t line = body.find_first_of("\n\r"); line != std::string::npos;
       line = body.find_first_of("\n\r", line + 1)) {
    const std::size_t next = body.find_first_not_of(" \t", line + 1);
    if (next != std::string::npos && is_medit_letter(body[next])) return false;
  }
  return true;
}

// Whether the reader takes a keyword called `name` for a section, and for nothing else.
bool is_plain_name(const std::string& name) {
  return looks_like_medit_keyword(name) && name != "End" && name != "MeshVersionFormatted" &&
         name != "Dimension" && name != "Vertices" && !name.ends_with("Ordering") && !medit_mark(name);
}

// Whether no values of nodes or elements before these have the same name. Of several with one name, only the
// first are written.
bool are_first_of_name(const Document& document, const Values& values, Of of) {
  const std::vector<Values>& all = of == Of::node ? document.node_values : document.element_values;
  return &values == &*std::find_if(all.begin(), all.end(),
                                   [&](const Values& other) { return other.name == values.name; });
}

// The reader drops references that are all 0.
bool references_come_back(const Values& values, bool binary) {
  if (values.reals.empty())
    return std::any_of(values.integers.begin(), values.integers.end(), [](std::int64_t r) { return r != 0; });
  if (values.name != "references")
    return std::any_of(values.reals.begin(), values.reals.end(), [](double r) { return r != 0; });
  return !binary && are_real_medit_references(values);
}

bool are_all_ones(const Values& values) {
  return values.integers.size() == values.at.size() &&
         std::all_of(values.integers.begin(), values.integers.end(), [](std::int64_t i) { return i == 1; });
}

bool mark_comes_back(const Document& document, bool numbers_stay, const Values& values, bool of_nodes,
                     bool binary) {
  const std::vector<Index> marked = medit_marked(document, values, of_nodes, binary);
  if (marked.empty() || (!values.at.empty() && !are_all_ones(values))) return false;
  if (!numbers_stay && std::any_of(marked.begin(), marked.end(), [](Index at) { return at < 0; }))
    return false;
  if (of_nodes) return true;
  // All marked elements must be of the type that the keyword is for; numbers that none of these has stay
  // such.
  const int type = medit_mark(values.name)->element;
  const auto is_of_type = [type](const ElementBlock& block) {
    const MeditKeyword* keyword = medit_place(block).keyword;
    return keyword && keyword->element == type;
  };
  std::int64_t count = 0;
  for (const ElementBlock& block : document.blocks)
    if (is_of_type(block)) count += static_cast<std::int64_t>(block.count);
  return std::all_of(marked.begin(), marked.end(), [&](Index at) {
    if (at >= 0)
      return static_cast<std::size_t>(at) < document.elements() &&
             is_of_type(block_of(document.blocks, static_cast<std::size_t>(at)));
    const std::int64_t number = document.named(at);
    return number < 1 || number > count;
  });
}

// The place of an element's keyword among all such.
std::size_t list_of(const MeditKeyword& keyword) {
  const auto& all = medit_elements();
  return static_cast<std::size_t>(std::find(all.begin(), all.end(), &keyword) - all.begin());
}

bool do_numbers_stay(const Document& document) {
  return document.node_tags.empty() && document.first_node == 1;
}

// Tools have other words for references. Reals that are no integers are references only under Medit's own.
const Values* references_of(const Document& document) {
  for (const Values& values : document.node_values)
    if (values.name == "references" && values.components == 1 && values.at.empty() && values.first == 0 &&
        values.size() == document.points.size())
      return &values;
  return node_tags(document, "references");
}

bool are_of_all_nodes(const Document& document, const Values& values) {
  if (values.at.empty()) return of_all(values, document.points.size());
  for (std::size_t i = 0; i < values.at.size(); ++i)
    if (values.at[i] != static_cast<Index>(i)) return false;
  return values.at.size() == document.points.size();
}

// Whether values belong to all elements of a list, each once, in its order.
bool are_of_list(const Values& values, const std::vector<const ElementBlock*>& blocks) {
  std::size_t count = 0;
  for (const ElementBlock* block : blocks) count += block->count;
  if (count != values.items()) return false;
  std::size_t k = 0;
  for (const ElementBlock* block : blocks)
    for (std::size_t e = block->first; e < block->first + block->count; ++e, ++k)
      if (static_cast<Index>(e) != (values.at.empty() ? static_cast<Index>(values.first + k) : values.at[k]))
        return false;
  return true;
}

// Adds values of elements where they fit. A .sol without values of vertices is not what MMG expects, and
// meshio refuses a mesh with such keywords: so only a Medit file gets them again.
void plan_element_fields(const Document& document, MeditPlan& plan) {
  if (plan.fields.empty() && document.format != "medit") return;
  if (!plan.numbers_stay && !document.unknown.empty()) return;  // elements may be left out
  for (const Values& values : document.element_values) {
    const int field = medit_field_of(values, values.items());
    const std::int64_t first =
        values.at.empty() ? static_cast<std::int64_t>(values.first) : std::int64_t{values.at[0]};
    if (field == 0 || first < 0 || first >= static_cast<std::int64_t>(document.elements())) continue;
    const MeditPlace place = medit_place(block_of(document.blocks, static_cast<std::size_t>(first)));
    const MeditSolutionKeyword* keyword =
        place.keyword ? medit_solution_keyword_of(place.keyword->element) : nullptr;
    if (!keyword || !are_of_list(values, plan.lists[list_of(*place.keyword)])) continue;
    auto& all = plan.element_fields;
    auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.keyword == keyword; });
    if (found == all.end()) found = all.insert(all.end(), {keyword, {}, values.items()});
    found->fields.emplace_back(&values, field);
  }
}

// The name under which values of elements come back. Empty: they do not.
std::string name_in_file(const std::vector<MeditSolutionPart>& all, const Values& values) {
  for (const MeditSolutionPart& one : all)
    for (std::size_t k = 0; k < one.fields.size(); ++k)
      if (one.fields[k].first == &values) return medit_field_name(k);
  return {};
}

}  // namespace

MeditPlace medit_place(const ElementBlock& block) {
  const ElementType* type = element_type(block.type);
  if (!type || type->nodes != block.nodes_each) return {};
  for (const MeditKeyword* keyword : medit_elements())
    if (keyword->element == block.type) return {keyword, block.nodes_each};
  for (const MeditKeyword* keyword : medit_elements())  // the linear one of the same shape
    if (const ElementType* linear = element_type(keyword->element);
        linear->shape == type->shape && linear->nodes == linear->corners)
      return {keyword, linear->nodes};
  return {};
}

std::int64_t medit_reference_of(const MeditPlan& plan, std::size_t node) {
  if (!plan.references) return 0;
  if (plan.references->reals.empty()) return plan.references->integers[node];
  return plan.references->name == "references" ? 0 : static_cast<std::int64_t>(plan.references->reals[node]);
}

std::int64_t medit_reference(const Document& document, const ElementBlock& block) {
  const auto& set = document.tag_sets[static_cast<std::size_t>(block.groups)];
  return set.empty() ? 0 : set[0];
}

std::vector<Index> medit_marked(const Document& document, const Values& values, bool of_nodes, bool binary) {
  const MeditMark* mark = medit_mark(values.name);
  if (!mark || (binary && medit_keyword(values.name)->code == no_medit_code) ||
      (mark->element == 0) != of_nodes || values.components != 1)
    return {};
  if (!values.at.empty()) return values.at;
  if (values.integers.empty() || !of_all(values, of_nodes ? document.points.size() : document.elements()))
    return {};
  std::vector<Index> marked;
  for (std::size_t i = 0; i < values.integers.size(); ++i) {
    if (values.integers[i] != 0 && values.integers[i] != 1) return {};
    if (values.integers[i] == 1) marked.push_back(static_cast<Index>(i));
  }
  return marked;
}

bool writes_medit_section(const Section& section, bool binary) {
  if (section.format != "medit" || section.binary || !is_plain_name(section.name)) return false;
  const MeditKeyword* keyword = medit_keyword(section.name);
  if (keyword && keyword->element != 0) return false;
  return binary ? keyword && medit_lines(*keyword, section.body, 3) : is_plain_body(section.body);
}

bool are_real_medit_references(const Values& values) {
  const auto is_read = [](double r) { return std::abs(r) < largest_medit_real_reference; };
  return std::all_of(values.reals.begin(), values.reals.end(), is_read) &&
         std::any_of(values.reals.begin(), values.reals.end(), [](double r) { return r != std::floor(r); });
}

MeditPlan medit_plan(const Document& document) {
  MeditPlan plan;
  plan.numbers_stay = do_numbers_stay(document);
  plan.references = references_of(document);
  for (const Values& values : document.node_values)
    if (&values != plan.references && are_of_all_nodes(document, values))
      if (const int field = medit_field_of(values, document.points.size()); field != 0)
        plan.fields.emplace_back(&values, field);
  for (const ElementBlock& block : document.blocks) {
    const MeditPlace place = medit_place(block);
    if (!place.keyword) continue;
    const std::size_t k = list_of(*place.keyword);
    if (plan.lists[k].empty()) plan.order.push_back(k);
    plan.lists[k].push_back(&block);
  }
  plan_element_fields(document, plan);
  return plan;
}

Holds medit_holds(const Document& document, const MeditPlan& plan, bool binary) {
  Holds holds;
  holds.unknown_nodes = plan.numbers_stay;
  holds.groups = Holds::Groups::first;
  const auto is_none = [&document](const ElementBlock& block) {  // a group that is written as none
    const auto& set = document.tag_sets[static_cast<std::size_t>(block.groups)];
    return !set.empty() && set[0] == 0;
  };
  if (std::any_of(document.blocks.begin(), document.blocks.end(), is_none))
    holds.groups_of = [&document, is_none](const ElementBlock& block) {
      return document.tag_sets[static_cast<std::size_t>(block.groups)].size() < 2 && !is_none(block);
    };
  holds.nodes_each = [](const ElementBlock& block) { return medit_place(block).nodes; };
  holds.kind = [order = plan.order](const ElementBlock& block) {
    const auto& all = medit_elements();
    const auto at = std::find(all.begin(), all.end(), medit_place(block).keyword) - all.begin();
    return static_cast<int>(std::find(order.begin(), order.end(), static_cast<std::size_t>(at)) -
                            order.begin());
  };
  const auto field = [fields = plan.fields](const Values& values) {
    return std::find_if(fields.begin(), fields.end(), [&](const auto& one) { return one.first == &values; }) -
           fields.begin();
  };
  const auto count = static_cast<std::ptrdiff_t>(plan.fields.size());
  const auto named = [field, count, of_elements = plan.element_fields](const Values& values, Of of) {
    return of == Of::element ? name_in_file(of_elements, values)
           : of == Of::node && field(values) != count
               ? medit_field_name(static_cast<std::size_t>(field(values)))
               : "";
  };
  holds.numbers = [&document, binary, named, stay = plan.numbers_stay, references = plan.references](
                      const Values& values, Of of) -> std::optional<HeldNumbers> {
    if (const std::string name = named(values, of); !name.empty()) return HeldNumbers{.name = name};
    if (of == Of::node && references == &values && (values.reals.empty() || values.name != "references") &&
        references_come_back(values, binary))
      return HeldNumbers{.name = "references"};
    if (of != Of::element_node && values.at.empty() && are_first_of_name(document, values, of) &&
        mark_comes_back(document, stay, values, of == Of::node, binary))
      return HeldNumbers{.name = values.name};
    return {};
  };
  holds.values = [&document, binary, named, stay = plan.numbers_stay, references = plan.references](
                     const Values& values, Of of) {
    if (const std::string name = named(values, of); !name.empty()) return values.name == name;
    if (of == Of::element_node || !values.labels.empty() || !values.nodes.empty() || has_step(values))
      return false;
    if (!are_first_of_name(document, values, of)) return false;
    if (of == Of::node && references == &values)
      return values.name == "references" && references_come_back(values, binary);
    return !values.at.empty() && mark_comes_back(document, stay, values, of == Of::node, binary);
  };
  std::unordered_set<const Section*> written;  // of several with one name, the first
  std::unordered_set<std::string_view> names;
  for (const Section& section : document.sections)
    if (writes_medit_section(section, binary) && names.insert(section.name).second) written.insert(&section);
  holds.section = [binary, written](const Section& section) {
    if (written.count(&section) == 0 || section.swapped || section.before_nodes) return false;
    if (!binary) return true;
    const MeditKeyword& keyword = *medit_keyword(section.name);
    return medit_body(keyword, *medit_lines(keyword, section.body, 3), 3) == section.body;
  };
  return holds;
}

namespace {

class MeditFilePlan : public FilePlan {
 public:
  MeditFilePlan(const Document& document, bool binary)
      : FilePlan(document), plan_(medit_plan(document)), binary_(binary) {
    holds_ = medit_holds(document, plan_, binary);
  }

  std::vector<std::string> files(const std::string& path) override {
    if (plan_.fields.empty()) return {path};
    return {path, solution_of(path)};
  }
  std::string warning(const std::string& path) override {
    if (plan_.fields.empty()) {
      const std::vector<std::string> read = medit_files_read(path);
      return read.size() < 2 || is_medit_solution(path)
                 ? ""
                 : fmt::format("{}: is there already and is not written, but will be read together with it",
                               read[1]);
    }
    std::vector<std::string> names;
    for (const auto& [values, field] : plan_.fields) names.push_back(fmt::format("\"{}\"", values->name));
    std::error_code none;
    return fmt::format("{}: is {} too, with the values {}; MMG takes one field for the sizes it shall make",
                       solution_of(path),
                       std::filesystem::exists(solution_of(path), none) ? "replaced" : "written",
                       fmt::join(names, ", "));
  }
  void write(const std::string& path, const std::string&) override {
    if (is_medit_solution(path))
      throw InputError(fmt::format("{}: this ending is that of a solution; name the mesh", path));
    AtomicFile file(path);
    write_medit(file, document_, plan_, binary_);
    if (plan_.fields.empty()) return file.commit();
    AtomicFile solution(solution_of(path));
    std::vector<MeditSolutionPart> parts{
        {medit_solution_keyword(medit_sol_at_vertices), plan_.fields, document_.points.size()}};
    parts.insert(parts.end(), plan_.element_fields.begin(), plan_.element_fields.end());
    write_medit_solution(solution, parts, binary_);
    solution
        .commit();  // first: a mesh never stands beside the solution of another one that it was written over
    file.commit();
  }

 private:
  std::string solution_of(const std::string& path) const {
    return path.substr(0, path.size() - ending_of(path).size()) + (binary_ ? ".solb" : ".sol");
  }

  const MeditPlan plan_;
  const bool binary_;
};

}  // namespace

std::unique_ptr<FilePlan> plan_medit(const Document& document, bool binary) {
  return std::make_unique<MeditFilePlan>(document, binary);
}

}  // namespace tetproof::io
