// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a mesh and the solution beside it, each in the form that its content shows.
#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "io/bytes/byte_order.hpp"
#include "io/bytes/scanner.hpp"
#include "io/error.hpp"
#include "io/medit/medit.hpp"
#include "io/medit/medit_content.hpp"
#include "io/medit/medit_solution.hpp"

namespace tetproof::io {
namespace {

void read_into(MeditContent& content, const InputFile& file, MeditPart part) {
  for (const std::endian order : {std::endian::little, std::endian::big})
    if (file.bytes().size() >= 4 && load<std::int32_t>(file.bytes().data(), order) == 1)
      return read_medit_binary(file, order, content, part);
  read_medit_text(file, content, part);
}

// Whether a file begins as Medit's do. Other programs have files with the ending .sol too.
bool is_medit(const InputFile& file) {
  if (Scanner(file).word('#').starts_with("MeshVersionFormatted")) return true;
  for (const std::endian order : {std::endian::little, std::endian::big})
    if (file.bytes().size() >= 4 && load<std::int32_t>(file.bytes().data(), order) == 1) return true;
  return false;
}

// The solution beside a mesh was not asked for, so it never stands in the way of the mesh.
void read_solution_beside(MeditContent& content, const std::string& path) {
  try {
    const InputFile file(path);
    if (!is_medit(file)) return content.warn_of(path, "no solution as Medit has them; it is not read");
    MeditContent solution(path);
    read_into(solution, file, MeditPart::solution);
    content.take_solutions(std::move(solution));
  } catch (const InputError& error) {
    content.drop("solutions beside the mesh that cannot be read", 1, error.what());
  }
}

}  // namespace

Document read_medit(const InputFile& file) {
  const std::string path = file.is_named() ? file.path() : "";
  // Standard input has no files beside it.
  const std::vector<std::string> files = path.empty() ? std::vector<std::string>{} : medit_files_read(path);
  MeditContent content(file.path());
  if (!path.empty() && is_medit_solution(path)) {
    if (files.size() < 2)
      throw InputError(fmt::format("{}: expected its mesh beside it, {}; found none", path,
                                   fmt::join(medit_meshes_beside(path), " or ")));
    read_into(content, InputFile(files[1]), MeditPart::mesh);
    MeditContent solution(path);
    read_into(solution, file, MeditPart::solution);
    content.take_solutions(std::move(solution));
    return content.finish();
  }
  read_into(content, file, MeditPart::mesh);
  if (files.size() > 1) read_solution_beside(content, files[1]);
  return content.finish();
}

}  // namespace tetproof::io
