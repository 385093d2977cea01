// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/follow/follow_first_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "io/error.hpp"
#include "reference/follow/follow_points.hpp"

namespace tetproof::reference {
namespace {

// A record's kind and its place in the lattice: what it is about.
using Key = std::array<int, 7>;

enum Kind { lattice, indicators, moved, cut, rows, mapped };
constexpr std::array<const char*, 6> names{"lattice", "indicators",      "moved vertices",
                                           "cuts",    "rows of Table 2", "mapped points"};

std::string text(const std::array<int, 3>& v) {
  return fmt::format("({}, {}, {})", v[0], v[1], v[2]);
}

std::string about(const Key& key) {
  const std::array<int, 3> first{key[1], key[2], key[3]}, second{key[4], key[5], key[6]};
  switch (key[0]) {
    case lattice:
      return "step (i): the lattice";
    case indicators:
      return fmt::format("step (iii): the indicators with j = {}, k = {}", key[1], key[2]);
    case moved:
      return fmt::format("reading D4: the place of the lattice vertex {}", text(first));
    case cut:
      return fmt::format("step (ii): the cut of the lattice edge {}-{}", text(first), text(second));
    case rows:
      return fmt::format("step (iv): the rows of Table 2 of the cell {}", text(first));
    default:
      return key[1] < 0 ? "reading D12: a mapped point at another place"
                        : fmt::format("reading D12: the mapped point {}", key[1] + 1);
  }
}

class FirstStepsCheck {
 public:
  explicit FirstStepsCheck(const std::vector<trace::Record>& ours) {
    std::vector<trace::Point> places;
    for (const trace::Record& record : ours) {
      if (const auto* box = std::get_if<trace::Lattice>(&record))
        reach_ = same_place * (box->box[1] - box->box[0]).norm();
      if (const auto* point = std::get_if<trace::Mapped>(&record)) places.push_back(point->from);
    }
    if (!places.empty()) mapped_.emplace(std::move(places));
    for (const trace::Record& record : ours)
      if (const auto key = key_of(record)) ours_.emplace(*key, Own{record});
  }

  // False if the record is none of steps (i) to (iv).
  bool take(const trace::Record& theirs) {
    const auto key = key_of(theirs);
    if (!key) return false;
    if ((*key)[0] != lattice && !seen_[lattice])
      throw Divergence{fmt::format("step (i): a '{}' record before the lattice", trace::name_of(theirs))};
    seen_[(*key)[0]] = true;
    const auto own = ours_.find(*key);
    if (own == ours_.end()) throw Divergence{about(*key) + ": this run has no such record"};
    if (own->second.found) throw Divergence{about(*key) + ": stands twice"};
    own->second.found = true;
    std::visit(
        [&](const auto& record) {
          using R = std::decay_t<decltype(record)>;
          compare(*key, record, std::get<R>(own->second.record));
        },
        theirs);
    return true;
  }

  // To be called when all records are taken: throws Divergence for one that the trace does not have.
  void end(std::vector<std::string>& not_checked) const {
    for (const auto& [key, own] : ours_) {
      if (own.found) continue;
      const bool always_there = key[0] == indicators || key[0] == cut || key[0] == rows;
      if (!always_there || seen_[key[0]]) throw Divergence{about(key) + ": the trace has no such record"};
    }
    for (const int kind : {indicators, cut, rows})
      if (!seen_[kind] &&
          std::any_of(ours_.begin(), ours_.end(), [&](const auto& own) { return own.first[0] == kind; }))
        not_checked.emplace_back(names[kind]);
  }

 private:
  struct Own {
    trace::Record record;
    bool found = false;  // whether the trace has it
  };

  std::optional<Key> key_of(const trace::Record& record) const {
    const auto key = [](int kind, const std::array<int, 3>& a, const std::array<int, 3>& b = {}) {
      return Key{kind, a[0], a[1], a[2], b[0], b[1], b[2]};
    };
    if (std::holds_alternative<trace::Lattice>(record)) return key(lattice, {});
    if (const auto* r = std::get_if<trace::Indicators>(&record)) return key(indicators, {r->j, r->k, 0});
    if (const auto* r = std::get_if<trace::Moved>(&record)) return key(moved, r->vertex);
    if (const auto* r = std::get_if<trace::Cut>(&record)) {
      const auto [a, b] = std::minmax(r->edge[0], r->edge[1]);
      return key(cut, a, b);
    }
    if (const auto* r = std::get_if<trace::Rows>(&record)) return key(rows, r->cell);
    if (const auto* r = std::get_if<trace::Mapped>(&record))
      return key(mapped, {mapped_number(r->from), 0, 0});
    return std::nullopt;
  }

  // A mapped point is known by the place that it comes from. The number of ours at this place; -1: there is
  // none.
  int mapped_number(const trace::Point& from) const {
    if (!mapped_ || !from.allFinite()) return -1;
    const double distance = mapped_->distance(from);
    return distance <= reach_ ? mapped_->nearest(from, distance) : -1;
  }

  void same(const Key& key, const trace::Point& theirs, const trace::Point& ours) const {
    using reference::text;
    if (!((theirs - ours).norm() <= reach_))
      throw Divergence{fmt::format("{} is {}, not {}", about(key), text(ours), text(theirs))};
  }

  void compare(const Key& key, const trace::Lattice& theirs, const trace::Lattice& ours) const {
    if (theirs.cells != ours.cells)
      throw Divergence{fmt::format("{} has {} cells, not {}", about(key), fmt::join(ours.cells, " x "),
                                   fmt::join(theirs.cells, " x "))};
    for (int corner = 0; corner < 2; ++corner) same(key, theirs.box[corner], ours.box[corner]);
  }
  void compare(const Key& key, const trace::Indicators& theirs, const trace::Indicators& ours) const {
    for (const auto& [what, a, b] : {std::tuple("before", &theirs.initial, &ours.initial),
                                     std::tuple("after", &theirs.after, &ours.after)})
      if (*a != *b) throw Divergence{fmt::format("{} {} Table 3 are {}, not {}", about(key), what, *b, *a)};
  }
  void compare(const Key& key, const trace::Moved& theirs, const trace::Moved& ours) const {
    same(key, theirs.point, ours.point);
    if (theirs.mended != ours.mended)
      throw Divergence{
          fmt::format("{}: it was {}mended because of rounding", about(key), ours.mended ? "" : "not ")};
  }
  void compare(const Key& key, const trace::Cut& theirs, const trace::Cut& ours) const {
    same(key, theirs.point, ours.point);
  }
  void compare(const Key& key, const trace::Rows& theirs, const trace::Rows& ours) const {
    if (theirs.rows != ours.rows)
      throw Divergence{fmt::format("{} are {}, not {}", about(key), fmt::join(ours.rows, " "),
                                   fmt::join(theirs.rows, " "))};
  }
  void compare(const Key& key, const trace::Mapped& theirs, const trace::Mapped& ours) const {
    same(key, theirs.to, ours.to);
  }
  template <class R>
  void compare(const Key&, const R&, const R&) const {}  // has no key

  double reach_ = 0;
  std::optional<VertexTree> mapped_;  // the places from which our mapped points come
  std::map<Key, Own> ours_;
  std::array<bool, names.size()> seen_{};
};

// Compares the settings that count in this run.
void compare(const trace::Settings& theirs, const trace::Settings& ours) {
  const auto same = [](const auto& trace, const auto& here, std::string_view name) {
    if (trace != here)
      throw Divergence{fmt::format("settings: the trace has {} {}, this run {}", name, trace, here)};
  };
  const auto same_number = [&](double trace, double here, std::string_view name) {
    if (!close(trace, here)) same(trace, here, name);
  };
  same(theirs.region, ours.region, "region");
  same_number(theirs.box_scale, ours.box_scale, "box_scale");
  same_number(theirs.on_surface, ours.on_surface, "on_surface");
  same(theirs.diagonals, ours.diagonals, "diagonals");
  same(theirs.literal, ours.literal, "literal");
  same(theirs.parametric, ours.parametric, "parametric");
  same(theirs.points, ours.points, "points");
  if (ours.points == "0") return;  // there are no steps (v) and (vi)
  same_number(theirs.p, ours.p, "p");
  same(theirs.curvature, ours.curvature, "curvature");
  same(theirs.improve, ours.improve, "improve");
  if (ours.improve != "none") same_number(theirs.improve_below, ours.improve_below, "improve_below");
  same(theirs.past_dilution, ours.past_dilution, "past_dilution");
}

}  // namespace

void fail_truncated(const trace::Reader& reader) {
  throw InputError(
      fmt::format("{}:{}: expected an 'end' record, found the end of the file: the trace breaks off",
                  reader.path(), reader.line()));
}

trace::Record check_first_steps(trace::Reader& reader, const std::vector<trace::Record>& ours,
                                const trace::Settings& own_settings, std::vector<std::string>& not_checked) {
  FirstStepsCheck check(ours);
  bool has_settings = false;
  std::optional<trace::Record> next;
  while ((next = reader.next())) {
    if (const auto* settings = std::get_if<trace::Settings>(&*next)) {
      if (has_settings) throw Divergence{"settings: stand twice"};
      has_settings = true;
      compare(*settings, own_settings);
    } else if (!check.take(*next)) {
      break;
    }
  }
  if (!next) fail_truncated(reader);
  if (!has_settings) not_checked.emplace_back("settings");
  check.end(not_checked);
  return std::move(*next);
}

}  // namespace tetproof::reference
