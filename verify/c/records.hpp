// SPDX-License-Identifier: GPL-3.0-or-later
// A report as the plain records of the C interface.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "io/tet_mesh.hpp"
#include "verify/c/tetproof.h"
#include "verify/report.hpp"

namespace tetproof::c {

/// The records of a report. They refer to its texts, so that it must outlive them and stay in its place.
class Records {
 public:
  Records(const verify::Report& report, const Numbering& numbering);
  Records(const Records&) = delete;
  Records& operator=(const Records&) = delete;
  const tetproof_records& all() const { return all_; }

 private:
  // Records of one type, which stay where they are, and the list of pointers to them.
  template <class Record>
  struct List {
    std::deque<Record> records;
    std::deque<std::vector<const Record*>> lists;
  };

  template <class Record, class Items, class Make>
  const Record* const* list(List<Record>& to, const Items& items, const Make& make);
  const std::int64_t* keep(std::vector<std::int64_t> numbers);
  const tetproof_check* const* checks(const std::vector<verify::CheckResult>& results);
  const tetproof_consequence* const* consequences(const std::vector<verify::Consequence>& all);
  const tetproof_not_judged* const* not_judged(const std::vector<verify::NotJudged>& all);
  tetproof_check check(const verify::CheckResult& result);
  tetproof_finding finding(const verify::Finding& finding);
  tetproof_shape shape(const verify::Shape& shape);
  void take_measures(const verify::Report& report);

  const Numbering& numbering_;
  std::deque<std::vector<std::int64_t>> numbers_;
  List<tetproof_check> checks_;
  List<tetproof_finding> findings_;
  List<tetproof_consequence> consequences_;
  List<tetproof_not_judged> not_judged_;
  List<tetproof_region> regions_;
  std::vector<const char*> notes_;
  tetproof_shape mesh_{}, surface_{};
  tetproof_volume volume_{};
  tetproof_fidelity fidelity_{};
  tetproof_quality quality_{};
  tetproof_records all_{};
};

}  // namespace tetproof::c
