// SPDX-License-Identifier: GPL-3.0-or-later
// A mesher to be tested: a command line, a preset for a known mesher, or a C++ function.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "corpus/meshing/outcome.hpp"
#include "corpus/meshing/process.hpp"
#include "io/document.hpp"
#include "io/tet_mesh.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

/// What a mesher did with a surface, before anyone judged its mesh.
struct MesherRun {
  /// Absent: it ended with success and wrote a file that can be read (`mesh` holds it).
  std::optional<Outcome> failure{};
  /// What tells this failure from others, without numbers, paths and addresses that change from run to run:
  /// "insertpoint_cdt: Assertion `x' failed at tetgen.cxx:123", "SIGSEGV in f < g < h", a refusal's words.
  std::string signature{};
  std::string message{};                ///< the line of the output that says most, as it stands there
  std::string output{};                 ///< all that it printed, the middle cut where long
  std::vector<std::string> warnings{};  ///< lines of the output that say that something was lost or changed
  std::shared_ptr<const Document> document{};  ///< the file as read
  TetMesh mesh{};
  Numbering numbering{};
  /// Decimal digits with which the file writes coordinates, if it is text: the rounding of its coordinates is
  /// no defect. 0: binary, or all digits of a double (17).
  int digits = 0;
  std::string mesh_file{};  ///< the file that it wrote, in the folder
  std::string program{};    ///< what was run, with its path; empty: found in PATH, or no program
  /// The surface as the mesher got it, if its format rounds coordinates (STL); null: the surface itself.
  std::shared_ptr<const TriangleSurface> given{};
  double cpu_s = 0, wall_s = 0;
  std::int64_t peak_mb = 0;
};

/// A mesher. `run` may be called by several threads at once, each with a folder of its own.
class Mesher {
 public:
  virtual ~Mesher() = default;
  /// Meshes the surface within the limits. `folder` exists; the surface and the mesh stay there.
  virtual MesherRun run(const TriangleSurface& surface, const std::string& folder,
                        const Limits& limits) const = 0;
  virtual std::string name() const = 0;     ///< "tetgen,pq": the preset and variant; or the program's name
  virtual std::string command() const = 0;  ///< with {surface} and {mesh}, as a user would type it
  virtual std::string version() const = 0;  ///< what it says of itself, one line; empty: unknown
  virtual std::string surface_ending() const = 0;  ///< ".stl", ".smesh", ...; empty: none is written
  /// Whether it may remesh the surface, within `fidelity`. If not, the boundary must be the surface.
  virtual bool may_change_boundary() const = 0;
  /// The distance that boundary and surface may have [box diagonal], if it may change the boundary.
  virtual double fidelity() const = 0;
  /// Whether it works on a lattice that loses what is thinner than a cell, and says so. Parts that are
  /// missing and another topology are then no defects, as in `verify::Options::coarse`.
  virtual bool coarse() const { return false; }
  virtual int repeats() const = 0;  ///< runs of each case: more than 1 for meshers that are not deterministic
};

/// What is to be run in place of a preset.
struct CommandMesher {
  std::vector<std::string>
      words;  ///< with {surface}, {mesh}; {box}, {size}: the diagonal, and a size [length]
  std::string surface_ending = ".off";
  std::string mesh_ending = ".msh";
  std::string name{};
  int repeats = 1;
};
std::unique_ptr<Mesher> command_mesher(CommandMesher command);

/// The mesher of "NAME" or "NAME,VARIANT". InputError, with the known names, if there is none, or if its
/// program is not installed. `program_path`: a program to run in place of the installed one; the variable
/// TETPROOF_NAME ("TETPROOF_CGAL" for "cgal") names one, too. Without either, programs beside this one or in
/// the folders above it come before those in PATH.
std::unique_ptr<Mesher> preset_mesher(const std::string& name, const std::string& program_path = "");
/// All presets with their variants, commands and what they are for; with installed versions: a text for
/// users.
std::string list_presets();
/// The names of a preset's variants: "tetgen,pq", "tetgen,pY", ...
std::vector<std::string> preset_variants(const std::string& name);

/// A C++ function as a mesher. It throws to refuse; the limits do not apply to it.
using MeshFunction = std::function<TetMesh(const TriangleSurface&)>;
std::unique_ptr<Mesher> function_mesher(MeshFunction function, std::string name = "function");

}  // namespace tetproof::corpus
