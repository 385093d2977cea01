#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the packages that `cpack` made on a bare Debian of the release that they were made for, and uses them: the
# programs, their pages, a project that calls find_package(tetproof), the Python module if there is one. Then it removes
# them and looks for what is left. Prints what each step took.
# usage: tests/package/deb.sh ROOT FOLDER    ROOT: the folder of a bare Debian (made by debootstrap, as root, if there is
#                                            none); FOLDER: where tetproof_*.deb and tetproof-dev_*.deb are
#        tests/package/deb.sh --here FOLDER  the same on this machine: for a container that is thrown away
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
fail() { echo "deb.sh: $1" >&2; exit 1; }
[ $# = 2 ] || { sed -n '6,8s/^# //p' "${BASH_SOURCE[0]}"; exit 2; }
folder=$(cd "$2" && pwd)
packages=("$folder"/tetproof_*.deb "$folder"/tetproof-dev_*.deb)
for file in "${packages[@]}"; do [ -f "$file" ] || fail "there is no $file"; done
[ ${#packages[@]} = 2 ] || fail "$folder holds the packages of more than one build"

if [ "$1" != --here ]; then
  root=$1
  [ "$(id -u)" = 0 ] || fail "only root may change the root folder"
  if [ ! -d "$root/usr" ]; then
    release=$(dpkg-deb -f "${packages[0]}" Version)
    case $release in
      *+deb12*) release=bookworm ;;
      *+deb13*) release=trixie ;;
      *) fail "${packages[0]} is not for Debian 12 or 13: make the root folder $root yourself" ;;
    esac
    debootstrap --variant=minbase "$release" "$root" >/dev/null || fail "debootstrap failed"
  fi
  work=$root/root/tetproof-packages
  rm -rf "$work"; mkdir -p "$work"
  cp "${packages[@]}" "${BASH_SOURCE[0]}" "$work"; cp -r "$here"/*consumer "$work"
  mounted=()
  finish() { for ((i = ${#mounted[@]} - 1; i >= 0; --i)); do umount -l "${mounted[i]}"; done; }
  trap finish EXIT
  for place in proc dev; do
    mountpoint -q "$root/$place" || { mount --bind "/$place" "$root/$place"; mounted+=("$root/$place"); }
  done
  mapfile -t proxies < <(env | grep -iE '^(http|https|no)_proxy=' || true)
  env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 ${proxies[@]+"${proxies[@]}"} \
    chroot "$root" bash /root/tetproof-packages/deb.sh --here /root/tetproof-packages
  exit
fi

export DEBIAN_FRONTEND=noninteractive
now() { date +%s.%N; }
took() { awk -v a="$1" -v b="$(now)" 'BEGIN { printf "%.1f s", b - a }'; }
# Installs and says what it took: apt-get's figures.
install() {
  local start; start=$(now)
  apt-get install -y -q "$@" >install.log 2>&1 || { tail -n 20 install.log >&2; fail "apt-get install $* failed"; }
  echo "apt-get install ${*##*/}: $(grep -E '^Need to get' install.log | sed 's/Need to get //;s/ of archives.*//') downloaded," \
    "$(grep -E '^After this' install.log | sed 's/After this operation, //;s/ of additional.*//') of disk," \
    "$(grep -oE '[0-9]+ newly installed' install.log), $(took "$start")"
}
# Runs a command whose exit code is known.
expect() {
  local code=$1 got=0; shift
  "$@" >run.log 2>&1 || got=$?
  [ "$got" = "$code" ] || { cat run.log >&2; fail "'$*' exits $got, expected $code"; }
}

cd "$(mktemp -d)"
apt-get update -q >update.log 2>&1 || { cat update.log >&2; fail "apt-get update failed"; }
for file in "${packages[@]}"; do
  echo "${file##*/}: $(($(stat -c %s "$file") / 1000)) kB, depends on $(dpkg-deb -f "$file" Depends)"
done
before=$(find /usr /etc /var/lib -name '*tetproof*' -prune | sort)
install --no-install-recommends "${packages[0]}"

start=$(now)
expect 0 tetproof-mesh sphere -o ball.msh --cells 12 --points 100 --save-surface ball.stl --trace ball.jsonl
expect 0 tetproof-verify ball.msh ball.stl --fidelity 0.05 --junit ball.xml --json ball.json
expect 0 tetproof-convert ball.msh ball.1.node
expect 0 tetproof-compare ball.1.node ball.msh
expect 0 tetproof-compare ball.jsonl ball.jsonl
sed 's/^10 \([0-9]*\) \([0-9]*\) /10 \2 \1 /' ball.msh >broken.msh
expect 1 tetproof-verify broken.msh
expect 2 tetproof-verify no-such-file.msh
tetproof-fuzz --cases 3 --out fuzzed -- tetproof-mesh '{surface}' -o '{mesh}' --points 0 >fuzz.txt 2>&1 || true
grep -q tetproof-mesh fuzz.txt || { cat fuzz.txt >&2; fail "tetproof-fuzz reports nothing"; }
printf 'SetFactory("OpenCASCADE");\nBox(1) = {0, 0, 0, 1, 1, 1};\n' >box.geo
expect 2 tetproof-convert box.geo box.msh   # through Gmsh's library, which is only recommended
grep -q 'Gmsh, whose library is not installed: libgmsh' run.log || { cat run.log >&2; fail "it does not say what is missing"; }
for program in mesh verify compare convert fuzz; do
  [ -s "/usr/share/bash-completion/completions/tetproof-$program" ] || fail "no completion for tetproof-$program"
  dpkg -L tetproof | grep -q "/man1/tetproof-$program.1.gz" || fail "no manual page of tetproof-$program"
done
echo "the five programs: $(took "$start")"

install "$(dpkg-query -W -f '${Recommends}' tetproof | grep -oE 'libgmsh[^ ,]*')"
expect 0 tetproof-convert box.geo box.msh
expect 0 tetproof-verify box.msh

if dpkg -L tetproof | grep -q /dist-packages/; then
  install python3-numpy
  start=$(now)
  expect 0 python3 -c '
import tetproof
assert tetproof.verify(tetproof.read("ball.msh"), "ball.stl", fidelity=0.05).sound
assert tetproof.verify(tetproof.read("broken.msh")).verdict == "defective"'
  echo "the Python module: $(took "$start")"
else
  echo "no Python module in the package: not tried"
fi

install --no-install-recommends "${packages[1]}" cmake g++ make pkg-config libgmock-dev librapidcheck-dev
for project in "$here"/*consumer; do   # in C++; in C
  start=$(now)
  expect 0 cmake -S "$project" -B "${project##*/}" -DCMAKE_BUILD_TYPE=Release
  expect 0 cmake --build "${project##*/}" -j "$(nproc)"
  expect 0 ctest --output-on-failure --no-tests=error --test-dir "${project##*/}"
  echo "a project with find_package(tetproof), ${project##*/}: $(took "$start")"
done

apt-get purge -y -q tetproof tetproof-dev >purge.log 2>&1 || { cat purge.log >&2; fail "apt-get purge failed"; }
after=$(find /usr /etc /var/lib -name '*tetproof*' -prune | sort)
[ "$before" = "$after" ] || { diff <(echo "$before") <(echo "$after") >&2; fail "this is left when the packages are gone"; }
echo "removed, nothing is left"
