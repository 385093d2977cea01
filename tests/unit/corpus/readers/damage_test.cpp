// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/readers/damage.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "corpus/readers/damaged_file.hpp"
#include "corpus/readers/sample_documents.hpp"
#include "corpus/readers/shrink_file.hpp"
#include "io/error.hpp"
#include "io/mesh_files.hpp"

namespace tetproof::corpus {
namespace {

TEST(SampleFiles, EveryFormatThatIsWrittenHasOne) {
  std::set<std::string> seen;
  for (const SampleFile& file : sample_files(1, {})) {
    seen.insert(file.form());
    EXPECT_GT(file.size(), 0) << file.form();
    EXPECT_TRUE(file.content) << file.form();
  }
  for (const Format& format : formats()) {
    EXPECT_EQ(seen.contains(format.name), format.ascii) << format.name;
    EXPECT_EQ(seen.contains(format.name + " binary"), format.binary) << format.name;
  }
  EXPECT_THROW(sample_files(1, {"no-such-format"}), InputError);
}

// Applies a kind of damage to all samples. The bytes must change exactly if it says that it did something.
TEST(Damage, EveryKindChangesSomeFiles) {
  const std::vector<SampleFile> files = sample_files(1, {});
  std::set<std::string> ids;
  for (const DamageKind& kind : damage_kinds()) {
    EXPECT_TRUE(ids.insert(kind.id).second) << kind.id;
    int changed = 0;
    for (const SampleFile& file : files)
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        std::string bytes = file.parts[0].bytes, same = bytes;
        Random random(seed), again(seed);
        const auto done = kind.apply(bytes, random);
        if (done) ++changed;
        EXPECT_TRUE(done || bytes == file.parts[0].bytes) << kind.id << " " << file.form();
        EXPECT_EQ(kind.apply(same, again), done);
        EXPECT_EQ(same, bytes) << kind.id;
      }
    EXPECT_GT(changed, 0) << kind.id;
  }
}

TEST(Damage, OfNothingIsNothing) {
  for (const DamageKind& kind : damage_kinds())
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
      for (const char* text : {"", "x", "\n", "1"}) {
        std::string bytes = text;
        Random random(seed);
        kind.apply(bytes, random);  // must not crash
      }
}

TEST(Damage, SaysWhatItDid) {
  const auto apply = [](const char* id, std::string bytes) {
    for (const DamageKind& kind : damage_kinds())
      if (kind.id == std::string(id)) {
        Random random(1);
        kind.apply(bytes, random);
      }
    return bytes;
  };
  const std::string mesh = "$Nodes\n5\n1 0.5 0.25 0\n$EndNodes\n$Elements\n3\n$EndElements\n";
  EXPECT_LT(apply("truncated", mesh).size(), mesh.size());
  EXPECT_EQ(apply("empty", mesh), "");
  EXPECT_NE(apply("negative-count", mesh).find('-'), std::string::npos);
  EXPECT_NE(apply("crlf", mesh).find("$Nodes\r\n5\r\n"), std::string::npos);
  const std::string ends = apply("missing-end", mesh);
  EXPECT_TRUE(ends.find("$EndNodes") == std::string::npos || ends.find("$EndElements") == std::string::npos);
  const std::string one_line = apply("long-line", mesh);
  EXPECT_TRUE(one_line.size() > (1U << 20) || std::count(one_line.begin(), one_line.end(), '\n') < 2);
  EXPECT_EQ(apply("deep-nesting", mesh), mesh);
  EXPECT_GT(apply("deep-nesting", "<VTKFile a=\"1\">\n</VTKFile>\n").size(), 3000u);
  EXPECT_NE(apply("byte-order", "byte_order=\"LittleEndian\"").find("BigEndian"), std::string::npos);
}

TEST(DamagedFiles, GoThroughAllSamplesAndKinds) {
  const DamagedFiles files({.cases = 400, .formats = {"msh22", "vtu"}});
  const std::vector<SampleFile> samples = sample_files(1, {"msh22", "vtu"});
  std::set<std::string> damages, forms;
  std::uint64_t valid = 0;
  for (std::uint64_t k = 0; k < files.size(); ++k) {
    const DamagedFile one = files.file(k);
    forms.insert(one.sample.form());
    damages.insert(one.damage);
    valid += one.damage == "none";
    // What is called damaged has other bytes.
    const SampleFile& sample = samples.at(k % samples.size());
    EXPECT_EQ(one.damage == "none", one.sample.parts.at(one.part).bytes == sample.parts.at(one.part).bytes)
        << k;
    EXPECT_EQ(files.file(k).sample.parts[0].bytes, one.sample.parts[0].bytes);
  }
  EXPECT_EQ(files.size(), valid + 400);
  EXPECT_EQ(forms, (std::set<std::string>{"msh22", "msh22 binary", "vtu", "vtu binary"}));
  EXPECT_EQ(damages.size(), damage_kinds().size() + 1);
  EXPECT_THROW(DamagedFiles({.damages = {"no-such-damage"}}), InputError);
}

TEST(ShrinkFile, LeavesWhatFails) {
  std::string text;
  for (int k = 0; k < 200; ++k) text += "line " + std::to_string(k) + "\n";
  int calls = 0;
  const auto fails = [&](const std::string& bytes) {
    ++calls;
    return bytes.find("line 17\n") != std::string::npos && bytes.find("99") != std::string::npos;
  };
  EXPECT_EQ(shrink_file(text, fails, 60), "line 17\n99");
  EXPECT_LT(calls, 1000);
  EXPECT_EQ(shrink_file(text, fails, 0), text);
  EXPECT_EQ(shrink_file(
                text, [](const std::string&) { return true; }, 60),
            "");
}

}  // namespace
}  // namespace tetproof::corpus
