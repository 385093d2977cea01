// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-verify --junit: another XML parser reads it, whatever the name of the mesh's file is.
#include <gmock/gmock.h>

#include <algorithm>

#include "tests/support/verify_files.hpp"

namespace tetproof::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

// Prints the attributes, text and children of every element; parsed by Python's expat.
constexpr const char* to_json =
    "import json, sys, xml.etree.ElementTree as tree\n"
    "def shown(e): return {'tag': e.tag, 'is': e.attrib, 'text': e.text, 'in': [shown(c) for c in e]}\n"
    "print(json.dumps([shown(tree.parse(file).getroot()) for file in sys.argv[1:]]))\n";

class VerifyJunit : public Verify {
 protected:
  // The test suite of each file. Expects that there is exactly one.
  json suites(const std::vector<std::string>& names) const {
    std::vector<std::string> command{"python3", "-c", to_json};
    for (const std::string& name : names) command.push_back(files / name);
    const Outcome parsed = run_program(command);
    EXPECT_EQ(parsed.exit_code, 0) << parsed;
    json found = json::array();
    for (const json& root : json::parse(parsed.out)) {
      EXPECT_EQ(root["tag"], "testsuites");
      EXPECT_EQ(root["in"].size(), 1u);
      EXPECT_EQ(root["in"][0]["tag"], "testsuite");
      found.push_back(root["in"][0]);
    }
    return found;
  }
  json suite(const std::string& name) const { return suites({name})[0]; }
  static json test_case(const json& suite, const std::string& id) {
    for (const json& child : suite["in"])
      if (child["tag"] == "testcase" && child["is"]["name"] == id) return child;
    return {};
  }
  static json property(const json& suite, const std::string& name) {
    for (const json& entry : suite["in"][0]["in"])
      if (entry["is"]["name"] == name) return entry["is"]["value"];
    return {};
  }
  void SetUp() override {
    if (!have_tool("python3")) GTEST_SKIP() << "python3, which parses the XML, is not installed";
  }
};

TEST_F(VerifyJunit, ASoundMesh) {
  const Outcome outcome = run({"cube.node", "--junit", files / "cube.xml"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_THAT(outcome.out, HasSubstr("sound: certified"));
  const json cube = suite("cube.xml");
  const json ids = report({"cube.node"}, 0)["checks"];
  EXPECT_EQ(cube["is"]["name"], files / "cube.node");
  EXPECT_EQ(cube["is"]["tests"], std::to_string(ids.size()));
  EXPECT_EQ(cube["is"]["failures"], "0");
  EXPECT_EQ(cube["is"]["errors"], "0");
  EXPECT_FALSE(cube["is"].contains("time"));
  EXPECT_EQ(property(cube, "certificate"), "true");
  EXPECT_EQ(property(cube, "tetrahedra"), "6");
  int skipped = 0;
  for (const json& check : ids) {
    const json entry = test_case(cube, check["id"]);
    ASSERT_FALSE(entry.is_null()) << check["id"];
    EXPECT_EQ(entry["is"]["classname"], files / "cube.node");
    if (check["verdict"] == "skipped") {
      ++skipped;
      EXPECT_EQ(entry["in"][0]["tag"], "skipped");
      EXPECT_EQ(entry["in"][0]["is"]["message"], "needs a surface");
    } else {
      EXPECT_EQ(check["verdict"], "pass");
      EXPECT_TRUE(entry["in"].empty()) << entry;
    }
  }
  EXPECT_GT(skipped, 0);
  EXPECT_EQ(cube["is"]["skipped"], std::to_string(skipped));
  EXPECT_EQ(cube["in"].back()["tag"], "system-out");
  EXPECT_THAT(cube["in"].back()["text"].get<std::string>(), StartsWith("sound: certified"));
}

TEST_F(VerifyJunit, ADefectiveMesh) {
  EXPECT_EQ(run({"bad.node", "--junit", files / "bad.xml"}).exit_code, 1);
  const json bad = suite("bad.xml");
  const json checks = report({"bad.node"}, 1)["checks"];
  const auto count = [&](const char* verdict) {
    return std::to_string(std::count_if(checks.begin(), checks.end(),
                                        [&](const json& check) { return check["verdict"] == verdict; }));
  };
  EXPECT_EQ(bad["is"]["failures"], count("fail"));
  EXPECT_EQ(property(bad, "verdict"), "defective");
  EXPECT_EQ(property(bad, "certificate"), "false");
  const json inverted = test_case(bad, "inverted")["in"][0];
  EXPECT_EQ(inverted["tag"], "failure");
  EXPECT_EQ(inverted["is"]["type"], "inverted");
  EXPECT_THAT(inverted["is"]["message"].get<std::string>(), StartsWith("tetrahedron 2: negative: volume"));
  EXPECT_THAT(inverted["text"].get<std::string>(), AllOf(StartsWith("FAIL inverted: 1\n  tetrahedron 2: "),
                                                         HasSubstr("\n    from this follows: ")));
  // All findings of this check follow from the duplicate.
  EXPECT_EQ(test_case(bad, "face-shared-thrice")["in"][0]["is"]["message"],
            "follows from what another check found");
}

TEST_F(VerifyJunit, AWarningIsNoFailure) {
  files.write("spare.node", std::string("9") + (cube_node + 1) + "9 0 0 5\n");
  files.write("spare.ele", cube_ele);
  EXPECT_EQ(run({"spare.node", "--junit", files / "spare.xml", "--skip", "overlap"}).exit_code, 0);
  const json spare = suite("spare.xml");
  EXPECT_EQ(spare["is"]["failures"], "0");
  EXPECT_EQ(property(spare, "certificate"), "unknown");
  const json warned = test_case(spare, "unused-point")["in"];
  ASSERT_EQ(warned.size(), 1u);
  EXPECT_EQ(warned[0]["tag"], "system-out");
  EXPECT_EQ(warned[0]["text"], "warning unused-point: 1\n  vertex 9: belongs to no tetrahedron\n");
  EXPECT_EQ(test_case(spare, "overlap")["in"][0]["is"]["message"], "not asked for");
}

TEST_F(VerifyJunit, HostileFileNames) {
  const std::vector<std::pair<std::string, std::string>> names{
      {"a&b &amp; &#10;", "a&b &amp; &#10;"},
      {"<x y=\"1\"> ]]> <!-- '", "<x y=\"1\"> ]]> <!-- '"},
      {"two\nlines\tand\rmore", "two\nlines\tand\rmore"},
      {"\xC3\xA4 \xE4\xB8\xAD \xF0\x9F\x98\x80", "\xC3\xA4 \xE4\xB8\xAD \xF0\x9F\x98\x80"},
      {"bell \x07 escape \x1B[31m", "bell \xEF\xBF\xBD escape \xEF\xBF\xBD[31m"},
      {"latin \xE4 cut \xE4\xB8", "latin \xEF\xBF\xBD cut \xEF\xBF\xBD\xEF\xBF\xBD"},
      {"overlong \xC0\xAF surrogate \xED\xA0\x80 none \xEF\xBF\xBE",
       "overlong \xEF\xBF\xBD\xEF\xBF\xBD surrogate \xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD none "
       "\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD"},
  };
  std::vector<std::string> reports;
  for (const auto& [name, read] : names) {
    files.write(name + ".node", cube_node);
    files.write(name + ".ele", bad_ele);
    reports.push_back(std::to_string(reports.size()) + ".xml");
    EXPECT_EQ(run({name + ".node", "--junit", files / reports.back()}).exit_code, 1);
  }
  const json found = suites(reports);
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(found[i]["is"]["name"], files / (names[i].second + ".node"));
    EXPECT_EQ(test_case(found[i], "inverted")["is"]["classname"], files / (names[i].second + ".node"));
  }
}

TEST_F(VerifyJunit, SameBytesUnlessTimed) {
  for (const char* file : {"1.xml", "2.xml"})
    EXPECT_EQ(run({"bad.node", "--junit", files / file, "--threads", std::string(file, 1)}).exit_code, 1);
  EXPECT_EQ(files.read("1.xml"), files.read("2.xml"));
  EXPECT_THAT(files.read("1.xml"), Not(HasSubstr("time=")));
  run({"cube.node", "--junit", files / "timed.xml", "--timings"});
  const json timed = suite("timed.xml");
  EXPECT_GE(std::stod(timed["is"]["time"].get<std::string>()), 0);
  EXPECT_FALSE(property(timed, "seconds of reading").is_null());
}

TEST_F(VerifyJunit, WholeOrNotAtAll) {
  EXPECT_THAT(run({"cube.node", "--junit", "-"}).out, StartsWith("<?xml"));
  const Outcome both = run({"cube.node", "--junit", "-", "--json", "-"});
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_EQ(both.out, "");
  EXPECT_EQ(lines(both.err), 1u);
  const Outcome nowhere = run({"cube.node", "--junit", files / "none/cube.xml"});
  EXPECT_EQ(nowhere.exit_code, 2);
  EXPECT_THAT(nowhere.err, HasSubstr("none/cube.xml"));
  EXPECT_EQ(nowhere.out, "");
  const auto before = files.names();
  EXPECT_EQ(run({"missing.node", "--junit", files / "missing.xml"}).exit_code, 2);
  EXPECT_EQ(files.names(), before);
}

}  // namespace
}  // namespace tetproof::test
