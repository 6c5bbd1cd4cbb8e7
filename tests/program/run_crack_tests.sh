#!/bin/bash
# A path along which a crack runs through blocks, interrupted anywhere and resumed, is the path of one run.
#   run_crack_tests.sh PROGRAM DECK
set -u
program=$(realpath "$1")
deck=$(realpath "$2")
source "$(dirname "${BASH_SOURCE[0]}")/scratch.sh"
open_scratch

whole_run() {
  expect 0 "run" "$program" run "$deck" --folder whole --quiet
  for what in aimed grown
  do grep -q "\"event\":\"$what\"" whole/log.jsonl || complain "no crack is $what"; done
  grep -q '"factorisations": *1[,}]' whole/summary.json || complain "cuts are not taken as a border of the stiffness"
}

# Before and after cracks grow, and where the segment ahead has been aimed anew.
resume_anywhere() {
  local last
  last=$(tail -n 1 whole/curve.csv | cut -d, -f1)
  for steps in $(seq 1 4 $((last - 1))); do
    expect 0 "part of $steps steps" "$program" run "$deck" --folder "part$steps" --quiet --set "path.stop.after_steps=$steps"
    expect 0 "rest after $steps steps" "$program" resume "part$steps" --quiet --set path.stop.after_steps=0
    same whole/curve.csv "part$steps/curve.csv"
  done
}

# Stopped and resumed after every few steps.
resume_often() {
  local last
  last=$(tail -n 1 whole/curve.csv | cut -d, -f1)
  expect 0 "first part" "$program" run "$deck" --folder often --quiet --set path.stop.after_steps=5
  for steps in $(seq 10 5 $((last + 5))); do
    expect 0 "up to $steps steps" "$program" resume often --quiet --set "path.stop.after_steps=$steps"
  done
  same whole/curve.csv often/curve.csv
}

with_more_threads() {
  expect 0 "three threads" "$program" run "$deck" --folder threads --quiet --threads 3
  same whole/curve.csv threads/curve.csv
}

for part in ${PARTS:-whole_run resume_anywhere resume_often with_more_threads}
do $part; done
exit $failed
