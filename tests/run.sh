#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs all tests, on a fresh Debian 12 or 13 too: set-up, ctest, a summary. Exits with ctest's code.
# usage: tests/run.sh [CTEST OPTION...]     for example: tests/run.sh -R verify
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
start=$SECONDS
.ci/setup.sh --full
ready=$SECONDS
code=0
ctest --test-dir build --output-on-failure -j "$(nproc)" "$@" || code=$?
echo
echo "set-up and build: $((ready - start)) s; tests: $((SECONDS - ready)) s; logs: build/Testing/Temporary/"
[ $code = 0 ] && echo "ALL TESTS PASSED" || echo "TESTS FAILED (ctest exit code $code)"
exit $code
