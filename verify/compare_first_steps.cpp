// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/compare_first_steps.hpp"

namespace tetproof::verify {
namespace {

using namespace trace;

constexpr std::array<const char*, 6> orders{"xyz", "xzy", "yxz",
                                            "yzx", "zxy", "zyx"};  // of the axes, as `rows` has them

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

// The settings that differ: for the sentence, and for each side.
struct Differing {
  std::string what, reference, other;
};

Differing differing(const Settings& a, const Settings& b, const Tolerance& tolerance) {
  Differing all;
  const auto compare = [&](const char* key, const auto& reference, const auto& other) {
    bool same = reference == other;
    if constexpr (std::is_same_v<std::decay_t<decltype(reference)>, double>)
      same = tolerance.same(reference, other);
    if (same) return;
    const char* const separator = all.what.empty() ? "" : "; ";
    all.what += fmt::format("{}{} is {} in reference, {} in other", separator, key, reference, other);
    all.reference += fmt::format("{}{} {}", separator, key, reference);
    all.other += fmt::format("{}{} {}", separator, key, other);
  };
  compare("region", a.region, b.region);
  compare("box_scale", a.box_scale, b.box_scale);
  compare("on_surface", a.on_surface, b.on_surface);
  compare("diagonals", a.diagonals, b.diagonals);
  compare("literal", a.literal, b.literal);
  compare("p", a.p, b.p);
  compare("curvature", a.curvature, b.curvature);
  compare("parametric", a.parametric, b.parametric);
  compare("improve", a.improve, b.improve);
  if (a.improve != "none" || b.improve != "none") compare("improve_below", a.improve_below, b.improve_below);
  compare("points", a.points, b.points);
  compare("past_dilution", a.past_dilution, b.past_dilution);
  return all;
}

std::string says(const Lattice& lattice) {
  return fmt::format("{} x {} x {} cells from {} to {}", lattice.cells[0], lattice.cells[1], lattice.cells[2],
                     text(lattice.box[0]), text(lattice.box[1]));
}

// The first vertex of the row whose indicators differ, and the difference.
void compare(const Indicators& a, std::int64_t line, const Indicators& b, std::int64_t other_line,
             Differences& differences) {
  for (const auto& [step, row, other_row, when] :
       {std::tuple{Step::indicators, &a.initial, &b.initial, "initially"},
        std::tuple{Step::table3, &a.after, &b.after, "after Table 3"}}) {
    for (std::size_t i = 0; i < std::max(row->size(), other_row->size()); ++i) {
      const char in_reference = i < row->size() ? (*row)[i] : ' ',
                 in_other = i < other_row->size() ? (*other_row)[i] : ' ';
      if (in_reference == in_other) continue;
      differences.add(step, line, other_line, [&, when = when] {
        const std::string reference = in_reference == ' ' ? "not there" : word(in_reference),
                          other = in_other == ' ' ? "not there" : word(in_other);
        return Differences::Difference{
            fmt::format("lattice vertex ({}, {}, {}) is {} {} in reference, {} in other", i, a.j, a.k, when,
                        reference, other),
            {line, reference, to_line(a)},
            {other_line, other, to_line(b)}};
      });
    }
  }
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

// Reads one trace's steps (i) to (iv). The lattice must come before what lies in it: points are matched by
// its size.
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
          } else if constexpr (std::is_same_v<R, FirstGrid> || std::is_same_v<R, Weight> ||
                               std::is_same_v<R, Insertion> || std::is_same_v<R, Flip> ||
                               std::is_same_v<R, End>) {
            return false;
          } else if (!lattice) {
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

void FirstSteps::compare(TraceStream& other, Differences& differences, std::vector<std::string>& notes) {
  Settings settings;
  std::int64_t settings_line = 0;
  // Points that must agree, where a record of each trace has one.
  const auto compare_points = [&](Step step, const auto& entry, const auto& record, const Point& a,
                                  const Point& b, const std::string& why) {
    if (tolerance_.same(a, b)) return;
    differences.add(step, entry.line, other.line(), [&] {
      return Differences::Difference{fmt::format("{} at {} in reference, at {} in other, {:.3g} apart{}",
                                                 name(record), text(a), text(b), (a - b).norm(), why),
                                     {entry.line, text(a), to_line(entry.record)},
                                     {other.line(), text(b), to_line(record)}};
    });
  };
  const auto called = [](const auto& record) { return name(record); };
  read(other, [&](const auto& record) {
    using R = std::decay_t<decltype(record)>;
    if constexpr (std::is_same_v<R, Settings>) {
      settings = record;
      settings_line = other.line();
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
            {other.line(), says(record), to_line(record)}};
      });
    } else if constexpr (std::is_same_v<R, Indicators>) {
      if (const auto* entry = indicators_.match(other, {record.j, record.k}, record, differences, called))
        verify::compare(entry->record, entry->line, record, other.line(), differences);
    } else if constexpr (std::is_same_v<R, Moved>) {
      if (const auto* entry = moved_.match(other, record.vertex, record, differences, called))
        compare_points(Step::moved, *entry, record, entry->record.point, record.point, "");
    } else if constexpr (std::is_same_v<R, Cut>) {
      if (const auto* entry = cuts_.match(other, key(record), record, differences, called))
        compare_points(Step::cut, *entry, record, entry->record.point, record.point,
                       " (Table 3, row 3b: of several, the one closest to the exterior end)");
    } else if constexpr (std::is_same_v<R, Rows>) {
      if (const auto* entry = rows_.match(other, record.cell, record, differences, called))
        verify::compare(entry->record, entry->line, record, other.line(), differences);
    } else if constexpr (std::is_same_v<R, Mapped>) {
      if (const auto* entry = mapped_.match(other, {from_->find(record.from)}, record, differences, called))
        compare_points(Step::mapped, *entry, record, entry->record.to, record.to, "");
    }
  });

  if (const Differing all = differing(settings_, settings, tolerance_); !all.what.empty())
    differences.add(Step::settings, settings_line_, settings_line, [&] {
      const auto side = [](std::int64_t line, const std::string& says, const Settings& of) {
        return Says{line, line ? says : "no settings record: the defaults", to_line(of)};
      };
      return Differences::Difference{"the settings differ: " + all.what,
                                     side(settings_line_, all.reference, settings_),
                                     side(settings_line, all.other, settings)};
    });

  const auto rest = [&](const auto& kind, const char* of) {
    if (kind.left_out())
      notes.push_back(
          fmt::format("{} are not compared: {} has none", of, kind.empty() ? "reference" : "other"));
    kind.rest(differences, called);
  };
  rest(indicators_, "indicators");
  rest(moved_, "moved vertices");
  rest(cuts_, "cuts");
  rest(rows_, "rows of Table 2");
  rest(mapped_, "mapped points");
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
  // The path of a tetrahedron's vertices goes along the axis of its largest coordinate first (reading D2).
  std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return inside[a] > inside[b]; });
  const std::string order{"xyz"[axes[0]], "xyz"[axes[1]], "xyz"[axes[2]]};
  std::string text = fmt::format("tetrahedron {} of cell {}", order, verify::text(cell));
  if (const Rows* rows = rows_.find(cell))
    text += fmt::format(", row {} of Table 2",
                        rows->rows[std::find(orders.begin(), orders.end(), order) - orders.begin()]);
  return text;
}

}  // namespace tetproof::verify
