// SPDX-License-Identifier: GPL-3.0-or-later
#include "documents_compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <tuple>

#include "document_texts.hpp"
#include "documents_pairing.hpp"
#include "entities_compare.hpp"
#include "io/model/element_types.hpp"
#include "remnants.hpp"

namespace tetproof::test {
namespace {

std::string kind_of(const Element& element) {
  static const std::map<io::Shape, const char*> names{
      {io::Shape::point, "points"},           {io::Shape::line, "lines"},
      {io::Shape::triangle, "triangles"},     {io::Shape::quadrangle, "quadrangles"},
      {io::Shape::tetrahedron, "tetrahedra"}, {io::Shape::hexahedron, "hexahedra"},
      {io::Shape::prism, "prisms"},           {io::Shape::pyramid, "pyramids"}};
  const io::ElementType* type = io::element_type(element.type);
  const auto found = type ? names.find(type->shape) : names.end();
  const char* name = element.type == io::polygon      ? "polygons"
                     : element.type == io::polyhedron ? "polyhedra"
                     : found == names.end()           ? "elements"
                                                      : found->second;
  return fmt::format("{} of {} node{} (type {})", name, element.nodes.size(),
                     element.nodes.size() == 1 ? "" : "s", element.type);
}

bool same_bits(double a, double b) {
  return bits(a) == bits(b);
}

// 0, 1, 2, ... or 1, 2, 3, ...
bool counts_up(const std::vector<std::int64_t>& tags) {
  for (std::size_t i = 0; i < tags.size(); ++i)
    if (tags[i] != tags[0] + static_cast<std::int64_t>(i)) return false;
  return tags.empty() || tags[0] == 0 || tags[0] == 1;
}

// The numbers behind question marks.
std::set<std::int64_t> unknown_in(const std::string& text) {
  std::set<std::int64_t> numbers;
  for (std::size_t i = 0; i + 1 < text.size(); ++i)
    if (text[i] == '?' && text[i + 1] >= '0' && text[i + 1] <= '9')
      numbers.insert(std::strtoll(text.c_str() + i + 1, nullptr, 10));
  return numbers;
}

// Lines in which "?17" is "?", sorted.
std::string without_unknown(const std::string& text) {
  std::vector<std::string> lines(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    lines.back() += text[i];
    if (text[i] == '\n') lines.emplace_back();
    if (text[i] == '?')
      while (i + 1 < text.size() && text[i + 1] >= '0' && text[i + 1] <= '9') ++i;
  }
  std::sort(lines.begin() + 1, lines.end());
  return fmt::format("{}", fmt::join(lines, "\n"));
}

class Comparison {
 public:
  Comparison(const Document& before, const Document& after, Holding holding)
      : before_(before),
        after_(after),
        old_(elements_of(before)),
        new_(elements_of(after)),
        pairs_(pair_up(before, old_, after, new_, holding)) {}

  std::vector<Difference> list() {
    nodes();
    elements();
    order_and_numbers();
    for (std::size_t e = 0; e < new_.size(); ++e)
      if (pairs_.element_before[e] != none) element(old_[at(pairs_.element_before[e])], new_[e]);
    for (std::size_t e = 0; e < old_.size(); ++e)
      if (pairs_.cut_after[e] != none) triangles(e);
    for (const Difference& d : differences_of_entities(before_, after_, pairs_))
      add(d.item, d.count, d.example, d.unsure);
    parts();
    return std::move(differences_);
  }

 private:
  // One of the things of which `subject` is the name.
  void add_one(const std::string& item, const std::string& subject, const std::string& more = "") {
    add(item, 1, subject + more, false, subject);
  }

  static std::size_t at(Index i) { return static_cast<std::size_t>(i); }

  // `subject`: of what it is true; empty: of the whole document.
  void add(const std::string& item, std::int64_t count, const std::string& example, bool unsure = false,
           const std::string& subject = "") {
    for (Difference& d : differences_)
      if (d.item == item) {
        d.count += count;
        d.unsure = d.unsure && unsure;
        if (!subject.empty()) d.subjects.push_back(subject);
        return;
      }
    differences_.push_back({item, count, example, {}, unsure});
    if (!subject.empty()) differences_.back().subjects.push_back(subject);
  }

  void nodes() {
    for (std::size_t i = 0; i < before_.points.size(); ++i) {
      const Index after = pairs_.node_after[i];
      if (after == none) {
        add_one("nodes of no element that is written", fmt::format("node {}", before_.node_tag(i)));
        continue;
      }
      for (int k = 0; k < 3; ++k) {
        const double a = before_.points[i][k], b = after_.points[at(after)][k];
        if (same_bits(a, b)) continue;
        const bool rounded = same_bits(static_cast<double>(static_cast<float>(a)), b);
        add_one(rounded ? "coordinates rounded to 32 bits" : "changed coordinates",
                fmt::format("{} becomes {}", a, b));
      }
    }
    for (std::size_t i = 0; i < after_.points.size(); ++i)
      if (pairs_.node_before[i] == none) add("gained nodes", 1, fmt::format("node {}", after_.node_tag(i)));
  }

  void elements() {
    // Where elements of a kind came back, those that did not are missing for another reason.
    std::set<std::tuple<int, std::size_t, bool>> kinds;
    const auto kind = [](const Element& e) { return std::tuple(e.type, e.nodes.size(), e.of_boundary); };
    for (std::size_t e = 0; e < old_.size(); ++e)
      if (pairs_.element_after[e] != none) kinds.insert(kind(old_[e]));
    for (std::size_t e = 0; e < old_.size(); ++e) {
      const std::string example = fmt::format("element {}", old_[e].tag);
      const Index after = pairs_.element_after[e];
      if (pairs_.cut_after[e] != none)
        add_one(kind_of(old_[e]) + " cut into triangles", example);
      else if (after == none)
        add_one(old_[e].names_unknown() && kinds.count(kind(old_[e]))
                    ? "elements that name nodes which do not exist"
                    : kind_of(old_[e]),
                example);
      else if (new_[at(after)].nodes.size() < old_[e].nodes.size())
        add_one(fmt::format("nodes between the corners of {}", kind_of(old_[e])), example);
    }
    for (std::size_t e = 0; e < new_.size(); ++e)
      if (pairs_.element_before[e] == none && pairs_.cut_before[e] == none)
        add("gained elements", 1, fmt::format("element {}", new_[e].tag));
  }

  void order_and_numbers() {
    std::vector<std::int64_t> was, is;
    Index last = -1;
    bool in_order = true;
    for (std::size_t e = 0; e < new_.size(); ++e) {
      const Index b = pairs_.element_before[e];
      if (b == none) continue;
      in_order = in_order && b > last;
      last = b;
      was.push_back(old_[at(b)].tag), is.push_back(new_[e].tag);
    }
    if (!in_order) add("order of elements", 1, "");
    if (was != is && !(counts_up(was) && counts_up(is)))
      add("numbers of elements", static_cast<std::int64_t>(was.size()),
          fmt::format("the first was {}", was[0]), false, fmt::format("the first is {}", was[0]));
    was.clear(), is.clear();
    in_order = true, last = -1;
    for (std::size_t i = 0; i < after_.points.size(); ++i) {
      const Index b = pairs_.node_before[i];
      if (b == none) continue;
      in_order = in_order && b > last;
      last = b;
      was.push_back(before_.node_tag(at(b))), is.push_back(after_.node_tag(i));
    }
    if (was != is && !(counts_up(was) && counts_up(is)))
      add("numbers of nodes", static_cast<std::int64_t>(was.size()), fmt::format("the first was {}", was[0]),
          false, fmt::format("the first is {}", was[0]));
    if (!in_order) add("order of nodes", 1, "");
  }

  void element(const Element& was, const Element& is) {
    const std::string example = fmt::format("element {}", was.tag);
    if (was.groups != is.groups) {
      if (is.groups.empty())
        add_one("physical groups of elements", example);
      else if (is.groups.size() == 1 && !was.groups.empty() && is.groups[0] == was.groups[0])
        add_one("physical groups beyond an element's first", example);
      else
        add("changed physical groups", 1, example);
    }
    if (was.partitions != is.partitions)
      add_one(is.partitions.empty() ? "partitions of elements" : "changed partitions", example);
    if (was.of_boundary != is.of_boundary)
      add_one(was.of_boundary ? "elements as polygons of the boundary to mesh"
                              : "elements as faces of a mesh, not polygons of a boundary to mesh",
              example);
    for (std::size_t k = 0; k < is.nodes.size(); ++k) {
      if (is.nodes[k] >= 0) continue;
      const std::int64_t a = before_.named(was.nodes[k]), b = after_.named(is.nodes[k]);
      if (a != b && renumbered_unknown_.insert(a).second)
        add("numbers of nodes that do not exist", 1, fmt::format("{} became {}", a, b), false,
            fmt::format("{} becomes {}", a, b));
    }
  }

  // All triangles of a polygon say the same.
  void triangles(std::size_t polygon) {
    const Element& first = new_[at(pairs_.cut_after[polygon])];
    Element alike = first;
    alike.nodes.clear();
    element(old_[polygon], alike);
    for (std::size_t e = 0; e < new_.size(); ++e)
      if (pairs_.cut_before[e] == static_cast<Index>(polygon) &&
          (new_[e].groups != first.groups || new_[e].partitions != first.partitions ||
           new_[e].entity != first.entity || new_[e].of_boundary != first.of_boundary))
        add("triangles of a polygon that differ", 1, fmt::format("element {}", new_[e].tag));
  }

  // What is a list of texts in both: what has no equal was lost, or gained.
  // Of what was lost something less may have come back.
  void lists(std::vector<Text> was, std::vector<Text> is) {
    std::erase_if(was, [&](const Text& text) {
      const auto found =
          std::find_if(is.begin(), is.end(), [&](const Text& t) { return t.text == text.text; });
      if (found == is.end()) return false;
      if (text.gone) add(text.item, text.count, text.text, true, text.subject);
      is.erase(found);
      return true;
    });
    std::erase_if(was, [&](const Text& text) {
      const auto found = std::find_if(is.begin(), is.end(), [&](const Text& t) {
        return t.item == text.item && without_unknown(t.text) == without_unknown(text.text);
      });
      if (found == is.end()) return false;
      const std::set<std::int64_t> still = unknown_in(found->text);
      for (const std::int64_t number : unknown_in(text.text))
        if (still.count(number) == 0 && renumbered_unknown_.insert(number).second)
          add("numbers of nodes that do not exist", 1, text.text);
      is.erase(found);
      return true;
    });
    std::erase_if(was, [&](const Text& text) {
      const auto found =
          std::find_if(is.begin(), is.end(), [&](const Text& t) { return gaps(text, t).has_value(); });
      if (found == is.end()) return false;
      const std::string whose = text.item.substr(text.item.rfind('"') + 2);
      if (text.name != found->name)
        add_one("names of values " + whose, fmt::format("\"{}\" becomes \"{}\"", text.name, found->name));
      if (text.labels != found->labels)
        add_one("labels of values " + whose, fmt::format("labels of \"{}\"", text.name));
      if (text.step != found->step)
        add_one("times and steps of values " + whose, fmt::format("\"{}\" of time", text.name));
      if (const std::size_t count = gaps(text, *found)->size(); count > 0)
        add("gaps in values " + whose, static_cast<std::int64_t>(count), text.text, false,
            fmt::format("has no \"{}\"", text.name));
      is.erase(found);
      return true;
    });
    for (const Text& text : was) {
      add(text.item, text.count, text.text, text.gone, text.subject);
      for (auto t = is.begin(); t != is.end();) {
        if (!is_remnant(text, *t)) {
          ++t;
          continue;
        }
        t = is.erase(t);
        if (!comes_in_pieces(text)) break;
      }
    }
    for (const Text& text : is) add(fmt::format("gained {}", text.item), text.count, text.text);
  }

  void parts() {
    // A file may go on naming what it lost by its number, which nothing has now.
    std::set<std::int64_t> lost_nodes, lost_elements;
    for (std::size_t i = 0; i < before_.points.size(); ++i)
      if (pairs_.node_after[i] == none) lost_nodes.insert(before_.node_tag(i));
    // By the one that it had, or by its place; where nothing came back that tells which, by either.
    bool renumbered = false, same = false;
    for (std::size_t e = 0; e < new_.size(); ++e)
      if (const Index was = pairs_.element_before[e]; was != none)
        (old_[at(was)].tag == new_[e].tag ? same : renumbered) = true;
    for (std::size_t e = 0; e < old_.size(); ++e)
      if (pairs_.element_after[e] == none) {
        if (!renumbered) lost_elements.insert(old_[e].tag);
        if (!same || renumbered) lost_elements.insert(static_cast<std::int64_t>(e + 1));
      }
    const auto name_in = [](const Document& document, const std::vector<Index>* to_before,
                            const std::vector<Index>* to_after, const std::set<std::int64_t>* lost) {
      return [&document, to_before, to_after, lost](Index i) -> std::string {
        if (i < 0 && lost && lost->count(document.unknown.at(at(-1 - i))) > 0) return {};
        if (i < 0) return fmt::format("?{}", document.unknown.at(at(-1 - i)));
        if (to_before) return fmt::format("{}", to_before->at(at(i)));
        return to_after->at(at(i)) == none ? std::string{} : fmt::format("{}", i);
      };
    };
    // What triangles have belongs to the polygon that they were.
    std::vector<Index> elements_after = pairs_.element_after, elements_before = pairs_.element_before;
    for (std::size_t e = 0; e < old_.size(); ++e)
      if (pairs_.cut_after[e] != none) elements_after[e] = pairs_.cut_after[e];
    for (std::size_t e = 0; e < new_.size(); ++e)
      if (pairs_.cut_before[e] != none) elements_before[e] = pairs_.cut_before[e];
    const Names node_was = name_in(before_, nullptr, &pairs_.node_after, nullptr),
                node_is = name_in(after_, &pairs_.node_before, nullptr, &lost_nodes),
                element_was = name_in(before_, nullptr, &elements_after, nullptr),
                element_is = name_in(after_, &elements_before, nullptr, &lost_elements);
    lists(texts_of_values(before_.node_values, "nodes", node_was),
          texts_of_values(after_.node_values, "nodes", node_is));
    lists(texts_of_values(before_.element_values, "elements", element_was),
          texts_of_values(after_.element_values, "elements", element_is));
    lists(texts_of_values(before_.element_node_values, "elements' nodes", element_was),
          texts_of_values(after_.element_node_values, "elements' nodes", element_is));
    lists(texts_of_names(before_), texts_of_names(after_));
    lists(texts_of_links(before_, node_was), texts_of_links(after_, node_is));
    lists(texts_of_ghosts(before_, element_was), texts_of_ghosts(after_, element_is));
    lists(texts_of_boundary(before_, node_was, element_was), texts_of_boundary(after_, node_is, element_is));
    lists(texts_of_voronoi(before_), texts_of_voronoi(after_));
    lists(texts_of_rest(before_), texts_of_rest(after_));
  }

  const Document &before_, &after_;
  const std::vector<Element> old_, new_;
  const Pairing pairs_;
  std::set<std::int64_t> renumbered_unknown_;
  std::vector<Difference> differences_;
};

}  // namespace

std::vector<Difference> differences(const Document& before, const Document& after, Holding holding) {
  return Comparison(before, after, holding).list();
}

}  // namespace tetproof::test
