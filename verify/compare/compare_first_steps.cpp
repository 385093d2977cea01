// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/compare/compare_first_steps.hpp"

#include <algorithm>
#include <cmath>

#include "verify/compare/compare_settings.hpp"

namespace tetproof::verify {
namespace {

using namespace trace;

// The orders of the axes that name a cell's six tetrahedra, in the order of `Rows::rows`.
constexpr std::array<const char*, 6> orders{"xyz", "xzy", "yxz", "yzx", "zxy", "zyx"};

std::array<int, 6> key(const Cut& cut) {
  const auto [a, b] = std::minmax(cut.edge[0], cut.edge[1]);
  return {a[0], a[1], a[2], b[0], b[1], b[2]};
}

std::string name(const Indicators& row) {
  return fmt::format("indicators of the lattice vertices (0..{}, {}, {})", row.initial.size() - 1, row.j,
                     row.k);
}
std::string name(const Moved& moved) {
  return fmt::format("lattice vertex {} is moved to the surface", text(moved.vertex));
}
std::string name(const Cut& cut) {
  return fmt::format("cut of the lattice edge {}-{}", text(cut.edge[0]), text(cut.edge[1]));
}
std::string name(const Rows& rows) {
  return fmt::format("rows of cell {}", text(rows.cell));
}
std::string name(const Mapped& mapped) {
  return fmt::format("cut {} is taken to the parametric surface", text(mapped.from));
}

std::string word(char indicator) {
  return indicator == '+' ? "interior (+1)" : indicator == '-' ? "exterior (-1)" : "on the surface (0)";
}

std::string says(const Lattice& lattice) {
  return fmt::format("{} x {} x {} cells from {} to {}", lattice.cells[0], lattice.cells[1], lattice.cells[2],
                     text(lattice.box[0]), text(lattice.box[1]));
}

void compare(const Rows& a, std::int64_t line, const Rows& b, std::int64_t other_line,
             Differences& differences) {
  for (int i = 0; i < 6; ++i)
    if (a.rows[i] != b.rows[i])
      differences.add(Step::table2, line, other_line, [&] {
        return Differences::Difference{
            fmt::format(
                "tetrahedron {} of cell {} is cut by row {} of Table 2 in reference, by row {} in other",
                orders[i], text(a.cell), a.rows[i], b.rows[i]),
            {line, a.rows[i], to_line(a)},
            {other_line, b.rows[i], to_line(b)}};
      });
}

}  // namespace

// Passes the records of one trace's steps (i) to (iv) to `take`. The lattice must come before what lies in
// it, because its size gives the tolerance for points.
template <class Take>
void FirstSteps::read(TraceStream& stream, const Take& take) {
  std::int64_t settings = 0, lattice = 0;
  const auto once = [&](std::int64_t& line) {
    if (line) stream.fail(fmt::format("no second {} record after line {}", name_of(*stream.next()), line));
    line = stream.line();
  };
  for (bool going = true; going && stream.next();) {
    going = std::visit(
        [&](const auto& record) {
          using R = std::decay_t<decltype(record)>;
          if constexpr (std::is_same_v<R, Settings>) {
            once(settings);
          } else if constexpr (std::is_same_v<R, Lattice>) {
            once(lattice);
          } else if (std::is_same_v<R, FirstGrid> || std::is_same_v<R, Weight> ||
                     std::is_same_v<R, Insertion> || std::is_same_v<R, Flip> || std::is_same_v<R, End> ||
                     !lattice) {
            return false;
          }
          take(record);
          return true;
        },
        *stream.next());
    if (going) stream.take();
  }
  if (!lattice) stream.fail("a lattice record before all others but settings");
}

FirstSteps::FirstSteps(TraceStream& reference, double tolerance) : tolerance_{.relative = tolerance} {
  read(reference, [&](const auto& record) {
    using R = std::decay_t<decltype(record)>;
    note(vertices_, record);
    if constexpr (std::is_same_v<R, Settings>) {
      settings_line_ = reference.line();
      settings_ = record;
    } else if constexpr (std::is_same_v<R, Lattice>) {
      lattice_line_ = reference.line();
      lattice_ = record;
      tolerance_.length = tolerance_.relative * (record.box[1] - record.box[0]).stableNorm();
      from_ = std::make_unique<PointIndex>(tolerance_.length);
    } else if constexpr (std::is_same_v<R, Indicators>) {
      indicators_.add(reference, {record.j, record.k}, record);
    } else if constexpr (std::is_same_v<R, Moved>) {
      moved_.add(reference, record.vertex, record);
    } else if constexpr (std::is_same_v<R, Cut>) {
      cuts_.add(reference, key(record), record);
    } else if constexpr (std::is_same_v<R, Rows>) {
      rows_.add(reference, record.cell, record);
    } else if constexpr (std::is_same_v<R, Mapped>) {
      mapped_.add(reference, {from_->add(record.from)}, record);
    }
  });
}

void FirstSteps::compare(TraceStream& other, Differences& differences,
                         std::vector<std::string>& not_compared) {
  Settings settings;
  std::int64_t settings_line = 0;
  // These wait until all records are read, because only then it is known what rounding decides.
  Vertices vertices;
  std::vector<Waiting> indicators;
  std::vector<std::pair<Moved, std::int64_t>> moved;
  // Compares the points of two records that belong together.
  const auto compare_points = [&](Step step, const auto& entry, const auto& record, std::int64_t line,
                                  const Point& a, const Point& b, const std::string& why,
                                  bool by_rounding = false) {
    if (tolerance_.same(a, b)) return;
    differences.add(
        step, entry.line, line,
        [&] {
          return Differences::Difference{fmt::format("{} at {} in reference, at {} in other, {:.3g} apart{}",
                                                     name(record), text(a), text(b), (a - b).norm(), why),
                                         {entry.line, text(a), to_line(entry.record)},
                                         {line, text(b), to_line(record)}};
        },
        by_rounding);
  };
  const auto called = [](const auto& record) { return name(record); };
  read(other, [&](const auto& record) {
    using R = std::decay_t<decltype(record)>;
    note(vertices, record);
    const std::int64_t line = other.line();
    if constexpr (std::is_same_v<R, Settings>) {
      settings = record;
      settings_line = line;
    } else if constexpr (std::is_same_v<R, Lattice>) {
      if (lattice_.cells == record.cells && tolerance_.same(lattice_.box[0], record.box[0]) &&
          tolerance_.same(lattice_.box[1], record.box[1]))
        return;
      differences.add(Step::lattice, lattice_line_, other.line(), [&] {
        const bool cells = lattice_.cells != record.cells;
        return Differences::Difference{
            cells ? fmt::format("the lattice has {} x {} x {} cells in reference, {} x {} x {} in other",
                                lattice_.cells[0], lattice_.cells[1], lattice_.cells[2], record.cells[0],
                                record.cells[1], record.cells[2])
                  : "the lattice's boxes differ",
            {lattice_line_, says(lattice_), to_line(lattice_)},
            {other.line(), says(record), to_line(record)},
            cells};
      });
    } else if constexpr (std::is_same_v<R, Indicators>) {
      if (const auto* entry = indicators_.match(line, {record.j, record.k}, record, differences, called))
        indicators.push_back({entry, record, line});
    } else if constexpr (std::is_same_v<R, Moved>) {
      moved.push_back({record, line});
    } else if constexpr (std::is_same_v<R, Cut>) {
      if (const auto* entry = cuts_.match(line, key(record), record, differences, called))
        compare_points(Step::cut, *entry, record, line, entry->record.point, record.point,
                       " (Table 3, row 3b: of several, the one closest to the exterior end)");
    } else if constexpr (std::is_same_v<R, Rows>) {
      if (const auto* entry = rows_.match(line, record.cell, record, differences, called))
        verify::compare(entry->record, entry->line, record, line, differences);
    } else if constexpr (std::is_same_v<R, Mapped>) {
      if (const auto* entry = mapped_.match(line, {from_->find(record.from)}, record, differences, called))
        compare_points(Step::mapped, *entry, record, line, entry->record.to, record.to, "");
    }
  });

  const bool exact = settings_.on_surface == 0 || settings_.literal;
  compare_indicators(indicators, vertices, exact, differences);
  for (const auto& [record, line] : moved) {
    const bool doubtful = (exact || record.mended) && vertices_.doubtful(record.vertex);
    if (const auto* entry = moved_.match(line, record.vertex, record, differences, called, doubtful)) {
      const Point &a = entry->record.point, &b = record.point, from = position(record.vertex);
      const bool as_close = std::abs((a - from).norm() - (b - from).norm()) <= tolerance_.length;
      compare_points(Step::moved, *entry, record, line, a, b, as_close ? ", both as close to it" : "",
                     as_close);
      if (entry->record.mended != record.mended)
        differences.add(
            Step::moved, entry->line, line,
            [&, &ours = record, &our_line = line] {
              const auto says = [](const Moved& m) {
                return m.mended ? "moved because of rounding" : "moved because it is near";
              };
              return Differences::Difference{fmt::format("{} in both, but only in {} because of rounding",
                                                         name(ours), ours.mended ? "other" : "reference"),
                                             {entry->line, says(entry->record), to_line(entry->record)},
                                             {our_line, says(ours), to_line(ours)}};
            },
            exact || vertices_.doubtful(record.vertex));
    }
  }

  compare_settings({settings_, settings_line_}, {settings, settings_line}, tolerance_, differences);

  const auto exactly = [](const auto&) { return false; };
  const auto rest = [&](const auto& kind, const char* of, const auto& by_rounding) {
    if (kind.left_out())
      not_compared.push_back(fmt::format("{}: {} has none", of, kind.empty() ? "reference" : "other"));
    kind.rest(differences, called, by_rounding);
  };
  rest(indicators_, "indicators", exactly);
  rest(moved_, "moved vertices",
       [&](const Moved& record) { return (exact || record.mended) && vertices.doubtful(record.vertex); });
  rest(cuts_, "cuts", exactly);
  rest(rows_, "rows of Table 2", exactly);
  rest(mapped_, "mapped points", exactly);
}

Point FirstSteps::position(const LatticeVertex& vertex) const {
  Point point;
  for (int i = 0; i < 3; ++i) {
    const double t = static_cast<double>(vertex[i]) / lattice_.cells[i];
    point[i] = (1 - t) * lattice_.box[0][i] + t * lattice_.box[1][i];
  }
  return point;
}

// A cut at a lattice vertex shows that the surface passes the vertex within rounding.
void FirstSteps::note(Vertices& vertices, const Record& record) const {
  if (const auto* moved = std::get_if<Moved>(&record); moved && moved->mended)
    vertices.mended.insert(moved->vertex);
  if (const auto* cut = std::get_if<Cut>(&record))
    for (const LatticeVertex& end : cut->edge)
      if (tolerance_.same(position(end), cut->point)) vertices.near.insert(end);
}

// Adds the vertices whose indicators differ. Mending starts the characterisation again, so a vertex that only
// one of the traces has mended is compared with the moved vertices and not here.
void FirstSteps::compare_indicators(const std::vector<Waiting>& rows, const Vertices& other, bool exact_only,
                                    Differences& differences) const {
  for (const Waiting& row : rows) {
    const Indicators &a = row.reference->record, &b = row.other;
    for (const auto& [step, in_a, in_b, moment] :
         {std::tuple{Step::indicators, &a.initial, &b.initial, "initially"},
          std::tuple{Step::table3, &a.after, &b.after, "after Table 3"}}) {
      for (std::size_t i = 0; i < std::max(in_a->size(), in_b->size()); ++i) {
        const char reference = i < in_a->size() ? (*in_a)[i] : ' ', its = i < in_b->size() ? (*in_b)[i] : ' ';
        if (reference == its) continue;
        const LatticeVertex vertex{static_cast<int>(i), a.j, a.k};
        if (vertices_.mended.contains(vertex) != other.mended.contains(vertex)) continue;
        const bool by_rounding = exact_only && ((reference == '0' && other.near.contains(vertex)) ||
                                                (its == '0' && vertices_.near.contains(vertex)));
        differences.add(
            step, row.reference->line, row.line,
            [&, when = moment] {
              const auto says = [](char indicator) {
                return indicator == ' ' ? std::string("not there") : word(indicator);
              };
              return Differences::Difference{
                  fmt::format("lattice vertex {} is {} {} in reference, {} in other", text(vertex), when,
                              says(reference), says(its)),
                  {row.reference->line, says(reference), to_line(a)},
                  {row.line, says(its), to_line(b)}};
            },
            by_rounding);
      }
    }
  }
}

std::string FirstSteps::lattice_tetrahedron(const Point& point) const {
  std::array<int, 3> cell, axes{0, 1, 2};
  Point inside;  // the cell, 0 to 1
  for (int i = 0; i < 3; ++i) {
    const double at =
        (point[i] - lattice_.box[0][i]) / (lattice_.box[1][i] - lattice_.box[0][i]) * lattice_.cells[i];
    cell[i] = static_cast<int>(std::clamp(std::floor(at), 0.0, lattice_.cells[i] - 1.0));
    inside[i] = at - cell[i];
  }
  // A tetrahedron's path of vertices first follows the axis of the point's largest coordinate (reading D2).
  std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return inside[a] > inside[b]; });
  const std::string order{"xyz"[axes[0]], "xyz"[axes[1]], "xyz"[axes[2]]};
  std::string text = fmt::format("tetrahedron {} of cell {}", order, verify::text(cell));
  if (const Rows* rows = rows_.find(cell))
    text += fmt::format(", row {} of Table 2",
                        rows->rows[std::find(orders.begin(), orders.end(), order) - orders.begin()]);
  return text;
}

}  // namespace tetproof::verify
