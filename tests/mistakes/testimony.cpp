// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/mistakes/testimony.hpp"

#include "tests/support/test_files.hpp"

namespace tetproof::mistakes {
namespace {

std::string write(const test::TestFiles& files, const std::string& name,
                  const std::vector<trace::Record>& records) {
  std::string text;
  for (const trace::Record& record : records) text += trace::to_line(record) + '\n';
  return files.write(name, text);
}

}  // namespace

Testimony testify(const TriangleSurface& surface, const reference::Options& options, Mistake mistake) {
  Testimony result{.mistaken = run(surface, options, mistake)};
  result.reference.push_back(reference::settings_of(options, static_cast<bool>(surface.evaluate)));
  reference::Options recorded = options;
  recorded.listener.record = [&](const trace::Record& record) { result.reference.push_back(record); };
  reference::generate(surface, recorded);

  const auto follow = [&](const std::string& path) {
    reference::Options replay = options;
    replay.follow = path;
    return reference::generate(surface, replay).follow.value();
  };
  const auto check = [&](const std::string& path) {
    const reference::Follow checked = follow(path);
    return verify::CheckedTrace{
        .admissible = checked.admissible, .line = checked.line, .what = checked.what, .ties = checked.ties};
  };
  const test::TestFiles files;
  const std::string other = write(files, "mistaken.jsonl", result.mistaken);
  result.comparison =
      verify::compare_traces(other, write(files, "reference.jsonl", result.reference), 1e-9, check);
  result.follow = follow(other);
  return result;
}

}  // namespace tetproof::mistakes
