// SPDX-License-Identifier: GPL-3.0-or-later
// Long blocks of binary .msh 4.1 and 2.2 are read by several threads if they are regular and in this
// machine's byte order. In the other order they are read number by number. The same file in both orders must
// give the same result.
#include "io/bytes/plain_records.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

#include "io/mesh_files.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof::test {
namespace {

// The content of a file, before it is written in a byte order.
struct Content {
  std::vector<std::vector<std::int64_t>> node_tags;  // of each block
  struct Block {
    int type = 4, each = 4;
    std::vector<std::int64_t> tags, nodes;
  };
  std::vector<Block> blocks;
  bool parameters = false;
  std::size_t cut = 0;  // number of bytes that are missing at the file's end
};

class Bytes {
 public:
  explicit Bytes(bool swapped) : swapped_(swapped) {}
  template <class T>
  void put(T value) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    if (swapped_) std::reverse(bytes, bytes + sizeof(T));
    text.append(bytes, sizeof(T));
  }
  std::string text;

 private:
  const bool swapped_;
};

std::string file_of(const Content& content, bool swapped) {
  Bytes out(swapped);
  out.text = "$MeshFormat\n4.1 1 8\n";
  out.put(std::int32_t{1});
  out.text += "\n$EndMeshFormat\n$Nodes\n";
  std::size_t nodes = 0, elements = 0;
  for (const auto& tags : content.node_tags) nodes += tags.size();
  for (const auto& block : content.blocks) elements += block.tags.size();
  for (const std::size_t n : {content.node_tags.size(), nodes, std::size_t{1}, nodes})
    out.put(static_cast<std::int64_t>(n));
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> any(-1, 1);
  std::int32_t entity = 0;
  for (const auto& tags : content.node_tags) {
    for (const std::int32_t n : {2, ++entity, content.parameters ? 1 : 0}) out.put(n);
    out.put(static_cast<std::int64_t>(tags.size()));
    for (const std::int64_t tag : tags) out.put(tag);
    for (std::size_t i = 0; i < tags.size() * (content.parameters ? 5 : 3); ++i) out.put(any(random));
  }
  out.text += "\n$EndNodes\n$Elements\n";
  for (const std::size_t n : {content.blocks.size(), elements, std::size_t{1}, elements})
    out.put(static_cast<std::int64_t>(n));
  for (const auto& block : content.blocks) {
    for (const std::int32_t n : {3, ++entity, block.type}) out.put(n);
    out.put(static_cast<std::int64_t>(block.tags.size()));
    const std::int64_t* node = block.nodes.data();
    for (const std::int64_t tag : block.tags) {
      out.put(tag);
      for (int k = 0; k < block.each; ++k) out.put(*node++);
    }
  }
  out.text += "\n$EndElements\n";
  out.text.resize(out.text.size() - content.cut);
  return out.text;
}

// The same in version 2.2. `again`: whether an element is written again in another group. Every block begins
// and ends within a run of equal elements that several headers cut.
std::string file22_of(const Content& content, const std::function<bool(std::size_t)>& again, bool swapped) {
  Bytes out(swapped);
  out.text = "$MeshFormat\n2.2 1 8\n";
  out.put(std::int32_t{1});
  std::size_t nodes = 0;
  for (const auto& tags : content.node_tags) nodes += tags.size();
  out.text += "\n$EndMeshFormat\n$Nodes\n" + std::to_string(nodes) + "\n";
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> any(-1, 1);
  for (const auto& tags : content.node_tags)
    for (const std::int64_t tag : tags) {
      out.put(static_cast<std::int32_t>(tag));
      for (int k = 0; k < 3; ++k) out.put(any(random));
    }
  struct Element {
    std::size_t block, i;
    std::int32_t group, tag;
  };
  std::vector<Element> elements;
  for (std::size_t b = 0; b < content.blocks.size(); ++b)
    for (std::size_t i = 0; i < content.blocks[b].tags.size(); ++i) {
      elements.push_back(
          {b, i, static_cast<std::int32_t>(i / 9000), static_cast<std::int32_t>(content.blocks[b].tags[i])});
      if (again(i)) elements.push_back({b, i, 7, static_cast<std::int32_t>(500000 + elements.size())});
    }
  out.text += "\n$EndNodes\n$Elements\n" + std::to_string(elements.size()) + "\n";
  for (std::size_t start = 0, end; start < elements.size(); start = end) {
    for (end = start;
         end < elements.size() && end < start + 7001 && elements[end].block == elements[start].block;)
      ++end;
    const Content::Block& block = content.blocks[elements[start].block];
    for (const std::int32_t n : {block.type, static_cast<std::int32_t>(end - start), 2}) out.put(n);
    for (std::size_t e = start; e < end; ++e) {
      for (const std::int32_t n : {elements[e].tag, elements[e].group, 3}) out.put(n);
      for (int k = 0; k < block.each; ++k)
        out.put(static_cast<std::int32_t>(
            block.nodes[elements[e].i * static_cast<std::size_t>(block.each) + static_cast<std::size_t>(k)]));
    }
  }
  out.text += "\n$EndElements\n";
  out.text.resize(out.text.size() - content.cut);
  return out.text;
}

std::vector<std::int64_t> tags_from(std::int64_t first, std::size_t count, std::int64_t step = 1) {
  std::vector<std::int64_t> tags(count);
  for (std::size_t i = 0; i < count; ++i) tags[i] = first + step * static_cast<std::int64_t>(i);
  return tags;
}

Content usual() {
  Content content;
  content.node_tags = {tags_from(1, 3000), tags_from(3001, 5), tags_from(3006, 20000)};
  std::mt19937_64 random(4);
  for (const auto& [type, each, first, count] :
       {std::tuple{2, 3, 1, 2000}, std::tuple{4, 4, 2001, 30000}, std::tuple{11, 10, 32001, 1500}}) {
    Content::Block block{type, each, tags_from(first, static_cast<std::size_t>(count)), {}};
    for (int i = 0; i < count * each; ++i)
      block.nodes.push_back(1 + static_cast<std::int64_t>(random() % 23005));
    content.blocks.push_back(std::move(block));
  }
  return content;
}

std::string outcome(const std::string& bytes) {
  const TestFiles files;
  const std::string path = files.write("x.msh", bytes);
  try {
    const Document document = read_document(path);
    std::string text = text_of(document);
    for (const std::string& warning : document.warnings) text += "! " + warning.substr(path.size()) + "\n";
    return text;
  } catch (const InputError& error) {
    return std::string("InputError ").append(error.what() + path.size());
  }
}

TEST(PlainRecords, BothByteOrdersSayTheSame) {
  using Change = std::function<void(Content&)>;
  const std::vector<std::pair<const char*, Change>> changes{
      {"as usual", [](Content&) {}},
      {"from a large number on",
       [](Content& c) {
         c.node_tags = {tags_from(0, 3000), tags_from(std::int64_t{1} << 40, 20005)};
       }},
      {"gaps between blocks", [](Content& c) { c.node_tags[2] = tags_from(3016, 20000); }},
      {"gaps everywhere", [](Content& c) { c.node_tags[2] = tags_from(3006, 20000, 7); }},
      {"downwards", [](Content& c) { c.node_tags[2] = tags_from(23005, 20000, -1); }},
      {"two nodes exchanged", [](Content& c) { std::swap(c.node_tags[2][15000], c.node_tags[2][15001]); }},
      {"a node twice", [](Content& c) { c.node_tags[2][15000] = 77; }},
      {"parameters", [](Content& c) { c.parameters = true; }},
      {"no such node", [](Content& c) { c.blocks[1].nodes[77777] = 23006; }},
      {"a negative node", [](Content& c) { c.blocks[1].nodes[77777] = -1; }},
      {"a gap of elements", [](Content& c) { c.blocks[1].tags = tags_from(2002, 30000); }},
      {"elements downwards", [](Content& c) { c.blocks[1].tags = tags_from(2000, 30000, -1); }},
      {"an element twice", [](Content& c) { c.blocks[1].tags[25000] = 3; }},
      {"the first is odd", [](Content& c) { c.blocks[1].tags[0] = 999999; }},
      {"cut in the last block", [](Content& c) { c.cut = 100; }},
      {"cut in its tags", [](Content& c) { c.cut = 88 * 1500; }},
      {"cut before it", [](Content& c) { c.cut = 88 * 1500 + 500000; }}};
  for (const auto& [what, change] : changes) {
    Content content = usual();
    change(content);
    const std::string fast = outcome(file_of(content, false)), slow = outcome(file_of(content, true));
    EXPECT_EQ(fast == slow, true) << what << ":\n" << fast.substr(0, 300) << "\nand\n" << slow.substr(0, 300);
    EXPECT_EQ(fast.starts_with("InputError"), content.cut > 0 || what == std::string("a node twice")) << what;
  }
}

TEST(PlainRecords, BothByteOrdersSayTheSameIn22) {
  using Change = std::function<void(Content&)>;
  const std::vector<std::pair<const char*, Change>> changes{
      {"as usual", [](Content&) {}},
      {"gaps between blocks", [](Content& c) { c.node_tags[2] = tags_from(3016, 20000); }},
      {"gaps everywhere", [](Content& c) { c.node_tags[2] = tags_from(3006, 20000, 7); }},
      {"two nodes exchanged", [](Content& c) { std::swap(c.node_tags[2][15000], c.node_tags[2][15001]); }},
      {"no such node", [](Content& c) { c.blocks[1].nodes[77777] = 23006; }},
      {"a negative node", [](Content& c) { c.blocks[1].nodes[77777] = -1; }},
      {"elements downwards", [](Content& c) { c.blocks[1].tags = tags_from(400000, 30000, -1); }},
      {"an element twice", [](Content& c) { c.blocks[1].tags[25000] = 3; }},
      {"cut in the last block", [](Content& c) { c.cut = 100; }},
      {"cut before it", [](Content& c) { c.cut = 52 * 1500 + 300000; }}};
  const std::vector<std::function<bool(std::size_t)>> copies{[](std::size_t) { return false; },
                                                             [](std::size_t) { return true; },
                                                             [](std::size_t i) { return i % 997 == 0; }};
  for (const auto& [what, change] : changes)
    for (const auto& again : copies) {
      Content content = usual();
      change(content);
      const std::string fast = outcome(file22_of(content, again, false)),
                        slow = outcome(file22_of(content, again, true));
      EXPECT_EQ(fast == slow, true) << what << ":\n"
                                    << fast.substr(0, 300) << "\nand\n"
                                    << slow.substr(0, 300);
      EXPECT_EQ(fast.starts_with("InputError"), content.cut > 0) << what;
    }
}

TEST(PlainRecords, EveryRecordOnce) {
  std::string text = "123";
  constexpr std::size_t count = 100000;
  for (std::uint32_t i = 0; i < count; ++i) {
    text.append(reinterpret_cast<const char*>(&i), 4);
    text += "abc";
  }
  const TestFiles files;
  const InputFile file(files.write("records", text));
  for (const Source& source : {Source(text), Source(file)}) {
    std::vector<int> seen(count);
    io::read_records(source, 3, 7, count, [&](const char* bytes, std::size_t first, std::size_t here) {
      for (std::size_t i = first; i < first + here; ++i, bytes += 7)
        seen[i] += io::number_at<std::uint32_t>(bytes) == i ? 1 : 1000;
    });
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(count));
    std::string copy(text.size() - 3, ' ');
    io::copy_bytes(source, 3, copy.size(), copy.data());
    EXPECT_EQ(copy == text.substr(3), true);
  }
}

}  // namespace
}  // namespace tetproof::test
