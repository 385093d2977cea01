#!/bin/sh
# Makes the traces of corpus/vectors/traces again, from traces/list.txt. usage: corpus/vectors/traces.sh BUILD_FOLDER [OUTPUT_FOLDER]
set -eu
here=$(dirname "$0")/traces
build=${1:?expected the build directory that holds tetproof-mesh}
to=${2:-$here}
grep -v '^#' "$here/list.txt" | while read -r name arguments; do
  # shellcheck disable=SC2086  # the arguments are words
  "$build/tetproof-mesh" $arguments --voxels 0 --trace "$to/$name.jsonl" --quiet > /dev/null
done
