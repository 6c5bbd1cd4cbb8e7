#!/bin/bash
# A block torn out under a point load: what `check` says before, and what the run, its figure and its report say after.
#   run_notice_tests.sh PROGRAM DECK
set -u
program=$(realpath "$1")
deck=$(realpath "$2")
source "$(dirname "${BASH_SOURCE[0]}")/scratch.sh"
open_scratch

expect 0 "check" "$program" check "$deck"
said "point_load at (0, 160) acts on one block"
said "\`over: [[0, "
expect 0 "run" "$program" run "$deck" --folder torn --quiet
said "; 1 notice: see summary.json"
expect 0 "the notice" grep -qF "point_load at (0, 160) has been torn out" torn/summary.json
expect 0 "the blocks" grep -qF '"torn_out"' torn/summary.json
expect 0 "the log" grep -qF "has been torn out" torn/log.jsonl
expect 0 "the mark" grep -qF '#e00000' torn/deformed.svg
expect 0 "the report" "$program" report torn
expect 0 "its notice" grep -qF "has been torn out" torn/report.html
exit $failed
