// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/mistakes/mistaken.hpp"

#include "io/surface/used_vertices.hpp"
#include "reference/paper/page.hpp"

namespace tetproof::mistakes {
namespace {

namespace paper = reference::paper;
namespace tables = reference::tables;
using paper::Edge;
using paper::EdgePoints;
using paper::Numbers;
using paper::Page;
using paper::Point;
using paper::Rational;
using paper::Tet;

class Mistaken : public Page {
 public:
  Mistaken(const TriangleSurface& surface, const reference::Options& options, Mistake mistake)
      : Page(surface, options), mistake_(mistake) {}

  // --- section 2

  tables::Table2Row choose_row(const Tet& v) const override {
    tables::Table2Row row = Page::choose_row(v);
    if (makes(Mistake::table2_row) && row.name == "12f")
      row.tets[1] = {tables::v1, tables::v3, tables::p24, tables::p34};
    return row;
  }
  bool starts_at_lower(int lower, int higher, int exterior) const override {
    return Page::starts_at_lower(lower, higher, exterior) != makes(Mistake::higher_diagonal);
  }
  const Rational& closest_to_exterior(const EdgePoints& met, bool exterior_is_first) const override {
    return Page::closest_to_exterior(met, exterior_is_first != makes(Mistake::table3_interior_end));
  }
  int asked_for(const std::set<int>& signs) const override {
    return makes(Mistake::asked_for_both) ? *signs.rbegin() : Page::asked_for(signs);
  }
  bool keeps_case_5(const Point& centroid) const override {
    return makes(Mistake::case5_kept) || Page::keeps_case_5(centroid);
  }

  // --- section 3

  double distance(const Point& centroid) const override {
    double least = Page::distance(centroid);
    for (std::size_t t = 0; t < triangles_.size() && makes(Mistake::distance_to_triangles); ++t)
      least = std::min(least, (paper::closest_point(triangles_[t], centroid) - centroid).norm());
    return least;
  }
  double curvature_near(const Point& centroid, double /*d*/) const override {
    return Page::curvature_near(centroid, Page::distance(centroid));  // still that of the closest vertex
  }
  double desired(double d) const override {
    reference::VolumeLaw law = law_;
    if (makes(Mistake::volumes_exchanged)) std::swap(law.v0, law.v1);
    return reference::desired_volume(d, law);
  }
  double error(double volume, double desired) const override {
    return makes(Mistake::signed_error) ? volume - desired : Page::error(volume, desired);
  }
  double absolute(double k1, double k2) const override {
    return makes(Mistake::signed_curvature) ? std::abs(k1 + k2) : Page::absolute(k1, k2);
  }
  double omega(double kappa) const override {
    if (!makes(Mistake::inverted_curvature_weight) || kappa_min_ == kappa_max_) return Page::omega(kappa);
    const double part = (kappa - kappa_min_) / (kappa_max_ - kappa_min_);
    return part + (1 - part) / 10;
  }
  double e_avg_after(double sum, double change, int pieces) const override {
    return Page::e_avg_after(sum, change, makes(Mistake::four_pieces) ? 4 : pieces);
  }
  bool is_diluted(const paper::Weight& weight) const override {
    return !makes(Mistake::dilution_ignored) && Page::is_diluted(weight);
  }

  // --- Table 4

  int row_of_table4(const Tet& v, const std::vector<int>& on_surface) const override {
    const int row = Page::row_of_table4(v, on_surface);
    return makes(Mistake::row_3b_as_3a) && is_row(row, "3b") ? tables::table4_row("3a") : row;
  }
  std::vector<std::vector<int>> unshared_edges(const Tet& v, int row) const override {
    if (makes(Mistake::row_4c_on_face) && is_row(row, "4c")) return {};
    return Page::unshared_edges(v, row);
  }
  Point centroid_of(const Tet& v, const std::vector<int>& positions) const override {
    const Point centroid = Page::centroid_of(v, positions);
    if (!makes(Mistake::skewed_centroid) || positions.size() != 3) return centroid;
    return (centroid * 3 + points_[v[positions[0]]]) / 4;
  }
  bool makes_surface_point(const paper::Split& split) const override {
    return !makes(Mistake::forgotten_surface_point) && Page::makes_surface_point(split);
  }

  // --- section 4

  Numbers surroundings(const Tet& replaced, const Numbers& pieces) const override {
    flips_before_ = flips_;
    if (makes(Mistake::tetrahedron_without_neighbours)) return pieces;
    if (!makes(Mistake::flips_everywhere)) return Page::surroundings(replaced, pieces);
    Numbers all;
    for (const auto& [number, tet] : tets_) all.insert(number);
    return all;
  }
  double gain(const paper::Flip& flip) const override {
    if (!makes(Mistake::worst_flip)) return Page::gain(flip);
    return flips_ > flips_before_ ? 0 : -Page::gain(flip);  // only one, or it would not end in a test's time
  }

 private:
  bool makes(Mistake mistake) const { return mistake == mistake_; }
  static bool is_row(int row, std::string_view name) { return tables::table4[row].name == name; }

  Mistake mistake_;
  mutable std::int64_t flips_before_ = 0;  ///< the number of flips before the present improvement
};

}  // namespace

const std::vector<NamedMistake>& mistakes() {
  static const std::vector<NamedMistake> all{
      {Mistake::table2_row, "table2-row"},
      {Mistake::higher_diagonal, "higher-diagonal"},
      {Mistake::table3_interior_end, "table3-interior-end"},
      {Mistake::asked_for_both, "asked-for-both"},
      {Mistake::case5_kept, "case5-kept"},
      {Mistake::distance_to_triangles, "distance-to-triangles"},
      {Mistake::volumes_exchanged, "volumes-exchanged"},
      {Mistake::signed_error, "signed-error"},
      {Mistake::signed_curvature, "signed-curvature"},
      {Mistake::inverted_curvature_weight, "inverted-curvature-weight"},
      {Mistake::four_pieces, "four-pieces"},
      {Mistake::row_3b_as_3a, "row-3b-as-3a"},
      {Mistake::row_4c_on_face, "row-4c-on-face"},
      {Mistake::forgotten_surface_point, "forgotten-surface-point"},
      {Mistake::skewed_centroid, "skewed-centroid"},
      {Mistake::dilution_ignored, "dilution-ignored"},
      {Mistake::worst_flip, "worst-flip"},
      {Mistake::flips_everywhere, "flips-everywhere"},
      {Mistake::tetrahedron_without_neighbours, "no-neighbours"}};
  return all;
}

std::vector<trace::Record> run(const TriangleSurface& given, reference::Options options, Mistake mistake) {
  reference::check(options);
  const std::optional<TriangleSurface> used = io::without_unused_vertices(given);
  const TriangleSurface& surface = used ? *used : given;
  std::vector<trace::Record> records{reference::settings_of(options, static_cast<bool>(surface.evaluate))};
  options.listener.record = [&records](const trace::Record& record) { records.push_back(record); };
  Mistaken(surface, options, mistake).run();
  return records;
}

}  // namespace tetproof::mistakes
