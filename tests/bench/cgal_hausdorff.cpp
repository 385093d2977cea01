// SPDX-License-Identifier: GPL-3.0-or-later
// Both directed Hausdorff distances of two surfaces by verify/hausdorff.hpp and by CGAL's
// bounded_error_Hausdorff_distance, in one run, for the same absolute error. CGAL on one thread (its parallel
// variant wants METIS), tetproof on all and on one.
// usage: cgal_hausdorff A B [ERROR in units of A's box diagonal, 1e-4]     A and B: files, or
// sphere:r=1,n=100000
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Surface_mesh.h>
#include <fmt/core.h>
#include <tbb/global_control.h>

#include <chrono>
#include <cstdlib>
#include <exception>

#include "corpus/surfaces.hpp"
#include "verify/hausdorff.hpp"

namespace {

using namespace tetproof;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Mesh cgal(const TriangleSurface& surface) {
  Mesh mesh;
  for (const Eigen::Vector3d& p : surface.vertices) mesh.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
  for (const auto& [a, b, c] : surface.triangles)
    mesh.add_face(Mesh::Vertex_index(static_cast<unsigned>(a)), Mesh::Vertex_index(static_cast<unsigned>(b)),
                  Mesh::Vertex_index(static_cast<unsigned>(c)));
  return mesh;
}

template <class Work>
double seconds(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

int compare(const std::string& name_a, const std::string& name_b, double share) {
  const TriangleSurface a = corpus::open_surface(name_a), b = corpus::open_surface(name_b);
  Eigen::Vector3d low = a.vertices.at(0), high = low;
  for (const Eigen::Vector3d& p : a.vertices) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const double diagonal = (high - low).norm(), error = share * diagonal;
  fmt::print("{} and {} triangles, error {} of the diagonal {}\n", a.triangles.size(), b.triangles.size(),
             share, diagonal);
  verify::DirectedDistance there, back;
  const auto measure = [&](double relative) {
    const verify::HausdorffOptions options{.error = error, .relative = relative};
    return seconds([&] {
      there = verify::directed_hausdorff(a.vertices, a.triangles, b.vertices, b.triangles, options);
      back = verify::directed_hausdorff(b.vertices, b.triangles, a.vertices, a.triangles, options);
    });
  };
  const auto print = [&](const char* what, double time) {
    fmt::print("{:<28}{:9.3f} s   [{:.6g}, {:.6g}] there, [{:.6g}, {:.6g}] back, of the diagonal\n", what,
               time, there.lower / diagonal, there.upper / diagonal, back.lower / diagonal,
               back.upper / diagonal);
  };
  const double ours = measure(0);
  print("tetproof", ours);
  double alone = 0;
  {
    tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    alone = measure(0);
    print("tetproof, one thread", alone);
  }
  print("tetproof, to a tenth of it", measure(0.1));
  const Mesh mesh_a = cgal(a), mesh_b = cgal(b);
  double cgal_there = 0, cgal_back = 0;
  const double theirs = seconds([&] {
    namespace pmp = CGAL::Polygon_mesh_processing;
    cgal_there = pmp::bounded_error_Hausdorff_distance<CGAL::Sequential_tag>(mesh_a, mesh_b, error);
    cgal_back = pmp::bounded_error_Hausdorff_distance<CGAL::Sequential_tag>(mesh_b, mesh_a, error);
  });
  fmt::print("{:<28}{:9.3f} s   {:.6g} there, {:.6g} back, of the diagonal\n", "CGAL " CGAL_VERSION_STR,
             theirs, cgal_there / diagonal, cgal_back / diagonal);
  fmt::print("CGAL takes {:.1f} times as long, {:.1f} times one thread\n", theirs / ours, theirs / alone);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "usage: cgal_hausdorff A B [ERROR in units of A's box diagonal, 1e-4]\n");
    return 2;
  }
  try {
    return compare(argv[1], argv[2], argc > 3 ? std::atof(argv[3]) : 1e-4);
  } catch (const std::exception& error) {
    fmt::print(stderr, "cgal_hausdorff: {}\n", error.what());
    return 2;
  }
}
