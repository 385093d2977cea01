#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Measures the programs and their peers on this machine; some 30 minutes. Tables on standard output, out/bench/bench.json.
# usage: tests/bench/run.sh [OPTION...]     tests/bench/run.sh --help lists the options
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
.ci/setup.sh >&2
exec /usr/bin/python3 tests/bench/bench.py "$@"
