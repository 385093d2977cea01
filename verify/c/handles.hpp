// SPDX-License-Identifier: GPL-3.0-or-later
// The objects behind the pointers of the C interface.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "io/document.hpp"
#include "io/triangle_surface.hpp"
#include "verify/c/document_view.hpp"
#include "verify/c/records.hpp"
#include "verify/c/tetproof.h"
#include "verify/report.hpp"
#include "verify/surface.hpp"

/// A surface, which is judged when that is first asked for.
struct tetproof_surface {
  std::string name;  ///< for messages; empty: it came from arrays
  tetproof::TriangleSurface surface;
  tetproof::SurfaceNumbering numbering;
  std::vector<std::string> warnings;
  std::vector<tetproof::Loss> dropped;
  tetproof_surface_arrays arrays{};

  const tetproof::verify::JudgedSurface& judged() const;
  /// Fills `arrays`, when all else is in its place.
  void lay_out();

 private:
  // Several threads may ask. Those that wait hold none of the work: each has an arena of its own.
  mutable std::mutex judging_;
  mutable std::optional<tetproof::verify::JudgedSurface> judged_;
};

/// A document, whose arrays are made when they are first asked for.
struct tetproof_document {
  tetproof::Document document;

  const tetproof_document_arrays& arrays() const;
  void forget_arrays() { view_.reset(); }

 private:
  mutable std::mutex viewing_;
  mutable std::unique_ptr<const tetproof::c::DocumentView> view_;
};

/// A report with the numbers that it names elements by, the regions that were judged, and its records.
struct tetproof_report {
  tetproof_report(tetproof::verify::Report made, tetproof::Numbering names, tetproof::TetRegions judged)
      : report(std::move(made)),
        numbering(std::move(names)),
        regions(std::move(judged)),
        records(report, numbering) {}
  tetproof_report(const tetproof_report&) = delete;
  tetproof_report& operator=(const tetproof_report&) = delete;

  const tetproof::verify::Report report;
  const tetproof::Numbering numbering;
  const tetproof::TetRegions regions;
  const tetproof::c::Records records;
};
