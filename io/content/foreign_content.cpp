// SPDX-License-Identifier: GPL-3.0-or-later
// Recognises files that are not read, so that they are refused by their names.
#include <array>
#include <string>

#include "io/bytes/input_file.hpp"
#include "io/bytes/scanner.hpp"
#include "io/bytes/tokens.hpp"
#include "io/content/content.hpp"
#include "io/content/head.hpp"

namespace tetproof::io {
namespace {

// How the first bytes are compared.
enum class Start {
  bytes,  // exactly
  text,   // letters in any case, behind blanks
  tag,    // the first tag of XML or HTML, in any case
};

struct Foreign {
  Start start;
  std::string_view with;
  const char* what;
  const char* advice;
};

constexpr const char* convert = "convert it to .vtk or .msh first";
constexpr const char* unpack = "unpack it first";
constexpr const char* mesh_wanted = "expected a mesh or a surface";

using namespace std::string_view_literals;

constexpr std::array foreign{
    Foreign{Start::bytes, "\x1f\x8b"sv, "a gzip archive", unpack},
    Foreign{Start::bytes, "PK\x03\x04"sv, "a zip archive", unpack},
    Foreign{Start::bytes, "BZh"sv, "a bzip2 archive", unpack},
    Foreign{Start::bytes,
            "\xfd"
            "7zXZ\0"sv,
            "an xz archive", unpack},
    Foreign{Start::bytes, "\x28\xb5\x2f\xfd"sv, "a zstd archive", unpack},
    Foreign{Start::bytes, "7z\xbc\xaf\x27\x1c"sv, "a 7z archive", unpack},
    Foreign{Start::bytes, "%PDF-"sv, "a PDF document", mesh_wanted},
    Foreign{Start::bytes, "\x89PNG"sv, "a PNG picture", mesh_wanted},
    Foreign{Start::bytes, "\x89HDF\r\n\x1a\n"sv, "an HDF5 file", convert},
    Foreign{Start::bytes, "CDF\x01"sv, "a netCDF file", convert},
    Foreign{Start::bytes, "CDF\x02"sv, "a netCDF file", convert},
    Foreign{Start::bytes, "glTF"sv, "a glTF scene", "convert it to .ply or .obj first"},
    Foreign{Start::tag, "<!doctype html"sv, "an HTML page", mesh_wanted},
    Foreign{Start::tag, "<html"sv, "an HTML page", mesh_wanted},
    Foreign{Start::tag, "<xdmf"sv, "an XDMF file", convert},
    Foreign{Start::tag, "<dolfin"sv, "a DOLFIN mesh", convert},
    Foreign{Start::text, "version https://git-lfs"sv, "a pointer of Git LFS",
            "fetch the file itself (git lfs pull)"},
    Foreign{Start::text, "mfem mesh v"sv, "an MFEM mesh", convert},
    Foreign{Start::text, "mfem nc mesh v"sv, "an MFEM mesh", convert},
    Foreign{Start::text, "mfem inline mesh v"sv, "an MFEM mesh", convert},
    Foreign{Start::text, "mfem nurbs mesh v"sv, "an MFEM mesh", convert},
    Foreign{Start::text, "mesh3d"sv, "a Netgen mesh", convert},
    Foreign{Start::text, "mesh dimension"sv, "a GiD mesh", convert},
    Foreign{Start::text, "*heading"sv, "an Abaqus input file", convert},
    Foreign{Start::text, "*node"sv, "an Abaqus input file", convert},
    Foreign{Start::text, "*part"sv, "an Abaqus input file", convert},
    Foreign{Start::text, "*keyword"sv, "an LS-DYNA input file", convert},
    Foreign{Start::text, "/com,"sv, "an ANSYS input file", convert},
    Foreign{Start::text, "/prep7"sv, "an ANSYS input file", convert},
    Foreign{Start::text, "iso-10303-21;"sv, "a STEP file", "call it .step, so that Gmsh reads it"},
    Foreign{Start::text, "dbrep_drawableshape"sv, "an OpenCASCADE BREP file",
            "call it .brep, so that Gmsh reads it"},
    Foreign{Start::text, "#vrml v"sv, "a VRML scene", "call it .wrl, so that Gmsh reads it"},
};

bool starts(std::string_view bytes, const Foreign& one) {
  if (one.start == Start::bytes) return bytes.starts_with(one.with);
  const std::string_view text = one.start == Start::tag ? first_tag(bytes) : head_text(bytes);
  return lower_case(text.substr(0, one.with.size())) == one.with;
}

// A section such as (0 "a comment") or (10 (0 1 d5 1 3)).
bool is_fluent(std::string_view bytes) {
  const std::string_view text = head_text(bytes);
  const std::size_t end = text.find_first_not_of("0123456789", 1);
  return text.starts_with('(') && end != text.npos && end > 1 && (text[end] == ' ' || text[end] == '(');
}

// The numbers of points, triangles and edges in one line; below it x, y and a label of the first point.
bool is_freefem(std::string_view bytes) {
  Scanner scanner = head_scanner(bytes);
  std::int64_t count;
  double number;
  for (int k = 0; k < 3; ++k)
    if (scanner.at_line_end() || !parse_integer(scanner.word(), count) || count < 0) return false;
  if (!scanner.at_line_end()) return false;
  scanner.next_line();
  for (int k = 0; k < 3; ++k)
    if (scanner.at_line_end() || !parse_real(scanner.word(), number)) return false;
  return true;
}

}  // namespace

std::optional<Content> foreign_content(std::string_view bytes, std::string_view ending) {
  for (const Foreign& one : foreign)
    if (starts(bytes, one)) return Content{{}, one.what, one.advice};
  if (is_fluent(bytes)) return Content{{}, "a Fluent mesh", convert};
  if (ending == ".msh" && is_freefem(bytes)) return Content{{}, "a FreeFem mesh", convert};
  return {};
}

}  // namespace tetproof::io
