// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's Mesh_3 as a program to measure beside ours: it reads a closed surface, refines, and writes a .mesh
// file. usage: cgal_mesh3 SURFACE.off GRID.mesh CELL_SIZE FACET_DISTANCE [optimise]
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/version.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Domain = CGAL::Polyhedral_mesh_domain_3<Surface, Kernel>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

int main(int argc, char** argv) {
  if (argc == 2 && std::string(argv[1]) == "--version") {
    std::cout << "CGAL " << CGAL_VERSION_STR << "\n";
    return 0;
  }
  if (argc < 5) {
    std::cerr << "usage: cgal_mesh3 SURFACE.off GRID.mesh CELL_SIZE FACET_DISTANCE [optimise]\n";
    return 2;
  }
  Surface surface;
  std::ifstream in(argv[1]);
  if (!(in >> surface) || !CGAL::is_closed(surface)) {
    std::cerr << argv[1] << ": not a closed surface in OFF\n";
    return 2;
  }
  const double cell_size = std::atof(argv[3]), facet_distance = std::atof(argv[4]);
  const Domain domain(surface);
  // The angle and the ratio of CGAL's own examples.
  namespace p = CGAL::parameters;
  const Criteria criteria(p::facet_angle = 25, p::facet_size = cell_size, p::facet_distance = facet_distance,
                          p::cell_radius_edge_ratio = 3, p::cell_size = cell_size);
  const Complex grid = argc > 5 && std::string(argv[5]) == "optimise"
                           ? CGAL::make_mesh_3<Complex>(domain, criteria)
                           : CGAL::make_mesh_3<Complex>(domain, criteria, p::no_perturb(), p::no_exude());
  std::ofstream out(argv[2]);
  grid.output_to_medit(out);
  std::cout << grid.number_of_cells_in_complex() << " tetrahedra\n";
  return out.good() ? 0 : 1;
}
