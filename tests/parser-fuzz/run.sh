#!/usr/bin/env bash
# libFuzzer on every reader: run.sh BUILD SECONDS [ENDING...]. BUILD is made by
#   cmake -S . -B BUILD -DCMAKE_CXX_COMPILER=clang++ -DTETPROOF_FUZZERS=ON && cmake --build BUILD --target parser_fuzzer
# One ending after the other, SECONDS each. Seeds: corpus/formats, ../shared/formats, and what former runs found
# (BUILD/fuzz/ENDING). A finding is left in BUILD/fuzz/found and ends that ending's run; the exit code is then 1.
set -u -o pipefail
[ $# -ge 2 ] || { sed -n '2,5s/^# //p' "$0"; exit 2; }
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
build=$(cd "$1" && pwd) || exit 2
seconds=$2
shift 2
fuzzer=$build/tests/parser-fuzz/parser_fuzzer
[ -x "$fuzzer" ] || { echo "$fuzzer is not there: build the target parser_fuzzer" >&2; exit 2; }
[ $# -gt 0 ] || set -- .msh .node .poly .stl .off .obj .ply .vtk .vtu .mesh .meshb .jsonl
tetgen=(.node .ele .face .edge .neigh .poly .smesh .vol .var .mtr .v.node .v.edge .v.face .v.cell .t2f .f2e .t2e)

samples() { find "$root/corpus/formats" "$root/../shared/formats" -type f -iname "*$1" 2>/dev/null; }

# A file of TetGen's with the others of its stem, as one input.
bundle() {
  local file=$1 stem=$2 first=$3 ending
  { printf '@@%s\n' "$first"; cat "$file"; } > "$4"
  for ending in "${tetgen[@]}"; do
    [ "$ending" != "$first" ] && [ -f "$stem$ending" ] && { printf '\n@@%s\n' "$ending"; cat "$stem$ending"; } >> "$4"
  done
}

seed() {
  local ending=$1 folder=$2 file member
  for member in "${tetgen[@]}"; do
    [ "$ending" = .node ] || [ "$ending" = .poly ] || break
    samples "$member" | while read -r file; do
      bundle "$file" "${file%"$member"}" "$member" "$folder/$(basename "$file")"
    done
  done
  samples "$ending" | while read -r file; do
    [ -f "$folder/$(basename "$file")" ] || cp "$file" "$folder/"
  done
}

export ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=1${ASAN_OPTIONS:+:$ASAN_OPTIONS}
export TMPDIR=${TMPDIR:-/dev/shm}   # the inputs become files: in memory
found=0
mkdir -p "$build/fuzz/found"
for ending in "$@"; do
  seeds=$build/fuzz/seeds$ending kept=$build/fuzz/kept$ending log=$build/fuzz/log$ending
  rm -rf "$seeds" && mkdir -p "$seeds" "$kept"
  seed "$ending" "$seeds"
  nice "$fuzzer" --ending="$ending" "$kept" "$seeds" -max_total_time="$seconds" -timeout=20 -max_len=60000 \
    -rss_limit_mb=4096 -dict="$here/words.dict" -artifact_prefix="$build/fuzz/found/x$ending." -print_final_stats=1 > "$log" 2>&1
  code=$?
  runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log" | tail -1)
  if [ $code -eq 0 ]; then
    echo "$ending: ${runs:-0} inputs in $seconds s, $(ls "$kept" | wc -l) kept, nothing found"
  else
    echo "$ending: FOUND, see $log and $build/fuzz/found"
    found=1
  fi
done
exit $found
