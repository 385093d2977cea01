// SPDX-License-Identifier: GPL-3.0-or-later
// Long texts are read by several threads if every line is plain. A vertical tab is a blank but not a plain
// one, so the same file with a vertical tab is read word by word. Both must give the same result.
#include "io/bytes/plain_lines.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <sstream>

#include "io/mesh_files.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof::test {
namespace {

// The text of each line as the pieces contained it; nothing if reading gave up.
std::optional<std::vector<std::string>> lines_read(const Source& source, std::size_t offset,
                                                   std::size_t count, std::size_t& behind) {
  std::vector<std::string> lines(count);
  std::size_t waves = 0, next = 0;
  io::LineReader reader;
  reader.begin = [&](const std::vector<io::LinePiece>& wave) {
    ++waves;
    for (std::size_t p = 0; p < wave.size(); ++p) {
      EXPECT_EQ(wave[p].number, p);
      EXPECT_EQ(wave[p].first, next);
      EXPECT_GT(wave[p].count, 0u);
      next += wave[p].count;
    }
  };
  reader.read = [&](const io::LinePiece& piece) {
    std::size_t at = 0;
    for (std::size_t i = piece.first; i < piece.first + piece.count; ++i) {
      const std::size_t feed = std::min(piece.text.find('\n', at), piece.text.size());
      lines[i] = piece.text.substr(at, feed - at);
      at = std::min(feed + 1, piece.text.size());
    }
    return piece.text.data() + at;
  };
  const auto end = io::read_lines(source, offset, count, reader);
  if (!end) return std::nullopt;
  EXPECT_EQ(next, count);
  behind = *end;
  return lines;
}

TEST(ReadLines, EveryLineIsInOnePieceFromMemoryAndFromAFile) {
  std::mt19937_64 random(5);
  std::string text = "header\n";
  std::vector<std::string> lines;
  std::vector<std::size_t> ends;
  for (int i = 0; i < 300000; ++i) {
    const std::size_t length = i == 12345 ? 400000 : i > 250000 ? random() % 90 : random() % 30;
    lines.push_back(std::string(length, static_cast<char>('a' + i % 26)) + (random() % 9 ? "" : "\r"));
    text += lines.back() + "\n";
    ends.push_back(text.size());
  }
  const TestFiles files;
  for (const bool last_feed : {true, false}) {
    if (!last_feed) text.pop_back(), --ends.back();
    const InputFile file(files.write("lines", text));
    for (const Source& source : {Source(text), Source(file)}) {
      for (const std::size_t count : {std::size_t{1}, std::size_t{11000}, lines.size()}) {
        std::size_t behind = 0;
        const auto read = lines_read(source, 7, count, behind);
        ASSERT_TRUE(read) << count;
        EXPECT_EQ(std::equal(read->begin(), read->end(), lines.begin()), true) << count;
        EXPECT_EQ(behind, ends[count - 1]);
      }
      std::size_t behind = 0;
      EXPECT_FALSE(lines_read(source, 7, lines.size() + 1, behind));
      EXPECT_FALSE(lines_read(source, text.size(), 1, behind));
    }
  }
}

TEST(ReadLines, ALineAsLongAsMemoryIsGivenUp) {
  const std::string text(40'000'000, 'x');
  std::size_t behind = 0;
  EXPECT_FALSE(lines_read(std::string_view(text), 0, 2, behind));
}

using Lines = std::vector<std::string>;

std::string joined(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::string coordinates(std::mt19937_64& random) {
  std::uniform_real_distribution<double> any(-1, 1);
  return fmt::format("{} {} {}", any(random), any(random), any(random));
}

// Triangles and tetrahedra of both orders, in runs with equal tags. Each element has its own nodes.
Lines msh22(std::mt19937_64& random) {
  constexpr int nodes = 4000, elements = 30000;
  Lines lines{"$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", std::to_string(nodes)};
  for (int i = 0; i < nodes; ++i) lines.push_back(fmt::format("{} {}", 3 * i + 7, coordinates(random)));
  lines.insert(lines.end(), {"$EndNodes", "$Elements", std::to_string(elements)});
  const std::array<std::pair<int, int>, 4> types{{{2, 3}, {4, 4}, {9, 6}, {11, 10}}};
  auto type = types[0];
  std::string tags;
  for (int i = 0; i < elements; ++i) {
    if (i == 0 || random() % 700 == 0) {
      type = types[random() % 4];
      tags = random() % 2 ? fmt::format("2 {} {}", random() % 4, random() % 3)
                          : fmt::format("5 {} {} 2 {} -2", random() % 4, random() % 3, random() % 9);
    }
    std::string line = fmt::format("{} {} {}", 2 * i + 1, type.first, tags);
    for (int k = 0; k < type.second; ++k) line += fmt::format(" {}", 3 * (random() % nodes) + 7);
    lines.push_back(line);
  }
  lines.push_back("$EndElements");
  return lines;
}

Lines msh41(std::mt19937_64& random) {
  Lines lines{"$MeshFormat", "4.1 0 8", "$EndMeshFormat", "$Nodes", "3 9000 1 9000"};
  for (int block = 0; block < 3; ++block) {
    lines.push_back(fmt::format("{} 1 {} 3000", block + 1, block == 1 ? 1 : 0));
    for (int i = 0; i < 3000; ++i) lines.push_back(std::to_string(1 + 3 * i + block));
    for (int i = 0; i < 3000; ++i)
      lines.push_back(coordinates(random) + (block == 1 ? fmt::format(" {} {}", 0.5 * i, -i) : ""));
  }
  lines.insert(lines.end(), {"$EndNodes", "$Elements", "2 40000 1 40000"});
  for (const int each : {3, 4}) {
    lines.push_back(fmt::format("{} 1 {} 20000", each - 1, each == 3 ? 2 : 4));
    for (int i = 0; i < 20000; ++i) {
      std::string line = std::to_string((each - 3) * 20000 + i + 1);
      for (int k = 0; k < each; ++k) line += fmt::format(" {}", 1 + random() % 9000);
      lines.push_back(line + " ");  // as Gmsh ends its lines
    }
  }
  lines.push_back("$EndElements");
  return lines;
}

// `one_in`: on average, one of so many elements is repeated for up to three groups.
Lines with_copies(const Lines& lines, std::size_t first, std::size_t one_in, std::mt19937_64& random) {
  Lines all(lines.begin(), lines.begin() + static_cast<int>(first));
  for (auto line = lines.begin() + static_cast<int>(first); *line != "$EndElements"; ++line) {
    all.push_back(*line);
    for (std::uint64_t copy = random() % one_in == 0 ? 1 + random() % 3 : 0; copy > 0; --copy) {
      std::istringstream words(*line);
      std::string tag, type, tags, group, rest;
      words >> tag >> type >> tags >> group;
      std::getline(words, rest);
      all.push_back(fmt::format("{} {} {} {}{}", 100000 + all.size(), type, tags, 4 + copy, rest));
    }
  }
  all[first - 1] = std::to_string(all.size() - first);
  all.push_back("$EndElements");
  return all;
}

// The result of reading, without the file's name: the document and its warnings, or the error message.
std::string outcome(const std::function<Document()>& read, const std::string& folder) {
  std::string text;
  try {
    const Document document = read();
    text = text_of(document);
    for (const std::string& warning : document.warnings) text += "! " + warning + "\n";
  } catch (const InputError& error) {
    text = std::string("InputError ") + error.what();
  }
  for (std::size_t at; (at = text.find(folder)) != std::string::npos;) text.erase(at, folder.size());
  return text;
}

// `slow` is the same file with a vertical tab in each of its long sections.
void expect_same(const Lines& fast, const Lines& slow, const char* what) {
  const TestFiles one, other;
  const std::string a = one.write("x.msh", joined(fast)), b = other.write("x.msh", joined(slow));
  const std::string read_fast = outcome([&] { return read_document(a); }, one.path(""));
  const std::string read_slow = outcome([&] { return read_document(b); }, other.path(""));
  EXPECT_EQ(read_fast == read_slow, true) << what << ":\n"
                                          << read_fast.substr(0, 300) << "\nand\n"
                                          << read_slow.substr(0, 300);
}

struct Section {
  std::size_t first, count;  // of the section's lines of numbers
};

void try_all(const Lines& lines, const std::vector<Section>& sections) {
  Lines slow = lines;
  for (const Section& section : sections) slow[section.first + section.count - 1].insert(0, "\v");
  expect_same(lines, slow, "as it is");
  const std::vector<std::pair<const char*, std::function<void(Lines&, std::size_t)>>> oddities{
      {"no such node",
       [](Lines& all, std::size_t i) { all[i].replace(all[i].find_last_of(' '), 1, " 77777777"); }},
      {"a word too many", [](Lines& all, std::size_t i) { all[i] += " 5"; }},
      {"a word too few", [](Lines& all, std::size_t i) { all[i].resize(all[i].find_last_of(' ')); }},
      {"no number", [](Lines& all, std::size_t i) { all[i] += "x"; }},
      {"an empty line", [](Lines& all, std::size_t i) { all.insert(all.begin() + static_cast<int>(i), ""); }},
      {"two in a line",
       [](Lines& all, std::size_t i) {
         all[i] += " " + all[i + 1];
         all.erase(all.begin() + static_cast<int>(i) + 1);
       }},
      {"one in two lines", [](Lines& all, std::size_t i) { all[i].replace(all[i].find(' '), 1, "\n"); }},
      {"twice", [](Lines& all, std::size_t i) { all[i] = all[i + 1]; }},
      {"leading zeros", [](Lines& all, std::size_t i) { all[i] = "00" + all[i]; }},
      {"tabs and a carriage return",
       [](Lines& all, std::size_t i) { all[i].replace(all[i].find(' '), 1, "\t \t"), all[i] += "\r"; }},
      {"the end", [](Lines& all, std::size_t i) { all.resize(i); }},
      {"a long number", [](Lines& all, std::size_t i) { all[i] = "123456789012345678901" + all[i]; }}};
  for (const Section& section : sections)
    for (const auto& [what, change] : oddities) {
      const std::size_t at = section.first + section.count / 2;
      if (lines[at].find(' ') == std::string::npos) continue;  // the line has only one number
      Lines fast = lines, other = slow;
      change(fast, at), change(other, at);
      expect_same(fast, other, what);
    }
}

TEST(PlainLines, Msh22) {
  std::mt19937_64 random(1);
  try_all(msh22(random), {{5, 4000}, {5 + 4000 + 3, 30000}});
}

TEST(PlainLines, ElementsInSeveralGroups) {
  std::mt19937_64 random(4);
  for (const std::size_t one_in : {1u, 2u, 50u, 20000u}) {
    const std::size_t first = 5 + 4000 + 3;
    const Lines lines = with_copies(msh22(random), first, one_in, random);
    Lines slow = lines;
    slow[first].insert(0, "\v");
    expect_same(lines, slow, "copies");
  }
}

TEST(PlainLines, Msh41) {
  std::mt19937_64 random(2);
  const Lines lines = msh41(random);
  std::vector<Section> sections;
  for (std::size_t block = 0; block < 3; ++block) {
    const std::size_t start = 6 + block * 6001;
    sections.push_back({start, 3000});
    sections.push_back({start + 3000, 3000});
  }
  sections.push_back({5 + 3 * 6001 + 4, 20000});
  sections.push_back({5 + 3 * 6001 + 4 + 20001, 20000});
  try_all(lines, sections);
}

// In TetGen's files commas separate words as blanks do, but they are not plain.
TEST(PlainLines, Tetgen) {
  std::mt19937_64 random(3);
  for (const int each : {4, 10})
    for (const int first : {0, 1}) {
      constexpr int nodes = 5000, tets = 20000;
      Lines node{fmt::format("{} 3 2 1", nodes)}, ele{fmt::format("{} {} 1", tets, each)};
      for (int i = 0; i < nodes; ++i)
        node.push_back(fmt::format("{} {} {} -7.5 {}", i + first, coordinates(random), 0.25 * i, -(i % 3)));
      for (int i = 0; i < tets; ++i) {
        std::string line = std::to_string(i + first);
        for (int k = 0; k < each; ++k) line += fmt::format(" {}", random() % nodes + first);
        ele.push_back(line + fmt::format(" {}", i % 4));
      }
      node.push_back("# Generated by hand");
      const auto read = [&](const Lines& n, const Lines& e) {
        const TestFiles files;
        const std::string path = files.write("x.node", joined(n));
        files.write("x.ele", joined(e));
        return outcome([&] { return read_document(path); }, files.path(""));
      };
      const auto comma = [](Lines lines, std::size_t at) {
        lines[at].replace(lines[at].find(' '), 1, ",");
        return lines;
      };
      const std::string plain = read(node, ele);
      EXPECT_EQ(plain.starts_with("tetgen\nn "), true) << plain.substr(0, 200);
      EXPECT_EQ(plain == read(comma(node, nodes), comma(ele, tets)), true);
      for (const std::string& odd : {std::string("# a comment"), std::string(""), std::string("1 2"),
                                     std::string("010 1 2 3 4 5 6 7 8 9 10 11 12")})
        for (const bool in_nodes : {true, false}) {
          Lines n = node, e = ele;
          (in_nodes ? n : e)[3000] = odd;
          EXPECT_EQ(read(n, e) == read(comma(n, nodes), comma(e, tets)), true) << odd;
        }
    }
}

}  // namespace
}  // namespace tetproof::test
