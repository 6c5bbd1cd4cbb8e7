#!/bin/bash
# A sweep of 40 runs as an array of a real Slurm, which this test starts for itself: two nodes on this machine. One task
# is killed with -9 and a node is drained meanwhile: all is done, and nothing twice but what died.
#   run_slurm_tests.sh PROGRAM BEAM_DECK; 77 where it is skipped
# Needs root and Debian's packages slurmctld, slurmd, slurm-client and munge.
set -u
program=$(realpath "$1")
beam=$(realpath "$2")
PATH=$PATH:/usr/sbin
skip() {
  echo "SKIPPED: $1"
  exit 77
}
[ "$(id -u)" -eq 0 ] || skip "not root"
for command in munged slurmctld slurmd sbatch scontrol squeue; do
  command -v $command >/dev/null || skip "there is no $command; apt-get install slurmctld slurmd slurm-client munge"
done
source "$(dirname "${BASH_SOURCE[0]}")/scratch.sh"
source "$(dirname "${BASH_SOURCE[0]}")/sweep_table.sh"
open_scratch
export SLURM_CONF=$work/slurm.conf

# free_ports COUNT: of this machine.
free_ports() {
  /usr/bin/python3 -c 'import socket, sys
sockets = [socket.socket() for _ in range(int(sys.argv[1]))]
for one in sockets: one.bind(("127.0.0.1", 0))
print(*(one.getsockname()[1] for one in sockets))' "$1"
}

configure() {
  local ports
  read -r -a ports <<<"$(free_ports 3)"
  cat >"$SLURM_CONF" <<EOF
ClusterName=scratch
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmctldPort=${ports[0]}
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge.socket
SlurmctldPidFile=$work/slurmctld.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdPidFile=$work/slurmd-%n.pid
SlurmdLogFile=$work/slurmd-%n.log
SlurmdSpoolDir=$work/spool-%n
StateSaveLocation=$work/state
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU_Memory
SlurmdParameters=config_overrides
ReturnToService=2
MpiDefault=none
NodeName=one,two NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 Port=${ports[1]},${ports[2]} CPUs=2 RealMemory=4000 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
EOF
}

# The daemons that stand in files of this test's own.
stop_slurm() {
  local file process
  for file in "$work"/slurmd-*.pid "$work"/slurmctld.pid "$work"/munged.pid; do
    read -r process <"$file" || continue
    kill "$process" && wait_for test ! -e "/proc/$process"
  done
  rm -rf "$work"
}

start_slurm() {
  mkdir state spool-one spool-two
  head -c 1024 /dev/urandom >munge.key
  chmod 600 munge.key
  munged --force --num-threads=1 --key-file="$work/munge.key" --socket="$work/munge.socket" --pid-file="$work/munged.pid" \
    --log-file="$work/munged.log" --seed-file="$work/munge.seed" || return
  configure
  slurmctld -c && slurmd -N one && slurmd -N two && wait_for are_idle
}
are_idle() { [ "$(sinfo -h -N -t idle | wc -l)" -eq 2 ]; }

are_over() { [ -z "$(squeue -h)" ]; }
running() { "$program" sweep --status forty | sed -n 's/^  \([0-9]*\)  .*process \([0-9]*\) of .*/\1 \2/p'; }
# is_begun: four run, and one of them, `victim`, has a restart file; the line "CASE KEEPER".
is_begun() {
  local case rest
  [ "$(running | wc -l)" -eq 4 ] || return
  while read -r case rest; do
    [ -e "forty/cases/$case/restart.h5" ] && victim="$case $rest" && return
  done < <(running)
  return 1
}
parent_of() { awk '/^PPid:/ { print $2 }' "/proc/$1/status"; }
# claimed_again GENERATION: the cases that were claimed so often.
claimed_again() { find forty/claims -name "[0-9]*.$1" -printf '%f\n' | sort | sed "s/\.$1$//" | xargs; }

# kill_a_task: all processes of one; its case is `killed_case`.
kill_a_task() {
  local keeper sweep run
  read -r killed_case keeper <<<"$victim"
  sweep=$(parent_of "$keeper")
  read -r run <"/proc/$keeper/task/$keeper/children"
  kill -KILL "$sweep" "$keeper" "$run"
}

forty() {
  printf 'sweep: {deck: %s, seed: 1..10, thickness: [50, 100, 150, 200]}\n' "$beam" >forty.yaml
  expect 0 "submitted" "$program" sweep forty.yaml --folder forty --launcher slurm --submit --set record.fields_every=1 --set scene.subdivision.blocks=500
  said "Submitted batch job"
  wait_for is_begun
  kill_a_task
  scontrol update nodename=two state=drain reason=test
  wait_for are_over
  [ "$(cells forty status | tr ' ' '\n' | grep -c '^goal_reached$')" -eq 40 ] || complain "not all: $(cells forty status)"
  [ "$(claimed_again 1 | wc -w)" -eq 40 ] || complain "claims: $(claimed_again 1)"
  [ "$(claimed_again 2)" == "$killed_case" ] || complain "twice: $(claimed_again 2) instead of $killed_case"
  [ -z "$(claimed_again 3)" ] || complain "three times: $(claimed_again 3)"
  [ "$(sinfo -h -N -n two -o %T)" == drained ] || complain "node two is $(sinfo -h -N -n two -o %T)"
  [ "$(find forty/cases -name log.jsonl -exec grep -l '"event":"resumed"' {} + | xargs)" == "forty/cases/$killed_case/log.jsonl" ] ||
    complain "another case than $killed_case was resumed"
}

# The same by one process.
compared() {
  "$program" sweep forty.yaml --folder alone --quiet --set record.fields_every=1 --set scene.subdivision.blocks=500 >said.log 2>&1 || complain "alone: $(cat said.log)"
  for case in alone/cases/*; do same "$case/curve.csv" "forty/cases/${case##*/}/curve.csv"; done
  for column in case seed status exit_code peak.load steps
  do [ "$(cells alone $column)" == "$(cells forty $column)" ] || complain "$column differs"; done
}

trap stop_slurm EXIT
if start_slurm; then
  forty
  compared
else
  complain "Slurm did not start: $(tail -n 3 ./*.log)"
fi
exit $failed
