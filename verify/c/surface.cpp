// SPDX-License-Identifier: GPL-3.0-or-later
// The surfaces of the C interface.
#include <memory>
#include <utility>

#include "corpus/surfaces.hpp"
#include "io/model/read_document.hpp"
#include "io/surface/document_surface.hpp"
#include "verify/c/arrays.hpp"
#include "verify/c/boundary.hpp"
#include "verify/c/documents.hpp"
#include "verify/c/handles.hpp"
#include "verify/c/options.hpp"

using namespace tetproof;
using namespace tetproof::c;

const verify::JudgedSurface& tetproof_surface::judged() const {
  const std::lock_guard lock(judging_);
  if (!judged_) judged_.emplace(surface, numbering);
  return *judged_;
}

void tetproof_surface::lay_out() {
  arrays.vertex_count = static_cast<std::int64_t>(surface.vertices.size());
  arrays.triangle_count = static_cast<std::int64_t>(surface.triangles.size());
  arrays.vertices = surface.vertices.empty() ? nullptr : surface.vertices[0].data();
  arrays.triangles = surface.triangles.empty() ? nullptr : surface.triangles[0].data();
  static_assert(sizeof surface.parameters[0] == 6 * sizeof(double));
  arrays.parameters = surface.parameters.empty() ? nullptr : surface.parameters[0][0].data();
}

namespace {

// The surface of a document, as that of a file: welded, and cut into triangles.
std::unique_ptr<tetproof_surface> surface_of_document(Document document) {
  auto made = std::make_unique<tetproof_surface>();
  made->name = document.path;
  made->warnings = document.warnings;
  made->dropped = document.dropped;
  io::ReadDocument read{std::move(document)};
  made->surface =
      io::surface_of_read(std::move(read), InputFile::in_memory("", ""), made->numbering, made->warnings);
  return made;
}

void hand_over(std::unique_ptr<tetproof_surface> made, tetproof_surface*& surface) {
  made->lay_out();
  surface = made.release();
}

}  // namespace

tetproof_status tetproof_surface_from_arrays(const tetproof_points* vertices,
                                             const tetproof_integers* triangles, tetproof_surface** surface,
                                             tetproof_error* error) {
  return guarded(error, [&] {
    tetproof_surface*& result = result_of(surface, "surface");
    DocumentArrays arrays{.points = vertices, .triangles = triangles};
    needed(vertices, "vertices"), needed(triangles, "triangles");
    on_threads(0, [&] { hand_over(surface_of_document(document_of_arrays(arrays)), result); });
  });
}

tetproof_status tetproof_surface_open(const char* file_or_spec, const char* format,
                                      tetproof_surface** surface, tetproof_error* error) {
  return guarded(error, [&] {
    tetproof_surface*& result = result_of(surface, "surface");
    const std::string name = file_or_spec ? file_or_spec : "";
    needed(file_or_spec, "file_or_spec");
    const ReadOptions options = read_options(format);
    on_threads(0, [&] {
      SurfaceFile file = corpus::open_surface_file(path_of(name), options);
      auto made = std::make_unique<tetproof_surface>();
      made->name = name;
      made->surface = std::move(file.surface);
      made->numbering = std::move(file.numbering);
      made->warnings = std::move(file.warnings);
      made->dropped = std::move(file.dropped);
      hand_over(std::move(made), result);
    });
  });
}

tetproof_status tetproof_surface_from_document(const tetproof_document* document, tetproof_surface** surface,
                                               tetproof_error* error) {
  return guarded(error, [&] {
    tetproof_surface*& result = result_of(surface, "surface");
    const Document& from = needed(document, "document").document;
    on_threads(0, [&] { hand_over(surface_of_document(from), result); });
  });
}

void tetproof_surface_free(tetproof_surface* surface) {
  delete surface;
}

const tetproof_surface_arrays* tetproof_surface_view(const tetproof_surface* surface) {
  return surface ? &surface->arrays : nullptr;
}

tetproof_status tetproof_surface_fault(const tetproof_surface* surface, char** fault, tetproof_error* error) {
  return guarded(error, [&] {
    char*& result = result_of(fault, "fault");
    needed(surface, "surface");
    on_threads(0, [&] {
      const std::string& found = surface->judged().report().fault;
      if (!found.empty()) result = text_for_caller(found);
    });
  });
}

tetproof_status tetproof_surface_json(const tetproof_surface* surface, char** json, tetproof_error* error) {
  return guarded(error, [&] {
    char*& result = result_of(json, "json");
    needed(surface, "surface");
    result = text_for_caller(reading_json(surface->warnings, surface->dropped));
  });
}

tetproof_status tetproof_list_surfaces(char** text, tetproof_error* error) {
  return guarded(error, [&] {
    char*& result = result_of(text, "text");
    result = text_for_caller(corpus::list_surfaces());
  });
}
