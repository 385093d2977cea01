// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <algorithm>
#include <numeric>

#include "io/bytes/text_output.hpp"
#include "io/model/document_fields.hpp"
#include "io/supplement/supplement.hpp"

namespace tetproof::io {
namespace {

constexpr std::size_t longest_line = 900, longest_piece = 200;

// Writes words, separated by blanks, in lines that are not too long.
class Encoder {
 public:
  template <class... T>
  void operator()(const T&... values) {
    (put_value(values), ...);
  }
  /// Starts a field of the document that the native part lacks.
  template <class... T>
  void field(std::string_view name, const T&... values) {
    end_line();
    word(name);
    (*this)(values...);
  }
  std::string take() {
    end_line();
    return std::move(text_);
  }

 private:
  void word(std::string_view word) {
    if (text_.size() - line_ + word.size() > longest_line) end_line();
    if (text_.size() > line_) text_ += ' ';
    text_ += word;
  }
  void end_line() {
    if (text_.size() > line_) text_ += '\n';
    line_ = text_.size();
  }

  void put_value(std::integral auto value) { number(static_cast<std::int64_t>(value)); }
  void put_value(double value) { number(value); }
  void number(auto value) {
    char digits[longest_real + 1];
    word({digits, static_cast<std::size_t>(put(digits, value) - digits)});
  }
  // A text is written in pieces, each after a quotation mark.
  void put_value(const std::string& text) {
    put_value((text.size() + longest_piece - 1) / longest_piece);
    for (std::size_t at = 0; at < text.size(); at += longest_piece) {
      std::string piece(1, '"');
      for (const char c : std::string_view(text).substr(at, longest_piece))
        if (c > ' ' && c <= '~' && c != '\\' && c != '$' && c != '#')
          piece += c;
        else
          piece += fmt::format("\\{:02x}", static_cast<unsigned char>(c));
      word(piece);
    }
  }
  void put_value(const Eigen::Vector3d& p) { (*this)(p.x(), p.y(), p.z()); }
  template <class T, std::size_t N>
  void put_value(const std::array<T, N>& values) {
    for (const T& value : values) put_value(value);
  }
  template <class T>
  void put_value(const std::vector<T>& values) {
    put_value(values.size());
    for (const T& value : values) put_value(value);
  }
  template <class T>
  requires std::is_class_v<T>
  void put_value(const T& part) { fields(part, *this); }

  std::string text_;
  std::size_t line_ = 0;  // where it starts
};

void put_blocks(Encoder& out, const Document& document, const Holds& holds) {
  out.field("blocks", document.blocks.size());
  for (const ElementBlock& block : document.blocks) {
    const int written = holds.nodes_each(block);
    const bool native = written == block.nodes_each;
    out(block, holds.kind(block), written > 0, native);
    if (native) continue;
    const Index* node = document.connectivity.data() + block.nodes;
    for (std::size_t k = 0; k < block.count * block.nodes_each; ++k) out(node[k]);
  }
}

// The faces of polyhedra, block by block. Hardly a document has any, so they are a field of their own.
void put_faces(Encoder& out, const Document& document) {
  for (std::size_t b = 0; b < document.blocks.size(); ++b)
    if (!document.blocks[b].faces.empty()) out.field("faces", b, document.blocks[b].faces);
}

// The roles of values, and that they are texts, likewise.
void put_roles(Encoder& out, const Document& document) {
  const std::vector<Values>* all[] = {&document.node_values, &document.element_values,
                                      &document.element_node_values};
  for (std::size_t kind = 0; kind < std::size(all); ++kind)
    for (std::size_t k = 0; k < all[kind]->size(); ++k) {
      const Values& values = (*all[kind])[k];
      if (!values.roles.empty()) out.field("roles", kind, k, values.roles);
      if (values.texts) out.field("texts", kind, k);
    }
}

// Whether the native part has all elements in this order. If not, values in it would belong to other
// elements.
bool in_order(const Document& document, const Holds& holds) {
  int last = 0;
  for (const ElementBlock& block : document.blocks) {
    if (holds.nodes_each(block) != block.nodes_each) return false;
    const int kind = holds.kind(block);
    if (&block != &document.blocks.front() && kind < last) return false;
    last = kind;
  }
  return true;
}

void put_all_values(Encoder& out, std::string_view name, const std::vector<Values>& all, Of of,
                    bool comparable, const Holds& holds) {
  out.field(name, all.size());
  for (const Values& values : all) {
    const std::int32_t native = !comparable                  ? not_native
                                : holds.values(values, of)   ? as_they_are
                                : holds.as_reals(values, of) ? integers_as_reals
                                                             : not_native;
    out(values, native);
    if (native == not_native) out(values.reals, values.integers);
  }
}

}  // namespace

std::string supplement_of(const Document& document, const Holds& holds) {
  Encoder out;
  std::vector<std::int64_t> written(document.unknown.size());
  for (std::size_t k = 0; k < written.size(); ++k)
    written[k] = holds.unknown_number ? holds.unknown_number(k) : document.unknown[k];
  out.field("unknown", document.unknown, written);
  out.field("tag_sets", document.tag_sets);
  put_blocks(out, document, holds);
  put_faces(out, document);
  if (!holds.node_tags) out.field("node_tags", document.first_node, document.node_tags);
  if (!holds.element_tags || !in_order(document, holds))
    out.field("element_tags", document.first_element, document.element_tags);
  out.field("node_blocks", document.node_blocks, document.parameters);
  out.field("entities", document.entities);
  out.field("groups", document.group_names);
  out.field("partitions", document.partitions, document.ghosts);
  out.field("ghost_elements", document.ghost_elements);
  if (!holds.periodic) out.field("periodic", document.periodic);
  const bool same_order = in_order(document, holds);
  put_all_values(out, "node_values", document.node_values, Of::node, true, holds);
  put_all_values(out, "element_values", document.element_values, Of::element, same_order, holds);
  put_all_values(out, "element_node_values", document.element_node_values, Of::element_node, same_order,
                 holds);
  put_roles(out, document);
  out.field("facets", document.facets);
  if (!holds.holes) out.field("holes", document.holes);
  if (!holds.regions) out.field("regions", document.regions);
  if (!holds.bounds) out.field("bounds", document.area_bounds, document.length_bounds);
  if (!holds.voronoi) out.field("voronoi", document.voronoi);
  out.field("tables", document.tables);
  if (!holds.title) out.field("title", document.title);
  out.field("sections", document.sections.size());
  for (const Section& section : document.sections) {
    const bool native = holds.section(section);
    out(section, native);
    if (!native) out(section.body);
  }
  return out.take();
}

std::string supplement_head(const std::vector<Checksum>& checksums) {
  std::string head = "tetproof 1";
  for (const Checksum& checksum : checksums)
    head += fmt::format(" {} {:08x}", checksum.ending.empty() ? "this" : checksum.ending, checksum.crc32);
  return head + '\n';
}

}  // namespace tetproof::io
