#!/bin/bash
# The memory that `check` predicts is that of the run, within a fifth.
#   run_memory_tests.sh PROGRAM STUDIES_FOLDER
set -u
program=$(realpath "$1")
studies=$(realpath "$2")
source "$(dirname "${BASH_SOURCE[0]}")/scratch.sh"
open_scratch

# predicted DECK [--set ...]
predicted() {
  local deck=$studies/$1
  shift
  "$program" check "$deck" "$@" >check.log 2>&1 || complain "check of $deck: $(tail -n 3 check.log)"
  "$program" run "$deck" "$@" --folder run --overwrite --quiet >run.log 2>&1
  local about used
  about=$(sed -n 's/.*about \([0-9]*\) MiB.*/\1/p' check.log)
  used=$(sed -n 's/.*"peak_memory_mib": \([0-9.]*\).*/\1/p' run/summary.json)
  awk -v p="$about" -v u="$used" 'BEGIN { exit !(p > 0 && u > 0 && p >= 0.8 * u && p <= 1.2 * u) }' ||
    complain "$deck $*: $about MiB predicted, $used used"
}

# Cracks stay updates of one factorisation.
predicted notched-beam/deck.yaml
predicted notched-beam/deck.yaml --set path.linear=mumps
predicted notched-beam/deck.yaml --set interfaces.ligament.treatment=lagrange
predicted notched-beam/deck.yaml --set interfaces.ligament.treatment=augmented_lagrangian
predicted notched-beam/deck.yaml --set 'record.eigenvalues={count: 4, every: 10}'
predicted notched-beam/deck.yaml --set record.condition=true
predicted notched-beam/deck.yaml --set path.control=arc_length
predicted kitoh-beam/release.yaml
predicted cantilever-stages/deck.yaml
predicted two-cracks/beam.yaml
# So much cracks that the tangent is factorised anew.
predicted kitoh-beam/coarse.yaml
predicted voronoi-beam/deck.yaml
predicted voronoi-beam/deck.yaml --set path.linear=mumps
predicted voronoi-beam/deck.yaml --set path.update=refactorise
predicted reinforced-beam/deck.yaml

exit $failed
