// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/msh/msh_write.hpp"

#include <algorithm>
#include <limits>

#include "io/bytes/words.hpp"
#include "io/supplement/supplement.hpp"

namespace tetproof::io {

std::string msh_header(const char* version, bool binary) {
  std::string text = fmt::format("$MeshFormat\n{} {} 8\n", version, binary ? 1 : 0);
  if (binary) {
    char one[4];
    put_raw(one, std::int32_t{1});
    text.append(one, 4);
    text += '\n';
  }
  return text + "$EndMeshFormat\n";
}

std::string msh_names(const Document& document, const Holds& holds) {
  std::string names;
  std::size_t count = 0;
  for (const GroupName& name : document.group_names) {
    if (!holds.name(name)) continue;
    names += fmt::format("{} {} \"{}\"\n", name.dim, name.group, name.name);
    ++count;
  }
  if (count == 0) return {};
  return fmt::format("$PhysicalNames\n{}\n{}$EndPhysicalNames\n", count, names);
}

std::string msh_kept_sections(const Document& document, const Holds& holds, bool before_nodes) {
  std::string text;
  for (const Section& section : document.sections) {
    if (section.before_nodes != before_nodes || !holds.section(section)) continue;
    text += fmt::format("${}\n{}", section.name, section.body);
    if (!section.body.empty() && section.body.back() != '\n') text += '\n';
    text += fmt::format("$End{}\n", section.name);
  }
  return text;
}

std::string MshFilePlan::warning(const std::string& path) {
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
  std::string texts;
  const auto look_for = [&](const char* which, const auto& is_one) {
    std::size_t count = 0;
    std::int64_t first = 0;
    for (const ElementBlock& block : document_.blocks) {
      const auto& groups = document_.tag_sets[static_cast<std::size_t>(block.groups)];
      const auto one = std::find_if(groups.begin(), groups.end(), is_one);
      if (one == groups.end() || block.count == 0) continue;
      if (count == 0) first = *one;
      count += block.count;
    }
    if (count > 0)
      texts += fmt::format("{}{}: {}, the first in {}", texts.empty() ? "" : ", and those ", which,
                           counted(count, "elements"), first);
  };
  look_for("beyond 32 bits for others", [](std::int64_t group) { return group < -most || group > most; });
  if (!document_.format.starts_with("msh"))
    look_for("below 0 for those above 0", [](std::int64_t group) { return group < 0 && group >= -most; });
  return texts.empty() ? "" : fmt::format("{}: Gmsh takes physical groups {}", path, texts);
}

void MshFilePlan::write(const std::string& path, const std::string& supplement) {
  AtomicFile file(path);
  if (!supplement.empty()) file.keep_checksum();
  write_into(file);
  if (!supplement.empty())
    file.write(fmt::format("$TetproofSupplement\n{}{}$EndTetproofSupplement\n",
                           supplement_head({{"", file.checksum()}}), supplement));
  file.commit();
}

}  // namespace tetproof::io
