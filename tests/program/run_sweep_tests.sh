#!/bin/bash
# What a user does to a sweep: start it, interrupt it, kill it, change it, misspell it, do it case by case.
#   run_sweep_tests.sh PROGRAM BAR_DECK BEAM_DECK DECK_WITH_A_MESH
set -u
program=$(realpath "$1")
bar=$(realpath "$2")
beam=$(realpath "$3")
meshed=$(realpath "$4")
source "$(dirname "${BASH_SOURCE[0]}")/scratch.sh"
source "$(dirname "${BASH_SOURCE[0]}")/sweep_table.sh"
open_scratch

product_and_zip() {
  cat >bars.yaml <<EOF
title: Bars
sweep:
  deck: $bar
  interfaces.crack.law.fracture_energy: [0.1, 0.2]
  zip: {interfaces.crack.law.tensile_strength: 2..3, path.stop.load_below: [0.1, 0.5]}
  columns: {area: peak.load/tensile_strength, doubled: 2*steps, nothing: sqrt(-steps)}
EOF
  expect 0 "a sweep" "$program" sweep bars.yaml
  said "4 goal_reached"
  said "xargs -P "
  has runs/bars case "1 2 3 4"
  has runs/bars folder "cases/001 cases/002 cases/003 cases/004"
  has runs/bars interfaces.crack.law.fracture_energy "0.1 0.1 0.2 0.2"
  has runs/bars interfaces.crack.law.tensile_strength "2 3 2 3"
  has runs/bars path.stop.load_below "0.1 0.5 0.1 0.5"
  has runs/bars status "goal_reached goal_reached goal_reached goal_reached"
  has runs/bars exit_code "0 0 0 0"
  grep -qF '"interfaces.crack.law.fracture_energy": "N/mm"' runs/bars/sweep.units.json || complain "no unit of a setting"
  cells runs/bars area | awk '{ for (i = 1; i <= 4; ++i) if ($i < 9999.9 || $i > 10000.1) exit 1 }' ||
    complain "strength times area, by strength: $(cells runs/bars area)"
  [ "$(cells runs/bars doubled)" == "$(cells runs/bars steps | awk '{ print 2 * $1, 2 * $2, 2 * $3, 2 * $4 }')" ] ||
    complain "twice the steps: $(cells runs/bars doubled)"
  has runs/bars nothing "   "
  grep -qF '"peak.load": "N"' runs/bars/sweep.units.json || complain "no unit of the peak load"
  cells runs/bars peak.load | awk '{ exit !($1 / 20000 > 0.99999 && $1 / 20000 < 1.00001 && $2 / 30000 > 0.99999 && $2 / 30000 < 1.00001) }' ||
    complain "peaks are not strength times area: $(cells runs/bars peak.load)"
  same bars.yaml runs/bars/sweep.yaml
  grep -qF '"status": "goal_reached"' runs/bars/sweep.json || complain "no status in sweep.json"
  exists runs/bars/curves.svg
  expect 0 "a report of the sweep" "$program" report runs/bars
  said "4 of its cases have no report"
  expect 0 "its cases' reports" "$program" report runs/bars --cases
  said "cases/004/report.html"
  exists runs/bars/cases/001/report.html
  grep -qF './cases/001/report.html' runs/bars/report.html || complain "a row does not lead to its report"
  expect 2 "cases of a run" "$program" report runs/bars/cases/001 --cases
  said "has no cases"
  "$program" run "$bar" --folder alone --quiet --set interfaces.crack.law.tensile_strength=3 \
    --set path.stop.load_below=0.5 >/dev/null
  same alone/curve.csv runs/bars/cases/002/curve.csv
}

# No column of one's own is called like one that sweep.csv has: every name in its first line that a column may have.
own_columns_have_other_names() {
  local name
  for name in $(/usr/bin/python3 -c 'import csv, re, sys
print(*(name for name in next(csv.reader(open(sys.argv[1]))) if re.fullmatch(r"\w+", name)))' runs/bars/sweep.csv); do
    case $name in area | doubled | nothing) continue ;; esac
    printf 'sweep:\n  deck: %s\n  thickness: [1, 2]\n  columns: {%s: 2*thickness}\n' "$bar" "$name" >taken.yaml
    expect 2 "a column called $name" "$program" check taken.yaml
    said "columns.$name: sweep.csv has a column of that name"
  done
}

# The deck itself with a section `sweep`, started by `run`; its case alone; values from the command line.
run_recognises_it() {
  { cat "$beam"; printf 'sweep:\n  seed: 3..4\n'; } >beams.yaml
  expect 0 "run of a sweep" "$program" run beams.yaml --quiet --folder beams --jobs 2 --set path.stop.after_steps=6
  has beams seed "3 4"
  [ "$(cells beams work.load)" == "no such column no such column" ] || complain "a column that nobody has"
  cmp -s beams/cases/001/curve.csv beams/cases/002/curve.csv && complain "two seeds made the same mesh"
  expect 0 "its deck alone" "$program" run beams.yaml --quiet --folder one --set sweep= --set path.stop.after_steps=6 \
    --set 'scene.subdivision={type: voronoi, blocks: 120, seed: 4}'
  same one/curve.csv beams/cases/002/curve.csv
  expect 0 "a sweep of any deck" "$program" sweep "$bar" --quiet --folder wide --set 'sweep.thickness=[50, 100]'
  has wide thickness "50 100"
  expect 0 "check" "$program" check beams.yaml
  said "cases             2"
  expect 2 "compare" "$program" compare beams.yaml --controls load
  said "this is a deck of many runs"
}

several_decks() {
  mkdir decks
  cp "$bar" decks/bar.yaml
  cp "$beam" decks/beam.yaml
  printf 'sweep:\n  deck: [bar.yaml, beam.yaml]\n  path.stop.after_steps: [4]\n' >decks/sweep.yaml
  expect 0 "two decks" "$program" sweep decks/sweep.yaml --quiet
  has runs/decks deck "bar.yaml beam.yaml"
  printf 'sweep: {deck: beam.yaml, seed: [7, 8], path.stop.after_steps: [4]}\n' >decks/seeds.yaml
  expect 0 "seeds of a deck" "$program" sweep decks/seeds.yaml --quiet
  grep -q 'seed: 8' runs/seeds/cases/002/effective_deck.yaml || complain "the seed was not set"
  printf 'sweep:\n  deck: [bar.yaml]\n  seed: [7, 8]\n' >decks/none.yaml
  expect 2 "seeds of a deck without" "$program" sweep decks/none.yaml
  said "decks/none.yaml:3:3: seed: decks/bar.yaml has no key of that name"
  ln -s "$(dirname "$meshed")" decks/meshed
  printf 'sweep:\n  deck: meshed/%s\n  scene.parameters.depth: [100, 120]\n' "$(basename "$meshed")" >decks/far.yaml
  expect 0 "files beside a deck elsewhere" "$program" sweep decks/far.yaml --dry-run
}

wrong_input() {
  printf 'sweep:\n  deck: %s\n  interfaces.crack.law.fracture_enrgy: [1, 2]\n  thickness: [1, -1]\n' "$bar" >wrong.yaml
  expect 2 "a misspelt key" "$program" run wrong.yaml --folder wrong
  said "wrong.yaml:3:3: unknown parameter 'fracture_enrgy'"
  said "did you mean 'fracture_energy'?"
  said "wrong.yaml:4:18: thickness: must be above 0, got -1"
  [ "$(grep -vc '^ ' said.log)" -eq 2 ] || complain "not one line per mistake beside its excerpt: $(cat said.log)"
  printf 'sweep:\n  deck: missing.yaml\n  thickness: 5..1\n' >wrong.yaml
  expect 2 "a range that ends before it begins" "$program" sweep wrong.yaml --folder wrong
  said "wrong.yaml:3:14: range '5..1'"
  printf 'thickness: 3\nsweep:\n  deck: missing.yaml\n  thickness: [1]\n' >wrong.yaml
  expect 2 "two decks" "$program" sweep wrong.yaml --folder wrong
  said "wrong.yaml:1:1: 'thickness' belongs to a deck"
  expect 2 "no sweep" "$program" sweep "$bar" --folder wrong
  said "has no section"
  is_absent wrong
}

# 2: a support that no block holds is found when the scene is meshed; 3: a control that cannot follow.
failing_cases() {
  cat >failing.yaml <<EOF
sweep:
  deck: $bar
  zip: {supports.guide_left.at: [[25, 50], [25, 5000], [25, 50]], path.control: [staged, staged, opening]}
EOF
  expect 2 "a case that fails" "$program" sweep failing.yaml --quiet --jobs 1
  has runs/failing status "goal_reached failed stopped_early"
  has runs/failing exit_code "0 2 3"
  grep -q '"reason": "support .guide_left.' runs/failing/sweep.json || grep -q 'guide_left.*5000\|5000.*guide_left' runs/failing/sweep.json ||
    complain "the reason is not kept: $(grep reason runs/failing/sweep.json)"
  sed -i 's/5000/50/' failing.yaml
  expect 3 "repaired" "$program" sweep failing.yaml
  said "2 of its 3 cases were there before"
  has runs/failing status "goal_reached goal_reached stopped_early"
}

# One run is killed, the others end; then again.
killed_and_missing() {
  printf 'sweep: {deck: %s, seed: 1..4}\n' "$beam" >four.yaml
  expect 0 "four seeds" "$program" sweep four.yaml --quiet
  "$program" sweep four.yaml --folder four --jobs 1 --quiet --set record.fields_every=1 >said.log 2>&1 &
  local sweep=$!
  wait_for has_rows four/cases/002 6
  kill -KILL "$(cat "/proc/$sweep/task/$sweep/children")"
  wait $sweep
  [ $? -eq 4 ] || complain "a killed run: the exit code is not 4"
  has four status "goal_reached failed goal_reached goal_reached"
  has four exit_code "0 137 0 0"
  rm -r four/cases/004
  expect 0 "what is missing" "$program" sweep four.yaml --folder four --set record.fields_every=1
  has four status "goal_reached goal_reached goal_reached goal_reached"
  [ "$(grep -c ' goal_reached' said.log)" -ge 2 ] || complain "it did not say what it ran"
  for case in 001 002 003 004
  do same "runs/four/cases/$case/curve.csv" "four/cases/$case/curve.csv"; done
  expect 0 "what is kept" "$program" sweep four.yaml --folder four --dry-run --set record.fields_every=1
  [ "$(grep -c '(goal_reached before)' said.log)" -eq 4 ] || complain "a resumed case is not known again: $(cat said.log)"
  grep -q '"event":"resumed"' four/cases/002/log.jsonl || complain "the killed case was not resumed"
}

# Exit code 130, restart files, and the rest later.
interrupted() {
  [ -e runs/four ] || killed_and_missing
  for signal in INT TERM; do
    "$program" sweep four.yaml --folder "stopped_$signal" --jobs 2 --set record.fields_every=1 >said.log 2>&1 &
    local sweep=$!
    wait_for has_rows "stopped_$signal/cases/002" 6
    kill -$signal $sweep
    wait $sweep
    [ $? -eq 130 ] || complain "$signal: the exit code is not 130"
    grep -q '"status": "interrupted"' "stopped_$signal/sweep.json" || complain "$signal: no case is interrupted"
    expect 0 "resume after $signal" "$program" resume "stopped_$signal" --quiet
    for case in 001 002 003 004
    do same "runs/four/cases/$case/curve.csv" "stopped_$signal/cases/$case/curve.csv"; done
  done
}

# Cases that stay keep their results under their new numbers; none is thrown away unasked.
changed() {
  printf 'sweep: {deck: %s, thickness: [50, 100], plane: [stress]}\n' "$bar" >change.yaml
  expect 0 "before the change" "$program" sweep change.yaml --quiet
  touch runs/change/cases/001/mark50 runs/change/cases/002/mark100
  expect 0 "nothing to do" "$program" sweep change.yaml --quiet
  printf 'sweep: {deck: %s, thickness: [100, 20, 50], plane: [stress]}\n' "$bar" >change.yaml
  expect 0 "more values" "$program" sweep change.yaml
  said "change.yaml has changed since: 2 of its 3 cases were there before"
  has runs/change thickness "100 20 50"
  exists runs/change/cases/001/mark100
  exists runs/change/cases/003/mark50
  printf 'sweep: {deck: %s, thickness: [100, 20]}\n' "$bar" >change.yaml
  expect 2 "fewer values" "$program" sweep change.yaml
  said "1 of its runs is no longer in change.yaml, runs/change/cases/003 for one"
  exists runs/change/cases/003/mark50
  expect 2 "what would happen" "$program" sweep change.yaml --dry-run
  expect 0 "all anew" "$program" sweep change.yaml --quiet --overwrite
  is_absent runs/change/cases/001/mark100
  is_absent runs/change/cases/003
  mkdir taken && touch taken/file
  expect 2 "a folder of something else" "$program" sweep change.yaml --folder taken
}

# The line that --dry-run prints does what the sweep does, whatever stands in names and values.
case_by_case() {
  mkdir "it's here"
  cp "$bar" "it's here/a bar.yaml"
  cat >"it's here/odd.yaml" <<EOF
sweep:
  deck: ["a bar.yaml"]
  title: ["it's \$HOME; a \"b\"", '{1} {#} 100%']
  interfaces.crack.law: [{type: bilinear_softening, tensile_strength: 3, fracture_energy: 0.1}, {type: linear_softening, tensile_strength: 2, fracture_energy: 0.1}]
EOF
  expect 0 "a sweep of odd names" "$program" sweep "it's here/odd.yaml" --quiet --folder "one way"
  "$program" sweep "it's here/odd.yaml" --dry-run --folder "other way" --set record.fields_every=10 | tail -n 1 >line.sh
  is_absent "other way"
  bash line.sh >said.log 2>&1 || complain "the line of cases failed: $(cat said.log)"
  for case in 001 002 003 004; do
    same "one way/cases/$case/curve.csv" "other way/cases/$case/curve.csv"
    cmp -s <(grep -v '^#' "one way/cases/$case/effective_deck.yaml") \
      <(grep -v '^#' "other way/cases/$case/effective_deck.yaml") || complain "case $case alone is another deck"
  done
  expect 0 "what was done case by case counts" "$program" sweep "it's here/odd.yaml" --dry-run --folder "other way"
  [ "$(grep -c 'goal_reached before' said.log)" -eq 4 ] || complain "not kept: $(cat said.log)"
  expect 0 "a case that is done" "$program" sweep "it's here/odd.yaml" --folder "other way" --case 2 --set record.fields_every=10
  expect 2 "a case that is not there" "$program" sweep "it's here/odd.yaml" --folder "other way" --case 5
  said "the sweep has 4 cases"
  expect 2 "no number" "$program" sweep "it's here/odd.yaml" --folder "other way" --case 0
  said "--case: '0' is not a number above 0"
  expect 0 "seeds" "$program" sweep "$beam" --quiet --folder seeds --set 'sweep.seed=[5]' --set path.stop.after_steps=3
  for folder in "seeds too" "seeds {} {1}"; do
    "$program" sweep "$beam" --dry-run --folder "$folder" --set 'sweep.seed=[5]' --set path.stop.after_steps=3 | tail -n 1 >line.sh
    bash line.sh >said.log 2>&1 || complain "the line of cases failed: $(cat said.log)"
    same seeds/cases/001/curve.csv "$folder/cases/001/curve.csv"
  done
}

for part in ${PARTS:-product_and_zip own_columns_have_other_names run_recognises_it several_decks wrong_input failing_cases killed_and_missing interrupted changed case_by_case}
do $part; done
exit $failed
