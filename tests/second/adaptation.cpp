// SPDX-License-Identifier: GPL-3.0-or-later
// Step (vi): the insertion of points by eqs (3.4), (3.5) and Table 4.
#include <algorithm>
#include <stdexcept>

#include "tests/second/section3.hpp"

namespace tetproof::second {
namespace {

using Tet = std::array<int, 4>;

}  // namespace

Adaptation::Adaptation(const TriangleSurface& surface, const Grid& grid, const Settings& settings)
    : surface_(surface), settings_(settings), points_(grid.points) {
  for (std::size_t p = 0; p < points_.size(); ++p)
    if (grid.on_surface[p]) surface_points_.insert(static_cast<int>(p));
  law_ = {.v0 = 1, .v1 = 1, .d1 = 1, .p = settings.p};  // until the first grid has told its own
  for (const Tet& tet : grid.tets) add(tet);
}

Corners Adaptation::corners(const Tet& v) const {
  return {points_[v[0]], points_[v[1]], points_[v[2]], points_[v[3]]};
}

void Adaptation::add(const Tet& v) {
  tets_[next_++] = {.v = v, .weight = weigh(surface_, corners(v), law_, settings_.mistake)};
  count(v, 1);
}

void Adaptation::remove(std::int64_t number) {
  count(tets_.at(number).v, -1);
  tets_.erase(number);
}

double Adaptation::sum() const {
  long double sum = 0;
  for (const auto& [number, tet] : tets_) sum += tet.weight.error;
  return static_cast<double>(sum);
}

// Eq. (3.5) for every tetrahedron: the number of the one whose split makes E_avg smallest, if any lowers it.
std::optional<std::int64_t> Adaptation::choose() {
  const double s = sum(), l = static_cast<double>(tets_.size());
  const auto pieces = [&](const Split& split) {
    return settings_.mistake == Mistake::four_pieces ? 4.0 : static_cast<double>(split.replaced.size());
  };
  std::map<double, std::int64_t>
      best;  // by the number of pieces, so that sums of like terms are compared (D16)
  for (auto& [number, tet] : tets_) {
    if (!tet.split || !settings_.remember_splits) tet.split = split_of(tet.v, tet.weight.error);
    if (tet.refused) continue;
    const auto [entry, first] = best.insert({pieces(*tet.split), number});
    if (!first && tet.split->change < tets_.at(entry->second).split->change) entry->second = number;
  }
  std::optional<std::int64_t> chosen;
  double least = s / l;
  for (const auto& [m, number] : best) {
    const double after = (s + tets_.at(number).split->change) / (l + m - 1);
    if (after < least || (chosen && after == least && number < *chosen)) {
      least = after;
      chosen = number;
    }
  }
  return chosen;
}

bool Adaptation::degenerates(const Tet& v, const Split& split) const {
  for (const int i : split.replaced) {
    Corners piece = corners(v);
    piece[i] = split.point;
    if (orientation(piece[0], piece[1], piece[2], piece[3]) <= 0) return true;
  }
  return false;
}

std::set<std::int64_t> Adaptation::insert(std::int64_t number) {
  const Tet v = tets_.at(number).v;
  const Split split = *tets_.at(number).split;
  const int p = static_cast<int>(points_.size());
  points_.push_back(split.point);
  if (split.on_surface) surface_points_.insert(p);
  remove(number);
  std::set<std::int64_t> pieces;
  for (const int i : split.replaced) {
    Tet piece = v;
    piece[i] = p;
    pieces.insert(next_);
    add(piece);
  }
  return pieces;
}

void Adaptation::weigh_first_grid(std::vector<trace::Record>& records) {
  trace::FirstGrid first{.points = static_cast<std::int64_t>(points_.size()),
                         .tets = static_cast<std::int64_t>(tets_.size())};
  double volume = 0, farthest = 0;
  for (const auto& [number, tet] : tets_) {
    volume += signed_volume(corners(tet.v));
    farthest = std::max(farthest, distance(surface_, corners(tet.v), settings_.mistake).first);
  }
  first.mean_volume = volume / static_cast<double>(tets_.size());
  law_.v0 = first.v0 = settings_.v0_absolute.value_or(settings_.v0 * first.mean_volume);
  law_.v1 = first.v1 = settings_.v1_absolute.value_or(settings_.v1 * first.mean_volume);
  law_.d1 = first.d1 = settings_.d1.value_or(farthest);
  if (settings_.curvature) {
    law_.kappas = absolute_curvatures(surface_, settings_.mistake);
    first.kappa_min = law_.kappa_min = *std::min_element(law_.kappas.begin(), law_.kappas.end());
    first.kappa_max = law_.kappa_max = *std::max_element(law_.kappas.begin(), law_.kappas.end());
  }
  for (auto& [number, tet] : tets_) tet.weight = weigh(surface_, corners(tet.v), law_, settings_.mistake);
  first.e_avg = average();
  records.push_back(first);
  for (const auto& [number, tet] : tets_) {
    const Weight& w = tet.weight;
    trace::Weight record{.tet = corners(tet.v),
                         .d = w.d,
                         .omega = w.omega,
                         .volume = w.volume,
                         .desired = w.desired,
                         .error = w.error};
    if (settings_.curvature) record.kappa = w.kappa;
    records.push_back(record);
  }
}

void Adaptation::run(std::vector<trace::Record>& records) {
  const bool positive =
      std::all_of(tets_.begin(), tets_.end(), [&](const auto& entry) {  // it may not be, if literal
        const Corners c = corners(entry.second.v);
        return orientation(c[0], c[1], c[2], c[3]) > 0;
      });
  const bool asked = settings_.insertions != 0 && !tets_.empty() && positive;
  std::string stopped = asked ? "" : "not-asked";
  if (asked) weigh_first_grid(records);
  double lowest = asked ? average() : 0;
  std::int64_t since_lowest = 0;
  while (stopped.empty()) {
    if (insertions_ == settings_.insertions) stopped = "points";
    if (since_lowest >= std::max<std::int64_t>(1000, static_cast<std::int64_t>(tets_.size()) / 10))
      stopped = "stalled";
    if (!stopped.empty()) break;
    const auto chosen = choose();
    if (!chosen) {
      stopped = "no-gain";
      break;
    }
    Tetrahedron& tet = tets_.at(*chosen);
    if (degenerates(tet.v, *tet.split)) {  // D18
      tet.refused = true;
      ++refused_;
      continue;
    }
    if (tet.weight.volume <= tet.weight.desired && !settings_.past_dilution &&
        settings_.mistake != Mistake::dilution_ignored) {
      stopped = "dilution";
      break;
    }
    const Tet replaced = tet.v;
    trace::Insertion record{.n = ++insertions_,
                            .tet = corners(replaced),
                            .row = tet.split->row,
                            .replaced = tet.split->replaced,
                            .point = tet.split->point};
    const std::set<std::int64_t> pieces = insert(*chosen);
    record.e_avg = average();
    records.push_back(record);
    const bool bad = std::any_of(pieces.begin(), pieces.end(), [&](std::int64_t piece) {
      return smallest_solid_angle(corners(tets_.at(piece).v)) < settings_.improve_below;
    });
    if (bad && settings_.improve != Quality::none) improve(surroundings(replaced, pieces), records);
    const double now = average();
    since_lowest = now < lowest ? 0 : since_lowest + 1;
    lowest = std::min(lowest, now);
  }
  records.push_back(trace::End{.stopped = stopped,
                               .insertions = insertions_,
                               .flips = flips_,
                               .refused = refused_,
                               .points = static_cast<std::int64_t>(points_.size()),
                               .tets = static_cast<std::int64_t>(tets_.size()),
                               .e_avg = asked ? average() : 0});
}

TetMesh Adaptation::mesh() const {
  TetMesh mesh{.points = points_};
  for (const auto& [number, tet] : tets_) mesh.tets.push_back({tet.v[0], tet.v[1], tet.v[2], tet.v[3]});
  return mesh;
}

}  // namespace tetproof::second
