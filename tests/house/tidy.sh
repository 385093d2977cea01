#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs clang-tidy 14 by .clang-tidy over the sources of the libraries and programs. All of them take half an hour on two cores.
# usage: tests/house/tidy.sh [SOURCE...]     a Release has been configured in build/
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
[ -f build/compile_commands.json ] || { echo "tidy.sh: build/ is not configured: cmake --preset release" >&2; exit 2; }
program=$(command -v clang-tidy-14 || command -v clang-tidy) || { echo "tidy.sh: clang-tidy is not installed" >&2; exit 2; }
if [ $# = 0 ]; then mapfile -t sources < <(find io reference verify corpus -name '*.cpp' | sort)
else sources=("$@")
fi
"$program" --version | sed -n 's/.*version/clang-tidy/p'
printf '%s\n' "${sources[@]}" | xargs -P "$(nproc)" -n 1 "$program" -p build --quiet
echo "${#sources[@]} sources: no complaint"
