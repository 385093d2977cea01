// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/program/report_losses.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

namespace tetproof::program {
namespace {

std::string line(const std::string& what, const Loss& loss) {
  return fmt::format("{}: {}: {} ({})", what, loss.item, loss.count, loss.example);
}

}  // namespace

void report_reading(const Common& common, const std::vector<std::string>& warnings,
                    const std::vector<Loss>& dropped) {
  for (const std::string& warning : warnings) say(common, "warning: " + warning);
  for (const Loss& loss : dropped) say(common, line("not read", loss));
}

nlohmann::ordered_json losses_json(const std::vector<Loss>& losses) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Loss& loss : losses)
    list.push_back({{"item", loss.item}, {"count", loss.count}, {"example", loss.example}});
  return list;
}

MeshOutput::MeshOutput(const Common& common, FilesInUse& files, const std::string& argument, std::string path,
                       const Document& document, WriteOptions options)
    : path_(std::move(path)), document_(document), options_(std::move(options)) {
  files.writes_mesh(argument, path_, options_, document_);
  losses_ = tetproof::losses(path_, document_, options_);
  kept_aside_ = tetproof::kept_aside(path_, document_, options_);
  for (const Loss& loss : losses_) say(common, line("lost", loss));
  for (const Loss& loss : kept_aside_.items) say(common, line("kept in " + kept_aside_.where, loss));
  const std::string warning = write_warning(path_, document_, options_);
  if (!warning.empty()) say(common, "warning: " + warning);
}

void MeshOutput::write() const {
  write_document(path_, document_, options_);
}

}  // namespace tetproof::program
