#!/bin/bash
# What a user does to a run: start it, interrupt it, kill it, resume it, give it no place to write.
#   run_program_tests.sh PROGRAM BAR_DECK BEAM_DECK
set -u
program=$(realpath "$1")
bar=$(realpath "$2")
beam=$(realpath "$3")
source "$(dirname "${BASH_SOURCE[0]}")/scratch.sh"
open_scratch

status_is() { grep -q "\"status\": \"$2\"" "$1/summary.json" || complain "$1 is not $2"; }

whole_run() {
  expect 0 "run" "$program" run "$bar" --folder whole --quiet
  for file in deck.yaml effective_deck.yaml model.svg log.jsonl curve.csv curve.svg deformed.svg summary.json fields/mesh.h5 run.xdmf restart.h5
  do exists whole/$file; done
  same whole/deck.yaml "$bar"
  head -n 1 whole/curve.csv |
    grep -q '^step,load_factor,control,newton_iterations,dissipated_energy,stored_energy,external_work,load,elongation,' ||
    complain "the columns of curve.csv are others"
  status_is whole goal_reached
  expect 0 "run of the effective deck" "$program" run whole/effective_deck.yaml --folder again --quiet
  same whole/curve.csv again/curve.csv
}

pictures_of_models() {
  expect 0 "check with a picture" "$program" check "$beam" --draw model.svg
  for text in left right concrete '× load factor' 'stroke="#000000"'
  do grep -qF -e "$text" model.svg || complain "no '$text' in model.svg"; done
  expect 0 "run beside it" "$program" run "$beam" --folder drawn --quiet
  same model.svg drawn/model.svg
  for kind in png pdf
  do
    expect 0 "as $kind" "$program" check "$beam" --draw model.$kind
    is_absent model.$kind.svg
  done
  head -c 8 model.png | grep -qa PNG || complain "model.png is no image"
  head -c 8 model.pdf | grep -qa PDF || complain "model.pdf is no document"
  expect 2 "another kind of picture" "$program" check "$beam" --draw model.gif
  said ".svg, .png or .pdf"
  PATH=/nowhere expect 4 "without librsvg" "$program" check "$beam" --draw model.png
  said "librsvg2-bin"
  expect 4 "a picture without a place" "$program" check "$beam" --draw /proc/model.svg
}

goals_far_before_anything_cracks() {
  expect 0 "a goal far before anything cracks" "$program" run "$bar" --folder far --quiet --overwrite \
    --set 'stages=[{loads: [{type: edge_traction, boundary: right, traction: [1e-9, 0]}]}]' --set path.stop.load_factor_above=1
  grep -q '"reason": "load_factor reached 1"' far/summary.json || complain "the goal was passed: $(grep reason far/summary.json)"
}

condition() {
  grep -q '"stiffness"' whole/summary.json && complain "a condition that nobody asked for"
  expect 0 "run with condition" "$program" run "$bar" --folder assessed --quiet --set record.condition=true
  same whole/curve.csv assessed/curve.csv
  for key in stiffness start end
  do grep -q "\"$key\": {" assessed/summary.json || complain "no '$key' in assessed/summary.json"; done
  for key in condition smallest_pivot largest_pivot negative_pivots null_pivots
  do [ "$(grep -c "\"$key\": " assessed/summary.json)" -eq 2 ] || complain "not two '$key' in assessed/summary.json"; done
}

folders() {
  cp whole/curve.csv before.csv
  expect 2 "a folder that is taken" "$program" run "$bar" --folder whole --quiet
  same whole/curve.csv before.csv
  expect 0 "overwriting" "$program" run "$bar" --folder whole --quiet --overwrite
  expect 0 "default folder" "$program" run "$bar" --quiet
  expect 0 "default folder again" "$program" run "$bar" --quiet
  exists runs/softening-bar/summary.json
  exists runs/softening-bar-2/summary.json
}

same_events() {
  /usr/bin/python3 - "$1" "$2" <<'PYTHON' || complain "$1 and $2 have other events"
import json, sys
one, other = (json.load(open(f"{folder}/summary.json")) for folder in sys.argv[1:])
for key in ("events", "small_extrema", "peak"):
    assert one.get(key) == other.get(key), [key, one.get(key), other.get(key)]
PYTHON
}

resume_after_steps() {
  expect 0 "whole beam" "$program" run "$beam" --folder beam --quiet
  for steps in 3 17 31; do
    expect 0 "first part" "$program" run "$beam" --folder part$steps --quiet --set path.stop.after_steps=$steps
    expect 0 "second part" "$program" resume part$steps --quiet --set path.stop.after_steps=0
    same beam/curve.csv part$steps/curve.csv
    same_events beam part$steps
  done
  expect 0 "resume of a finished run" "$program" resume beam --quiet
  said "goal_reached"
}

# Of a path that falls from its peak by a release the row before is the largest limit point, wherever it was resumed.
peak_before_release() {
  local law='interfaces.any.law={type: mohr_coulomb, tensile_strength: 3, cohesion: 3, friction_angle: 0}'
  expect 0 "whole release" "$program" run "$beam" --folder released --quiet --set "$law" --set path.stop.after_steps=24
  for steps in 1 2 3 12; do
    expect 0 "first part" "$program" run "$beam" --folder released$steps --quiet --set "$law" --set path.stop.after_steps=$steps
    expect 0 "second part" "$program" resume released$steps --quiet --set path.stop.after_steps=24
    same_events released released$steps
  done
  /usr/bin/python3 - <<'PYTHON' || complain "the peak before a release is not the largest limit point"
import csv, json
whole = json.load(open("released/summary.json"))
rows = list(csv.DictReader(open("released/curve.csv")))
limits = [event for event in whole["events"] if event["kind"] == "limit_point"]
top = max(limits, key=lambda event: event["load"])
assert top["load"] == whole["peak"]["load"] == max(float(row["load"]) for row in rows), (top, whole["peak"])
assert rows[top["step"] + 1]["control"] == "release", rows[top["step"] + 1]
assert [event["extremum"] for event in limits].count("maximum") == 1, limits
PYTHON
}

# Killed between the last restart file and summary.json: the goal must be seen before a step is taken.
resume_without_summary() {
  for goal in path.stop.load_below=0.1 path.stop.load_below=0.9 path.stop.load_below=0 path.stop.gauges.elongation=0.05; do
    expect 0 "to $goal" "$program" run "$bar" --folder ended --overwrite --quiet --set "$goal"
    local reason
    reason=$(grep '"reason"' ended/summary.json)
    cp ended/curve.csv ended.csv
    rm ended/summary.json
    expect 0 "resume at $goal" "$program" resume ended --quiet
    same ended.csv ended/curve.csv
    [ "$(grep '"reason"' ended/summary.json)" = "$reason" ] || complain "another reason: $(grep '"reason"' ended/summary.json)"
  done
}

limits() {
  expect 3 "limit of steps" "$program" run "$bar" --folder limited --quiet --set path.stop.steps=4
  status_is limited stopped_early
  said "path.stop.steps"
  said "what now: \`dda explain limit-of-steps\`"
  grep -q '"stop": "limit-of-steps"' limited/summary.json || complain "no name of the stop"
  expect 0 "what now" "$program" explain limit-of-steps
  said "The run was on its way"
  expect 0 "steps as a goal" "$program" run "$bar" --folder counted --quiet --set path.stop.after_steps=4
  status_is counted goal_reached
}

resume_under_another_control() {
  expect 0 "first part" "$program" run "$bar" --folder half --quiet --set path.stop.load_below=0.5
  expect 0 "other control" "$program" resume half --folder other --quiet --set path.control=arc_length \
    --set path.stop.load_below=0.3
  grep -q ',arc_length,' other/curve.csv || complain "no arc-length step was taken"
  same half/model.svg other/model.svg
  rm half/model.svg  # as of a structure that is too large to be drawn
  expect 0 "without a picture of the model" "$program" resume half --folder undrawn --quiet --set path.stop.load_below=0.4
  expect 2 "another structure" "$program" resume half --quiet --set 'scene.subdivision={type: grid, size: 100}'
  expect 3 "stopped early" "$program" run "$bar" --folder early --quiet --set path.control=opening
  status_is early stopped_early
  said "snaps back"
}

# The bar, once cracked: S = 1/(1 - E w_c/(ft L)) = 3, and one negative eigenvalue.
eigenvalues() {
  expect 0 "run with eigenvalues" "$program" run "$bar" --folder watched --quiet --profile --set record.eigenvalues.count=2
  said "eigenvalues"
  said "reduced iterations"
  awk -F, '
    NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next }
    { s = $at["current_stiffness"]; n = $at["negative_eigenvalues"]; mu = $at["mu_1"]; more = $at["mu_2"] }
    NR == 2 && (s != 1 || n != 0 || mu <= 0) { exit 1 }
    NR > 2 && ((s - 3)^2 > 1e-10 || n != 1 || mu >= 0 || more <= 0) { exit 1 }
    END { if (NR < 5) exit 1 }' watched/curve.csv || complain "wrong eigenvalues or current stiffness"
  expect 2 "branches with unknown multipliers" "$program" run "$bar" --folder tied --quiet --set path.branch=switch \
    --set interfaces.crack.treatment=lagrange
  said "use another treatment"
  is_absent tied
  expect 2 "an event that there is not" "$program" run "$bar" --folder tied --quiet \
    --set 'record.eigenvalues.at=[limit_pont]'
  said "did you mean 'limit_point'"
  expect 0 "eigenvalues at events" "$program" run "$bar" --folder seldom --quiet --set record.eigenvalues.count=1 \
    --set record.eigenvalues.every=0 --set 'record.eigenvalues.at=[limit_point, end]'
  [ "$(grep -c ',nan,nan,nan$' seldom/curve.csv)" -eq $(($(wc -l < seldom/curve.csv) - 4)) ] ||
    complain "eigenvalues at steps that were not asked for"
  for file in eigenvalues.svg modes.svg; do [ -s seldom/$file ] || complain "no $file"; done
  # By contribution, at the end with a released joint: the eigenvalues are those of the sum.
  expect 0 "stiffness by contribution" "$program" run "$bar" --folder parts --quiet --set record.stiffness=true \
    --set record.eigenvalues.count=4 --set record.eigenvalues.mass=none --set path.stop.load_below=0
  /usr/bin/python3 - <<'PYTHON' || complain "the contributions do not add up to the eigenvalues"
import csv, json
import numpy
end = json.load(open("parts/stiffness.json"))["end"]["physical"]
values = numpy.linalg.eigvalsh(sum(numpy.array(part) for part in end.values()))
row = list(csv.DictReader(open("parts/curve.csv")))[-1]
assert row["rigid_modes"] == "1", row["rigid_modes"]
for i in (2, 3, 4):
    assert abs(float(row[f"mu_{i}"]) / values[i - 1] - 1) < 1e-6, (i, row[f"mu_{i}"], values[i - 1])
PYTHON
  grep -q '"kind": "limit_point"' seldom/summary.json || complain "the limit point is not among the events"
}

# The run is stopped by the signal as soon as its curve has some rows, then resumed to the same path.
stop_and_resume() {
  local signal=$1 folder=$2
  "$program" run "$beam" --folder "$folder" --quiet --set record.fields_every=1 >said.log 2>&1 &
  local pid=$!
  for _ in $(seq 500); do
    [ -e "$folder/curve.csv" ] && [ "$(wc -l <"$folder/curve.csv")" -ge 8 ] && break
    sleep 0.01
  done
  kill -"$signal" $pid
  wait $pid
  code=$?
  "$program" resume "$folder" --quiet >said.log 2>&1 || complain "resume after $signal: $(tail -n 1 said.log)"
  same beam/curve.csv "$folder/curve.csv"
}

interrupted() {
  stop_and_resume INT ctrl_c
  [ $code -eq 130 ] || complain "Ctrl-C: exit code $code instead of 130"
  stop_and_resume KILL killed
  [ $code -eq 137 ] || complain "the run ended before it was killed"
}

no_place_to_write() {
  echo >file
  expect 4 "a folder below a file" "$program" run "$bar" --folder file/run --quiet
  said "file/run"
  (ulimit -f 16 && exec "$program" run "$beam" --folder full --quiet) >said.log 2>&1
  [ $? -eq 4 ] || complain "full disk: exit code is not 4: $(tail -n 1 said.log)"
  said "full/"
  is_absent full/summary.json
}

command_line() {
  expect 2 "unknown command" "$program" rnu "$bar"
  said "did you mean 'run'?"
  expect 2 "unknown option" "$program" run "$bar" --folde x
  said "did you mean '--folder'?"
  expect 2 "no deck" "$program" run
  expect 2 "several ranks" env OMPI_COMM_WORLD_SIZE=2 OMPI_COMM_WORLD_RANK=0 "$program" check "$bar"
  said "is for one"
  expect 0 "version" "$program" --version
  expect 0 "help" "$program" --help
  expect 0 "explain" "$program" explain law/linear_softening
  said "tensile_strength"
  expect 0 "schema" "$program" explain --json
  expect 2 "unknown family" "$program" explain law/linear_softenin
  expect 0 "check" "$program" check "$bar"
  said "unknowns          12"
  expect 2 "unknown key by --set" "$program" check "$bar" --set path.stop.step=3
  said "did you mean 'steps'?"
}

comparing() {
  expect 3 "compare" "$program" compare "$bar" --controls dissipation,opening --folder compared --quiet
  expect 0 "compare, one expected to stop" "$program" compare "$bar" --controls dissipation,arc_length,opening \
    --folder expected --quiet --set 'path.expected_to_stop=[opening]' --out compared.svg
  exists compared.svg
  exists expected/compare.csv
  exists expected/compare.md
  exists expected/compare.svg
  status_is expected/arc_length goal_reached
  expect 2 "a figure of no kind" "$program" compare "$bar" --controls dissipation --folder nothing --out compared.txt
  expect 2 "an unknown control" "$program" compare "$bar" --controls dissipation,arclength --folder nothing
  is_absent nothing
  expect 0 "plot" "$program" plot expected/dissipation expected/arc_length --out overlay.svg
  exists overlay.svg
}

for part in ${PARTS:-whole_run pictures_of_models goals_far_before_anything_cracks condition eigenvalues folders resume_after_steps peak_before_release resume_without_summary limits resume_under_another_control interrupted no_place_to_write command_line comparing}
do $part; done
exit $failed
