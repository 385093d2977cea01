// SPDX-License-Identifier: GPL-3.0-or-later
// Small .vtu files as text.
#pragma once

#include <string>

namespace tetproof::test {

/// A file with these pieces; `attributes` are added to its root element.
inline std::string vtu(const std::string& piece, const std::string& attributes = "") {
  return "<?xml version=\"1.0\"?>\n<!-- <VTKFile> -->\n<VTKFile type=\"UnstructuredGrid\" " + attributes +
         ">\n<UnstructuredGrid>" + piece + "</UnstructuredGrid></VTKFile>\n";
}

/// A piece with one tetrahedron of these nodes; `more` follows its cells.
inline std::string piece(const std::string& more = "", const std::string& nodes = "0 1 2 3") {
  return "<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\"><Points><DataArray type=\"Float32\" "
         "NumberOfComponents=\"3\">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points><Cells>"
         "<DataArray type=\"Int32\" Name=\"connectivity\">" +
         nodes +
         "</DataArray><DataArray type=\"Int8\" Name=\"types\">10</DataArray>"
         "<DataArray type=\"UInt64\" Name=\"offsets\" format=\"ascii\">4</DataArray></Cells>" +
         more + "</Piece>";
}

}  // namespace tetproof::test
