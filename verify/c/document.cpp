// SPDX-License-Identifier: GPL-3.0-or-later
// The documents of the C interface.
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/bytes/one_line.hpp"
#include "io/mesh_files.hpp"
#include "io/program/describe.hpp"
#include "io/program/refusal.hpp"
#include "io/writing.hpp"
#include "verify/c/boundary.hpp"
#include "verify/c/documents.hpp"
#include "verify/c/handles.hpp"
#include "verify/c/options.hpp"

using namespace tetproof;
using namespace tetproof::c;

const tetproof_document_arrays& tetproof_document::arrays() const {
  const std::lock_guard lock(viewing_);
  if (!view_) view_ = std::make_unique<const DocumentView>(document);
  return view_->arrays();
}

namespace {

using Json = nlohmann::ordered_json;

// As the programs print it.
std::string json_text(const Json& json) {
  return io::escape_controls_of_json(json.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

Json losses_json(const std::vector<Loss>& losses) {
  Json list = Json::array();
  for (const Loss& loss : losses)
    list.push_back({{"item", loss.item}, {"count", loss.count}, {"example", loss.example}});
  return list;
}

void hand_over(Document document, tetproof_document*& result) {
  auto made = std::make_unique<tetproof_document>();
  made->document = std::move(document);
  result = made.release();
}

program::Strictness strictness_of(std::int32_t strict) {
  return strict == TETPROOF_STRICT_NATIVE ? program::Strictness::native
         : strict == TETPROOF_STRICT_ON   ? program::Strictness::strict
                                          : program::Strictness::lax;
}

// Names one of the items that `strict` does not permit.
void refuse_losses(const Document& document, PlannedFile& file, std::int32_t strict) {
  const program::Refusal refusal(strictness_of(strict), document.dropped, file.losses(),
                                 file.kept_aside().items, file.dangling());
  for (const auto& [how, losses] : {std::pair{"not everything was read", &refusal.not_read},
                                    std::pair{"the format has no place for", &refusal.lost},
                                    std::pair{"other programs do not read what is kept aside", &refusal.kept},
                                    std::pair{"elements name nodes that do not exist", &refusal.dangling}})
    if (!losses->empty())
      throw Refused(TETPROOF_LOSSY,
                    fmt::format("not written, since {}: {}: {} ({}){}", how, losses->front().item,
                                losses->front().count, losses->front().example,
                                refusal.items() > 1 ? ", and more" : ""));
}

// Plans the file, and gives the plan and the options to `work`.
template <class Work>
void with_plan(const tetproof_document* document, const char* path, const tetproof_write_options* options,
               const Work& work) {
  const Document& from = needed(document, "document").document;
  needed(path, "path");
  const StrictWriteOptions write = checked(options);
  on_threads(0, [&] {
    PlannedFile file(path_of(path), from, write.options);
    work(from, file, write.strict);
  });
}

}  // namespace

namespace tetproof::c {

std::string path_of(const std::string& path) {
  return path == "-" ? "./-" : path;
}

std::string reading_json(const std::vector<std::string>& warnings, const std::vector<Loss>& dropped) {
  return json_text({{"warnings", warnings}, {"dropped", losses_json(dropped)}});
}

}  // namespace tetproof::c

tetproof_status tetproof_document_read(const char* path, const char* format, tetproof_document** document,
                                       tetproof_error* error) {
  return guarded(error, [&] {
    tetproof_document*& result = result_of(document, "document");
    needed(path, "path");
    const ReadOptions options = read_options(format);
    on_threads(0, [&] { hand_over(read_document(path_of(path), options), result); });
  });
}

tetproof_status tetproof_document_read_memory(const void* bytes, size_t size, const char* format,
                                              tetproof_document** document, tetproof_error* error) {
  return guarded(error, [&] {
    tetproof_document*& result = result_of(document, "document");
    if (size > 0 && !bytes) refuse_argument("bytes is null");
    if (size > static_cast<std::size_t>(PTRDIFF_MAX))
      refuse_argument(fmt::format("size is {}, which no memory has", size));
    const ReadOptions options = read_options(format);
    const std::string_view file(size > 0 ? static_cast<const char*>(bytes) : "", size);
    on_threads(0, [&] { hand_over(read_document_in_memory(file, options), result); });
  });
}

tetproof_status tetproof_document_from_arrays(const tetproof_points* points, const tetproof_integers* tets,
                                              const tetproof_integers* tet_groups,
                                              const tetproof_integers* triangles,
                                              const tetproof_integers* triangle_groups,
                                              tetproof_document** document, tetproof_error* error) {
  return guarded(error, [&] {
    tetproof_document*& result = result_of(document, "document");
    hand_over(document_of_arrays({points, tets, tet_groups, triangles, triangle_groups}), result);
  });
}

tetproof_status tetproof_document_name_group(tetproof_document* document, int32_t dimension, int64_t tag,
                                             const char* name, tetproof_error* error) {
  return guarded(error, [&] {
    needed(document, "document");
    needed(name, "name");
    if (dimension < 0 || dimension > 3)
      refuse_argument(fmt::format("dimension is {}, expected 0 to 3", dimension));
    if (tag < 1 || tag > std::numeric_limits<std::int32_t>::max())
      refuse_argument(fmt::format("tag is {}, expected 1 to 2147483647", tag));
    std::vector<GroupName>& names = document->document.group_names;
    const auto named = std::find_if(names.begin(), names.end(), [&](const GroupName& one) {
      return one.dim == dimension && one.group == tag;
    });
    GroupName group{dimension, tag, name};
    if (named != names.end())
      *named = std::move(group);
    else
      names.push_back(std::move(group));
    document->forget_arrays();
  });
}

void tetproof_document_free(tetproof_document* document) {
  delete document;
}

tetproof_status tetproof_document_view(const tetproof_document* document,
                                       const tetproof_document_arrays** arrays, tetproof_error* error) {
  return guarded(error, [&] {
    const tetproof_document_arrays*& result = result_of(arrays, "arrays");
    result = &needed(document, "document").arrays();
  });
}

tetproof_status tetproof_document_json(const tetproof_document* document, char** json,
                                       tetproof_error* error) {
  return guarded(error, [&] {
    char*& result = result_of(json, "json");
    result = text_for_caller(json_text(describe_json(needed(document, "document").document)));
  });
}

tetproof_status tetproof_document_losses(const tetproof_document* document, const char* path,
                                         const tetproof_write_options* options, char** json,
                                         tetproof_error* error) {
  return guarded(error, [&] {
    char*& result = result_of(json, "json");
    with_plan(document, path, options, [&](const Document& from, PlannedFile& file, std::int32_t) {
      result = text_for_caller(json_text({{"dropped", losses_json(from.dropped)},
                                          {"losses", losses_json(file.losses())},
                                          {"kept_aside", losses_json(file.kept_aside().items)},
                                          {"dangling", losses_json(file.dangling())},
                                          {"warning", file.warning()}}));
    });
  });
}

tetproof_status tetproof_document_write(const tetproof_document* document, const char* path,
                                        const tetproof_write_options* options, tetproof_error* error) {
  return guarded(error, [&] {
    with_plan(document, path, options, [&](const Document& from, PlannedFile& file, std::int32_t strict) {
      refuse_losses(from, file, strict);
      file.write();
    });
  });
}
