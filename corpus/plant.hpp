// SPDX-License-Identifier: GPL-3.0-or-later
// Plants defects in sound meshes: kinds that are known by name, at places that a seed chooses.
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

/// What a judge should make of a mesh. Debatable: a valid triangulation that hardly anyone meant.
enum class Expected { sound, debatable, defective };
const char* name_of(Expected);

struct Parts;
struct Site;

/// A kind of mutation. Ids of checks are those of `tetproof-verify --list-checks`.
struct PlantKind {
  const char* id;
  std::optional<Expected> expected;  ///< absent: what is true of the mutated mesh decides
  std::vector<const char*> flags;    ///< what it is about: "orientation", "overlap", "rounding", ...
  std::vector<const char*> needed;   ///< one of them at least is reported as a root cause and names the place
  std::vector<const char*> also;     ///< others that may be reported beside it
  const char* comment;               ///< one line
  bool (*mutate)(Site&);             ///< false: no such place here
  const char* first = nullptr;       ///< ids of two others, planted far from each other
  const char* second = nullptr;

  bool has(std::string_view flag) const;
};

/// All kinds, in the order of their themes. Flag "whole": concerns the whole mesh. "slit": defective by what
/// was meant, though exact arithmetic may find it valid.
const std::vector<PlantKind>& plant_kinds();
/// InputError naming the id when there is none.
const PlantKind& plant_kind(std::string_view id);

/// What a report has to name as a root cause.
struct PlantedRoot {
  std::vector<std::string> ids;       ///< one of these checks
  std::vector<Index> tets, vertices;  ///< at one of these
};

/// A mutated mesh and what is known of it.
struct Planted {
  TetMesh mesh{};
  Expected expected = Expected::sound;
  std::vector<Index> tets;      ///< those that were added or changed, and those beside which one was left out
  std::vector<Index> vertices;  ///< those that were added or moved, and those of tetrahedra left out
  std::vector<PlantedRoot> needed;      ///< each
  std::vector<std::string> admissible;  ///< all ids that may be root causes
  Truth truth;                          ///< around what was changed
};

/// A sound mesh in which to plant, with how its parts hang together.
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

/// Kinds that concern the whole mesh are not planted in larger ones: what is true of all pairs would take too
/// long.
inline constexpr std::size_t most_tets_for_whole = 4000;

/// Plants one mutation: same arguments, same result. What changed nothing, or did not bring about what the
/// kind promises (decided by exact arithmetic), is discarded and tried elsewhere; nothing when no place was
/// found.
std::optional<Planted> plant(const PlantKind& kind, const Ground& ground, std::uint64_t seed);

}  // namespace tetproof::corpus
