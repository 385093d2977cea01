#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# From a clone to a verified grid and its picture, on a fresh Debian 12 too: set-up, then the surface of a skull is meshed, judged and written into out/.
# usage: corpus/demo.sh [OPTION OF tetproof-mesh...]     for example: corpus/demo.sh --cells 96
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
.ci/setup.sh --without-tests programs
mkdir -p out
echo
# An option stands once: what is given here takes the place of ours.
defaults=()
[[ " $* " == *" --cells"* ]] || defaults+=(--cells 64)
[[ " $* " == *" --plane"* ]] || defaults+=(--plane x=120)
command=(build/tetproof-mesh corpus/surfaces/ct_skull.off -o out/ct_skull.msh "${defaults[@]}" --json out/ct_skull.json --figure out/ct_skull.svg "$@")
echo "\$ ${command[*]}"
"${command[@]}"
echo
echo "\$ build/tetproof-convert out/ct_skull.msh out/ct_skull.vtu"
build/tetproof-convert out/ct_skull.msh out/ct_skull.vtu
echo
echo "What lies in out/:"
for file in ct_skull.msh:"the grid; Gmsh opens it" ct_skull.vtu:"the same for ParaView" ct_skull.json:"the report" \
  ct_skull.svg:"a plane's cut through it, as in the paper's figures; corpus/gallery.sh makes those"; do
  printf '  %-18s %8s  %s\n' "out/${file%%:*}" "$(du -h --apparent-size "out/${file%%:*}" | cut -f1)" "${file#*:}"
done
