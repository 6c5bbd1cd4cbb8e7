#!/bin/bash
# What `dda report` writes, where, and what it says to a folder that is none.
#   run_report_tests.sh PROGRAM DECK
set -u
program=$(realpath "$1")
deck=$(realpath "$2")
source "$(dirname "${BASH_SOURCE[0]}")/scratch.sh"
open_scratch


pages() {
  expect 0 "run" "$program" run "$deck" --folder whole --quiet
  expect 0 "report" "$program" report whole
  said "whole/report.html"
  exists whole/report.html
  expect 0 "report elsewhere" "$program" report whole/ --out page.html
  exists page.html
  grep -q '<!DOCTYPE html>' page.html || complain "page.html is no HTML"
  expect 0 "overwriting" "$program" run "$deck" --folder whole --quiet --overwrite
  is_absent whole/report.html
}

unfinished() {
  mkdir cut
  head -n 4 whole/curve.csv >cut/curve.csv
  expect 0 "report of what a killed run left" "$program" report cut
  exists cut/report.html
  mkdir begun
  cp whole/log.jsonl begun
  expect 0 "report of a run without a step" "$program" report begun
  exists begun/report.html
}

refusals() {
  mkdir -p empty runs
  expect 2 "an empty folder" "$program" report empty
  said "is no run folder and no sweep"
  is_absent empty/report.html
  cp -r whole runs/whole
  expect 2 "the folder above" "$program" report runs
  said "did you mean 'runs/whole'?"
  expect 2 "no folder" "$program" report nowhere
  expect 2 "a file" "$program" report whole/curve.csv
  expect 2 "nothing" "$program" report
  expect 4 "no place to write" "$program" report whole --out nowhere/page.html
  said "nowhere/page.html"
}

for part in ${PARTS:-pages unfinished refusals}
do $part; done
exit $failed
