#!/bin/bash
# Many processes do one sweep in one folder: together, killed, frozen elsewhere, on a full disk, by launchers.
#   run_shared_sweep_tests.sh PROGRAM BAR_DECK BEAM_DECK
set -u
program=$(realpath "$1")
bar=$(realpath "$2")
beam=$(realpath "$3")
source "$(dirname "${BASH_SOURCE[0]}")/scratch.sh"
source "$(dirname "${BASH_SOURCE[0]}")/sweep_table.sh"
open_scratch
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1

# claims FOLDER GENERATION: the cases of which there is that generation of a claim, on one line.
claims() {
  local out=() file
  for file in "$1"/claims/*/[0-9]*."$2"; do
    [ -e "$file" ] && out+=("$(basename "$file" ".$2")")
  done
  echo "${out[*]}"
}
claimed() { [ "$(claims "$1" "$2")" == "$3" ] || complain "claims $2 in $1: '$(claims "$1" "$2")' instead of '$3'"; }
# keepers PID: the children of a sweep; runs PID: their children.
keepers() { cat "/proc/$1/task/$1/children"; }
runs() { for keeper in $(keepers "$1"); do keepers "$keeper"; done; }
# foreign_claim BEATS LEASE: as a process of another machine writes it, whose clock is an hour ahead.
foreign_claim() {
  printf '{"beats": %20d, "pid": %20d, "start": %20d, "host": "far", "machine": "far 0", "lease": %s, "note": {"since": "%s"}}\n' \
    "$1" 1 1 "$2" "$(date -u -d '+1 hour' +%FT%T.000Z)"
}
# slow FOLDER [ARGUMENTS...]: this shell becomes a sweep of four beams, each of which takes a while.
slow() {
  local folder=$1
  shift
  exec "$program" sweep slow.yaml --folder "$folder" --quiet --set record.fields_every=1 --set scene.subdivision.blocks=600 "$@"
}
printf 'sweep: {deck: %s, seed: 1..4}\n' "$beam" >slow.yaml
printf 'sweep:\n  deck: %s\n  interfaces.crack.law.tensile_strength: 2..3 step 0.1\n' "$bar" >bars.yaml
readonly all_bars="001 002 003 004 005 006 007 008 009 010 011"

alone() {
  (slow alone --jobs 2) >said.log 2>&1 || complain "four beams alone: $(cat said.log)"
  "$program" sweep bars.yaml --folder bars_alone --quiet >said.log 2>&1 || complain "bars alone: $(cat said.log)"
  claimed bars_alone 1 "$all_bars"
}

together() {
  local pids=() pid
  for i in 1 2 3; do
    "$program" sweep bars.yaml --folder bars --quiet --jobs 2 >"together_$i.log" 2>&1 &
    pids+=($!)
  done
  for pid in "${pids[@]}"; do
    wait "$pid" || complain "one of three: exit code $?: $(cat together_*.log)"
  done
  grep -q ' 11 goal_reached' together_1.log || complain "one of three does not know of all: $(cat together_1.log)"
  the_same_table bars_alone bars
  claimed bars 1 "$all_bars"
  claimed bars 2 ""
  grep -q '"status": "running"\|"status": "pending"' bars/sweep.json && complain "sweep.json is not the last one"
  exists bars/curves.svg
  [ -z "$(find bars -name '*.part')" ] || complain "left behind: $(find bars -name '*.part')"
}

# A sweep is killed: its runs write restart files and end; or all is killed at once, as when a machine dies.
killed() {
  local first second
  for how in sweep everything; do
    slow "killed_$how" --jobs 1 --lease 86400 >first.log 2>&1 &
    first=$!
    slow "killed_$how" --jobs 1 --lease 86400 >second.log 2>&1 &
    second=$!
    wait_for is_claimed "killed_$how" 2
    wait_for find_victim "killed_$how" $first
    if [ $how == sweep ]
    then kill -KILL $first
    else kill -KILL $first $(keepers $first) $(runs $first)
    fi
    wait $first 2>/dev/null
    wait $second || complain "the other one, $how killed: exit code $?: $(cat second.log)"
    claimed "killed_$how" 1 "001 002 003 004"
    claimed "killed_$how" 2 "$victim"
    claimed "killed_$how" 3 ""
    grep -q '"event":"resumed"' "killed_$how/cases/$victim/log.jsonl" || complain "$how: the case was not resumed"
    for case in 001 002 003 004
    do same "alone/cases/$case/curve.csv" "killed_$how/cases/$case/curve.csv"; done
    the_same_table_of_results alone "killed_$how"
  done
}
# find_victim FOLDER SWEEP: `victim` is the case that this process runs; it has a restart file and is not near its end.
find_victim() {
  local keeper
  keeper=$(keepers "$2")
  victim=$("$program" sweep --status "$1" | sed -n "s/^  \([0-9]*\)  .*process ${keeper% } of .*/\1/p")
  [ -n "$victim" ] && [ -e "$1/cases/$victim/restart.h5" ] && [ "$(wc -l <"$1/cases/$victim/curve.csv")" -lt 30 ]
}
# A case that was resumed counts its iterations from there.
the_same_table_of_results() {
  for column in case seed status exit_code peak.load steps
  do [ "$(cells "$1" $column)" == "$(cells "$2" $column)" ] || complain "$column differs in $1 and $2"; done
}

# Two processes, and cases that are claimed by another machine: not taken while that gives signs of life, whatever its clock says; taken over
# when it gives none.
another_machine() {
  local claims beating sweep second
  "$program" sweep bars.yaml --folder far --quiet --case 1 >/dev/null
  claims=$(echo far/claims/11-*)
  foreign_claim 5 2 >"$claims/002.1"
  foreign_claim 5 4 >"$claims/003.1"
  touch -d '-1 hour' "$claims/002.1"
  (
    beats=5
    while [ ! -e stop_beating ]; do
      ((++beats))
      printf '%20d' $beats | dd of="$claims/003.1" bs=1 seek=10 conv=notrunc status=none
      touch -d '+1 hour' "$claims/003.1"
      sleep 0.1
    done
  ) &
  beating=$!
  "$program" sweep bars.yaml --folder far --quiet --jobs 1 >said.log 2>&1 &
  sweep=$!
  "$program" sweep bars.yaml --folder far --quiet --jobs 1 >second.log 2>&1 &
  second=$!
  wait_for test -s "$claims/002.2"
  sleep 6
  is_absent "$claims/003.2"
  "$program" sweep --status far >said.log
  said "far: 11 cases: 10 done, 1 running"
  said "process 1 of far, since "
  cp -r bars_alone/cases/003 far/cases/003
  echo '{"status": "goal_reached", "exit_code": 0, "reason": ""}' >>"$claims/003.1"
  wait $sweep || complain "a case of another machine: exit code $?"
  wait $second || complain "a case of another machine: exit code $? of the second process"
  claimed far 1 "$all_bars"
  touch stop_beating
  wait $beating
  claimed far 2 "002"
  the_same_table bars_alone far
}

# A file changes while another machine has left a claim: waits until that machine is taken for dead.
changed_beside_the_dead() {
  printf 'sweep: {deck: %s, thickness: [50, 100]}\n' "$bar" >change.yaml
  expect 0 "before the change" "$program" sweep change.yaml --folder change --quiet
  foreign_claim 5 1 >"$(echo change/claims/2-*)/002.2"
  printf 'sweep: {deck: %s, thickness: [100, 20, 50]}\n' "$bar" >change.yaml
  expect 0 "after the change" "$program" sweep change.yaml --folder change
  said "waiting for process 1 of far, since "
  said "2 of its 3 cases were there before"
  has change thickness "100 20 50"
  claimed change 1 "002"
}

# Whoever was taken for dead and is not ends its run when it sees that, and writes no more.
lost() {
  local sweep claims run
  slow lost --jobs 1 --lease 1 >said.log 2>&1 &
  sweep=$!
  wait_for has_rows lost/cases/001 6
  run=$(runs $sweep)
  claims=$(echo lost/claims/*/)
  foreign_claim 1 1 >"$claims/001.2"
  wait_for test ! -e "/proc/$run"
  wait $sweep || complain "a lost case: exit code $?: $(cat said.log)"
  claimed lost 2 "001"
  claimed lost 3 "001"
  same alone/cases/001/curve.csv lost/cases/001/curve.csv
}

# A sweep that is stopped (Ctrl-Z) keeps its cases, and its runs go on; Ctrl-C hands them to the others.
stopped_and_interrupted() {
  local first second
  slow handed --jobs 1 >first.log 2>&1 &
  first=$!
  wait_for has_rows handed/cases/001 4
  slow handed --jobs 1 >second.log 2>&1 &
  second=$!
  kill -STOP $first
  wait_for has_result handed/cases/001
  is_absent "$(echo handed/claims/*/)001.2"
  kill -CONT $first
  wait_for is_claimed handed 3
  kill -INT $first
  wait $first
  [ $? -eq 130 ] || complain "interrupted beside another one: not 130"
  wait $second || complain "the other one: exit code $?: $(cat second.log)"
  has handed status "goal_reached goal_reached goal_reached goal_reached"
  claimed handed 3 ""
}
# As a batch queue ends a task: SIGTERM to every process, each of which passes it on.
terminated() {
  local sweep
  slow terminated --jobs 1 >said.log 2>&1 &
  sweep=$!
  wait_for has_rows terminated/cases/001 2
  kill -TERM $sweep $(keepers $sweep) $(runs $sweep)
  wait $sweep
  [ $? -eq 130 ] || complain "a task that was ended: not 130"
  grep -q '"status": "interrupted"' terminated/cases/001/summary.json || complain "the run was not ended in good order"
  exists terminated/cases/001/restart.h5
}
has_result() { grep -q goal_reached "$1/summary.json"; }
is_claimed() { [ "$(claims "$1" 1 | wc -w)" -ge "$2" ]; }

# What fails is one try of all that work together, and another one when somebody begins anew.
failures() {
  cat >failing.yaml <<EOF
sweep:
  deck: $bar
  supports.guide_left.at: [[25, 50], [25, 5000], [25, 50]]
EOF
  for i in 1 2; do
    expect 2 "attempt $i" "$program" sweep failing.yaml --quiet --folder failing --attempt one
    claimed failing 2 ""
  done
  has failing status "goal_reached failed goal_reached"
  expect 0 "how it stands" "$program" sweep --status failing
  said "failing: 3 cases: 2 done, 1 failed"
  said "exit code 2: $bar:"
  expect 2 "another attempt" "$program" sweep failing.yaml --quiet --folder failing --attempt two
  claimed failing 2 "002"
  expect 2 "again" "$program" sweep failing.yaml --quiet --folder failing
  claimed failing 3 "002"
  expect 2 "alone" "$program" sweep failing.yaml --quiet --folder failing --case 2
  said "lies outside every block"
  claimed failing 4 "002"
}

# Which sweep runs where: a file that has changed does not move cases under the runs of others; --case neither.
at_work() {
  local sweep keeper
  cp slow.yaml work.yaml
  "$program" sweep work.yaml --folder work --quiet --jobs 1 --set record.fields_every=1 >first.log 2>&1 &
  sweep=$!
  wait_for has_rows work/cases/001 4
  sed -i 's/1\.\.4/[4, 3, 2, 1]/' work.yaml
  expect 2 "a file that has changed" "$program" sweep work.yaml --folder work --set record.fields_every=1
  said "is at work on the sweep as it was before; stop it or wait for its end, or choose another --folder"
  expect 2 "all anew" "$program" sweep work.yaml --folder work --overwrite --quiet
  said "is at work"
  cp slow.yaml work.yaml
  expect 2 "a case that is being run" "$program" sweep work.yaml --folder work --case 1 --set record.fields_every=1
  said "is running this case"
  until
    keeper=$(keepers $sweep)
    expect 0 "how it stands, by its file" "$program" sweep work.yaml --status --folder work
    [ "$keeper" == "$(keepers $sweep)" ]  # else a case has ended in between, and the next one begun
  do :; done
  said "work: 4 cases: "
  said "1 running"
  said "process ${keeper// /} of $(hostname), since "
  kill -KILL $sweep
  wait $sweep 2>/dev/null
  wait_for is_left work
  expect 2 "no sweep" "$program" sweep --status .
  said "holds no sweep"
  expect 2 "no folder" "$program" sweep --status nowhere.yaml
  said "nowhere.yaml: there is no such file or folder"
}

# Cases that are run one by one, as in a batch queue, leave no sweep.json.
one_by_one() {
  expect 0 "one case of many" "$program" sweep bars.yaml --folder single --quiet --case 2
  is_absent single/sweep.json
  expect 0 "how it stands" "$program" sweep --status single
  said "single: 11 cases: 1 done, 10 waiting"
  rm -r single/claims
  expect 0 "how runs without claims stand" "$program" sweep --status single
  said "single: 1 case: 1 done"
}

is_left() { "$program" sweep --status "$1" | grep -q 'which is dead'; }

# disk SIZE: a small disk under `disk`; false where that takes rights that are not there.
disk() { mkdir -p disk && mount -t tmpfs -o "size=$1" tmpfs disk 2>/dev/null; }

full_disk() {
  if ! disk 400k; then
    echo "SKIPPED: full_disk, which needs the right to mount a small disk"
    return
  fi
  local first second
  "$program" sweep bars.yaml --folder disk/bars --quiet --jobs 1 >first.log 2>&1 &
  first=$!
  "$program" sweep bars.yaml --folder disk/bars --quiet --jobs 1 >second.log 2>&1 &
  second=$!
  wait $first
  [ $? -eq 4 ] || complain "a full disk: exit code not 4: $(cat first.log)"
  wait $second
  [ $? -eq 4 ] || complain "a full disk: exit code of the second one not 4: $(cat second.log)"
  cat first.log second.log >said.log
  said "No space left on device"
  local before
  before=$(cat disk/bars/cases/*/summary.json 2>/dev/null | grep -c '"status": "goal_reached"')
  mount -o remount,size=64m disk
  expect 0 "room again" "$program" sweep bars.yaml --folder disk/bars --jobs 1
  [ "$before" -eq 0 ] || said "those with a result stay"
  the_same_table bars_alone disk/bars
  umount disk
}

# As above, where a file may not become long.
short_files() {
  (ulimit -f 8; slow short --jobs 2 >said.log 2>&1)
  [ $? -eq 4 ] || complain "short files: the exit code is not 4: $(cat said.log)"
  "$program" sweep --status short >>said.log 2>&1
  said "File too large"
  (slow short) >said.log 2>&1 || complain "long files again: exit code $?: $(cat said.log)"
  the_same_table_of_results alone short
}

launchers() {
  expect 2 "a misspelt launcher" "$program" sweep bars.yaml --launcher slrm
  said "did you mean 'slurm'?"
  expect 2 "nothing to submit to" "$program" sweep bars.yaml --launcher mpirun --submit
  said "--submit: goes with --launcher slurm alone"
  expect 2 "hosts of Slurm" "$program" sweep bars.yaml --launcher slurm --hosts a,b
  expect 0 "a script" "$program" sweep bars.yaml --launcher slurm --folder "by slurm"
  said "#SBATCH --array=1-11"
  said "by \`dda check\`, the most of 8 that were meshed"
  grep -qE '^#SBATCH --mem=[1-9][0-9]*M$' said.log || complain "no memory is asked for: $(cat said.log)"
  said "# time: unknown, no case has finished"
  grep -q -- '--time' said.log && complain "a time that nobody knows"
  is_absent "by slurm"
  bash -n said.log || complain "the script is no script"
  mkdir -p bin && printf '#!/bin/bash\ncat >submitted.sh\necho "Submitted batch job 7"\n' >bin/sbatch && chmod +x bin/sbatch
  PATH=$PWD/bin:$PATH expect 0 "submitted" "$program" sweep bars.yaml --launcher slurm --folder "by slurm" --submit
  said "Submitted batch job 7"
  SLURM_ARRAY_JOB_ID=7 bash submitted.sh >said.log 2>&1 || complain "a task of the array failed: $(cat said.log)"
  the_same_table bars_alone "by slurm"
  PATH=/usr/bin expect 0 "what is left" "$program" sweep bars.yaml --launcher slurm --folder "by slurm" --submit
  said "no case is left to be run"
  rm -r "by slurm/cases/002"
  expect 0 "what is left" "$program" sweep bars.yaml --launcher slurm --folder "by slurm"
  said "1 of 11 cases"
  said "the longest of 10 finished cases took"
  said "#SBATCH --time=5"
  PATH=$PWD/none expect 4 "no sbatch" "$program" sweep bars.yaml --launcher slurm --folder "by slurm" --submit
  said "cannot start sbatch: No such file or directory; without --submit the script is printed"
  expect 0 "hosts" "$program" sweep bars.yaml --launcher parallel --hosts one,two --jobs 4
  said "head -n 4 | parallel --jobs 2 --sshlogin one,two --workdir $PWD"
}

# started_by NAME: the line of a launcher does the whole sweep, whatever stands in names.
started_by() {
  if ! command -v "$1" >/dev/null; then
    echo "SKIPPED: by_$1, which is not installed"
    return
  fi
  mkdir -p "it's {}" && cp bars.yaml "it's {}/bars {1}.yaml"
  "$program" sweep "it's {}/bars {1}.yaml" --launcher "$1" --folder "by $1" --jobs 3 >line.sh
  bash line.sh >said.log 2>&1 || complain "$1: exit code $?: $(cat line.sh said.log)"
  the_same_table bars_alone "by $1"
  claimed "by $1" 1 "$all_bars"
  claimed "by $1" 2 ""
}

# A process of mpirun is killed, and the others go on.
killed_by_mpirun() {
  local all keeper
  command -v mpirun >/dev/null || return
  "$program" sweep slow.yaml --launcher mpirun --folder ranks --jobs 2 --set record.fields_every=1 \
    --set scene.subdivision.blocks=600 >line.sh
  bash line.sh >said.log 2>&1 &
  all=$!
  wait_for has_rows ranks/cases/001 2
  wait_for has_rows ranks/cases/002 2
  keeper=$("$program" sweep --status ranks | sed -n 's/.*process \([0-9]*\) of .*/\1/p' | head -n 1)
  kill -KILL "$(awk '/^PPid:/ { print $2 }' "/proc/$keeper/status")"
  wait $all
  "$program" sweep --status ranks >said.log
  said "ranks: 4 cases: 4 done"
  the_same_table_of_results alone ranks
}

by_parallel() { started_by parallel; }
by_mpirun() { started_by mpirun; }

for part in ${PARTS:-alone together killed another_machine changed_beside_the_dead lost stopped_and_interrupted terminated failures at_work one_by_one full_disk \
  short_files launchers by_parallel by_mpirun killed_by_mpirun}
do $part; done
exit $failed
