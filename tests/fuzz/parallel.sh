#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The four shards of a campaign on the slots of one machine, by GNU parallel, as a user would run them. Merged, they
# report byte for byte what one run reports.
# usage: tests/fuzz/parallel.sh BUILD     exit code 77: GNU parallel is not installed
command -v parallel >/dev/null && parallel --version 2>/dev/null | grep -q '^GNU parallel' ||
  { echo "SKIPPED: GNU parallel is not installed"; exit 77; }
# shellcheck source=tests/fuzz/shards.sh
source "$(dirname "${BASH_SOURCE[0]}")/shards.sh" "$1"
trap 'rm -rf "$scratch"' EXIT
export HOME=$scratch   # where parallel keeps its own files

run_whole

# -q: the mesher's command has blanks and quotes. parallel's exit code is the number of shards with findings.
parallel -q -j 4 --joblog "$scratch/jobs" \
  "${campaign[@]}" --shard {}/4 --threads 2 --quiet --out "$scratch/shards" -- "${mesher[@]}" ::: 0 1 2 3 \
  >"$scratch/parallel.txt" || [ $? -le 4 ] || fail "parallel failed"
awk 'NR > 1 && $7 > 1 { print "FAILED: shard with exit code " $7; bad = 1 } END { exit bad || NR != 5 }' "$scratch/jobs" ||
  fail "not all four shards ran"

compare_merged "$scratch/shards"
