// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/program/report_losses.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace tetproof::program {

std::string loss_line(const std::string& what, const Loss& loss) {
  return fmt::format("{}: {}: {} ({})", what, loss.item, loss.count, loss.example);
}

void report_reading(const Common& common, const std::vector<std::string>& warnings,
                    const std::vector<Loss>& dropped) {
  for (const std::string& warning : warnings) say(common, "warning: " + warning);
  for (const Loss& loss : dropped) say(common, loss_line("not read", loss));
}

nlohmann::ordered_json losses_json(const std::vector<Loss>& losses) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Loss& loss : losses)
    list.push_back({{"item", loss.item}, {"count", loss.count}, {"example", loss.example}});
  return list;
}

MeshOutput::MeshOutput(const Common& common, FilesInUse& files, const std::string& argument,
                       const std::string& path, const Document& document, const WriteOptions& options)
    : file_(path, document, options) {
  files.writes_mesh(argument, file_);
  for (const Loss& loss : losses()) say(common, loss_line("lost", loss));
  for (const Loss& loss : kept_aside().items) say(common, loss_line("kept in " + kept_aside().where, loss));
  dangling_ = file_.dangling();
  for (const Loss& loss : dangling_)
    say(common, "warning: " + loss_line(path, loss) + ": other programs may refuse the file");
  if (!file_.warning().empty()) say(common, "warning: " + file_.warning());
}

}  // namespace tetproof::program
