#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Shows the way from a clone to a verified grid and its picture: installs what is needed, builds, meshes the surface of a skull, judges the grid and writes
# everything into out/. Works on a fresh Debian 12 or 13.
# usage: corpus/demo.sh [OPTIONS OF tetproof-mesh]     for example: corpus/demo.sh --cells 96
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
.ci/setup.sh --without-tests programs
mkdir -p out
echo
# An option may be given only once, so an option of the user replaces our default.
defaults=()
[[ " $* " == *" --cells"* ]] || defaults+=(--cells 64)
[[ " $* " == *" --plane"* ]] || defaults+=(--plane x=120)
[[ " $* " == *" --view"* ]] || defaults+=(--view 3d)
command=(build/tetproof-mesh corpus/surfaces/ct_skull.off -o out/ct_skull.msh "${defaults[@]}" --json out/ct_skull.json --figure out/ct_skull.svg --html out/ct_skull.html "$@")
echo "\$ ${command[*]}"
"${command[@]}"
echo
echo "\$ build/tetproof-convert out/ct_skull.msh out/ct_skull.vtu"
build/tetproof-convert out/ct_skull.msh out/ct_skull.vtu
echo
echo "Files in out/:"
for file in ct_skull.msh:"the grid, for Gmsh" ct_skull.vtu:"the grid, for ParaView" ct_skull.json:"the report" \
  ct_skull.html:"the report as a page: open it in a browser, turn the grid and cut it" \
  ct_skull.svg:"the grid cut open, after the paper's figures (corpus/gallery has more)"; do
  printf '  %-18s %8s  %s\n' "out/${file%%:*}" "$(du -h --apparent-size "out/${file%%:*}" | cut -f1)" "${file#*:}"
done
