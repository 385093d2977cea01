// SPDX-License-Identifier: GPL-3.0-or-later
// PlannedFile gives the same answers as the functions that answer one question each, and computes each answer
// once. The linker counts the calls: tests/unit/io/CMakeLists.txt wraps the functions below.
#include "io/writing.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <type_traits>
#include <vector>

#include "io/loss/holds.hpp"
#include "io/supplement/supplement.hpp"
#include "io/tetgen/tetgen_plan.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof {
namespace {

struct Calls {
  int encoding = 0, plan = 0, holds = 0, unheld = 0, supplement = 0;
  bool operator==(const Calls&) const = default;

  friend void PrintTo(const Calls& calls, std::ostream* out) {
    *out << "encoding " << calls.encoding << ", plan " << calls.plan << ", holds " << calls.holds
         << ", unheld " << calls.unheld << ", supplement " << calls.supplement;
  }
};
Calls calls;

}  // namespace

// Calls between the library's object files go to __wrap_NAME; __real_NAME is the library's function. These
// are the names that the linker sees.
#define TETPROOF_ENCODING_OF \
  "_ZN8tetproof11encoding_ofERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEERKNS_12WriteOptionsE"
#define TETPROOF_MESH_PLAN "_ZN8tetproof2io16tetgen_mesh_planERKNS_8DocumentE"
#define TETPROOF_MESH_HOLDS "_ZN8tetproof2io17tetgen_mesh_holdsERKNS_8DocumentERKNS0_10TetgenPlanE"
#define TETPROOF_UNHELD "_ZN8tetproof2io6unheldERKNS_8DocumentERKNS0_5HoldsE"
#define TETPROOF_SUPPLEMENT_OF "_ZN8tetproof2io13supplement_ofB5cxx11ERKNS_8DocumentERKNS0_5HoldsE"

Encoding real_encoding(const std::string&, const WriteOptions&) asm("__real_" TETPROOF_ENCODING_OF);
io::TetgenPlan real_plan(const Document&) asm("__real_" TETPROOF_MESH_PLAN);
io::Holds real_holds(const Document&, const io::TetgenPlan&) asm("__real_" TETPROOF_MESH_HOLDS);
std::vector<Loss> real_unheld(const Document&, const io::Holds&) asm("__real_" TETPROOF_UNHELD);
std::string real_supplement(const Document&, const io::Holds&) asm("__real_" TETPROOF_SUPPLEMENT_OF);

Encoding counted_encoding(const std::string&, const WriteOptions&) asm("__wrap_" TETPROOF_ENCODING_OF);
io::TetgenPlan counted_plan(const Document&) asm("__wrap_" TETPROOF_MESH_PLAN);
io::Holds counted_holds(const Document&, const io::TetgenPlan&) asm("__wrap_" TETPROOF_MESH_HOLDS);
std::vector<Loss> counted_unheld(const Document&, const io::Holds&) asm("__wrap_" TETPROOF_UNHELD);
std::string counted_supplement(const Document&, const io::Holds&) asm("__wrap_" TETPROOF_SUPPLEMENT_OF);

Encoding counted_encoding(const std::string& path, const WriteOptions& options) {
  return ++calls.encoding, real_encoding(path, options);
}
io::TetgenPlan counted_plan(const Document& document) {
  return ++calls.plan, real_plan(document);
}
io::Holds counted_holds(const Document& document, const io::TetgenPlan& plan) {
  return ++calls.holds, real_holds(document, plan);
}
std::vector<Loss> counted_unheld(const Document& document, const io::Holds& holds) {
  return ++calls.unheld, real_unheld(document, holds);
}
std::string counted_supplement(const Document& document, const io::Holds& holds) {
  return ++calls.supplement, real_supplement(document, holds);
}

namespace {

// Named groups, which TetGen's files keep aside and surfaces lose; and a value -inf, which makes .vtu warn.
constexpr const char* mesh =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 3 \"wall\"\n3 5 \"air\"\n$EndPhysicalNames\n"
    "$Entities\n0 0 1 1\n1 0 0 0 1 1 1 1 3 0\n1 0 0 0 1 1 1 1 5 0\n$EndEntities\n"
    "$Nodes\n1 4 1 4\n3 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n0 1 0\n0 0 0.1\n$EndNodes\n"
    "$Elements\n2 2 1 2\n2 1 2 1\n1 1 2 3\n3 1 4 1\n2 1 2 3 4\n$EndElements\n"
    "$NodeData\n1\n\"heat\"\n1\n0\n3\n0\n1\n1\n1 -inf\n$EndNodeData\n";

class Writing : public testing::Test {
 protected:
  const test::TestFiles files_;
  const Document document_ = read_document(files_.write("in.msh", mesh));
};

TEST_F(Writing, WorksEachAnswerOutOnce) {
  calls = {};
  PlannedFile file(files_.path("a.ele"), document_);
  EXPECT_EQ(calls, (Calls{.encoding = 1}));
  EXPECT_EQ(file.encoding().format, "tetgen");
  EXPECT_TRUE(file.losses().empty());
  EXPECT_FALSE(file.kept_aside().items.empty());
  EXPECT_EQ(file.warning(), "");
  file.write();
  const Calls once{.encoding = 1, .plan = 1, .holds = 1, .unheld = 1, .supplement = 1};
  EXPECT_EQ(calls, once);
  // Asking again computes nothing.
  EXPECT_EQ(file.encoding().format, "tetgen");
  EXPECT_TRUE(file.losses().empty());
  EXPECT_EQ(file.kept_aside().where, "comments");
  EXPECT_EQ(file.warning(), "");
  EXPECT_EQ(calls, once);
}

TEST_F(Writing, WritesUnasked) {
  calls = {};
  PlannedFile(files_.path("a.ele"), document_).write();
  EXPECT_EQ(calls, (Calls{.encoding = 1, .plan = 1, .holds = 1, .unheld = 1, .supplement = 1}));
}

// Functions that answer one question each start anew. The counts above are compared with these.
TEST_F(Writing, FunctionsForOneQuestionStartAnew) {
  calls = {};
  const std::string path = files_.path("a.ele");
  losses(path, document_), kept_aside(path, document_), write_warning(path, document_);
  write_document(path, document_);
  EXPECT_EQ(calls, (Calls{.encoding = 4, .plan = 4, .holds = 4, .unheld = 3, .supplement = 1}));
}

TEST_F(Writing, AnswersAreThoseOfTheFunctions) {
  bool lost = false, kept = false, warned = false;
  const auto same = [](const std::vector<Loss>& a, const std::vector<Loss>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Loss& x, const Loss& y) {
      return x.item == y.item && x.count == y.count && x.example == y.example;
    });
  };
  for (const Format& format : formats())
    for (const bool binary : {false, true}) {
      if (!(binary ? format.binary : format.ascii)) continue;
      const std::string ending =
          !format.binary_ending.empty() && binary ? format.binary_ending : format.endings.front();
      const WriteOptions options{.format = format.name, .binary = binary};
      const std::string one = files_.path("one" + ending), other = files_.path("other" + ending);
      PlannedFile file(one, document_, options);
      EXPECT_EQ(file.encoding().format, format.name);
      EXPECT_EQ(file.encoding().binary, binary);
      EXPECT_TRUE(same(file.losses(), losses(one, document_, options))) << ending;
      EXPECT_EQ(file.kept_aside().where, kept_aside(one, document_, options).where) << ending;
      EXPECT_TRUE(same(file.kept_aside().items, kept_aside(one, document_, options).items)) << ending;
      EXPECT_EQ(file.warning(), write_warning(one, document_, options)) << ending;
      lost = lost || !file.losses().empty();
      kept = kept || !file.kept_aside().items.empty();
      warned = warned || !file.warning().empty();
      file.write();
      write_document(other, document_, options);
      EXPECT_EQ(test::TestFiles::read(one), test::TestFiles::read(other)) << ending;
      EXPECT_FALSE(test::TestFiles::read(one).empty()) << ending;
    }
  EXPECT_TRUE(lost && kept && warned);  // otherwise nothing was compared
}

TEST_F(Writing, RefusesBeforeAnythingIsAsked) {
  EXPECT_EQ(files_.message([&] { PlannedFile("a.xyz", document_); }).substr(0, 21), "a.xyz: unknown ending");
  EXPECT_EQ(files_.message([&] { PlannedFile("a.off", document_, {.binary = true}); }),
            "a.off: OFF surface is never binary");
  EXPECT_FALSE(std::filesystem::exists("a.off"));
}

// A temporary document would be destroyed before the file is written.
static_assert(!std::is_constructible_v<PlannedFile, std::string, Document>);
static_assert(std::is_constructible_v<PlannedFile, std::string, const Document&>);

}  // namespace
}  // namespace tetproof
