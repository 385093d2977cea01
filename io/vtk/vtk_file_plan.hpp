// SPDX-License-Identifier: GPL-3.0-or-later
// What the plans of VTK's two file formats have in common.
#pragma once

#include <optional>
#include <string>

#include "io/loss/file_plan.hpp"
#include "io/vtk/vtk_mesh.hpp"
#include "io/vtk/vtk_plan.hpp"

namespace tetproof::io {

class VtkFilePlan : public OneFilePlan {
 protected:
  /// `entities`: the name that the array of entity tags has in this format.
  VtkFilePlan(const Document& document, const std::string& entities, bool binary)
      : OneFilePlan(document), plan_(vtk_plan(document, entities)), binary_(binary) {}

  /// Made only when it is needed, because it takes memory and `holds` does not need it.
  const VtkMesh& mesh() {
    if (!mesh_) mesh_ = vtk_mesh(document_, plan_);
    return *mesh_;
  }

  const VtkPlan plan_;
  const bool binary_;

 private:
  std::optional<VtkMesh> mesh_;
};

}  // namespace tetproof::io
