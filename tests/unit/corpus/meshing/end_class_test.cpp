// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/meshing/end_class.hpp"

#include <gtest/gtest.h>
#include <signal.h>

#include <string>
#include <vector>

#include "corpus/meshing/crash_words.hpp"
#include "corpus/meshing/output_lines.hpp"

namespace tetproof::corpus {
namespace {

ProcessEnd exited(int code, const std::string& output) {
  ProcessEnd end;
  end.exit_code = code;
  end.output = output;
  return end;
}
ProcessEnd killed(int signal, const std::string& output) {
  ProcessEnd end;
  end.signal = signal;
  end.output = output;
  return end;
}

struct Case {
  const char* name;
  ProcessEnd end;
  const char* outcome;  ///< "" for a success
  std::string signature;
};

// The words are those of the programs named, as they print them.
const std::vector<Case> cases{
    {"success", exited(0, "Info : done\n"), "", ""},
    {"TetGen throws an int",
     killed(SIGABRT,
            "Recovering boundaries...\nFound a segment and a subface intersect.\n"
            "  1st: [4, 6] 1.\nterminate called after throwing an instance of 'int'\n"),
     "refused-valid", "Found a segment and a subface intersect."},
    {"TetGen throws an int without a claim",
     killed(SIGABRT,
            "Error:  The point set is trivial.\nterminate called after throwing an instance of 'int'\n"),
     "refused", "Error: The point set is trivial."},
    {"TetGen's assertion",
     killed(SIGABRT,
            "tetgen: tetgen.cxx:12345: int tetgenmesh::fillcavity(arraypool*, long int, face*): Assertion "
            "`!bflag || t == NULL' failed.\n"),
     "crashed", "fillcavity: Assertion `!bflag || t == NULL' failed at tetgen.cxx:12345"},
    {"an assertion in a path",
     killed(SIGABRT, "gmsh: /build/gmsh-4.8/src/mesh/a.cpp:7: void f(): Assertion `x' failed.\n"), "crashed",
     "f: Assertion `x' failed at a.cpp:7"},
    {"libstdc++'s assertion",
     killed(SIGABRT,
            "/usr/include/c++/12/bits/stl_vector.h:1045: std::vector<_Tp, _Alloc>::reference "
            "std::vector<_Tp, _Alloc>::operator[](size_type) [with _Tp = int]: Assertion '__n < "
            "this->size()' failed.\n"),
     "crashed", "operator[]: Assertion '__n < this->size()' failed at stl_vector.h:1045"},
    {"CGAL's assertion",
     killed(
         SIGABRT,
         "terminate called after throwing an instance of 'CGAL::Assertion_exception'\n  what():  CGAL ERROR: "
         "assertion violation!\nExpr: i < 4\nFile: /usr/include/CGAL/Triangulation_3.h\nLine: 812\n"),
     "crashed", "CGAL: i < 4 at Triangulation_3.h:812"},
    {"an exception",
     killed(SIGABRT,
            "terminate called after throwing an instance of 'std::out_of_range'\n  what():  "
            "vector::_M_range_check: __n (which is 18) >= this->size()\n"),
     "crashed", "uncaught std::out_of_range: vector::_M_range_check: __n (which is #) >= this->size()"},
    {"the heap", killed(SIGABRT, "double free or corruption (out)\n"), "crashed", "heap corruption"},
    {"a signal", killed(SIGSEGV, "Info : 3D\n"), "crashed", "SIGSEGV"},
    {"a signal through a shell", exited(139, "Segmentation fault\n"), "crashed", "SIGSEGV"},
    {"AddressSanitizer",
     exited(
         1,
         "==77==ERROR: AddressSanitizer: heap-use-after-free on address 0x6020 at pc 0x55\nREAD of size 4\n"
         "    #0 0x55 in malloc (/lib/libasan.so)\n    #1 0x56 in flip(Tet*, int) /src/flip.cpp:3\n"),
     "crashed", "AddressSanitizer: heap-use-after-free in flip"},
    {"UndefinedBehaviorSanitizer that goes on",
     exited(0, "/src/a.cpp:12:5: runtime error: signed integer overflow: 7\n"), "crashed",
     "UndefinedBehaviorSanitizer: signed integer overflow: # at a.cpp:12"},
    {"Gmsh finds a claim",
     exited(1,
            "Error   : Invalid boundary mesh (overlapping facets) on surface 1 surface 1\n"
            "Error   : No elements in volume 1 \n"),
     "refused-valid", "Error : Invalid boundary mesh (overlapping facets) on surface # surface #"},
    {"Gmsh gives up", exited(1, "Error   : HXT 3D mesh failed\nError   :     0 warnings\n"), "refused",
     "Error : HXT #D mesh failed"},
    {"HXT names a point",
     exited(1,
            "PLC Error:  A segment and a facet intersect at point (0.8,-0.1,1e-05).\nError   : HXT 3D mesh "
            "failed\n"),
     "refused-valid", "PLC Error: A segment and a facet intersect at point (#,#,#)."},
    {"Netgen", exited(1, "Error: Stop meshing since boundary mesh is overlapping\n"), "refused-valid",
     "Error: Stop meshing since boundary mesh is overlapping"},
    {"absent", exited(1, "Error   : Frontal algorithm requires Netgen\n"), "not-compiled-in",
     "Error : Frontal algorithm requires Netgen"},
    {"absent, and it goes on",
     exited(0, "Warning : This version of Gmsh is not compiled with MMG support: skipping refinement\n"),
     "not-compiled-in",
     "Warning : This version of Gmsh is not compiled with MMG support: skipping refinement"},
    {"no memory",
     killed(SIGABRT,
            "terminate called after throwing an instance of 'std::bad_alloc'\n  what():  "
            "std::bad_alloc\n"),
     "out-of-memory", "terminate called after throwing an instance of 'std::bad_alloc'"},
    {"killed by the kernel", killed(SIGKILL, "working\n"), "out-of-memory", "killed by SIGKILL"},
    {"says nothing", exited(4, ""), "refused", "exit code 4"},
};

TEST(EndClass, OfWhatMeshersPrint) {
  for (const Case& c : cases) {
    const EndClass found = classify_end(c.end);
    EXPECT_STREQ(found.failure ? name_of(*found.failure) : "", c.outcome) << c.name;
    EXPECT_EQ(found.signature, c.signature) << c.name;
  }
}

TEST(EndClass, WordsOfACrashBeforeASuccessAreNone) {
  EXPECT_FALSE(classify_end(exited(0, "caught signal handler installed\nfree(): is fine\n")).failure);
}

// Which words the C library has for a damaged heap differs from run to run.
TEST(EndClass, ADamagedHeapIsOneSignature) {
  for (const char* words :
       {"corrupted size vs. prev_size\n", "free(): invalid size\n",
        "malloc(): unaligned tcache chunk detected\n", "munmap_chunk(): invalid pointer\n"}) {
    const EndClass found = classify_end(killed(SIGABRT, words));
    EXPECT_EQ(found.failure, Outcome::crashed);
    EXPECT_EQ(found.signature, "heap corruption") << words;
    EXPECT_EQ(found.message + "\n", words);
    EXPECT_FALSE(found.wants_backtrace);
  }
}

TEST(EndClass, ABannerIsNoVerdict) {
  EXPECT_FALSE(classify_end(exited(0, "Info : compiled without OpenMP\n")).failure);
  EXPECT_EQ(classify_end(exited(1, "Info : compiled without OpenMP\n")).failure, Outcome::not_compiled_in);
  EXPECT_EQ(classify_end(exited(0, "Warning : Netgen is not compiled in\n")).failure,
            Outcome::not_compiled_in);
  EXPECT_EQ(
      classify_end(exited(1, "Checking for overlapping facets\n0 overlapping facets\nError: too thin\n"))
          .failure,
      Outcome::refused);
}

TEST(EndClass, SignalsFromOutsideAreNoCrashes) {
  EXPECT_EQ(classify_end(killed(SIGTERM, "")).failure, Outcome::not_judged);
  EXPECT_EQ(classify_end(exited(128 + SIGKILL, "")).failure, Outcome::out_of_memory);  // through a shell
  EXPECT_EQ(classify_end(exited(128 + SIGSEGV, "")).failure, Outcome::crashed);
}

TEST(EndClass, LimitsComeFirst) {
  ProcessEnd end = killed(SIGKILL, "Error: self-intersecting\n");
  end.limit = Limit::cpu;
  EXPECT_EQ(classify_end(end).failure, Outcome::slow);
  end.limit = Limit::memory;
  EXPECT_EQ(classify_end(end).failure, Outcome::out_of_memory);
}

TEST(EndClass, AsksForABacktraceWhereWordsDoNotSayThePlace) {
  EXPECT_TRUE(classify_end(killed(SIGSEGV, "")).wants_backtrace);
  EXPECT_TRUE(classify_end(killed(SIGABRT, "stack smashing detected\n")).wants_backtrace);
  EXPECT_FALSE(classify_end(killed(SIGABRT, "a: b.c:1: f: Assertion `x' failed.\n")).wants_backtrace);
}

TEST(EndClass, WarningsOnceAndCounted) {
  std::string output =
      "Warning:  Point 3 is replaced by point 1.\nInfo : fine\nWarning:  Point 3 is replaced by point 1.\n";
  EXPECT_EQ(classify_end(exited(0, output)).warnings,
            std::vector<std::string>{"Warning:  Point 3 is replaced by point 1."});
  for (int i = 0; i < 60; ++i) output += "Warning: " + std::to_string(i) + "\n";
  const auto warnings = classify_end(exited(0, output)).warnings;
  ASSERT_EQ(warnings.size(), 51u);
  EXPECT_EQ(warnings.back(), "and 11 more such lines");
}

TEST(OutputLines, WithoutNumbers) {
  EXPECT_EQ(without_numbers("at 0x7ffe12 in /tmp/a1/b.geo:17, -3.5e-7 of 12  points"),
            "at ADDRESS in b.geo:#, # of # points");
  EXPECT_EQ(without_numbers("tet2 v3.x HXT 3D 'dir/x.msh'"), "tet2 v3.x HXT #D 'x.msh'");
  EXPECT_EQ(without_numbers(std::string(1000, 'a')).size(), 160u);
}

TEST(OutputLines, WithoutColoursAndOverwrittenText) {
  EXPECT_EQ(output_lines("\x1b[1;31mError\x1b[0m\r\n10%\r100%\nend"),
            (std::vector<std::string>{"Error", "100%", "end"}));
}

TEST(CrashWords, NamesOfFunctions) {
  EXPECT_EQ(function_name("int tetgenmesh::insertpoint_cdt(point, triface*)"), "insertpoint_cdt");
  EXPECT_EQ(function_name("void a::{anonymous}::f<std::pair<int, int> >(T) [with T = int]"), "f");
  EXPECT_EQ(function_name("const T& A<B::C>::operator()(int) const"), "operator()");
  EXPECT_EQ(function_name("main"), "main");
  // As gdb prints a frame, with and without the program's debug information.
  EXPECT_EQ(function_name("tetgenmesh::split_segment (this=...) at tetgen.cxx:27107"), "split_segment");
  EXPECT_EQ(function_name("terminatetetgen () at a/tetgen.h:2523"), "terminatetetgen");
  EXPECT_EQ(function_name("meshGRegionHxt(std::vector<GRegion*>&) () from /lib/libgmsh.so"),
            "meshGRegionHxt");
}

}  // namespace
}  // namespace tetproof::corpus
