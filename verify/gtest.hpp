// SPDX-License-Identifier: GPL-3.0-or-later
// GoogleMock matchers for the tests of a mesher. Only this header of the library needs GoogleMock.
//
//   EXPECT_THAT(mesh, IsSound());
//   EXPECT_THAT(mesh, IsCertified());
//   EXPECT_THAT(mesh, Fills(surface, 1e-3));
//   EXPECT_THAT(std::filesystem::path("out/part.msh"), Fills("part.stl", 1e-3));
//
// A failure message has the first findings of the report: the cause, the elements, the place.
#pragma once

#include <gmock/gmock.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "io/error.hpp"
#include "io/mesh_files.hpp"
#include "io/surface_files.hpp"
#include "verify/findings_text.hpp"
#include "verify/verify.hpp"

namespace tetproof {

/// Prints a mesh in GoogleTest's messages.
inline void PrintTo(const TetMesh& mesh, std::ostream* out) {
  *out << "a mesh of " << mesh.tets.size() << " tetrahedra and " << mesh.points.size() << " points";
}

namespace verify {
namespace gtest_internal {

/// The number of findings in a message; `tetproof-verify` lists more.
inline constexpr std::size_t findings_told = 5;

/// Judges a TetMesh, whose points and tetrahedra are numbered from 0, or a mesh file, given by its
/// std::filesystem::path or its name, with the numbers of the file. A file with elements that are not judged,
/// because they are no tetrahedra or were not read, is not matched. A file that cannot be read is an
/// InputError, which fails the test, under `Not` too.
class Judge {
 public:
  enum class Wanted { sound, certified, filled };

  Judge(Wanted wanted, Options options) : wanted_(wanted), options_(std::move(options)) {
    options_.quality = false;
  }
  Judge(TriangleSurface surface, Options options, SurfaceNumbering numbering = {})
      : Judge(Wanted::filled, std::move(options)) {
    if (options_.region == Region::none) options_.region = Region::inside;
    surface_ = std::make_shared<const TriangleSurface>(std::move(surface));
    judged_ = std::make_shared<const JudgedSurface>(*surface_, std::move(numbering));
    if (const std::string& fault = judged_->report().fault; !fault.empty()) throw InputError(fault);
  }

  bool MatchAndExplain(const TetMesh& mesh, testing::MatchResultListener* listener) const {
    return judge(mesh, {}, options_, listener);
  }
  bool MatchAndExplain(const std::filesystem::path& file, testing::MatchResultListener* listener) const {
    const Document document = read_document(file.string());
    Options options = options_;
    options.unjudged = unjudged(document);
    const std::vector<NotJudged>& of_surface = options_.unjudged.unread;
    options.unjudged.unread.insert(options.unjudged.unread.end(), of_surface.begin(), of_surface.end());
    return judge(tet_mesh(document), numbering(document), options, listener);
  }

  void DescribeTo(std::ostream* out) const { *out << "is " << description(); }
  void DescribeNegationTo(std::ostream* out) const { *out << "is not " << description(); }

 private:
  bool judge(const TetMesh& mesh, const Numbering& numbers, const Options& options,
             testing::MatchResultListener* listener) const {
    if (mesh.tets.empty()) {
      *listener << "which has no tetrahedra";
      return false;
    }
    const Report report = judged_ ? verify(mesh, *judged_, options) : verify(mesh, options);
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

/// Matches a mesh, or a mesh file, if no check fails and everything was judged.
inline auto IsSound(Options options = {}) {
  return testing::MakePolymorphicMatcher(
      gtest_internal::Judge(gtest_internal::Judge::Wanted::sound, std::move(options)));
}

/// Matches a sound mesh with a certificate: no check that the proof needs was skipped.
inline auto IsCertified() {
  return testing::MakePolymorphicMatcher(gtest_internal::Judge(gtest_internal::Judge::Wanted::certified, {}));
}

/// Matches a sound mesh that fills the surface within `options.fidelity`, in units of the surface's box
/// diagonal; `options.region` none means inside. The surface is judged here, once: InputError when it is not
/// usable.
inline auto Fills(TriangleSurface surface, Options options) {
  return testing::MakePolymorphicMatcher(gtest_internal::Judge(std::move(surface), std::move(options)));
}
/// The surface of a file. InputError when it cannot be read.
inline auto Fills(const std::filesystem::path& surface, Options options) {
  SurfaceFile file = read_surface_file(surface.string());
  add_unread_surface(options.unjudged, file.dropped);
  return testing::MakePolymorphicMatcher(
      gtest_internal::Judge(std::move(file.surface), std::move(options), std::move(file.numbering)));
}
/// The inside of the surface, within `tolerance` box diagonals; 0: the surface exactly.
inline auto Fills(TriangleSurface surface, double tolerance) {
  Options options;
  options.fidelity = tolerance;
  return Fills(std::move(surface), std::move(options));
}
inline auto Fills(const std::filesystem::path& surface, double tolerance) {
  Options options;
  options.fidelity = tolerance;
  return Fills(surface, std::move(options));
}

}  // namespace verify
}  // namespace tetproof
