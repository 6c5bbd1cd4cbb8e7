#!/bin/bash
# What `check` says that a run takes at least is less than what it takes, and a good part of it; a run for which there
# is too little memory is refused before anything is factorised.
#   run_memory_tests.sh PROGRAM STUDIES_FOLDER
set -u
program=$(realpath "$1")
studies=$(realpath "$2")
source "$(dirname "${BASH_SOURCE[0]}")/scratch.sh"
open_scratch

# bounded DECK [--set ...]
bounded() {
  local deck=$studies/$1
  shift
  "$program" check "$deck" "$@" >check.log 2>&1 || complain "check of $deck: $(tail -n 3 check.log)"
  "$program" run "$deck" "$@" --folder run --overwrite --quiet >run.log 2>&1
  local least used
  least=$(sed -n 's/.*at least \([0-9]*\) MiB.*/\1/p' check.log)
  used=$(sed -n 's/.*"peak_memory_mib": \([0-9.]*\).*/\1/p' run/summary.json)
  awk -v p="$least" -v u="$used" 'BEGIN { exit !(p > 0 && u > 0 && p >= 0.2 * u && p <= u) }' ||
    complain "$deck $*: at least $least MiB, $used used"
}

bounded notched-beam/deck.yaml
bounded notched-beam/deck.yaml --set path.linear=mumps
bounded notched-beam/deck.yaml --set path.linear=amesos2
bounded notched-beam/deck.yaml --set interfaces.ligament.treatment=lagrange
bounded notched-beam/deck.yaml --set interfaces.ligament.treatment=augmented_lagrangian
bounded notched-beam/deck.yaml --set 'record.eigenvalues={count: 4, every: 10}'
bounded notched-beam/deck.yaml --set path.update=refactorise
bounded kitoh-beam/release.yaml
bounded voronoi-beam/deck.yaml

expect 2 "too little memory" "$program" run "$studies/notched-beam/deck.yaml" --folder refused --quiet --memory-limit 0.01
said "of memory for the factor and vectors"
is_absent refused
expect 0 "a limit of its own" "$program" run "$studies/notched-beam/deck.yaml" --folder allowed --quiet --memory-limit 100

exit $failed
