// SPDX-License-Identifier: GPL-3.0-or-later
// Plants defects in sound meshes: the kind of defect is chosen by name, the place by a seed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/truth.hpp"
#include "io/tet_mesh.hpp"

namespace tetproof::corpus {

/// The verdict that a judge should reach on a mesh. Debatable: a valid triangulation that hardly anyone
/// intended.
enum class Expected { sound, debatable, defective };
const char* name_of(Expected);

struct Parts;
struct Site;

/// A kind of mutation. Written with designated initialisers; members that a kind does not need are left out.
/// Ids of checks are those of `tetproof-verify --list-checks`.
struct PlantKind {
  const char* id = "";
  /// Absent: the truth about the mutated mesh decides (corpus/truth.hpp).
  std::optional<Expected> expected = {};
  std::vector<const char*> flags = {};  ///< what it is about: "orientation", "overlap", "rounding", ...
  /// Checks. At least one of them must be reported as a root cause and name the place.
  std::vector<const char*> needed = {};
  std::vector<const char*> also = {};  ///< further checks that may be reported as root causes
  const char* comment = "";            ///< one line for users
  /// Plants the defect. False: this attempt found no place for it. Null: two other kinds are planted instead.
  bool (*mutate)(Site&) = nullptr;
  /// If `mutate` is null: the ids of these two kinds. Null: random ones.
  const char* first = nullptr;
  const char* second = nullptr;

  bool has(std::string_view flag) const;
};

/// All kinds, in the order of their themes. Some flags change how a kind is planted and judged:
/// "whole": the kind changes the whole mesh; it is planted only in small meshes.
/// "slit": defective because nobody intends such a mesh, even where exact arithmetic finds it valid.
/// "campaign": only for the mutation campaign, not for the files of corpus/bad-meshes.
const std::vector<PlantKind>& plant_kinds();
/// The kind with this id. Throws InputError, which names the id, if there is none.
const PlantKind& plant_kind(std::string_view id);

/// A root cause that a report has to name.
struct PlantedRoot {
  std::vector<std::string> ids;       ///< by at least one of these checks
  std::vector<Index> tets, vertices;  ///< at one of these tetrahedra or vertices
};

/// A mutated mesh and what is known about it.
struct Planted {
  TetMesh mesh{};
  Expected expected = Expected::sound;
  std::vector<Index> tets;      ///< tetrahedra that were added or changed, and the neighbours of removed ones
  std::vector<Index> vertices;  ///< vertices that were added or moved, and those of removed tetrahedra
  std::vector<PlantedRoot> needed;      ///< a report must name every one of these
  std::vector<std::string> admissible;  ///< the ids of all checks that may be reported as root causes
  Truth truth;                          ///< of the changed tetrahedra
};

/// A sound mesh in which defects are planted, with its adjacency.
class Ground {
 public:
  explicit Ground(TetMesh mesh);
  ~Ground();
  Ground(Ground&&) noexcept;

  const TetMesh& mesh() const;
  const Parts& parts() const { return *parts_; }

 private:
  std::unique_ptr<const Parts> parts_;
};

/// Kinds with the flag "whole" are not planted in meshes with more tetrahedra than this, because the truth
/// about all pairs would take too long.
inline constexpr std::size_t most_tets_for_whole = 4000;

/// Plants one mutation. The same arguments give the same result. An attempt that changes nothing, or whose
/// result is not what the kind promises (decided by exact arithmetic), is discarded, and another place is
/// tried. Nothing is returned if no place is found.
std::optional<Planted> plant(const PlantKind& kind, const Ground& ground, std::uint64_t seed);

}  // namespace tetproof::corpus
