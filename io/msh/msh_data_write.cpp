// SPDX-License-Identifier: GPL-3.0-or-later
// Writes $Periodic, $GhostElements, $NodeData, $ElementData and $ElementNodeData.
#include <algorithm>

#include "io/msh/msh_write.hpp"

namespace tetproof::io {
namespace {

template <bool Binary>
class Writer {
 public:
  Writer(AtomicFile& file, const MshTags& tags) : file_(file), tags_(tags), document_(*tags.document) {}

  void periodic(bool affine_word) {
    file_.write("$Periodic\n");
    file_.write(line<Binary>(1, [&](auto& out) { out.size(document_.periodic.size()); }));
    for (const PeriodicLink& link : document_.periodic) {
      file_.write(line<Binary>(
          3, [&](auto& out) { out.integer(link.dim), out.integer(link.entity), out.integer(link.master); }));
      if (affine_word && !link.affine.empty()) file_.write("Affine ");
      if (!affine_word || !link.affine.empty())
        file_.write(line<Binary>(1 + link.affine.size(), [&](auto& out) {
          if (!affine_word) out.size(static_cast<std::int64_t>(link.affine.size()));
          for (double value : link.affine) out.real(value);
        }));
      file_.write(
          line<Binary>(1, [&](auto& out) { out.size(static_cast<std::int64_t>(link.nodes.size())); }));
      write_items(file_, link.nodes.size(), 2 * Putter<Binary>::longest, [&](std::size_t i, char* to) {
        Putter<Binary> out{to};
        for (Index node : link.nodes[i]) out.size(tags_.node(node));
        out.end_line();
        return out.to;
      });
    }
    end("Periodic");
  }

  void ghosts() {
    file_.write("$GhostElements\n");
    file_.write(line<Binary>(1, [&](auto& out) { out.size(document_.ghost_elements.size()); }));
    for (const GhostElement& ghost : document_.ghost_elements)
      file_.write(line<Binary>(3 + ghost.ghosts.size(), [&](auto& out) {
        out.size(tags_.element(ghost.element)), out.integer(ghost.partition);
        out.size(static_cast<std::int64_t>(ghost.ghosts.size()));
        for (std::int64_t partition : ghost.ghosts) out.integer(partition);
      }));
    end("GhostElements");
  }

  void values(const std::vector<Values>& all, Of of, const Holds& holds) {
    for (const Values& values : all)
      if (holds.values(values, of) || holds.as_reals(values, of)) one(values, of);
  }

 private:
  void one(const Values& values, Of of) {
    const char* name = of == Of::node ? "NodeData" : of == Of::element ? "ElementData" : "ElementNodeData";
    const auto components = static_cast<std::size_t>(values.components);
    const std::size_t rows = values.items();
    file_.write(header(name, values, rows));
    std::vector<std::size_t> start;  // where the values of each element's nodes start
    std::size_t longest = components;
    if (of == Of::element_node) {
      start.push_back(0);
      for (const std::int32_t nodes : values.nodes) {
        const std::size_t count = static_cast<std::size_t>(nodes) * components;
        longest = std::max(longest, count);
        start.push_back(start.back() + count);
      }
    }
    write_items(file_, rows, (2 + longest) * Putter<Binary>::longest, [&](std::size_t i, char* to) {
      Putter<Binary> out{to};
      const Index at = values.at.empty() ? static_cast<Index>(values.first + i) : values.at[i];
      out.integer(of == Of::node ? tags_.node(at) : tags_.element(at));
      if (of == Of::element_node) out.integer(values.nodes[i]);
      const std::size_t from = start.empty() ? i * components : start[i];
      const std::size_t behind = start.empty() ? from + components : start[i + 1];
      for (std::size_t k = from; k < behind; ++k)
        out.real(values.integers.empty() ? values.reals[k] : static_cast<double>(values.integers[k]));
      out.end_line();
      return out.to;
    });
    end(name);
  }

  // The header is text in binary files, too. Values that are not of a view have no time.
  static std::string header(const char* name, const Values& values, std::size_t rows) {
    std::string text =
        fmt::format("${}\n{}\n\"{}\"\n", name, values.interpolation.empty() ? 1 : 2, values.name);
    if (!values.interpolation.empty()) text += fmt::format("\"{}\"\n", values.interpolation);
    if (values.of_view)
      text += "1\n" + line<false>(1, [&](auto& out) { out.real(values.time); });
    else
      text += "0\n";
    text +=
        fmt::format("{}\n{}\n{}\n{}\n", values.partition != 0 ? 4 : 3, values.step, values.components, rows);
    if (values.partition != 0) text += fmt::format("{}\n", values.partition);
    return text;
  }

  void end(const char* section) { file_.write(fmt::format("{}$End{}\n", Binary ? "\n" : "", section)); }

  AtomicFile& file_;
  const MshTags& tags_;
  const Document& document_;
};

template <bool Binary>
void write(AtomicFile& file, const MshTags& tags, const Holds& holds, const std::string& format) {
  const Document& document = *tags.document;
  Writer<Binary> writer(file, tags);
  if (holds.periodic && !document.periodic.empty()) {
    if (format == "msh41")
      writer.periodic(false);
    else  // text even if the rest is binary
      Writer<false>(file, tags).periodic(true);
  }
  if (format != "msh22" && holds.ghosts && !document.ghost_elements.empty()) writer.ghosts();
  writer.values(document.node_values, Of::node, holds);
  writer.values(document.element_values, Of::element, holds);
  writer.values(document.element_node_values, Of::element_node, holds);
}

}  // namespace

void write_msh_data(AtomicFile& file, const MshTags& tags, const Holds& holds, const std::string& format,
                    bool binary) {
  binary ? write<true>(file, tags, holds, format) : write<false>(file, tags, holds, format);
}

}  // namespace tetproof::io
