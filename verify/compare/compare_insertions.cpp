// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/compare/compare_insertions.hpp"

#include "verify/compare/compare_flips.hpp"
#include "verify/compare/rounding.hpp"

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

class Insertions {
 public:
  Insertions(TraceStream& other, TraceStream& reference, const FirstSteps& steps, FirstGrid& first,
             TraceComparison& result)
      : other_(other),
        reference_(reference),
        settings_(steps.settings()),
        tolerance_(steps.tolerance()),
        points_(first.points()),
        sizes_{.length = steps.magnitude()},
        result_(result) {
    if (first.summary()) {
      sizes_.volume = scale_ = first.summary()->mean_volume;
      before_ = first.summary()->e_avg;
    }
  }

  void run() {
    for (std::int64_t n = 1;; ++n) {
      // The reference comes first: its points are the ones that the other's are matched with.
      const std::optional<Split> a = next(Side::reference, n, nullptr),
                                 b = next(Side::other, n, a ? &*a : nullptr);
      if (!a && !b) break;
      if (!a || !b) return a ? one_ended(n, &*a, nullptr) : one_ended(n, nullptr, &*b);
      if (!step(n, *a, *b)) return;
      drift_ = a->e_avg() - b->e_avg();
      if (std::abs(drift_) > tolerance_.relative * std::abs(a->e_avg())) drift_ = 0;
      before_ = a->e_avg();
    }
    if (!waiting_.empty()) return parted_at_a_tie("both traces end");
    ends();
  }

 private:
  // Reads insertion n of one trace. `same_n`: the other trace's insertion n, if it was read already.
  std::optional<Split> next(Side side, std::int64_t n, const Split* same_n) {
    return read_split(side == Side::reference ? reference_ : other_, side, n, points_,
                      [&](const TetKey& tet) {
                        const auto partner = waiting_.find(tet);
                        if (partner != waiting_.end() && partner->second.first != side)
                          return partner->second.second.point;
                        return same_n && same_n->tet == tet ? same_n->point : -1;
                      });
  }

  // The rounding error of an average error. If it is far below the mean volume, the rounding of volumes
  // dominates.
  double rounding(double e_avg) const { return tie * std::abs(e_avg) + 1e-14 * sizes_.volume; }

  // False if the comparison ends here.
  bool step(std::int64_t n, const Split& a, const Split& b) {
    // A difference that the E_avg's had before this insertion (drift_) says nothing about the choice.
    const double difference = a.insertion.e_avg - b.insertion.e_avg;
    const double size = rounding(std::max(std::abs(a.insertion.e_avg), std::abs(b.insertion.e_avg)));
    const bool equally_good = std::abs(difference) <= size || std::abs(difference - drift_) <= size;
    if (waiting_.empty()) {
      if (a.tet == b.tet) return same_tet(n, a, b, false);
      if (!equally_good) return parted_in_choice(n, a, b);
      tie_ = {n, a, b};
      group_ = 0;
    } else if (!equally_good) {
      const auto [one, two] = apart(a.insertion.e_avg, b.insertion.e_avg);
      parted_at_a_tie(
          fmt::format("E'avg first differs at insertion {}: {} in reference, {} in other", n, one, two));
      return false;
    }
    // Within a tie the same splits may come in another order, so each split waits for its partner.
    ++group_;
    if (!meet(n, a, Side::reference) || !meet(n, b, Side::other)) return false;
    if (waiting_.empty()) result_.reordered += group_;
    return true;
  }

  bool meet(std::int64_t n, const Split& split, Side side) {
    const auto found = waiting_.find(split.tet);
    if (found == waiting_.end()) {
      waiting_.emplace(split.tet, std::pair{side, split});
      return true;
    }
    if (found->second.first == side) {  // a trace cannot split a tetrahedron twice
      const TraceStream& stream = side == Side::reference ? reference_ : other_;
      throw InputError(fmt::format("{}:{}: expected an existing tetrahedron, found the one split in line {}",
                                   stream.path(), split.line, found->second.second.line));
    }
    const Split earlier = std::move(found->second.second);
    waiting_.erase(found);
    return side == Side::reference ? same_tet(n, split, earlier, true) : same_tet(n, earlier, split, true);
  }

  // Both split the same tetrahedron. Compares how.
  bool same_tet(std::int64_t n, const Split& a, const Split& b, bool in_a_tie) {
    const std::string both =
        fmt::format("insertion {}: both split the tetrahedron at {}", n, at(a.insertion.tet));
    if (a.insertion.row != b.insertion.row)
      return diverge(n, Step::table4,
                     fmt::format("{}, reference by row {} of Table 4, other by row {}", both, a.insertion.row,
                                 b.insertion.row),
                     side(a), side(b));
    if (a.replaced != b.replaced) {
      const bool as_large = equally_large(a, b, sizes_);
      diverge(n, Step::table4,
              fmt::format("{} by row {} of Table 4, but the new point lies in different simplices{}", both,
                          a.insertion.row, as_large ? ": a tie, they are equally large" : ""),
              {a.line, place(a), to_line(a.insertion)}, {b.line, place(b), to_line(b.insertion)});
      if (as_large) result_.verdict = TraceComparison::Verdict::tie;
      return false;
    }
    if (!tolerance_.same(a.insertion.point, b.insertion.point))
      return diverge(n, Step::point,
                     fmt::format("{} by row {}, but the new points are {:.3g} apart", both, a.insertion.row,
                                 (a.insertion.point - b.insertion.point).norm()),
                     {a.line, text(a.insertion.point), to_line(a.insertion)},
                     {b.line, text(b.insertion.point), to_line(b.insertion)});
    if (!in_a_tie && !tolerance_.same(a.insertion.e_avg, b.insertion.e_avg, scale_)) {
      const auto [one, two] = apart(a.insertion.e_avg, b.insertion.e_avg);
      return diverge(n, Step::average_after,
                     fmt::format("{} by row {}, but E'avg is {} against {}", both, a.insertion.row, one, two),
                     side(a), side(b));
    }
    ++result_.insertions;
    return same_flips(n, a, b, in_a_tie);
  }

  bool same_flips(std::int64_t n, const Split& a, const Split& b, bool in_a_tie) {
    if (verify::same_flips(a, b)) {  // perhaps in another order, which eq. (3.5) does not decide
      result_.flips += static_cast<std::int64_t>(a.flips.size());
      if (a.flips.empty() || in_a_tie || tolerance_.same(a.e_avg(), b.e_avg(), scale_)) return true;
      const auto [one, two] = apart(a.e_avg(), b.e_avg());
      const Flipped &last_a = a.flips.back(), &last_b = b.flips.back();
      return diverge(n, Step::average_after,
                     fmt::format("insertion {}: after the same flips E_avg is {} against {}", n, one, two),
                     {last_a.line, says(last_a.flip), to_line(last_a.flip)},
                     {last_b.line, says(last_b.flip), to_line(last_b.flip)});
    }
    if (in_a_tie) {  // the tetrahedra around the two splits may have been different
      parted_at_a_tie(fmt::format("flips differ in lines {} and {}", a.line, b.line));
      return false;
    }
    const FlipDifference flips = first_flip_difference(n, a, b, settings_, sizes_);
    diverge(n, Step::flips, flips.tie ? flips.what + "; " + *flips.tie : flips.what, flips.reference,
            flips.other);
    if (flips.tie) result_.verdict = TraceComparison::Verdict::tie;
    return false;
  }

  static std::string choice(std::int64_t n, const Split& a, const Split& b) {
    const auto [one, two] = apart(a.insertion.e_avg, b.insertion.e_avg);
    return fmt::format(
        "insertion {}: reference splits the tetrahedron at {} by row {}, other the one at {} by row {}; "
        "E'avg {} against {}",
        n, at(a.insertion.tet), a.insertion.row, at(b.insertion.tet), b.insertion.row, one, two);
  }

  // Looks further for the insertion at which each trace splits the other's tetrahedron. Its row of Table 4
  // may tell what is wrong here.
  bool parted_in_choice(std::int64_t n, const Split& a, const Split& b) {
    // The trace with the larger E'avg has refused the other's split.
    const bool by_rounding = refused_by_rounding(a.insertion.e_avg < b.insertion.e_avg ? a : b, sizes_);
    const auto later = [&](Side side, const Split& wanted, const char* who) {
      for (std::int64_t i = n + 1; const std::optional<Split> split = next(side, i, nullptr); ++i)
        if (split->tet == wanted.tet)
          return fmt::format(" ({} splits it as insertion {}, by row {})", who, i, split->insertion.row);
      return fmt::format(" ({} never splits it)", who);
    };
    std::string what = choice(n, a, b);
    if (by_rounding)
      what += "; decided by rounding: the better split makes tetrahedra thinner than rounding (reading D18)";
    diverge(n, Step::choice, what, side(a, later(Side::other, a, "other")),
            side(b, later(Side::reference, b, "reference")));
    if (by_rounding) result_.verdict = TraceComparison::Verdict::tie;
    return false;
  }

  bool diverge(std::int64_t n, Step step, const std::string& what, const Says& reference, const Says& other) {
    tell(result_, step, 1, {what, reference, other});
    result_.insertion = n;
    return false;
  }

  // The traces differ while a tie is still open.
  void parted_at_a_tie(const std::string& how) {
    result_.notes.push_back(fmt::format("the tie was never closed; {}", how));
    diverge(tie_.n, Step::choice, choice(tie_.n, tie_.a, tie_.b) + ": a tie", side(tie_.a), side(tie_.b));
    result_.verdict = TraceComparison::Verdict::tie;
  }

  // One trace has no insertion n.
  void one_ended(std::int64_t n, const Split* a, const Split* b) {
    if (!waiting_.empty())
      return parted_at_a_tie(fmt::format("{} has no insertion {}", a ? "other" : "reference", n));
    const TraceStream& ended = a ? other_ : reference_;
    const auto* end = ended.next_is<End>();
    const Says over{end ? ended.line() : 0,
                    end ? fmt::format("ends ({})", end->stopped) : "breaks off, without an end record",
                    end ? to_line(*end) : ""};
    const Split& split = a ? *a : *b;
    diverge(n, Step::end,
            fmt::format("insertion {}: {} {}, {} splits the tetrahedron at {} by row {}", n,
                        a ? "other" : "reference", over.says, a ? "reference" : "other",
                        at(split.insertion.tet), split.insertion.row),
            a ? side(split) : over, a ? over : side(split));
    if (!end || end->stopped != "no-gain") return;
    const char* reason =
        before_ - split.insertion.e_avg <= rounding(before_) ? "a tie: E_avg falls by rounding"
        : refused_by_rounding(split, sizes_)
            ? "decided by rounding: the split makes tetrahedra thinner than rounding (reading D18)"
            : nullptr;
    if (!reason) return;
    result_.verdict = TraceComparison::Verdict::tie;
    result_.what += fmt::format("; {}", reason);
  }

  // Neither trace has more insertions. Compares the ends.
  void ends() {
    const End *a = reference_.next_is<End>(), *b = other_.next_is<End>();
    if (!a && !b) return result_.notes.push_back("both traces break off, without an end record");
    const auto ending = [](const End* end) {
      return !end ? std::string("breaks off, without an end record")
                  : fmt::format("ends ({}) with {} points, {} tetrahedra, E_avg {}", end->stopped,
                                end->points, end->tets, end->e_avg);
    };
    if (a && b && a->stopped == b->stopped && a->points == b->points && a->tets == b->tets &&
        tolerance_.same(a->e_avg, b->e_avg, scale_))
      return;
    diverge(result_.insertions, Step::end,
            fmt::format("the end: reference {}, other {}", ending(a), ending(b)),
            {a ? reference_.line() : 0, ending(a), a ? to_line(*a) : ""},
            {b ? other_.line() : 0, ending(b), b ? to_line(*b) : ""});
  }

  TraceStream &other_, &reference_;
  const Settings& settings_;
  const Tolerance& tolerance_;
  TracePoints& points_;
  Magnitudes sizes_;
  TraceComparison& result_;
  double scale_ = 0;
  double drift_ = 0;   // the difference of the E_avg's before the current insertion
  double before_ = 0;  // the reference's E_avg before it

  struct Tie {
    std::int64_t n;
    Split a, b;
  } tie_{};                 // the first insertion of the current tie
  std::int64_t group_ = 0;  // the number of insertions in it
  // The splits of the current tie that have no partner yet, and whose they are.
  std::unordered_map<TetKey, std::pair<Side, Split>, ArrayHash> waiting_;
};

}  // namespace

void compare_insertions(TraceStream& other, TraceStream& reference, const FirstSteps& steps, FirstGrid& first,
                        TraceComparison& result) {
  Insertions(other, reference, steps, first, result).run();
}

}  // namespace tetproof::verify
