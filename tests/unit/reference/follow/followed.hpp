// SPDX-License-Identifier: GPL-3.0-or-later
// Runs whose traces the tests change and follow.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "corpus/surfaces.hpp"
#include "io/error.hpp"
#include "reference/generate.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof::reference {

using Records = std::vector<trace::Record>;

struct TracedRun {
  TriangleSurface surface;
  Options options;
  Records records{};

  TracedRun(const std::string& surface_name, const Options& run_options)
      : surface(corpus::make_surface(surface_name)), options(run_options) {
    Options recorded = options;
    recorded.listener.record = [this](const trace::Record& record) { records.push_back(record); };
    generate(surface, recorded);
  }
};

/// A sphere with flips; its surface points are mapped.
inline const TracedRun& sphere() {
  static const TracedRun run(
      "sphere:r=1,n=300",
      {.cells = {5, 0, 0}, .adapt = AdaptOptions{.v0 = {0.2}, .v1 = {1}, .improve_below = 0.01}});
  return run;
}

/// The position of the n-th record of a kind, from 0.
template <class Kind>
std::size_t find(const Records& records, std::size_t n) {
  for (std::size_t i = 0; i < records.size(); ++i)
    if (std::holds_alternative<Kind>(records[i]) && n-- == 0) return i;
  throw std::logic_error("too few records for this test");
}
template <class Kind>
Kind& get(Records& records, std::size_t n = 0) {
  return std::get<Kind>(records[find<Kind>(records, n)]);
}

inline void insert(Records& records, std::size_t at, const trace::Record& record) {
  records.insert(records.begin() + static_cast<std::ptrdiff_t>(at), record);
}
inline void drop(Records& records, std::size_t at) {
  records.erase(records.begin() + static_cast<std::ptrdiff_t>(at));
}

class FollowTest : public testing::Test {
 protected:
  /// Follows `records` with the options of `run`.
  Generation generate_along(const Records& records, const TracedRun& run = sphere()) const {
    std::string lines;
    for (const trace::Record& record : records) lines += trace::to_line(record) + "\n";
    Options options = run.options;
    options.follow = files.write("trace.jsonl", lines);
    return generate(run.surface, options);
  }
  Follow follow_records(const Records& records, const TracedRun& run = sphere()) const {
    return *generate_along(records, run).follow;
  }

  /// Expects the change to be found at record `at`, with these words.
  void expect_found(const Records& records, std::size_t at, const std::string& words,
                    const TracedRun& run = sphere()) const {
    const Follow outcome = follow_records(records, run);
    EXPECT_FALSE(outcome.admissible);
    EXPECT_EQ(outcome.line, static_cast<std::int64_t>(at) + 1) << outcome.what;
    EXPECT_NE(outcome.what.find(words), std::string::npos) << outcome.what;
  }
  void expect_admissible(const Records& records, const TracedRun& run = sphere()) const {
    const Follow outcome = follow_records(records, run);
    EXPECT_TRUE(outcome.admissible) << outcome.line << ": " << outcome.what;
  }

  const test::TestFiles files;
};

}  // namespace tetproof::reference
