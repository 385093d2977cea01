#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The set-up that every command of this project begins with: installs the packages of apt-packages.txt that are
# missing, and builds a Release in build/. Where all is installed and built it takes a second or two.
# usage: .ci/setup.sh [--without-tests | --full] [TARGET...]
#   TARGET            what to build, as CMake names it; default: everything
#   --without-tests   leaves out the packages that only tests and measurements need
#   --full            compiles the parsers and their tests once more under sanitizers, for tests/run.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
mkdir -p build
tests=ON preset=release
case ${1:-} in
  --without-tests) tests=OFF; shift ;;
  --full) preset=full; shift ;;
esac
start=$SECONDS

fail() { echo "set-up: $1" >&2; exit 1; }

# Runs a command with its output in a log, shown only when the command fails.
logged() {
  local log=$1; shift
  "$@" >"$log" 2>&1 || { tail -n 40 "$log" >&2; fail "failed: $* (the whole of it: $log)"; }
}

# Of what apt-get says: the costs, and every 50th package. (Not by awk: mawk waits until its buffer is full.)
progress() {
  local line total=0 unpacked=0 ready=0
  while read -r line; do
    case $line in
      *" newly installed, "*) read -r _ _ total _ <<<"$line" ;;
      "Need to get "*) line=${line#Need to get }; echo "set-up: downloading ${line% of archives*}" ;;
      "After this operation, "*) line=${line#After this operation, }; echo "set-up: taking ${line% of additional*} of disk space" ;;
      "Unpacking "*) unpacked=$((unpacked + 1)); [ $((unpacked % 50)) != 0 ] || echo "set-up: unpacked $unpacked of $total" ;;
      "Setting up "*) ready=$((ready + 1)); [ $((ready % 50)) != 0 ] || echo "set-up: installed $ready of $total" ;;
    esac
  done
}

# --- packages
list=$(if [ $tests = ON ]; then cat apt-packages.txt; else sed '/^# --- only for tests/,$d' apt-packages.txt; fi)
mapfile -t wanted < <(sed 's/[[:space:]]*#.*//' <<<"$list" | grep .)   # "NAME" or "NAME | NAME"
if ! command -v dpkg-query >/dev/null; then
  echo "set-up: not a Debian system: apt-packages.txt is taken as installed"
else
  declare -A installed
  while read -r status name; do if [ "$status" = installed ]; then installed[$name]=1; fi
  done < <(dpkg-query -W -f '${db:Status-Status} ${Package}\n')
  missing=()
  for names in "${wanted[@]}"; do
    found=
    for name in ${names//|/ }; do if [ -n "${installed[$name]:-}" ]; then found=1; fi; done
    [ -n "$found" ] || missing+=("$names")
  done
  if [ ${#missing[@]} -gt 0 ]; then
    printf -v missing_list '%s, ' "${missing[@]}"; missing_list=${missing_list%, }
    if [ "$(id -u)" = 0 ]; then as_root=(env)
    elif command -v sudo >/dev/null; then as_root=(sudo env)
    else fail "packages are missing, and only root may install them (there is no sudo here). As root: apt-get satisfy --no-install-recommends '$missing_list'"
    fi
    apt_get=("${as_root[@]}" DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8
             apt-get -q -y -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3)
    echo "set-up: installing, with what they need: $missing_list"
    # A package source of the user's own may fail to answer without mattering here; the installation decides.
    "${apt_get[@]}" update >build/apt-update.log 2>&1 ||
      { tail -n 3 build/apt-update.log >&2; echo "set-up: apt-get update failed; going on with the package lists that are there" >&2; }
    "${apt_get[@]}" satisfy --no-install-recommends "$missing_list" 2>&1 </dev/null | tee build/apt-install.log | progress ||
      { tail -n 20 build/apt-install.log >&2; fail "apt-get could not install the packages (the whole of it: build/apt-install.log)"; }
    echo "set-up: packages installed in $((SECONDS - start)) s"
  fi
fi

# --- build
[ -f build/build.ninja ] || echo "set-up: configuring a Release in build/"
if [ $tests = OFF ] && [ -f build/build.ninja ]; then choice=(); else choice=("-DBUILD_TESTING=$tests"); fi   # what is there stays
logged build/configure.log cmake --preset $preset "${choice[@]}"
# Some sources take a gigabyte of memory to compile: no more jobs than fit.
jobs=$(nproc)
fitting=$(awk '/^MemAvailable:/ { print int($2 / 1500000) }' /proc/meminfo)
if [ "$fitting" -lt "$jobs" ]; then jobs=$((fitting > 0 ? fitting : 1)); fi
echo "set-up: building in build/ with $jobs jobs"
cmake --build build -j "$jobs" ${1:+--target "$@"}
