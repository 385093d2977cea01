#!/bin/sh
# The whole mutation campaign: meshes by TetGen, Gmsh, CGAL and ourselves, every kind of defect, three places (as it is, around 1e6, in size 1e-9), each once more at a random power of two from 2^-1000
# to 2^950, and once along one axis without some of the checks that the certificate does not need.
# And that of traces: 5,000 changes, each found by tetproof-compare and by the check of one trace, at its line.
# usage: run.sh [BUILD_FOLDER [CASES [SEED]]]     exits 1 if the judge was wrong once, or a changed trace was not found
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "${1:-$here/../../build}" && pwd)
cmake --build "$build" --target tetproof-campaign tetproof-trace-campaign tetproof-mesh tetproof-convert cgal_mesh3
"$build/tetproof-trace-campaign" --seed "${3:-1}"
meshes=$build/mutation-meshes
python3 "$here/meshes.py" "$build" "$meshes" > "$meshes.txt"
# shellcheck disable=SC2046  # one path a line, none with a blank
exec "$build/tetproof-campaign" --cases "${2:-8000}" --seed "${3:-1}" --scales --mesh block jittered ball $(cat "$meshes.txt")
