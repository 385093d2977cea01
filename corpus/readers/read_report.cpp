// SPDX-License-Identifier: GPL-3.0-or-later
// What a reader did with damaged files, as text, JSON and JUnit XML.
#include <fmt/format.h>

#include <array>
#include <map>
#include <nlohmann/json.hpp>

#include "corpus/campaign/junit_suite.hpp"
#include "corpus/campaign/plain_page.hpp"
#include "corpus/campaign/text_table.hpp"
#include "corpus/meshing/command_words.hpp"
#include "corpus/readers/read_campaign.hpp"
#include "io/bytes/words.hpp"

namespace tetproof::corpus {
namespace {

using Json = nlohmann::ordered_json;

struct Counts {
  std::int64_t files = 0, unnoticed = 0, wordless = 0;
  std::array<std::int64_t, reading_count> of{};

  void add(const ReadCase& one) {
    ++files;
    ++of[static_cast<std::size_t>(one.run.reading)];
    if (one.unnoticed) ++unnoticed;
    if (one.run.reading == Reading::refused && one.run.wordless) ++wordless;
  }
  std::int64_t count(Reading reading) const { return of[static_cast<std::size_t>(reading)]; }
  std::int64_t findings() const {
    std::int64_t sum = 0;
    for (int r = 0; r < reading_count; ++r)
      if (is_finding(static_cast<Reading>(r))) sum += of[static_cast<std::size_t>(r)];
    return sum;
  }
};

// Rows in the order in which they first occur.
struct Rows {
  std::vector<std::pair<std::string, Counts>> rows;
  void add(const std::string& name, const ReadCase& one) {
    for (auto& [other, counts] : rows)
      if (other == name) return counts.add(one);
    rows.emplace_back(name, Counts{}).second.add(one);
  }
};

Rows rows_of(const ReadResult& result, std::string ReadCase::*key) {
  Rows rows;
  for (const ReadCase& one : result.cases) rows.add(one.*key, one);
  return rows;
}

Counts all_of(const ReadResult& result) {
  Counts counts;
  for (const ReadCase& one : result.cases) counts.add(one);
  return counts;
}

std::int64_t new_groups(const ReadResult& result) {
  std::int64_t n = 0;
  for (const ReadGroup& group : result.groups) n += !group.known;
  return n;
}

std::string summary_of(const ReadResult& result) {
  const Counts all = all_of(result);
  const std::int64_t fresh = new_groups(result),
                     known = static_cast<std::int64_t>(result.groups.size()) - fresh;
  std::string line = fmt::format("seed {}: {} on {}: {} read, {} refused, {} in {}", result.seed,
                                 printable(result.reader.name), io::counted(all.files, "files"),
                                 all.count(Reading::read), all.count(Reading::refused),
                                 io::counted(all.findings(), "findings"), io::counted(fresh, "new groups"));
  if (known > 0) line += fmt::format(" and {}", io::counted(known, "known groups"));
  line += fmt::format("; {} read without a word although the content changed", all.unnoticed);
  if (all.wordless > 0) line += fmt::format("; {} refused without a word", all.wordless);
  if (const auto refused = refused_valid_files(result); !refused.empty())
    line += fmt::format("; {} refused", io::counted(refused.size(), "valid files"));
  return line;
}

TextRows cells_of(const char* head, const Rows& rows) {
  TextRows cells{{head, "files", "read", "of these changed, unnoticed", "refused"}};
  for (int r = 0; r < reading_count; ++r)
    if (is_finding(static_cast<Reading>(r))) cells[0].emplace_back(name_of(static_cast<Reading>(r)));
  for (const auto& [name, counts] : rows.rows) {
    auto& row = cells.emplace_back(
        std::vector{name, std::to_string(counts.files), std::to_string(counts.count(Reading::read)),
                    std::to_string(counts.unnoticed), std::to_string(counts.count(Reading::refused))});
    for (int r = 0; r < reading_count; ++r)
      if (is_finding(static_cast<Reading>(r)))
        row.push_back(std::to_string(counts.of[static_cast<std::size_t>(r)]));
  }
  return cells;
}

std::string table(const char* head, const Rows& rows) {
  return text_table(cells_of(head, rows)) + "\n";
}

std::string details(const ReadGroup& group) {
  const ReadCase& first = group.cases.front();
  std::string text = fmt::format("smallest: case {}, {} ({}), {}: {}: {}\n", first.index, first.form,
                                 first.document, io::counted(first.bytes, "bytes"), first.damage, first.done);
  if (!first.run.message.empty()) text += "says: " + printable(first.run.message) + "\n";
  if (group.shrunk) text += fmt::format("shrunk: {}\n", io::counted(*group.shrunk, "bytes"));
  if (group.unseen_again) text += "did not fail again in one further run\n";
  if (!group.file.empty()) text += "file: " + group.file + "\n";
  return text;
}

Json case_json(const ReadCase& one) {
  return {{"case", one.index},
          {"form", one.form},
          {"document", one.document},
          {"damage", one.damage},
          {"done", one.done},
          {"bytes", one.bytes},
          {"outcome", name_of(one.run.reading)},
          {"signature", one.run.signature},
          {"what", one.run.message}};
}

Json rows_json(const Rows& rows) {
  Json json = Json::object();
  for (const auto& [name, counts] : rows.rows) {
    Json& row = json[name];
    row["files"] = counts.files;
    for (int r = 0; r < reading_count; ++r)
      row[name_of(static_cast<Reading>(r))] = counts.of[static_cast<std::size_t>(r)];
    row["unnoticed"] = counts.unnoticed;
    row["refused_without_a_word"] = counts.wordless;
  }
  return json;
}

std::vector<std::string> remarks(const ReadResult& result) {
  std::vector<std::string> lines;
  for (const std::string& id : result.known_unseen)
    lines.push_back("known, and did not occur: " + printable(id));
  for (const std::string& id : result.not_applied)
    lines.push_back("asked for, and applied to no file: " + id);
  for (const ReadCase* one : refused_valid_files(result))
    lines.push_back(fmt::format("refused, though valid: {} ({}): {}", one->form, one->document,
                                printable(one->run.message)));
  return lines;
}

}  // namespace

std::string read_text(const ReadResult& result) {
  std::string text = summary_of(result) + "\n\n" + table("format", rows_of(result, &ReadCase::form)) +
                     table("damage", rows_of(result, &ReadCase::damage));
  std::size_t number = 0;
  for (const ReadGroup& group : result.groups) {
    text += fmt::format("{}. {}{}\n  {}\n", ++number, printable(group.id()), group.known ? "  (known)" : "",
                        io::counted(group.cases.size(), "files"));
    const std::string more = details(group);
    for (std::size_t at = 0; at < more.size(); at = more.find('\n', at) + 1)
      text += "  " + more.substr(at, more.find('\n', at) + 1 - at);
  }
  for (const std::string& line : remarks(result)) text += line + "\n";
  return text;
}

std::string read_page(const ReadResult& result, const std::string& folder) {
  PlainPage page{.title = printable(result.reader.name) + " on damaged files",
                 .summary = summary_of(result),
                 .tables = {{"formats", "By format", cells_of("format", rows_of(result, &ReadCase::form))},
                            {"damages", "By damage", cells_of("damage", rows_of(result, &ReadCase::damage))}},
                 .remarks = remarks(result)};
  for (const ReadGroup& group : result.groups)
    page.findings.push_back(fmt::format(
        "{}{}\n{}\n{}\n{}", printable(group.id()), group.known ? "  (known)" : "",
        io::counted(group.cases.size(), "files"), details(group), readme_beside(folder, group.file)));
  const std::int64_t fresh = new_groups(result);
  const bool all_said = refused_valid_files(result).empty() && result.not_applied.empty();
  page.verdict = fresh > 0  ? fmt::format("{} new", fresh)
                 : all_said ? "nothing new"
                            : "nothing new, but not all was tried";
  page.verdict_kind = fresh > 0 ? "fail" : all_said ? "pass" : "warning";
  return plain_page(page);
}

std::string read_json(const ReadResult& result) {
  const Counts all = all_of(result);
  Json json;
  json["summary"] = summary_of(result);
  json["findings"] = all.findings();
  json["new_groups"] = new_groups(result);
  json["settings"] = {
      {"seed", result.seed}, {"reader", result.reader.name}, {"command", command_line(result.reader.words)}};
  json["by_format"] = rows_json(rows_of(result, &ReadCase::form));
  json["by_damage"] = rows_json(rows_of(result, &ReadCase::damage));
  Json groups = Json::array(), refused = Json::array(), unnoticed = Json::array();
  for (const ReadGroup& group : result.groups) {
    Json one{{"id", group.id()},
             {"outcome", name_of(group.reading)},
             {"signature", group.signature},
             {"known", group.known},
             {"file", group.file},
             {"shrunk", nullptr},
             {"unseen_again", group.unseen_again},
             {"cases", Json::array()}};
    if (group.shrunk) one["shrunk"] = *group.shrunk;
    for (const ReadCase& member : group.cases) one["cases"].push_back(case_json(member));
    groups.push_back(std::move(one));
  }
  for (const ReadCase* one : refused_valid_files(result)) refused.push_back(case_json(*one));
  for (const ReadCase& one : result.cases)
    if (one.unnoticed) unnoticed.push_back(case_json(one));
  json["groups"] = std::move(groups);
  json["refused_valid"] = std::move(refused);
  json["unnoticed"] = std::move(unnoticed);
  json["known_unseen"] = result.known_unseen;
  json["not_applied"] = result.not_applied;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string read_junit(const ReadResult& result) {
  JunitSuite suite(result.reader.name);
  const Counts all = all_of(result);
  if (all.files > all.findings()) suite.pass(fmt::format("read or refused: {}", all.files - all.findings()));
  for (const ReadGroup& group : result.groups) {
    const std::string name = fmt::format("{} ({})", group.id(), io::counted(group.cases.size(), "files"));
    if (group.known)
      suite.skip(name, "known");
    else
      suite.fail(name, name_of(group.reading), group.cases.front().run.message, details(group));
  }
  for (const ReadCase* one : refused_valid_files(result))
    suite.skip(fmt::format("{} ({}), valid", one->form, one->document), "refused: " + one->run.message);
  for (const std::string& id : result.not_applied) suite.skip(id, "applied to no file");
  return junit_document({suite});
}

}  // namespace tetproof::corpus
