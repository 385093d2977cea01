// SPDX-License-Identifier: GPL-3.0-or-later
// Matches faces in linear time. Each face goes to the range that holds its smallest vertex. Each range is
// sorted by that vertex, and the few faces that share it are sorted by their other two vertices.
#include "verify/mesh/faces.hpp"

#include <fmt/core.h>
#include <sys/mman.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <new>
#include <numeric>
#include <utility>

#include "io/error.hpp"

namespace tetproof::verify {
namespace {

struct Record {
  std::uint64_t key;  // middle vertex, largest vertex, and whether an odd permutation sorted the vertices
  std::uint32_t smallest;
  FaceId face;
};

constexpr std::uint64_t same_vertices = ~std::uint64_t{1};

Record record_of(const std::array<Index, 4>& tet, int f, FaceId face) {
  auto [a, b, c] = std::array{tet[tet_faces[f][0]], tet[tet_faces[f][1]], tet[tet_faces[f][2]]};
  bool odd = false;
  if (a > b) std::swap(a, b), odd = !odd;
  if (b > c) std::swap(b, c), odd = !odd;
  if (a > b) std::swap(a, b), odd = !odd;
  return {std::uint64_t(b) << 32 | std::uint64_t(c) << 1 | std::uint64_t(odd), static_cast<std::uint32_t>(a),
          face};
}

bool before(const Record& a, const Record& b) {
  return a.key != b.key ? a.key < b.key : a.face < b.face;
}

// Uninitialised memory for the records, in large pages where the system has them. With pages of 4 KiB, the
// page faults for 64 bytes a tetrahedron take a third as long as the matching itself.
struct Room {
  explicit Room(std::size_t count) {
    constexpr std::size_t page = std::size_t{1} << 21;
    const std::size_t bytes = std::max(page, (count * sizeof(Record) + page - 1) / page * page);
    memory.reset(static_cast<Record*>(std::aligned_alloc(page, bytes)));
    if (!memory) throw std::bad_alloc();
    ::madvise(memory.get(), bytes, MADV_HUGEPAGE);
  }
  struct Free {
    void operator()(Record* p) const { std::free(p); }
  };
  std::unique_ptr<Record[], Free> memory;
};

// A vertex usually has a dozen or two of these faces, but a fan may have a million.
void sort_faces_of_vertex(Record* begin, Record* end) {
  if (end - begin > 48) return std::sort(begin, end, before);
  for (Record* i = begin + 1; i < end; ++i) {
    const Record record = *i;
    Record* j = i;
    for (; j > begin && record.key < j[-1].key; --j)
      *j = j[-1];  // stable, so equal keys keep ascending faces
    *j = record;
  }
}

void append(FaceGroups& groups, const Record* begin, const Record* end) {
  groups.starts.push_back(groups.faces.size());
  for (; begin < end; ++begin) groups.faces.push_back(begin->face);
}

void append(FaceGroups& groups, const FaceGroups& more) {
  for (const std::size_t start : more.starts) groups.starts.push_back(groups.faces.size() + start);
  groups.faces.insert(groups.faces.end(), more.faces.begin(), more.faces.end());
}

// Matches the records of one range of smallest vertices. They come in any order.
void match_range(const Record* begin, const Record* end, std::uint32_t lowest, std::uint32_t width,
                 FaceMatching& found) {
  std::vector<std::uint32_t> start(width + 1, 0);
  for (const Record* r = begin; r < end; ++r) ++start[r->smallest - lowest + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  const auto sorted = std::make_unique_for_overwrite<Record[]>(static_cast<std::size_t>(end - begin));
  for (const Record* r = begin; r < end; ++r) sorted[next[r->smallest - lowest]++] = *r;
  for (std::uint32_t v = 0; v < width; ++v) {
    Record* const last = sorted.get() + start[v + 1];
    Record* i = sorted.get() + start[v];
    sort_faces_of_vertex(i, last);
    while (i < last) {
      Record* j = i + 1;
      while (j < last && ((i->key ^ j->key) & same_vertices) == 0) ++j;
      if (j - i == 1)
        found.boundary.push_back(i->face);
      else if (j - i > 2)
        append(found.thrice, i, j);
      else if (i[0].key == i[1].key)
        append(found.same_side, i, j);
      i = j;
    }
  }
}

}  // namespace

FaceMatching match_faces(const TetMesh& mesh, const std::vector<std::uint8_t>& excluded) {
  const std::size_t tets = mesh.tets.size();
  if (tets >= std::size_t{1} << 30)
    throw InputError(fmt::format("{} tetrahedra, at most 2^30 - 1 are supported", tets));

  // Each range has a power of two of vertices and some 8000 faces, so that its work stays in the cache.
  const std::size_t points = std::max<std::size_t>(mesh.points.size(), 1);
  int shift = 0;
  while ((points >> shift) * 8192 > 4 * tets && (std::size_t{1} << shift) < points) ++shift;
  const std::size_t ranges = ((points - 1) >> shift) + 1;

  const std::size_t pieces = std::clamp<std::size_t>(tets / 65536, 1, 32);
  const auto piece_begin = [&](std::size_t piece) { return tets * piece / pieces; };
  std::vector<std::vector<std::uint32_t>> place(pieces, std::vector<std::uint32_t>(ranges, 0));
  tbb::parallel_for(std::size_t{0}, pieces, [&](std::size_t piece) {
    for (std::size_t t = piece_begin(piece); t < piece_begin(piece + 1); ++t) {
      if (!excluded.empty() && excluded[t]) continue;
      auto [a, b, c, d] = mesh.tets[t];
      if (a > b) std::swap(a, b);
      if (c > d) std::swap(c, d);
      // The face without the smallest vertex starts at the second smallest, the other three at the smallest.
      place[piece][std::min(a, c) >> shift] += 3;
      place[piece][std::min(std::max(a, c), std::min(b, d)) >> shift] += 1;
    }
  });
  std::vector<std::uint32_t> range_start(ranges + 1, 0);
  std::uint32_t total = 0;
  for (std::size_t range = 0; range < ranges; ++range) {
    range_start[range] = total;
    for (std::size_t piece = 0; piece < pieces; ++piece) total += std::exchange(place[piece][range], total);
  }
  range_start[ranges] = total;

  const Room room(total);
  Record* const records = room.memory.get();
  tbb::parallel_for(std::size_t{0}, pieces, [&](std::size_t piece) {
    std::vector<std::uint32_t>& next = place[piece];
    for (std::size_t t = piece_begin(piece); t < piece_begin(piece + 1); ++t) {
      if (!excluded.empty() && excluded[t]) continue;
      for (int f = 0; f < 4; ++f) {
        const Record record = record_of(mesh.tets[t], f, static_cast<FaceId>(4 * t + f));
        records[next[record.smallest >> shift]++] = record;
      }
    }
  });

  std::vector<FaceMatching> found(ranges);
  tbb::parallel_for(std::size_t{0}, ranges, [&](std::size_t range) {
    const std::size_t lowest = range << shift;
    const std::size_t width = std::min(points - lowest, std::size_t{1} << shift);
    match_range(&records[range_start[range]],
                &records[range_start[range]] + (range_start[range + 1] - range_start[range]),
                static_cast<std::uint32_t>(lowest), static_cast<std::uint32_t>(width), found[range]);
  });

  FaceMatching all;
  std::size_t boundary = 0;
  for (const FaceMatching& part : found) boundary += part.boundary.size();
  all.boundary.reserve(boundary);
  for (const FaceMatching& part : found) {
    all.boundary.insert(all.boundary.end(), part.boundary.begin(), part.boundary.end());
    append(all.thrice, part.thrice);
    append(all.same_side, part.same_side);
  }
  std::sort(all.boundary.begin(), all.boundary.end());
  return all;
}

}  // namespace tetproof::verify
