#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes pictures like the paper's figures 3 to 6: cuts through unstructured grids around a sphere, a torus, a wing and a skull. Writes them into corpus/gallery/.
# usage: corpus/gallery.sh [FOLDER]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
folder=${1:-corpus/gallery}
.ci/setup.sh --without-tests programs
mkdir -p "$folder"

# As in section 5 of the paper, the grids are adapted to the distance, without curvature, and improved by maximizing the minimum aspect ratio. With an odd number
# of cells, the middle plane is not a lattice plane.
figure() {
  local file=$folder/$1.svg
  shift
  local command=(build/tetproof-mesh "$@" --region outside --improve aspect-ratio --figure "$file")
  echo
  echo "\$ ${command[*]}"
  "${command[@]}"
}
figure sphere sphere:r=1,n=20000 --cells 19 --box-scale 2 --v0 0.02 --v1 1 --p 1.5 --plane x=0
figure torus torus:R=1,r=0.4,n=20000 --cells 27 --box-scale 1.4 --v0 0.01 --v1 1 --p 1.5 --plane y=0
figure wing wing:naca=2418,span=2,n=20000 --cells 41,15,11 --box-scale 1.8 --v0 0.02 --v1 1 --plane y=1
figure skull corpus/surfaces/ct_skull.off --cells 21,25,27 --v0 0.05 --v1 2 --plane x
echo
ls -l "$folder"/*.svg
