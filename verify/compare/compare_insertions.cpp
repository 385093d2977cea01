// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/compare/compare_insertions.hpp"

#include <unordered_set>

#include "verify/compare/compare_flips.hpp"

namespace tetproof::verify {
namespace {

using namespace trace;

// `more`: further text, placed after the numbers.
Says side(const Split& split, const std::string& more = "") {
  return {split.line,
          fmt::format("row {}, E'avg {}{}: {}", split.insertion.row, split.insertion.e_avg, more,
                      short_text(split.insertion.tet)),
          to_line(split.insertion)};
}

std::string place(const Split& split) {
  const char* const simplex[] = {"edge", "face", "tetrahedron"};
  std::string text = fmt::format("in the {}", simplex[split.insertion.replaced.size() - 2]);
  for (const int i : split.insertion.replaced) text += fmt::format(" {}", short_text(split.insertion.tet[i]));
  return text;
}

// Compares insertion by insertion. As long as both traces agree, they build the same grid, which is kept
// here.
class Insertions {
 public:
  Insertions(TraceStream& other, TraceStream& reference, const FirstSteps& steps, FirstGrid& first,
             TraceComparison& result)
      : other_(other),
        reference_(reference),
        settings_(steps.settings()),
        tolerance_(steps.tolerance()),
        points_(first.points()),
        result_(result) {
    if (first.summary()) scale_ = first.summary()->mean_volume;
    for (const TetKey& tet : first.tets()) grid_.insert(tet);
    grid_is_known_ = !grid_.empty();
  }

  void run() {
    for (std::int64_t n = 1;; ++n) {
      // The reference comes first: its points are the ones that the other's are matched with.
      const std::optional<Split> a = next(Side::reference, n, nullptr),
                                 b = next(Side::other, n, a ? &*a : nullptr);
      if (!a && !b) return ends();
      if (!a || !b) return a ? one_ended(n, &*a, nullptr) : one_ended(n, nullptr, &*b);
      if (!step(n, *a, *b)) return;
    }
  }

 private:
  // Reads insertion n of one trace. `same_n`: the other trace's insertion n, if it was read already.
  std::optional<Split> next(Side side, std::int64_t n, const Split* same_n) {
    return read_split(side == Side::reference ? reference_ : other_, side, n, points_,
                      [&](const TetKey& tet) { return same_n && same_n->tet == tet ? same_n->point : -1; });
  }

  // False if the comparison ends here.
  bool step(std::int64_t n, const Split& a, const Split& b) {
    return exists(n, b, other_) && exists(n, a, reference_) && same_split(n, a, b) && split(a) &&
           same_flips(n, a, b);
  }

  // Whether the tetrahedron that the insertion names is in the grid.
  bool exists(std::int64_t n, const Split& split, const TraceStream& stream) {
    if (!grid_is_known_ || grid_.contains(split.tet)) return true;
    return contradicts(
        n, Step::choice, stream, split.line, to_line(split.insertion),
        fmt::format("insertion {}: there is no tetrahedron at {} in the grid that the trace has built", n,
                    short_text(split.insertion.tet)));
  }

  bool same_split(std::int64_t n, const Split& a, const Split& b) {
    if (a.tet != b.tet) {
      const auto [one, two] = apart(a.insertion.e_avg, b.insertion.e_avg);
      return part(
          n, Step::choice,
          fmt::format(
              "insertion {}: reference splits the tetrahedron at {} by row {}, other the one at {} by "
              "row {}; E'avg {} against {}",
              n, at(a.insertion.tet), a.insertion.row, at(b.insertion.tet), b.insertion.row, one, two),
          side(a, later(Side::other, n, a, "other")), side(b, later(Side::reference, n, b, "reference")));
    }
    const std::string both =
        fmt::format("insertion {}: both split the tetrahedron at {}", n, at(a.insertion.tet));
    if (a.insertion.row != b.insertion.row)
      return part(n, Step::table4,
                  fmt::format("{}, reference by row {} of Table 4, other by row {}", both, a.insertion.row,
                              b.insertion.row),
                  side(a), side(b));
    if (a.replaced != b.replaced)
      return part(n, Step::table4,
                  fmt::format("{} by row {} of Table 4, but the new point lies in different simplices", both,
                              a.insertion.row),
                  {a.line, place(a), to_line(a.insertion)}, {b.line, place(b), to_line(b.insertion)});
    if (!tolerance_.same(a.insertion.point, b.insertion.point))
      return part(n, Step::point,
                  fmt::format("{} by row {}, but the new points are {:.3g} apart", both, a.insertion.row,
                              (a.insertion.point - b.insertion.point).norm()),
                  {a.line, text(a.insertion.point), to_line(a.insertion)},
                  {b.line, text(b.insertion.point), to_line(b.insertion)});
    if (!tolerance_.same(a.insertion.e_avg, b.insertion.e_avg, scale_)) {
      const auto [one, two] = apart(a.insertion.e_avg, b.insertion.e_avg);
      return part(n, Step::average_after,
                  fmt::format("{} by row {}, but E'avg is {} against {}", both, a.insertion.row, one, two),
                  side(a), side(b));
    }
    ++result_.insertions;
    return true;
  }

  // Looks further for the insertion at which a trace splits the other's tetrahedron. Its row of Table 4 may
  // tell what is wrong here.
  std::string later(Side side, std::int64_t n, const Split& wanted, const char* who) {
    for (std::int64_t i = n + 1; const std::optional<Split> split = next(side, i, nullptr); ++i)
      if (split->tet == wanted.tet)
        return fmt::format(" ({} splits it as insertion {}, by row {})", who, i, split->insertion.row);
    return fmt::format(" ({} never splits it)", who);
  }

  // Splits the tetrahedron in the grid.
  bool split(const Split& split) {
    grid_.erase(split.tet);
    for (const int corner : split.replaced) {
      TetKey piece = split.tet;
      *std::find(piece.begin(), piece.end(), corner) = split.point;
      grid_.insert(sorted(piece));
    }
    return true;
  }

  // The flips after an insertion, in their order.
  bool same_flips(std::int64_t n, const Split& a, const Split& b) {
    for (std::size_t i = 0; i < std::max(a.flips.size(), b.flips.size()); ++i) {
      const Flipped* const one = i < a.flips.size() ? &a.flips[i] : nullptr;
      const Flipped* const two = i < b.flips.size() ? &b.flips[i] : nullptr;
      for (const auto& [flipped, stream] : {std::pair(two, &other_), std::pair(one, &reference_)})
        if (flipped && !is_right(n, *flipped, *stream)) return false;
      if (!one || !two || one->key != two->key) {
        const FlipDifference flips = flip_difference(n, i, a, b);
        return part(n, Step::flips, flips.what, flips.reference, flips.other);
      }
      for (const TetKey& tet : old_tets(one->key)) grid_.erase(tet);
      for (const TetKey& tet : new_tets(one->key)) grid_.insert(tet);
      if (!tolerance_.same(one->flip.e_avg, two->flip.e_avg, scale_)) {
        const auto [of_a, of_b] = apart(one->flip.e_avg, two->flip.e_avg);
        return part(n, Step::average_after,
                    fmt::format("insertion {}: after the same flips E_avg is {} against {}", n, of_a, of_b),
                    {one->line, says(one->flip), to_line(one->flip)},
                    {two->line, says(two->flip), to_line(two->flip)});
      }
      ++result_.flips;
    }
    return true;
  }

  // Whether the tetrahedra of a flip are in the grid and have the qualities that the trace states.
  bool is_right(std::int64_t n, const Flipped& flipped, const TraceStream& stream) {
    const auto wrong = [&](const std::string& what) {
      return contradicts(n, Step::flips, stream, flipped.line, to_line(flipped.flip),
                         fmt::format("insertion {}: the {}: {}", n, says(flipped.flip), what));
    };
    const std::vector<TetKey> old = old_tets(flipped.key);
    if (grid_is_known_ &&
        !std::all_of(old.begin(), old.end(), [&](const TetKey& t) { return grid_.contains(t); }))
      return wrong("its tetrahedra are not in the grid that the trace has built");
    const std::string false_quality = wrong_quality(flipped.flip, settings_.improve, tolerance_);
    return false_quality.empty() || wrong(false_quality);
  }

  // The traces part here, and it is not known which of them is wrong.
  bool part(std::int64_t n, Step step, const std::string& what, const Says& reference, const Says& other) {
    tell(result_, step, 1, {what, reference, other});
    result_.insertion = n;
    return false;
  }

  // A trace contradicts itself, so that it is wrong whatever the other one says.
  bool contradicts(std::int64_t n, Step step, const TraceStream& stream, std::int64_t line,
                   const std::string& record, const std::string& what) {
    const bool in_other = &stream == &other_;
    const Says it{line, what, record}, none{0, "not compared with it"};
    part(n, step, what, in_other ? none : it, in_other ? it : none);
    result_.verdict = TraceComparison::Verdict::diverges;
    result_.wrong = {stream.path(), line, what, record};
    return false;
  }

  static Says ending(const TraceStream& stream) {
    if (const auto* end = stream.next_is<End>())
      return {stream.line(),
              fmt::format("ends ({}) after {} insertions and {} flips, {} splits refused, with {} points, {} "
                          "tetrahedra, E_avg {}",
                          end->stopped, end->insertions, end->flips, end->refused, end->points, end->tets,
                          end->e_avg),
              to_line(*end)};
    return {stream.line(), fmt::format("breaks off after line {}, without an end record", stream.line())};
  }

  // Whether the trace has an end record.
  bool has_end(std::int64_t n, const TraceStream& stream) {
    return stream.next_is<End>() ||
           contradicts(n, Step::end, stream, stream.line(), "", "the trace " + ending(stream).says);
  }

  // One trace has no insertion n.
  void one_ended(std::int64_t n, const Split* a, const Split* b) {
    const TraceStream& ended = a ? other_ : reference_;
    if (!has_end(n, ended)) return;
    const Says over = ending(ended);
    const Split& split = a ? *a : *b;
    part(n, Step::end,
         fmt::format("insertion {}: {} ends ({}), {} splits the tetrahedron at {} by row {}", n,
                     a ? "other" : "reference", ended.next_is<End>()->stopped, a ? "reference" : "other",
                     at(split.insertion.tet), split.insertion.row),
         a ? side(split) : over, a ? over : side(split));
  }

  // Neither trace has more insertions. Compares the ends.
  void ends() {
    if (!has_end(result_.insertions, other_) || !has_end(result_.insertions, reference_)) return;
    const End &a = *reference_.next_is<End>(), &b = *other_.next_is<End>();
    if (std::tie(a.stopped, a.insertions, a.flips, a.refused, a.points, a.tets) ==
            std::tie(b.stopped, b.insertions, b.flips, b.refused, b.points, b.tets) &&
        tolerance_.same(a.e_avg, b.e_avg, scale_))
      return;
    const Says one = ending(reference_), two = ending(other_);
    part(result_.insertions, Step::end, fmt::format("the end: reference {}, other {}", one.says, two.says),
         one, two);
  }

  TraceStream &other_, &reference_;
  const Settings& settings_;
  const Tolerance& tolerance_;
  TracePoints& points_;
  TraceComparison& result_;
  double scale_ = 0;  // the mean volume of the first grid: rounding errors of averages are relative to it
  std::unordered_set<TetKey, ArrayHash> grid_;
  bool grid_is_known_ = false;  // whether the traces say what the first grid is
};

}  // namespace

void compare_insertions(TraceStream& other, TraceStream& reference, const FirstSteps& steps, FirstGrid& first,
                        TraceComparison& result) {
  Insertions(other, reference, steps, first, result).run();
}

}  // namespace tetproof::verify
