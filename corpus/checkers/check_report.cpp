// SPDX-License-Identifier: GPL-3.0-or-later
// The matrix of checkers and kinds of defects, as text, JSON and JUnit XML.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "corpus/campaign/junit_suite.hpp"
#include "corpus/campaign/plain_page.hpp"
#include "corpus/campaign/text_table.hpp"
#include "corpus/checkers/check_campaign.hpp"
#include "corpus/meshing/command_words.hpp"
#include "io/bytes/words.hpp"

namespace tetproof::corpus {
namespace {

using Json = nlohmann::ordered_json;

std::int64_t of(const GradeCounts& counts, Grade grade) {
  return counts[static_cast<std::size_t>(grade)];
}

std::int64_t sum_where(const GradeCounts& counts, bool (*holds)(Grade)) {
  std::int64_t sum = 0;
  for (int g = 0; g < grade_count; ++g)
    if (holds(static_cast<Grade>(g))) sum += counts[static_cast<std::size_t>(g)];
  return sum;
}

std::int64_t total(const GradeCounts& counts) {
  return sum_where(counts, [](Grade) { return true; });
}

// "3 seen", "2 missed, 1 seen": findings first.
std::string cell(const GradeCounts& counts) {
  std::vector<std::string> words;
  for (const bool findings : {true, false})
    for (int g = 0; g < grade_count; ++g)
      if (const auto grade = static_cast<Grade>(g); is_finding(grade) == findings && of(counts, grade) > 0)
        words.push_back(fmt::format("{} {}", of(counts, grade), name_of(grade)));
  return words.empty() ? "-" : fmt::format("{}", fmt::join(words, ", "));
}

std::string summary_of(const CheckResult& result) {
  std::int64_t findings = 0, unasked = 0;
  for (const Checker& checker : result.checkers) {
    const GradeCounts counts = count_grades(result, checker.name);
    findings += sum_where(counts, is_finding);
    unasked += sum_where(counts, is_unasked);
  }
  std::string line = fmt::format(
      "seed {}: {} on {} of {}: {} in {}", result.seed, io::counted(result.checkers.size(), "checkers"),
      io::counted(result.checkers.empty() ? 0 : result.cases.size() / result.checkers.size(), "meshes"),
      io::counted(result.kinds.size(), "kinds"), io::counted(findings, "findings"),
      io::counted(result.findings.size(), "groups"));
  if (unasked > 0) line += fmt::format("; nothing is said of {}", io::counted(unasked, "cases"));
  return line;
}

TextRows totals_rows(const CheckResult& result) {
  std::vector<Grade> columns;
  for (int g = 0; g < grade_count; ++g) {
    const auto grade = static_cast<Grade>(g);
    bool used = grade <= Grade::false_alarm;
    for (const Checker& checker : result.checkers)
      used = used || of(count_grades(result, checker.name), grade) > 0;
    if (used) columns.push_back(grade);
  }
  TextRows rows{{"checker", "meshes"}};
  for (const Grade grade : columns) rows[0].emplace_back(name_of(grade));
  for (const Checker& checker : result.checkers) {
    const GradeCounts counts = count_grades(result, checker.name);
    auto& row = rows.emplace_back(std::vector{checker.name, std::to_string(total(counts))});
    for (const Grade grade : columns) row.push_back(std::to_string(of(counts, grade)));
  }
  return rows;
}

TextRows matrix_rows(const CheckResult& result) {
  TextRows rows{{"kind of defect"}};
  for (const Checker& checker : result.checkers) rows[0].push_back(checker.name);
  for (const std::string& kind : result.kinds) {
    auto& row = rows.emplace_back(std::vector{kind});
    for (const Checker& checker : result.checkers)
      row.push_back(cell(count_grades(result, checker.name, kind)));
  }
  return rows;
}

std::string finding_text(const CheckFinding& finding, std::size_t number) {
  const CheckedCase& first = finding.cases.front();
  std::string text = fmt::format("{}. {}:{}:{}\n", number, printable(finding.checker), name_of(finding.grade),
                                 printable(finding.subject));
  text += fmt::format("  {}; smallest: case {}, {} in {}, {}\n", io::counted(finding.cases.size(), "cases"),
                      first.index, first.kind, first.ground, io::counted(first.tets, "tetrahedra"));
  if (!first.what.empty()) text += "  says: " + printable(first.what) + "\n";
  if (!finding.file.empty()) text += "  file: " + finding.file + "\n";
  return text;
}

Json counts_json(const GradeCounts& counts) {
  Json json;
  json["meshes"] = total(counts);
  for (int g = 0; g < grade_count; ++g)
    json[name_of(static_cast<Grade>(g))] = counts[static_cast<std::size_t>(g)];
  return json;
}

Json case_json(const CheckedCase& one) {
  return {{"case", one.index},           {"checker", one.checker},     {"kind", one.kind},
          {"ground", one.ground},        {"tets", one.tets},           {"expected", name_of(one.expected)},
          {"grade", name_of(one.grade)}, {"signature", one.signature}, {"what", one.what}};
}

std::vector<std::string> reasons_without_answer(const CheckResult& result) {
  // Each reason once: a format is named, not its every mesh.
  std::vector<std::string> reasons;
  for (const CheckedCase& one : result.cases) {
    if (!is_unasked(one.grade)) continue;
    const std::string line =
        fmt::format("{}: {}: {}: {}", one.checker, name_of(one.grade), one.kind, one.what);
    if (std::find(reasons.begin(), reasons.end(), line) == reasons.end()) reasons.push_back(line);
  }
  return reasons;
}

}  // namespace

std::string check_text(const CheckResult& result) {
  std::string text = summary_of(result) + "\n\n" + text_table(totals_rows(result)) + "\n" +
                     text_table(matrix_rows(result)) + "\n";
  std::size_t number = 0;
  for (const CheckFinding& finding : result.findings) text += finding_text(finding, ++number);
  for (const std::string& line : reasons_without_answer(result))
    text += "not asked or no answer: " + printable(line) + "\n";
  return text;
}

std::string check_page(const CheckResult& result, const std::string& folder) {
  PlainPage page{.title = "Checkers on planted defects",
                 .summary = summary_of(result),
                 .tables = {{"checkers", "By checker", totals_rows(result)},
                            {"kinds", "By kind of defect", matrix_rows(result)}},
                 .remarks = reasons_without_answer(result)};
  std::size_t number = 0;
  for (const CheckFinding& finding : result.findings)
    page.findings.push_back(finding_text(finding, ++number) + "\n" + readme_beside(folder, finding.file));
  const bool all_said = page.remarks.empty();
  page.verdict = !page.findings.empty() ? io::counted(page.findings.size(), "groups of findings")
                 : all_said             ? "nothing found"
                                        : "nothing found, but not all was answered";
  page.verdict_kind = !page.findings.empty() ? "fail" : all_said ? "pass" : "warning";
  return plain_page(page);
}

std::string check_json(const CheckResult& result) {
  Json json;
  json["summary"] = summary_of(result);
  json["settings"] = {{"seed", result.seed}, {"each", result.each}};
  Json checkers = Json::array(), totals = Json::object(), rows = Json::object();
  for (const Checker& checker : result.checkers) {
    checkers.push_back({{"name", checker.name},
                        {"command", command_line(checker.words)},
                        {"version", checker.version},
                        {"format", checker.format}});
    totals[checker.name] = counts_json(count_grades(result, checker.name));
  }
  for (const std::string& kind : result.kinds)
    for (const Checker& checker : result.checkers)
      rows[kind][checker.name] = counts_json(count_grades(result, checker.name, kind));
  json["checkers"] = std::move(checkers);
  json["by_checker"] = std::move(totals);
  json["matrix"] = std::move(rows);
  Json findings = Json::array();
  for (const CheckFinding& finding : result.findings) {
    Json one{{"checker", finding.checker},
             {"grade", name_of(finding.grade)},
             {"subject", finding.subject},
             {"file", finding.file},
             {"cases", Json::array()}};
    for (const CheckedCase& member : finding.cases) one["cases"].push_back(case_json(member));
    findings.push_back(std::move(one));
  }
  json["findings"] = std::move(findings);
  json["unasked"] = Json::array();
  for (const CheckedCase& one : result.cases)
    if (is_unasked(one.grade)) json["unasked"].push_back(case_json(one));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string check_junit(const CheckResult& result) {
  std::vector<JunitSuite> suites;
  for (const Checker& checker : result.checkers) {
    JunitSuite& suite = suites.emplace_back(checker.name);
    for (const std::string& kind : result.kinds) {
      const GradeCounts counts = count_grades(result, checker.name, kind);
      if (sum_where(counts, is_finding) == 0) {
        if (sum_where(counts, is_unasked) > 0)
          suite.skip(kind, cell(counts));
        else
          suite.pass(kind);
        continue;
      }
      std::string details;
      const CheckedCase* worst = nullptr;
      for (const CheckedCase& one : result.cases) {
        if (one.checker != checker.name || one.kind != kind || !is_finding(one.grade)) continue;
        if (!worst) worst = &one;
        details += fmt::format("case {} in {}, {}: {}: {}\n", one.index, one.ground,
                               io::counted(one.tets, "tetrahedra"), name_of(one.grade), one.what);
      }
      suite.fail(kind, name_of(worst->grade), cell(counts), details);
    }
  }
  return junit_document(suites);
}

}  // namespace tetproof::corpus
