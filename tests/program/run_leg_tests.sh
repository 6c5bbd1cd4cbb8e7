#!/bin/bash
# A path of several legs, interrupted anywhere and resumed, is the path of one run.
#   run_leg_tests.sh PROGRAM DECK_OF_LEGS
set -u
program=$(realpath "$1")
deck=$(realpath "$2")
source "$(dirname "${BASH_SOURCE[0]}")/scratch.sh"
open_scratch

# follow NAME COMMAND...: the command must end well.
follow() {
  local what=$1
  shift
  "$@" >said.log 2>&1 || complain "$what: exit code $?; it said: $(tail -n 3 said.log)"
}

# Number of accepted steps after which the column `control` (the third) first changes to or from unloading.
turns() { awk -F, 'NR > 2 && ($3 == "unloading") != last { print $1 - 1 } NR > 1 { last = ($3 == "unloading") }' "$1"; }

# Steps in the middle of each leg, on the last of a leg, and on the first of the next one.
places() {
  for turn in $(turns whole/curve.csv); do echo $((turn - 3)) "$turn" $((turn + 1)) $((turn + 4)); done
}

whole_run() {
  follow "run" "$program" run "$deck" --folder whole --quiet
  [ "$(turns whole/curve.csv | wc -l)" -eq 3 ] || complain "loading, unloading, reloading and unloading make three turns"
  for leg in unloading reloading "unloading again"
  do grep -q "\"event\":\"leg\".*\"$leg\"" whole/log.jsonl || complain "the log does not name leg '$leg'"; done
}

resume_anywhere() {
  for steps in $(places); do
    follow "part of $steps steps" "$program" run "$deck" --folder "part$steps" --quiet --set "path.stop.after_steps=$steps"
    follow "rest after $steps steps" "$program" resume "part$steps" --quiet --set path.stop.after_steps=0
    same whole/curve.csv "part$steps/curve.csv"
  done
}

# Stopped and resumed after every few steps, so that each leg is entered by another process.
resume_often() {
  local last
  last=$(tail -n 1 whole/curve.csv | cut -d, -f1)
  follow "first part" "$program" run "$deck" --folder often --quiet --set path.stop.after_steps=5
  for steps in $(seq 10 5 $((last + 5))); do
    follow "up to $steps steps" "$program" resume often --quiet --set "path.stop.after_steps=$steps"
  done
  same whole/curve.csv often/curve.csv
}

# The signal finds the run in one leg or another; the curve is the same.
interrupted() {
  for rows in 6 24 34; do
    "$program" run "$deck" --folder "stopped$rows" --quiet --set record.fields_every=1 >said.log 2>&1 &
    local pid=$!
    for _ in $(seq 500); do
      [ -e "stopped$rows/curve.csv" ] && [ "$(wc -l <"stopped$rows/curve.csv")" -ge "$rows" ] && break
      sleep 0.005
    done
    kill -INT $pid
    wait $pid
    local code=$?
    [ $code -eq 130 ] || complain "Ctrl-C after $rows rows: exit code $code instead of 130"
    follow "resume after $rows rows" "$program" resume "stopped$rows" --quiet
    same whole/curve.csv "stopped$rows/curve.csv"
  done
}

for part in ${PARTS:-whole_run resume_anywhere resume_often interrupted}
do $part; done
exit $failed
