#!/bin/bash
# What a run tells about its interfaces: energies, first cracks, random fields, a reference peak.
#   run_interface_tests.sh PROGRAM BEAM_DECK
set -u
program=$(realpath "$1")
beam=$(realpath "$2")
source "$(dirname "${BASH_SOURCE[0]}")/scratch.sh"
open_scratch

run() {
  local folder=$1
  shift
  "$program" run "$beam" --folder "$folder" --quiet "$@" >"$folder.log" 2>&1 || complain "$folder: $(tail -n 3 "$folder.log")"
}
field='interfaces.any.field={coefficient_of_variation: 0.2, correlation_length: 20, seed: 3}'
# An expression over `s`, summary.json, and `rows`, the table's; `a` and `b` are those of two folders.
holds() {
  local what=$1 expression=$2
  shift 2
  python3 - "$expression" "$@" <<'PYTHON' || complain "$what: $expression"
import csv, json, sys
def load(folder):
    with open(folder + "/curve.csv", newline="") as stream:
        return json.load(open(folder + "/summary.json")), list(csv.DictReader(stream))
loaded = [load(folder) for folder in sys.argv[2:]]
s, rows = loaded[0]
a, b = loaded[0][0], loaded[-1][0]
sys.exit(not eval(sys.argv[1]))
PYTHON
}

energies() {
  run plain
  holds "one interface spends all" \
    'all(abs(float(r["dissipated_energy_any"]) - float(r["dissipated_energy"])) <= 1e-9 * (1e-3 + float(r["dissipated_energy"])) for r in rows)' plain
  holds "the summary has the last row's energy" \
    'abs(s["interfaces"]["any"]["dissipated_energy"] - float(rows[-1]["dissipated_energy"])) < 1e-9 * float(rows[-1]["dissipated_energy"])' plain
  holds "the crack starts at the notch" \
    'abs(s["interfaces"]["any"]["first_crack"]["at"][0] - 150) < 12 and abs(s["interfaces"]["any"]["first_crack"]["at"][1] - 30) < 12' plain
  holds "and is widest there" 's["interfaces"]["any"]["widest"]["at"][1] < 60 and s["interfaces"]["any"]["widest"]["opening"] > 0.03' plain
  run first --set path.stop.after_steps=9
  "$program" resume first --quiet --set path.stop.after_steps=0 >said.log 2>&1 || complain "resume: $(tail -n 3 said.log)"
  holds "a resumed run remembers its first crack" 'a["interfaces"] == b["interfaces"]' plain first
}

random_fields() {
  run uniform --set 'interfaces.any.field={coefficient_of_variation: 0, correlation_length: 20}'
  same plain/curve.csv uniform/curve.csv
  run varied --set "$field"
  run again --set "$field"
  same varied/curve.csv again/curve.csv
  cmp -s plain/curve.csv varied/curve.csv && complain "the field changes nothing"
  run other --set "${field/seed: 3/seed: 4}"
  cmp -s varied/curve.csv other/curve.csv && complain "the seed changes nothing"
  grep -q strength_factor varied/run.xdmf || complain "run.xdmf has no strength_factor"
  grep -q strength_factor plain/run.xdmf && complain "a strength_factor where nothing varies"
  holds "energy balance" 's["status"] == "goal_reached" and s["energy_balance_error"] < 1e-3' varied
  "$program" check "$beam" --set 'interfaces.any.field={coefficient_of_variation: 0.2}' >said.log 2>&1
  [ $? -eq 2 ] && grep -q correlation_length said.log || complain "a field without its length: $(tail -n 2 said.log)"
}

reference_peak() {
  holds "no reference, no bias" '"mesh_bias" not in s' plain
  run biased --set 'record.reference_peak={load: 1000, text: straight crack}'
  same plain/curve.csv biased/curve.csv
  holds "peak against reference" 'abs(s["mesh_bias"] - (s["peak"]["load"] / 1000 - 1)) < 1e-12 and s["reference_peak"]["text"] == "straight crack"' biased
  run marked --set 'record.reference_peak={load: 9000, text: measured peak, at: {cmod: 0.03}}'
  [ "$(grep -c 'measured peak' marked/curve.svg)" -eq 1 ] || complain "curve.svg marks no measured peak"
  "$program" plot plain marked biased --out overlay.svg >said.log 2>&1 || complain "plot: $(tail -n 1 said.log)"
  [ "$(grep -c 'measured peak' overlay.svg)" -eq 1 ] || complain "the overlay marks no measured peak"
  "$program" check "$beam" --set 'record.reference_peak={load: 9000, at: {cmdo: 1}}' >said.log 2>&1
  [ $? -eq 2 ] && grep -q "did you mean 'cmod'" said.log || complain "an unknown gauge: $(tail -n 2 said.log)"
  grep -q '% of the reference' biased.log || complain "the last line says nothing of the reference: $(tail -n 1 biased.log)"
}

detail() {
  [ -e plain/detail.svg ] && complain "a detail that nobody asked for"
  run close --set 'record.detail={from: [120, 0], to: [180, 60]}'
  local all shown
  all=$(grep -c '<path' plain/deformed.svg) shown=$(grep -c '<path' close/detail.svg)
  [ "$shown" -ge 8 ] && [ "$shown" -lt "$((all / 2))" ] || complain "the detail shows $shown of $all paths"
}

for part in ${PARTS:-energies random_fields reference_peak detail}
do $part; done
exit $failed
