// SPDX-License-Identifier: GPL-3.0-or-later
// GoogleMock matchers for the tests of a mesher. Who includes this header needs GoogleMock; nothing else of
// the library does.
//
//   EXPECT_THAT(mesh, IsSound());
//   EXPECT_THAT(mesh, IsCertified());
//   EXPECT_THAT(mesh, Fills(surface, 1e-3));
//   EXPECT_THAT(std::filesystem::path("out/part.msh"), Fills("part.stl", 1e-3));
//
// A failure tells what the report finds first: the cause, the elements, the place.
#pragma once

#include <gmock/gmock.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <utility>

#include "io/error.hpp"
#include "io/mesh_files.hpp"
#include "io/surface_files.hpp"
#include "verify/findings_text.hpp"
#include "verify/verify.hpp"

namespace tetproof {

/// What GoogleTest prints of a mesh.
inline void PrintTo(const TetMesh& mesh, std::ostream* out) {
  *out << "a mesh of " << mesh.tets.size() << " tetrahedra and " << mesh.points.size() << " points";
}

namespace verify {
namespace gtest_internal {

/// So many findings are told; `tetproof-verify` lists them all.
inline constexpr std::size_t findings_told = 5;

/// Judges what it is given: a TetMesh, whose points and tetrahedra are numbered from 0, or a mesh file by its
/// std::filesystem::path or its name, with the numbers of the file. A file that cannot be read is an
/// InputError, which fails the test, under `Not` too.
class Judge {
 public:
  enum class Wanted { sound, certified, filled };

  Judge(Wanted wanted, Options options) : wanted_(wanted), options_(std::move(options)) {
    options_.quality = false;
  }
  Judge(TriangleSurface surface, Options options) : Judge(Wanted::filled, std::move(options)) {
    if (options_.region == Region::none) options_.region = Region::inside;
    surface_ = std::make_shared<const TriangleSurface>(std::move(surface));
    judged_ = std::make_shared<const JudgedSurface>(*surface_);
    if (const std::string& fault = judged_->report().fault; !fault.empty()) throw InputError(fault);
  }

  bool MatchAndExplain(const TetMesh& mesh, testing::MatchResultListener* listener) const {
    return judge(mesh, {}, listener);
  }
  bool MatchAndExplain(const std::filesystem::path& file, testing::MatchResultListener* listener) const {
    const Document document = read_document(file.string());
    return judge(tet_mesh(document), numbering(document), listener);
  }

  void DescribeTo(std::ostream* out) const { *out << "is " << description(); }
  void DescribeNegationTo(std::ostream* out) const { *out << "is not " << description(); }

 private:
  bool judge(const TetMesh& mesh, const Numbering& numbers, testing::MatchResultListener* listener) const {
    if (mesh.tets.empty()) {
      *listener << "which has no tetrahedra";
      return false;
    }
    const Report report = judged_ ? verify(mesh, *judged_, options_) : verify(mesh, options_);
    if (listener->IsInterested()) *listener << "which is " << failure_text(report, numbers, findings_told);
    return sound(report) && (wanted_ != Wanted::certified || report.certificate == true);
  }

  std::string description() const {
    switch (wanted_) {
      case Wanted::sound:
        return "a sound tetrahedral mesh";
      case Wanted::certified:
        return "a sound tetrahedral mesh, certified to be a valid triangulation of a solid";
      case Wanted::filled:
        break;
    }
    return std::string("a sound tetrahedral mesh that fills the ") +
           (options_.region == Region::outside ? "outside" : "inside") + " of a surface of " +
           std::to_string(surface_->triangles.size()) + " triangles within " +
           testing::PrintToString(options_.fidelity) + " of its box diagonal";
  }

  Wanted wanted_;
  Options options_;
  std::shared_ptr<const TriangleSurface> surface_;
  std::shared_ptr<const JudgedSurface> judged_;
};

}  // namespace gtest_internal

/// Matches a mesh, or a mesh file, of which no check fails.
inline auto IsSound(Options options = {}) {
  return testing::MakePolymorphicMatcher(
      gtest_internal::Judge(gtest_internal::Judge::Wanted::sound, std::move(options)));
}

/// Matches a sound mesh whose certificate holds: no check that the proof needs was skipped.
inline auto IsCertified() {
  return testing::MakePolymorphicMatcher(gtest_internal::Judge(gtest_internal::Judge::Wanted::certified, {}));
}

/// Matches a sound mesh that fills the surface within `options.fidelity`, in units of the surface's box
/// diagonal; `options.region` none means inside. The surface is judged here, once: InputError when it is not
/// usable.
inline auto Fills(TriangleSurface surface, Options options) {
  return testing::MakePolymorphicMatcher(gtest_internal::Judge(std::move(surface), std::move(options)));
}
/// Of a surface file. InputError when it cannot be read.
inline auto Fills(const std::filesystem::path& surface, Options options) {
  return Fills(read_surface(surface.string()), std::move(options));
}
/// The inside, within `tolerance` box diagonals; 0: the surface exactly.
inline auto Fills(TriangleSurface surface, double tolerance) {
  Options options;
  options.fidelity = tolerance;
  return Fills(std::move(surface), std::move(options));
}
inline auto Fills(const std::filesystem::path& surface, double tolerance) {
  return Fills(read_surface(surface.string()), tolerance);
}

}  // namespace verify
}  // namespace tetproof
