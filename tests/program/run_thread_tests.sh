#!/bin/bash
# The same results, bit for bit, with any number of threads.
#   run_thread_tests.sh PROGRAM COMPARE_FIELDS DECK...
set -u
program=$(realpath "$1")
compare=$(realpath "$2")
shift 2
decks=()
for deck in "$@"; do decks+=("$(realpath "$deck")"); done
source "$(dirname "${BASH_SOURCE[0]}")/scratch.sh"
open_scratch

same_results() {
  same "$1/curve.csv" "$2/curve.csv"
  /usr/bin/python3 "$compare" "$1" "$2" >said.log 2>&1 || complain "fields differ: $(cat said.log)"
}

# has_threads RUN NUMBER: what summary.json says.
has_threads() { grep -qF "\"threads\": $2," "$1/summary.json" || complain "$1 did not run with $2 threads"; }

bit_for_bit() {
  for deck in "${decks[@]}"; do
    for threads in 1 2 3 4; do
      expect 0 "$deck with $threads threads" "$program" run "$deck" --folder "t$threads" --overwrite --quiet --threads $threads
      has_threads "t$threads" $threads
      same_results t1 "t$threads"
    done
  done
}

# Half of a run with one thread, the rest with three.
resumed_with_more() {
  expect 0 "half of a run" "$program" run "${decks[0]}" --folder half --quiet --threads 1 --set path.stop.after_steps=12
  expect 0 "the rest" "$program" resume half --quiet --threads 3 --set path.stop.after_steps=0
  expect 0 "a whole run" "$program" run "${decks[0]}" --folder whole --quiet --threads 1
  same whole/curve.csv half/curve.csv
}

chosen() {
  OMP_NUM_THREADS=3,1 expect 0 "as OMP_NUM_THREADS says" "$program" run "${decks[0]}" --folder three --quiet --set path.stop.after_steps=2
  has_threads three 3
  expect 2 "no threads" "$program" run "${decks[0]}" --folder none --threads 0
  said "--threads"
  is_absent none
}

for part in ${PARTS:-bit_for_bit resumed_with_more chosen}
do $part; done
exit $failed
