#!/bin/sh
# Makes the traces of corpus/vectors/traces again, from traces/list.txt, each with its surface: NAME.obj with (u,v) if the trace follows
# a parametric surface, else NAME.off. The page makes them (reference/paper). usage: corpus/vectors/traces.sh BUILD_FOLDER [OUTPUT_FOLDER]
set -eu
here=$(dirname "$0")/traces
build=${1:?expected the build directory that holds tetproof-mesh}
to=${2:-$here}
grep -v '^#' "$here/list.txt" | while read -r name arguments; do
  # shellcheck disable=SC2086  # the arguments are words
  "$build/tetproof-mesh" $arguments --engine paper --voxels 0 --trace "$to/$name.jsonl" --quiet > /dev/null
  if grep -q '"parametric":true' "$to/$name.jsonl"; then ending=obj; else ending=off; fi
  # shellcheck disable=SC2086
  "$build/tetproof-convert" "${arguments%% *}" "$to/$name.$ending" --quiet
done
