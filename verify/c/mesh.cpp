// SPDX-License-Identifier: GPL-3.0-or-later
// Grids by the paper's method, for the C interface.
#include <memory>
#include <optional>
#include <utility>

#include "io/error.hpp"
#include "io/surface/used_vertices.hpp"
#include "reference/generate.hpp"
#include "verify/c/boundary.hpp"
#include "verify/c/handles.hpp"
#include "verify/c/options.hpp"

using namespace tetproof;
using namespace tetproof::c;

namespace {

// The method is defined for usable surfaces only. Vertices that no triangle names count nowhere.
void refuse_unusable(const tetproof_surface& surface) {
  SurfaceNumbering numbering = surface.numbering;
  const std::optional<TriangleSurface> used = io::without_unused_vertices(surface.surface, numbering);
  const std::string fault =
      used ? verify::judge_surface(*used, std::move(numbering)).fault : surface.judged().report().fault;
  if (!fault.empty()) throw InputError((surface.name.empty() ? "the surface" : surface.name) + ": " + fault);
}

}  // namespace

tetproof_status tetproof_mesh(const tetproof_surface* surface, const tetproof_mesh_options* options,
                              tetproof_document** document, tetproof_error* error) {
  return guarded(error, [&] {
    tetproof_document*& result = result_of(document, "document");
    needed(surface, "surface");
    const MeshOptions mesh = checked(options);
    on_threads(mesh.threads, [&] {
      refuse_unusable(*surface);
      auto made = std::make_unique<tetproof_document>();
      made->document = document_of(reference::generate(surface->surface, mesh.options).mesh());
      result = made.release();
    });
  });
}
