#!/bin/bash
# A gauge that turns back and forward again within what would be one step, and a wall that goes on as a mechanism.
#   run_turn_tests.sh PROGRAM DECK_OF_TURN DECK_OF_WALL
set -u
program=$(realpath "$1")
turn=$(realpath "$2")
wall=$(realpath "$3")
source "$(dirname "${BASH_SOURCE[0]}")/scratch.sh"
open_scratch

# Share of its largest value so far by which a column falls between two of its rows before it rises again to more.
turned_back() {
  awk -F, -v name="$1" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i; next }
    { x = $c; if (x > top) { if (top > 0 && (top - low) / top > depth) depth = (top - low) / top; top = low = x } if (x < low) low = x }
    END { printf "%.6f\n", depth }' "$2"
}

expect 0 "the beam" "$program" run "$turn" --folder turn --quiet
depth=$(turned_back end turn/curve.csv)
awk -v d="$depth" 'BEGIN { exit !(d > 0.004) }' || complain "the end turns back by 0.5 %, the rows show $depth"

expect 0 "the wall" "$program" run "$wall" --folder wall --quiet
said "drift reached 1"
awk -F, 'NR > 2 && $8 < 0 { exit 1 }' wall/curve.csv || complain "the load has grown the wrong way"
exit $failed
