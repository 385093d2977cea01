// SPDX-License-Identifier: GPL-3.0-or-later
// Section 3, step (vi): the choice by eq. (3.5), the split by Table 4. README.md has the page's sentence for
// each function.
#pragma once

#include "reference/paper/parametric.hpp"

namespace tetproof::reference::paper {

class Insertion : public Parametric {
 public:
  using Parametric::Parametric;

  // --- Table 4, reading D19

  virtual int row_of_table4(const Tet& v, const std::vector<int>& on_surface) const {
    std::string name = std::to_string(on_surface.size());
    if (name == "2" || name == "3") name += is_shared(v, on_surface) ? "a" : "b";
    const auto unshared = [&](const std::vector<int>& face) { return !is_shared(v, face); };
    if (name == "4") name += "abcde"[std::count_if(faces.begin(), faces.end(), unshared)];
    return tables::table4_row(name);
  }

  virtual std::vector<std::vector<int>> unshared_edges(const Tet& v, int /*row*/) const {
    std::vector<std::vector<int>> found;
    for (const auto& [a, b] : ends)
      if (!is_shared(v, {a, b})) found.push_back({a, b});
    return found;
  }

  /// The positions of the corners whose centroid is the new point: all, those of a face, or those of an edge.
  std::vector<int> place_of_point(const Tet& v, int row, const std::vector<int>& on_surface) const {
    if (tables::table4[row].place == tables::Place::tetrahedron) return {0, 1, 2, 3};
    if (on_surface.size() < 4) return on_surface;
    std::vector<std::vector<int>> places;
    if (tables::table4[row].place == tables::Place::edge) places = unshared_edges(v, row);
    if (places.empty())
      std::copy_if(faces.begin(), faces.end(), std::back_inserter(places),
                   [&](const auto& f) { return !is_shared(v, f); });
    const auto size = [&](const std::vector<int>& place) {  // squared: of a length, of twice an area
      const Point a = points_[v[place[0]]], ab = points_[v[place[1]]] - a;
      return place.size() == 2 ? ab.squaredNorm() : ab.cross(points_[v[place[2]]] - a).squaredNorm();
    };
    return *std::min_element(places.begin(), places.end(), [&](const auto& a, const auto& b) {
      return std::pair(-size(a), names(v, a)) < std::pair(-size(b), names(v, b));
    });
  }

  virtual Point centroid_of(const Tet& v, const std::vector<int>& positions) const {
    Point sum(0, 0, 0);
    for (const int i : positions) sum += points_[v[i]];
    return sum / static_cast<double>(positions.size());
  }
  virtual bool makes_surface_point(const Split& split) const { return split.replaced.size() < 4; }

  /// The split of a tetrahedron by Table 4, and what it does to the sum of the errors (reading D16).
  Split split_of(const Tetrahedron& tet) const {
    std::vector<int> on_surface;
    for (int i = 0; i < 4; ++i)
      if (surface_points_.contains(tet.v[i])) on_surface.push_back(i);
    Split split{.row = row_of_table4(tet.v, on_surface)};
    split.replaced = place_of_point(tet.v, split.row, on_surface);
    split.point = centroid_of(tet.v, split.replaced);
    split.on_surface = makes_surface_point(split);
    if (split.on_surface && is_parametric() && !tet.left) {  // reading D12
      Split mapped = split;
      mapped.point = on_parametric_surface(split.point);
      mapped.moved = true;
      if (is_positive(tet.v, mapped)) split = mapped;
    }
    for (const Corners& piece : pieces(tet.v, split)) split.change += weigh(piece).error;
    split.change -= tet.weight.error;
    return split;
  }
  std::vector<Corners> pieces(const Tet& v, const Split& split) const {
    std::vector<Corners> all(split.replaced.size(), corners(v));
    for (std::size_t k = 0; k < all.size(); ++k) all[k][split.replaced[k]] = split.point;
    return all;
  }
  bool is_positive(const Tet& v, const Split& split) const {
    const std::vector<Corners> all = pieces(v, split);
    return std::all_of(all.begin(), all.end(), positive);
  }

  // --- step (vi)

  /// The tetrahedron whose split makes E_avg' smallest, if one lowers E_avg (reading D16).
  std::optional<std::int64_t> choose() {
    std::map<std::size_t, std::int64_t> best;  // by the number of pieces
    for (auto& [number, tet] : tets_) {
      if (!tet.split) tet.split = split_of(tet);
      if (tet.refused) continue;
      const auto [entry, first] = best.insert({tet.split->replaced.size(), number});
      if (!first && tet.split->change < tets_.at(entry->second).split->change) entry->second = number;
    }
    const double sum = sum_of_errors();
    double least = e_avg();
    std::optional<std::int64_t> chosen;
    for (const auto& [m, number] : best) {
      const double after = e_avg_after(sum, tets_.at(number).split->change, static_cast<int>(m));
      if (after < least || (chosen && after == least && number < *chosen)) least = after, chosen = number;
    }
    return chosen;
  }
  virtual bool is_diluted(const Weight& weight) const { return weight.volume <= weight.desired; }  // D17

  void insert_points() {
    const AdaptOptions& adapt = *options_.adapt;
    double lowest = e_avg();
    std::int64_t lowest_at = 0;
    while (true) {
      if (insertions_ == adapt.points) return end("points");  // readings D17 and D23
      if (e_avg_goal_ > 0 && e_avg() <= e_avg_goal_) return end("e-avg");
      if (insertions_ - lowest_at >= std::max<std::int64_t>(1000, size() / 10)) return end("stalled");
      const auto chosen = choose();
      if (!chosen) return end("no-gain");
      Tetrahedron& tet = tets_.at(*chosen);
      if (!is_positive(tet.v, *tet.split)) {  // reading D18
        tet.refused = true;
        ++refused_;
        continue;
      }
      if (tet.split->moved && crosses_boundary(tet.v, *tet.split)) {  // reading D12
        tet.left = true;
        tet.split.reset();
        continue;
      }
      if (!adapt.past_dilution && is_diluted(tet.weight)) return end("dilution");
      const Tet v = tet.v;
      const Numbers fresh = insert(*chosen);
      const bool improves = std::any_of(fresh.begin(), fresh.end(), [&](std::int64_t t) {  // reading D21
        return solid_angle(smallest_solid_angle(corners(tets_.at(t).v))) < adapt.improve_below;
      });
      if (improves && adapt.improve != Criterion::none) improve(surroundings(v, fresh));
      if (const double now = e_avg(); now < lowest) lowest = now, lowest_at = insertions_;
    }
  }
  void end(const char* why) { stopped_ = why; }

  /// Replaces a tetrahedron by the pieces of its split; their numbers.
  Numbers insert(std::int64_t number) {
    const Tetrahedron whole = tets_.at(number);
    const Split& split = *whole.split;
    const int p = static_cast<int>(points_.size());
    points_.push_back(split.point);
    if (split.on_surface) surface_points_.insert(p);
    left_ += split.on_surface && is_parametric() && !split.moved;
    remove(number);
    Numbers fresh;
    for (const int i : split.replaced) {
      Tet piece = whole.v;
      piece[i] = p;
      fresh.insert(next_);
      add(piece);
    }
    ++table4_[split.row];
    const std::string row(tables::table4[split.row].name);
    record(trace::Insertion{++insertions_, corners(whole.v), row, split.replaced, split.point, e_avg()});
    return fresh;
  }

  inline static const std::vector<std::vector<int>> faces{{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};
  std::string stopped_ = "not-asked";
  std::int64_t insertions_ = 0, refused_ = 0, left_ = 0;
  std::array<std::int64_t, tables::table4.size()> table4_{};  ///< insertions by each row of Table 4
};

}  // namespace tetproof::reference::paper
