#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The four shards of a campaign as a Slurm array, on a Slurm of one node that this script starts and stops: its own
# daemons, ports, key and folder, whatever Slurm there is besides. One shard is killed by SIGKILL in its middle and
# requeued. Merged, the shards report byte for byte what one run reports.
# usage: tests/fuzz/slurm.sh BUILD     exit code 77: Slurm is not installed, or its daemons may not run here
# Packages: slurm-wlm and munge. They start services when they are installed, of which this script needs none; so they
# are not in apt-packages.txt, and whoever wants this test installs them.
PATH=$PATH:/usr/sbin:/sbin
for program in munged slurmctld slurmd sbatch squeue scontrol sinfo; do
  command -v $program >/dev/null || { echo "SKIPPED: $program is not installed (packages slurm-wlm and munge)"; exit 77; }
done
# shellcheck source=tests/fuzz/shards.sh
source "$(dirname "${BASH_SOURCE[0]}")/shards.sh" "$1"

state=$scratch/slurm
# Ends what was started here, by the numbers of the processes.
stop() {
  local code=$? name pid
  trap - EXIT
  if [ -s "$state/slurmctld.pid" ]; then scancel --user="$(id -un)" 2>/dev/null || true; fi
  for name in slurmd slurmctld munged; do
    pid=$(cat "$state/$name.pid" 2>/dev/null) || continue
    kill "$pid" 2>/dev/null || continue
    for _ in $(seq 50); do kill -0 "$pid" 2>/dev/null || break; sleep 0.1; done
    kill -9 "$pid" 2>/dev/null || true
  done
  if [ $code != 0 ] && [ $code != 77 ]; then
    tail -n 15 "$state"/*.log "$scratch"/task-*.txt >&2 || true
  fi
  rm -rf "$scratch"
  exit $code
}
trap stop EXIT
trap 'exit 130' INT TERM

# Waits at most $1 seconds until the command after it succeeds.
await() {
  local end=$((SECONDS + $1)); shift
  until "$@" >/dev/null 2>&1; do
    [ $SECONDS -lt $end ] || return 1
    sleep 0.2
  done
}

# --- a Slurm of one node
mkdir -p "$state/spool" "$state/ctld" "$state/munge"
chmod 700 "$state/munge"
(umask 077; head -c 1024 /dev/urandom >"$state/munge/key")
read -r port1 port2 < <(python3 -c 'import socket
s = [socket.socket() for _ in range(2)]
for one in s: one.bind(("127.0.0.1", 0))
print(*(one.getsockname()[1] for one in s))')
host=$(hostname -s)
cat >"$state/slurm.conf" <<CONF
ClusterName=one
SlurmctldHost=$host(127.0.0.1)
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
CredType=cred/munge
# A requeued job waits until the credential of its first run has expired: 120 s by default.
AuthInfo=socket=$state/munge/socket,cred_expire=5
SlurmctldPort=$port1
SlurmdPort=$port2
StateSaveLocation=$state/ctld
SlurmdSpoolDir=$state/spool
SlurmctldPidFile=$state/slurmctld.pid
SlurmdPidFile=$state/slurmd.pid
SlurmctldLogFile=$state/slurmctld.log
SlurmdLogFile=$state/slurmd.log
ProctrackType=proctrack/pgid
SchedulerType=sched/builtin
SchedulerParameters=sched_interval=2
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
JobRequeue=1
MailProg=/bin/true
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=local Nodes=$host Default=YES MaxTime=INFINITE OverSubscribe=FORCE:4 State=UP
CONF
# Versions from 24.05 on look for cgroups unless they are told not to; older ones do not know the word.
version=$(slurmctld -V | sed 's/[^0-9]*\([0-9]*\).*/\1/')
[ "$version" -lt 24 ] || echo "CgroupPlugin=disabled" >"$state/cgroup.conf"
export SLURM_CONF=$state/slurm.conf
unset SLURM_ARRAY_TASK_ID SLURM_ARRAY_TASK_COUNT   # where this script itself runs under Slurm

munged --force --key-file="$state/munge/key" --socket="$state/munge/socket" --pid-file="$state/munged.pid" \
  --log-file="$state/munged.log" --seed-file="$state/munge/seed" >"$state/start.txt" 2>&1 ||
  skip "munged does not start here: $(tail -n 1 "$state/start.txt")"
slurmctld >"$state/start.txt" 2>&1 || skip "slurmctld does not start here: $(tail -n 1 "$state/start.txt")"
slurmd >"$state/start.txt" 2>&1 || skip "slurmd does not start here: $(tail -n 1 "$state/start.txt")"
node_is_idle() { [ "$(sinfo --noheader --format=%T)" = idle ]; }
await 15 node_is_idle || skip "the node does not become idle: $(tail -n 1 "$state/slurmctld.log")"

# --- the campaign. The program reads from the environment which shard it is.
run_whole
{
  echo "#!/bin/sh"
  echo "echo \$\$ >>'$scratch/started-'\$SLURM_ARRAY_TASK_ID"   # exec: the number of the program's own process
  printf 'exec'
  printf ' %q' "${campaign[@]}" --threads 1 --quiet --out "$scratch/shards" -- "${mesher[@]}"
  echo
} >"$scratch/job.sh"
job=$(sbatch --parsable --array=0-3 --requeue --output="$scratch/task-%a.txt" --open-mode=append "$scratch/job.sh")

journal=$scratch/shards/journal-1-of-4.jsonl
has_lines() { [ "$(wc -l <"$journal" 2>/dev/null || echo 0)" -ge 8 ]; }
await 30 has_lines || fail "shard 1 has no results after 30 s"
kill -9 "$(tail -n 1 "$scratch/started-1")"
state_of_shard_1() { scontrol show job "${job}_1" | grep -o 'JobState=[A-Z_]*'; }
has_failed() { [ "$(state_of_shard_1)" = JobState=FAILED ]; }
await 15 has_failed || fail "the killed shard is not FAILED but $(state_of_shard_1)"
cases_done() { grep -c '^{"case":' "$journal"; }
done_before=$(cases_done)
[ "$done_before" -lt 30 ] || fail "shard 1 had finished before it was killed"
head -n "$done_before" "$journal" >"$scratch/before"   # the header and all cases but the last, which may be cut off
echo "shard 1 killed after $done_before of 30 cases"
scontrol requeue "${job}_1"

all_have_ended() { [ -z "$(squeue --noheader --states=all --job="$job" --format=%T | grep -v -e COMPLETED -e FAILED)" ]; }
started_again() { [ "$(wc -l <"$scratch/started-1")" = 2 ]; }
await 40 started_again || fail "the requeued shard does not start: $(scontrol show job "${job}_1" | grep -E 'JobState|StartTime')"
await 60 all_have_ended || fail "the array does not end: $(squeue --noheader)"
[ "$(cases_done)" = 30 ] || fail "shard 1 has $(cases_done) of 30 cases"
cmp <(head -n "$done_before" "$journal") "$scratch/before" || fail "what the killed shard had done was done again"
compare_merged "$scratch/shards"
