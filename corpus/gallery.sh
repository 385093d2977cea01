#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes pictures like the paper's figures 3 to 6: unstructured grids around a sphere, a torus, a wing and a skull, each cut by a plane and cut open. Writes them into
# corpus/gallery/.
# usage: corpus/gallery.sh [FOLDER]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
folder=${1:-corpus/gallery}
.ci/setup.sh --without-tests programs
mkdir -p "$folder"

# As in section 5 of the paper, the grids are adapted to the distance, without curvature, and improved by maximizing the minimum aspect ratio. An odd number of
# cells keeps the middle plane off the lattice's planes. corpus/gallery/README.md says what the pictures show, and how far the grid's boundary is from the surface.
figure() {
  local file=$folder/$1.svg
  shift
  local command=(build/tetproof-mesh "$@" --region outside --improve aspect-ratio --figure "$file")
  echo
  echo "\$ ${command[*]}"
  "${command[@]}"
}
figure sphere sphere:r=1,n=20000 --cells 27 --box-scale 1.6 --v0 0.04 --v1 1 --p 1 --plane x=0 --title "Unstructured grid around a sphere"
figure sphere-open sphere:r=1,n=20000 --cells 17 --box-scale 1.6 --v0 0.05 --v1 2 --p 2 --view 3d --title "Unstructured grid around a sphere, cut open"
figure torus torus:R=1,r=0.4,n=20000 --cells 33,33,11 --box-scale 1.4 --v0 0.03 --v1 1 --p 1 --plane z=0 --title "Unstructured grid around a torus"
figure torus-open torus:R=1,r=0.4,n=20000 --cells 27,27,9 --box-scale 1.4 --v0 0.05 --v1 1 --p 1 --plane y=0 --view 0.45,-1,0.6 --title "Unstructured grid around a torus, cut open"
figure wing wing:naca=2418,span=1,n=20000 --cells 41,9,11 --box-scale 2 --v0 0.03 --v1 2 --p 1 --plane y=0.5 --title "Unstructured grid around a wing"
figure wing-open wing:naca=2418,span=1,n=20000 --cells 35,21,9 --box-scale 2 --v0 0.05 --v1 2 --p 1 --plane y=0.5 --view 0.3,-1,0.45 --title "Unstructured grid around a wing, cut open"
figure skull corpus/surfaces/ct_skull.off --cells 23,27,29 --v0 0.05 --v1 2 --p 1 --plane x --title "Unstructured grid around a skull"
figure skull-open corpus/surfaces/ct_skull.off --cells 21,25,27 --v0 0.1 --v1 2 --p 1 --view 3d --title "Unstructured grid around a skull, cut open"
echo
ls -l "$folder"/*.svg
