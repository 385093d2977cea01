// SPDX-License-Identifier: GPL-3.0-or-later
// What the functions of documents and of surfaces share.
#pragma once

#include <string>
#include <vector>

#include "io/document.hpp"
#include "verify/c/tetproof.h"

namespace tetproof::c {

/// The arrays of a caller that make a document; null: none.
struct DocumentArrays {
  const tetproof_points* points = nullptr;
  const tetproof_integers* tets = nullptr;
  const tetproof_integers* tet_groups = nullptr;
  const tetproof_integers* triangles = nullptr;
  const tetproof_integers* triangle_groups = nullptr;
};

/// The document, with the points and elements numbered from the arrays' base on. Refused: what tetproof.h
/// does not permit.
Document document_of_arrays(const DocumentArrays& arrays);

/// A path for the readers and writers, to whom "-" is standard input: here it is a file.
std::string path_of(const std::string& path);

/// The JSON of tetproof_surface_json.
std::string reading_json(const std::vector<std::string>& warnings, const std::vector<Loss>& dropped);

}  // namespace tetproof::c
