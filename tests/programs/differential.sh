#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs the differential tests on more than the samples: on meshes made by Gmsh, of all versions, orders and kinds of
# elements, with partitions, periodic sides and parametric nodes. It takes a few minutes.
# usage: tests/programs/differential.sh [BUILD]
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$(cd "${1:-$here/../../build}" && pwd)
folder=$(mktemp -d -t tetproof-differential-XXXXXX)
trap 'rm -rf "$folder"' EXIT

cat >"$folder/blocks.geo" <<'GEO'
h = 0.5;
Point(1) = {0, 0, 0, h}; Point(2) = {1, 0, 0, h}; Point(3) = {1, 1, 0, h}; Point(4) = {0, 1, 0, h};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
a[] = Extrude {0, 0, 1/3} { Surface{1}; };
b[] = Extrude {0, 0, 2/3} { Surface{a[0]}; };
Physical Volume("steel part", 11) = {a[1]};
Physical Volume("both", 12) = {a[1], b[1]};
Physical Surface("between", 21) = {a[0]};
Physical Curve("edge", 31) = {1};
Physical Point("probe", 41) = {1};
Periodic Curve {3} = {-1} Translate {0, 1, 0};
GEO
sed 's/Surface{1}; }/Surface{1}; Layers{2}; Recombine; }/; s/^a\[\]/Transfinite Surface{1}; Recombine Surface{1};\na[]/' \
  "$folder/blocks.geo" >"$folder/hexahedra.geo"
sed 's/Surface{1}; }/Surface{1}; Layers{2}; Recombine; }/' "$folder/blocks.geo" >"$folder/prisms.geo"

make() { # NAME GEO FORMAT OPTION...
  local name=$1 geo=$2 format=$3
  shift 3
  gmsh "$folder/$geo.geo" -3 -v 1 -format "$format" -o "$folder/$name-$format.msh" "$@" >/dev/null
}
for format in msh1 msh22 msh40 msh41; do
  for geo in blocks hexahedra prisms; do
    for order in 1 2 3; do make "$geo-$order" $geo $format -order $order; done
  done
done
for format in msh22 msh41; do
  make binary blocks $format -bin
  make all-binary hexahedra $format -bin -save_all
  make parametric blocks $format -parametric
  make parametric-binary blocks $format -parametric -bin
  make serendipity hexahedra $format -order 2 -setnumber Mesh.SecondOrderIncomplete 1
done
make partitions blocks msh41 -part 3 -part_ghosts
make partitions-binary blocks msh41 -part 3 -part_ghosts -bin

code=0
TETPROOF_ALL_SAMPLES=1 TETPROOF_SAMPLES=$folder "$build/tests/programs/format_tests" --gtest_filter='DifferentialGmsh.*' ||
  code=1
for peer in tetgen vtk meshio; do
  echo "--- $peer"
  /usr/bin/python3 "$here/differential.py" --build "$build" --peer $peer --all --samples "$folder" || code=1
done
exit $code
