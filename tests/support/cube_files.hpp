// SPDX-License-Identifier: GPL-3.0-or-later
// A unit cube as text in every format that holds its faces, put together by hand and not by our writers.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace tetproof::test {

using Face = std::vector<int>;  ///< three or four corners, from 0, outward

inline const std::vector<std::array<int, 3>> cube_corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                                          {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
inline const std::vector<Face> cube_quads{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                          {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

/// The faces of the cube, of which the first `cut` are cut into two triangles each, from their first corner
/// on.
inline std::vector<Face> cube_faces(std::size_t cut) {
  std::vector<Face> faces;
  for (std::size_t i = 0; i < cube_quads.size(); ++i) {
    const Face& q = cube_quads[i];
    if (i < cut) {
      faces.push_back({q[0], q[1], q[2]});
      faces.push_back({q[0], q[2], q[3]});
    } else {
      faces.push_back(q);
    }
  }
  return faces;
}

/// The endings of `cube_file`.
inline const std::vector<std::string> cube_endings{".msh", ".vtk", ".vtu",  ".mesh", ".off",
                                                   ".obj", ".ply", ".poly", ".smesh"};

/// A file with these faces of the cube. Triangles come before quadrangles, as .mesh wants it.
inline std::string cube_file(const std::string& ending, const std::vector<Face>& faces) {
  const std::size_t n = cube_corners.size(), m = faces.size();
  const auto number = [](std::size_t i) { return std::to_string(i); };
  // A line for each corner; `first`: of their numbers, -1: none.
  const auto points = [&](const std::string& before, int first, const std::string& after) {
    std::string text;
    for (std::size_t i = 0; i < n; ++i) {
      text += before + (first < 0 ? "" : number(i + static_cast<std::size_t>(first)) + " ");
      for (int k = 0; k < 3; ++k)
        text += (k ? " " : "") + std::to_string(cube_corners[i][static_cast<std::size_t>(k)]);
      text += after + "\n";
    }
    return text;
  };
  const auto corners = [](const Face& face, int first) {
    std::string text;
    for (std::size_t k = 0; k < face.size(); ++k) text += (k ? " " : "") + std::to_string(face[k] + first);
    return text;
  };
  const auto lines = [&](std::size_t size, const std::string& before, bool count, int first,
                         const std::string& after) {  // size 0: all
    std::string text;
    for (const Face& face : faces)
      if (size == 0 || face.size() == size)
        text += before + (count ? number(face.size()) + " " : "") + corners(face, first) + after + "\n";
    return text;
  };
  const auto how_many = [&](std::size_t size) {
    std::size_t count = 0;
    for (const Face& face : faces) count += face.size() == size;
    return count;
  };
  std::size_t indices = 0;
  for (const Face& face : faces) indices += face.size();

  if (ending == ".msh") {
    std::string elements;
    for (std::size_t i = 0; i < m; ++i)
      elements +=
          number(i + 1) + (faces[i].size() == 3 ? " 2" : " 3") + " 2 0 1 " + corners(faces[i], 1) + "\n";
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + number(n) + "\n" + points("", 1, "") +
           "$EndNodes\n$Elements\n" + number(m) + "\n" + elements + "$EndElements\n";
  }
  if (ending == ".vtk") {
    std::string types;
    for (const Face& face : faces) types += face.size() == 3 ? "5\n" : "9\n";
    return "# vtk DataFile Version 3.0\nby hand\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " + number(n) +
           " double\n" + points("", -1, "") + "CELLS " + number(m) + " " + number(m + indices) + "\n" +
           lines(0, "", true, 0, "") + "CELL_TYPES " + number(m) + "\n" + types;
  }
  if (ending == ".vtu") {
    std::string types, offsets;
    std::size_t offset = 0;
    for (const Face& face : faces) {
      types += face.size() == 3 ? "5 " : "9 ";
      offsets += number(offset += face.size()) + " ";
    }
    const auto array = [](const std::string& what, const std::string& numbers) {
      return "<DataArray " + what + " format=\"ascii\">" + numbers + "</DataArray>";
    };
    return "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\"><UnstructuredGrid>"
           "<Piece NumberOfPoints=\"" +
           number(n) + "\" NumberOfCells=\"" + number(m) + "\"><Points>" +
           array("type=\"Float64\" NumberOfComponents=\"3\"", points("", -1, "")) + "</Points><Cells>" +
           array("type=\"Int32\" Name=\"connectivity\"", lines(0, "", false, 0, "")) +
           array("type=\"Int32\" Name=\"offsets\"", offsets) + array("type=\"UInt8\" Name=\"types\"", types) +
           "</Cells></Piece></UnstructuredGrid></VTKFile>\n";
  }
  if (ending == ".mesh") {
    std::string text =
        "MeshVersionFormatted 2\nDimension 3\nVertices\n" + number(n) + "\n" + points("", -1, " 0");
    if (how_many(3) > 0) text += "Triangles\n" + number(how_many(3)) + "\n" + lines(3, "", false, 1, " 0");
    if (how_many(4) > 0)
      text += "Quadrilaterals\n" + number(how_many(4)) + "\n" + lines(4, "", false, 1, " 0");
    return text + "End\n";
  }
  if (ending == ".off")
    return "OFF\n" + number(n) + " " + number(m) + " 0\n" + points("", -1, "") + lines(0, "", true, 0, "");
  if (ending == ".obj") return points("v ", -1, "") + lines(0, "f ", false, 1, "");
  if (ending == ".ply")
    return "ply\nformat ascii 1.0\nelement vertex " + number(n) +
           "\nproperty double x\nproperty double y\nproperty double z\nelement face " + number(m) +
           "\nproperty list uchar int vertex_indices\nend_header\n" + points("", -1, "") +
           lines(0, "", true, 0, "");
  const std::string nodes = number(n) + " 3 0 0\n" + points("", 1, "") + number(m) + " 0\n";
  return nodes + lines(0, ending == ".poly" ? "1\n" : "", true, 1, "") + "0\n0\n";
}

}  // namespace tetproof::test
