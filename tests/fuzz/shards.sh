# SPDX-License-Identifier: GPL-3.0-or-later
# The campaign that parallel.sh and slurm.sh cut into shards, and the comparison with one run of it. Sourced by them
# with the build folder; sets `campaign`, `mesher`, `scratch`.
set -euo pipefail

skip() { echo "SKIPPED: $1"; exit 77; }
fail() { echo "FAILED: $1" >&2; exit 1; }

build=$(realpath "$1")
for name in tetproof-fuzz tetproof-faulty-mesher; do
  [ -x "$build/$name" ] || fail "$build/$name is not there"
done
scratch=$(mktemp -d "${TMPDIR:-/tmp}/tetproof-shards-XXXXXX")

# Each case takes a tenth of a second, so that a shard can be killed in its middle. The mesher refuses some surfaces
# and has a tetrahedron twice on the others: the reports have groups to compare.
campaign=("$build/tetproof-fuzz" --seed 3 --cases 120 --name faulty)
mesher=(sh -c 'sleep 0.1; exec "$0" "$@"' "$build/tetproof-faulty-mesher" duplicate '{surface}' '{mesh}')

# Runs a campaign; findings (1) are a result, everything else but 0 is a failure.
run_campaign() {
  local code=0
  "$@" || code=$?
  [ $code = 0 ] || [ $code = 1 ] || fail "exit code $code: $*"
}

# One run of all cases, in the folder `whole`.
run_whole() {
  run_campaign "${campaign[@]}" --threads 16 --quiet --out "$scratch/whole" -- "${mesher[@]}" >"$scratch/whole.txt"
}

# Merges the journals in the folder $1 and compares.
compare_merged() {
  run_campaign "$build/tetproof-fuzz" --merge "$1" --json "$scratch/merged.json" >"$scratch/merged.txt"
  grep -q ':wrong-answer:duplicate-tet' "$scratch/whole.txt" || fail "the campaign found nothing: it shows nothing"
  cmp "$scratch/whole.txt" "$scratch/merged.txt" || fail "the merged report differs from that of one run"
  cmp "$scratch/whole/report.json" "$scratch/merged.json" || fail "the merged JSON differs from that of one run"
  head -n 1 "$scratch/merged.txt"
}
