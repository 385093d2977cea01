// SPDX-License-Identifier: GPL-3.0-or-later
// Edits of documents: what users ask a converter for besides the format. Each keeps numbers, values and
// groups.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

/// What an edit did, in one line without its name, and what went with it that nobody asked to leave out.
struct Edit {
  std::string did;
  std::vector<Loss> lost;
};

/// Adds another document behind `document`. Points and elements come behind those that are there.
///
/// Node numbers, element numbers and tags of entities that both have are moved up in `other`, all of them by
/// the same step, so that they come behind. Numbers that a reader counted come behind those of a file.
/// Numbers that name nothing go on naming nothing. Groups of the same dimension are one group if they have a
/// name in common, or the same number and not two names; two groups of `other` stay two. A number that two
/// groups claim is given anew in `other`, and all names stay. Values of the same name, kind and step become
/// one. Lost: what a document has once, if the two differ (title, Voronoi diagram, tables and sections of one
/// name), sections of a document whose numbers move, and numbers of elements in TetGen's values.
Edit join(Document& document, Document&& other);

/// Multiplies all lengths by a positive number: coordinates, boxes, holes, regions and their bounds, TetGen's
/// sizes. Other values stay. InputError if one of them would leave the range of doubles, or become so small
/// that digits are gone.
Edit scale(Document& document, double factor);
/// Moves everything that has a place. Lost: places, so far away that rounding moves points by more than a
/// millionth of the mesh's diagonal. InputError as above.
Edit translate(Document& document, const Eigen::Vector3d& by);

/// Merges points. Without a tolerance: those with the same coordinates (-0 equals 0, NaN equals nothing).
/// With one: point by point in the document's order, a point goes to the first of those that stayed so far
/// whose distance is not larger than the tolerance; so no chain of near points collapses. The first point's
/// place, number, entity and values stay; what differs is listed. Elements that have a node twice thereafter
/// stay, and are counted.
Edit merge_points(Document& document, std::optional<double> tolerance = {});

/// Keeps the elements of some types: comma-separated words of `name_of_elements` ("tetrahedra", "triangles",
/// ...; the singular too), any order, or Gmsh's numbers of types. "lines" are polylines too. All points stay.
/// InputError for an unknown word, and if no element would be left.
Edit keep_only(Document& document, const std::string& types);

/// Replaces all elements by the boundary of the solids: their faces that belong to one solid only, wound
/// outwards.
///
/// A face that is an element of the document already is that element, with its groups and values. Any other
/// face has the groups, partitions and values of its solid; a group or an entity of volumes keeps its number
/// and name among those of surfaces, and gets a new number if there is one of that number. Faces have the
/// nodes of their solid up to the second order, and are given by corners above. A quadrangle and the two
/// triangles that cover it are inside. Of several elements on one face, the first stays, with the groups of
/// all. Lost: further elements there, nodes of solids between corners that faces have not, and solids that no
/// rule says the faces of (polyhedra, Bezier tetrahedra). InputError if there are no others.
Edit boundary(Document& document);

/// Cuts quadrangles and polygons, facets of several polygons too, into triangles by the rules of
/// io/surface/cutting.hpp. Triangles have the groups and values of what they are cut from. Quadrangles of
/// higher order are cut by their corners; triangles and all that are no faces stay as they are. Lost: facets
/// without area. InputError for a polygon that crosses itself.
Edit triangulate(Document& document);

/// Leaves out the points that no element has. The others keep the numbers that the file says.
Edit prune(Document& document);
/// Numbers nodes and elements from 1 on, in the document's order. Numbers that name nothing go on naming
/// nothing. Lost: sections, which may name numbers.
Edit renumber(Document& document);

/// Gives the elements values "group names": the names of their groups (", " between several; the number of a
/// group without a name; empty without a group), as texts in VTK's files. ParaView shows these; meshio reads
/// no texts. InputError if no group has a name.
Edit add_group_texts(Document& document);

/// The elements of one physical group, and their points.
struct GroupPart {
  /// For the name of a file: "steel", "7", "ungrouped". Different for all parts, capitals or not.
  std::string word;
  Document document;
  std::vector<Loss> lost;  ///< as of an `Edit`
};
/// One document for each physical group that has elements, by dimension (solids first) and number; and one
/// for the elements in no group, if there are any. An element in several groups is in each of their
/// documents. InputError if no element has a group.
std::vector<GroupPart> split_by_group(const Document& document);

}  // namespace tetproof::io
