// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the .msh reader. Each reads the content of one section and stops in front of its $End.
#pragma once

#include "io/bytes/large_pages.hpp"
#include "io/bytes/scanner.hpp"
#include "io/document.hpp"
#include "io/model/node_index.hpp"
#include "io/model/tag_sets.hpp"
#include "io/msh/msh_data.hpp"
#include "io/msh/numbers.hpp"

namespace tetproof::io {

/// How a line tells an element's tags. v1: two numbers. v20 (versions 2.0 and 2.1): the third tag is the
/// partition. v22: the third tag counts the partitions that follow. v3: the partitions stand behind the
/// nodes.
enum class ElementTags { v1, v20, v22, v3 };

// Sections that are text in every file.

/// What $MeshFormat says beside the version.
struct MshFormat {
  ElementTags element_tags = ElementTags::v22;
  bool binary = false,
       swapped = false;  ///< `swapped`: numbers are of the other byte order than this machine's
};
/// Sets `document.format` too.
MshFormat read_mesh_format(Scanner& in, Document& document);
/// Version 2.0 has no dimensions of names: these get `no_dimension`, and a warning.
void read_physical_names(Scanner& in, Document& document);
inline constexpr int no_dimension = -1;
/// Gives names without a dimension those of the elements in their groups: one name for each dimension. The
/// name of a group without elements gets the largest dimension of all elements.
void find_dimensions_of_names(Document& document);

/// Whether bytes that are not read may be elements: they have the name of a section, a line that begins with
/// a number, or characters that no text has.
bool may_be_elements(std::string_view bytes);

// Versions 4.0 and 4.1.
void read_entities4(Numbers& in, bool v40, Document& document, TagSets& sets);
void read_partitioned_entities4(Numbers& in, bool v40, Document& document, TagSets& sets);
void read_nodes4(Numbers& in, bool v40, Document& document);
void read_elements4(Numbers& in, bool v40, Document& document, NodeIndex& index);

// Version 3. Nodes and elements: after the line with their number.
void read_entities3(Numbers& in, Document& document, TagSets& sets);
void read_nodes3(Numbers& in, std::int64_t count, Document& document);

/// A node in a binary file of version 2: its tag and its coordinates.
inline constexpr std::size_t node_bytes22 = 4 + 3 * sizeof(double);

// Versions 1 and 2.0 to 2.2, after the line with the number of nodes.
void read_nodes22(Numbers& in, std::int64_t count, bool parametric, Document& document);

/// Versions 1 to 3, after the line with the number of elements. An element that stands in the file once for
/// each of its physical groups becomes one; `copies` gets the tags of its further appearances.
void read_elements22(Numbers& in, std::int64_t count, ElementTags tags, Document& document, NodeIndex& index,
                     TagSets& sets, std::vector<ElementTag>& copies);

/// Warns of content that is legal but suspicious. The document has been read.
void warn_of_oddities(Document& document, const std::vector<ElementTag>& copies);

/// Makes room for `more` numbers at the end of `numbers` and returns where they start.
template <class T>
std::size_t append(std::vector<T>& numbers, std::size_t more) {
  const std::size_t start = numbers.size();
  if (start + more > numbers.capacity()) reserve_in_large_pages(numbers, std::max(start + more, 2 * start));
  numbers.resize(start + more);
  return start;
}

/// InputError if an Index cannot number so many nodes.
void check_node_count(const Numbers& in, std::size_t nodes);

}  // namespace tetproof::io
