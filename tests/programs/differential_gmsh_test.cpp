// SPDX-License-Identifier: GPL-3.0-or-later
// Gmsh and tetproof understand .msh files in the same way: files that others wrote, and files that we write.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <sstream>

#include "io/mesh_files.hpp"
#include "io/model/element_types.hpp"
#include "tests/support/document_listing.hpp"
#include "tests/support/run_program.hpp"

namespace tetproof::test {
namespace {

namespace fs = std::filesystem;

/// What Gmsh understood of a file.
struct Heard {
  int code = 0;  // 0: read; 3: refused; below 0: crashed
  std::vector<std::string> complaints;
  Listing lines;
};

std::map<std::string, Heard> listen_to_gmsh(const std::vector<std::string>& files) {
  std::vector<std::string> command{"/usr/bin/python3", TETPROOF_SOURCE_DIR "/tests/programs/gmsh_listing.py"};
  command.insert(command.end(), files.begin(), files.end());
  const Outcome run = run_program(command);
  std::map<std::string, Heard> all;
  if (run.exit_code == 77) return all;
  EXPECT_EQ(run.exit_code, 0) << run.err;
  std::istringstream in(run.out);
  Heard* heard = nullptr;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("file "))
      heard = &all[line.substr(5)];
    else if (line.starts_with("end "))
      heard->code = std::stoi(line.substr(4));
    else if (!line.starts_with("says "))
      heard->lines.insert(line);
    // It complains that it cannot look for closest nodes, which nobody asked for.
    else if (line.find("compiled with ANN support") == line.npos)
      heard->complaints.push_back(line.substr(5));
  }
  return all;
}

std::vector<std::string> samples() {
  std::vector<std::string> all;
  std::vector<fs::path> folders{TETPROOF_SOURCE_DIR "/corpus/formats",
                                TETPROOF_SOURCE_DIR "/../shared/formats"};
  if (const char* more = std::getenv("TETPROOF_SAMPLES")) folders.push_back(more);
  for (const fs::path& folder : folders) {
    if (!fs::exists(folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.path().extension() == ".msh" && entry.path().parent_path().filename() != "gmsh484_crashers")
        all.push_back(entry.path().lexically_normal().string());
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::string name_of(const std::string& path) {
  return fs::path(path).filename().string();
}

// The parts of a line such as "element 7 4 in 3 2: 1 2 3 4".
struct ElementLine {
  std::int64_t tag = 0;
  std::string what, place;  // "4 in 3 2: 1 2 3 4", "3 2"
};
ElementLine element_line(const std::string& line) {
  ElementLine element;
  const std::size_t space = line.find(' ', 8), in = line.find(" in "), colon = line.find(':');
  element.tag = std::stoll(line.substr(8, space - 8));
  element.what = line.substr(space + 1);
  element.place = line.substr(in + 4, colon - in - 4);
  return element;
}

/// Removes what the file does not say but Gmsh computes, and what Gmsh has no way to report.
Listing comparable(const Listing& lines, bool has_entities) {
  Listing kept;
  std::map<std::string, std::int64_t> copies;  // the smallest tag of equal elements
  std::set<std::string> with_elements;
  for (const std::string& line : lines)
    if (line.starts_with("element ")) {
      const ElementLine element = element_line(line);
      with_elements.insert(element.place);
      const auto [at, first] = copies.insert({element.what, element.tag});
      if (!first) at->second = std::min(at->second, element.tag);
    }
  for (const std::string& line : lines) {
    if (has_entities) {
      // Gmsh reports the end points of curves without their sign, and at most two for each curve.
      if (!line.starts_with("boundary 1 ")) {
        kept.insert(line);
        continue;
      }
      std::istringstream in(line.substr(line.find(':') + 1));
      std::set<std::int64_t> tags;
      for (std::int64_t tag; in >> tag;) tags.insert(std::abs(tag));
      if (tags.size() <= 2) kept.insert(fmt::format("{}: {}", line.substr(0, line.find(':')), joined(tags)));
      continue;
    }
    // Types 13x are points, lines, triangles and tetrahedra that are parts of another element. Of version 2,
    // Gmsh reads only which element they belong to.
    if (const std::size_t type = line.find(" 13"); line.starts_with("element ") && type < line.find(" in "))
      continue;
    // Before version 4, nodes belong to no entity unless they have parametric coordinates. Entities are those
    // that elements name; they have no boundaries. An element is listed once for each of its groups.
    if (line.starts_with("boundary ") || line.starts_with("partitions ")) continue;
    // Gmsh reports no periodic links of version 2.
    if (line.starts_with("periodic ")) continue;
    if (line.starts_with("groups ") && !with_elements.contains(line.substr(7, line.find(':') - 7))) continue;
    if (line.starts_with("node ") && line.find(" in ") != line.npos) continue;
    if (line.starts_with("entity ") && !with_elements.contains(line.substr(7))) continue;
    if (line.starts_with("element ")) {
      const ElementLine element = element_line(line);
      if (copies.at(element.what) != element.tag) continue;
    }
    kept.insert(line);
  }
  return kept;
}

// Gmsh cuts names at an inner quote and after 127 bytes (128 in .msh 4), and reports only groups that have an
// entity.
void adjust_names(const Document& document, const Heard& gmsh, Listing& ours) {
  std::set<std::int64_t> used;
  for (const auto& set : document.tag_sets)
    for (std::int64_t group : set) used.insert(std::abs(group));
  for (const GroupName& name : document.group_names) {
    const std::string start = fmt::format("name {} ", place(name.dim, name.group));
    const auto theirs = gmsh.lines.lower_bound(start);
    if (theirs == gmsh.lines.end() || !theirs->starts_with(start)) {
      if (!used.contains(std::abs(name.group))) ours.erase(start + name.name);
      continue;
    }
    const std::string said = theirs->substr(start.size());
    if (name.name.starts_with(said) && (said.size() >= 127 || name.name[said.size()] == '"')) {
      ours.erase(start + name.name);
      ours.insert(*theirs);
    }
  }
}

// Removes what is in sections that we keep as they are, without reading them.
void drop_verbatim(const Document& document, Listing& gmsh) {
  for (const Section& section : document.sections) {
    if (section.name == "GhostElements")
      for (const GhostEntity& ghost : document.ghosts)
        std::erase_if(gmsh, [&](const std::string& line) {
          return line.starts_with("element ") &&
                 element_line(line).place.ends_with(fmt::format(" {}", ghost.tag));
        });
    const std::string start = section.name == "Periodic"          ? "periodic "
                              : section.name == "NodeData"        ? "data NodeData "
                              : section.name == "ElementData"     ? "data ElementData "
                              : section.name == "ElementNodeData" ? "data ElementNodeData "
                                                                  : "";
    if (!start.empty()) std::erase_if(gmsh, [&](const std::string& line) { return line.starts_with(start); });
  }
}

std::string difference(const Listing& ours, const Listing& gmsh) {
  std::vector<std::string> only_ours, only_gmsh;
  std::set_difference(ours.begin(), ours.end(), gmsh.begin(), gmsh.end(), std::back_inserter(only_ours));
  std::set_difference(gmsh.begin(), gmsh.end(), ours.begin(), ours.end(), std::back_inserter(only_gmsh));
  std::string text;
  for (const auto& [who, lines] : {std::pair{"only we:   ", &only_ours}, {"only Gmsh: ", &only_gmsh}}) {
    for (std::size_t i = 0; i < lines->size() && i < 5; ++i) text += fmt::format("{}{}\n", who, (*lines)[i]);
    if (lines->size() > 5) text += fmt::format("{}{} lines\n", who, lines->size());
  }
  return text;
}

bool has_entities(const Document& document) {
  return document.format == "msh40" || document.format == "msh41";
}

/// The difference between our reading of a file and Gmsh's.
std::string difference(const Document& document, const Heard& heard, bool entities) {
  Listing ours = listing_of(document), gmsh = heard.lines;
  adjust_names(document, heard, ours);
  drop_verbatim(document, gmsh);
  return difference(comparable(ours, entities), comparable(gmsh, entities));
}

// Files that Gmsh 4.8.4 cannot read, with its exit code.
const std::map<std::string, int> not_read{
    {"sparse.msh", -11},       // tag 4000000000: the size of an array overflows 32 bits
    {"two_40_binary.msh", 3},  // "Can only read MSH 4.0 format in ASCII mode"
};

// Files that it reads differently.
const std::set<std::string> misread{
    "partitions.msh",  // node 0 becomes a second node 1
};

TEST(DifferentialGmsh, SamplesOfOthers) {
  const auto files = samples();
  if (files.empty()) GTEST_SKIP() << "no samples";
  const auto heard = listen_to_gmsh(files);
  if (heard.empty()) GTEST_SKIP() << "libgmsh is not installed";
  for (const std::string& file : files) {
    const Heard& gmsh = heard.at(file);
    const auto known = not_read.find(name_of(file));
    if (known != not_read.end()) {
      EXPECT_EQ(gmsh.code, known->second) << file << " is read by this Gmsh";
      EXPECT_GT(read_document(file).elements(), 0u) << file;
      continue;
    }
    EXPECT_EQ(gmsh.code, 0) << file;
    const Document document = read_document(file);
    const std::string differs = difference(document, gmsh, has_entities(document));
    if (misread.contains(name_of(file)))
      EXPECT_NE(differs, "") << file << " is read well by this Gmsh";
    else
      EXPECT_EQ(differs, "") << file;
  }
}

// Samples with all features of Gmsh. If TETPROOF_ALL_SAMPLES is set, all samples of version 4 are used.
const std::set<std::string> rich{"two_41_text.msh", "two_40_text.msh",    "two41part.msh", "two41o2b.msh",
                                 "per_msh41.msh",   "two22.msh",          "two41par.msh",  "view5.msh",
                                 "hybrid_part.msh", "adaptive_tet20.msh", "s.msh"};

TEST(DifferentialGmsh, WhatWeWrite) {
  struct Target {
    const char* format;
    bool binary;
  };
  std::vector<Target> targets;
  for (const Format& format : formats())
    for (bool binary : {false, true})
      if (format.name.starts_with("msh") && (binary ? format.binary : format.ascii))
        targets.push_back({format.name.c_str(), binary});
  const ScratchFolder folder;
  struct Written {
    Document document;
    std::string origin;
    bool entities;
  };
  std::map<std::string, Written> written;  // key: the file
  for (const std::string& file : samples()) {
    if (not_read.contains(name_of(file)) || misread.contains(name_of(file))) continue;
    const Document document = read_document(file);
    // Elements without an entity get one when they are written, so old files are used only if all their
    // elements have one.
    const bool also = std::getenv("TETPROOF_ALL_SAMPLES") && has_entities(document);
    if (!also && !rich.contains(name_of(file))) continue;
    for (const auto& [format, binary] : targets) {
      const std::string out = folder / fmt::format("{}-{}.msh", written.size(), format);
      write_document(out, document, {.format = format, .binary = binary});
      const bool entities = has_entities(document) && std::string(format) != "msh22";
      written[out] = {document, fmt::format("{} as {}{}", file, format, binary ? ", binary" : ""), entities};
      // Ghosts belong to entities that version 2 does not have.
      if (!entities) written[out].document.ghosts.clear();
    }
  }
  if (written.empty()) GTEST_SKIP() << "no samples";
  std::vector<std::string> files;
  for (const auto& [file, what] : written) files.push_back(file);
  const auto heard = listen_to_gmsh(files);
  if (heard.empty()) GTEST_SKIP() << "libgmsh is not installed";
  for (const auto& [file, what] : written) {
    const Heard& gmsh = heard.at(file);
    EXPECT_EQ(gmsh.code, 0) << what.origin;
    EXPECT_EQ(gmsh.complaints, std::vector<std::string>{}) << what.origin;
    EXPECT_EQ(difference(what.document, gmsh, what.entities), "") << what.origin;
  }
}

}  // namespace
}  // namespace tetproof::test
