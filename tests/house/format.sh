#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Checks that every C and C++ source is formatted as clang-format 14 does it by .clang-format. Exit code 77: there is no clang-format 14 here.
# usage: tests/house/format.sh [--fix]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
for program in clang-format-14 clang-format; do
  if "$program" --version 2>/dev/null | grep -q 'version 14\.'; then
    found=$program
    break
  fi
done
if [ -z "${found:-}" ]; then
  echo "skipped: clang-format 14 is not installed, and other versions format otherwise"
  exit 77
fi
mapfile -t sources < <(find io reference verify corpus tests -name '*.cpp' -o -name '*.hpp' -o -name '*.c' -o -name '*.h' | sort)
[ ${#sources[@]} -gt 0 ]
if [ "${1:-}" = --fix ]; then
  "$found" -i "${sources[@]}"
else
  "$found" --dry-run -Werror "${sources[@]}"
fi
echo "${#sources[@]} files"
