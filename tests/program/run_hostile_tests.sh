#!/bin/bash
# Input that would harm, hang or mislead: each is refused with its place and what to do, before anything is written.
#   run_hostile_tests.sh PROGRAM BAR_DECK BEAM_DECK
set -u
program=$(realpath "$1")
bar=$(realpath "$2")
beam=$(realpath "$3")
source "$(dirname "${BASH_SOURCE[0]}")/scratch.sh"
open_scratch

# refused WHAT TEXT COMMAND...: exit code 2 within 20 s, with the text.
refused() {
  local what=$1 text=$2
  shift 2
  expect 2 "$what" timeout -s KILL 20 "$@"
  said "$text"
  [ "$(wc -c <said.log)" -lt 10000 ] || complain "$what: it said $(wc -c <said.log) bytes"
}

# plate NAME [LINES]: a deck with a plate from NAME.geo, which has the lines before its own.
plate() {
  cat >"$1.geo" <<GEO
${2:-}
DefineConstant[w = 100, h = 50];
Point(1) = {0, 0, 0, h}; Point(2) = {w, 0, 0, h}; Point(3) = {w, 100, 0, h}; Point(4) = {0, 100, 0, h};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Physical Surface("material:concrete") = {1};
Physical Curve("boundary:left") = {4};
Physical Curve("boundary:right") = {2};
GEO
  cat >"$1.yaml" <<YAML
scene: {type: ${3:-geo}, file: ${4:-$1.geo}, subdivision: ${5:-triangles}}
thickness: 100
materials: {concrete: {type: linear_elastic, young_modulus: 30000, poisson_ratio: 0.2}}
supports: {wall: {boundary: left, fix: xy}}
stages: [{loads: [{type: edge_traction, boundary: right, traction: [1, 0]}]}]
path: {control: load, stop: {steps: 1}}
YAML
}

commands_in_geometry() {
  plate sound
  expect 0 "a plate" "$program" check sound.yaml
  plate system 'SystemCall "touch harm";'
  refused "a command" "system.geo:1:1: 'SystemCall' runs a program; \`--trust-geo\`" "$program" check system.yaml
  plate written 'Printf("x") > "harm";'
  refused "a written file" "written.geo:1:1: 'Printf' writes a file" "$program" run written.yaml
  plate ended 'x = 1; Exit;'
  refused "the end" "ended.geo:1:8: 'Exit'" "$program" check ended.yaml
  plate merged 'Merge "/etc/passwd";'
  refused "a file elsewhere" "merged.geo:1:7: '/etc/passwd' lies outside" "$program" check merged.yaml
  plate disguised 'SystemCall "touch harm";' msh disguised.geo given
  refused "a geometry as a mesh" "disguised.geo:1:1: is no gmsh mesh" "$program" check disguised.yaml
  is_absent harm
  is_absent runs
  expect 0 "a trusted command" "$program" check system.yaml --trust-geo
  exists harm
  refused "a trusted end" "gmsh ended itself" "$program" check ended.yaml --trust-geo
}

broken_geometry() {
  plate sound
  plate endless 'For i In {0:1:1e-15}
  x = i;
EndFor'
  refused "a loop without end" "gmsh was stopped after 1 s with 'endless.geo'" "$program" check endless.yaml \
    --set scene.meshing_seconds=1
  local value
  refused "a plate of no width" "sound.yaml:1:8: " "$program" check sound.yaml --set scene.parameters.w=1e-9 --set "scene.subdivision={type: voronoi, size: 10}"
  for value in 0 -1e-300 1e40; do
    refused "w = $value" "s" "$program" check sound.yaml --set "scene.parameters.w=$value"
  done
  for value in '{type: triangles, size: 1e-12}' '{type: quads, size: 1e-12}' '{type: voronoi, size: 1e-12}' \
    '{type: voronoi, blocks: 10000000}'; do
    refused "$value" "--set scene.subdivision" "$program" check sound.yaml --set "scene.subdivision=$value" \
      --memory-limit 8
    said "\`--memory-limit\`"
  done
  refused "a sliver" "has no room for a cell" "$program" check "$beam" --set "scene.slits={notch: [[150, 0], [1e12, 30]]}"
  refused "a fine grid" "\`--memory-limit\`" "$program" check "$bar" --memory-limit 8 \
    --set 'scene.subdivision={type: grid, columns: 100000, rows: 100000}'
}

# One signal is enough.
interrupted_meshing() {
  plate endless 'For i In {0:1:1e-15}
  x = i;
EndFor'
  "$program" run endless.yaml --folder never >said.log 2>&1 &
  local pid=$!
  sleep 0.5
  kill -INT $pid
  timeout 5 tail --pid=$pid -f /dev/null || kill -KILL $pid
  wait $pid
  local code=$?
  [ $code -eq 130 ] || complain "Ctrl-C while meshing: exit code $code instead of 130"
  is_absent never
}

loads() {
  refused "no load" "stage '1' applies no load" "$program" run "$beam" --folder none \
    --set 'stages=[{name: "1", loads: [{type: point_load, at: [0, 100], inside: [0.1, 99.9], force: [0, 0]}]}]'
  refused "a load without bound" "larger than any quantity" "$program" run "$beam" --folder none \
    --set 'stages=[{name: "1", loads: [{type: point_load, at: [0, 100], inside: [0.1, 99.9], force: [0, -1e308]}]}]'
  is_absent none
}

limits() {
  refused "a million eigenvalues" "record.eigenvalues.count" "$program" run "$bar" --folder none \
    --set record.eigenvalues.count=1000000
  local list
  for list in 'nox={Direction: {Method: Foo}}' 'nox={Direction: Foo}' 'nox=[1]' 'loca=3' \
    'loca={Stepper: {Bordered Solver Method: Foo}}' 'loca={Stepper: {Max Steps: foo}}'; do
    refused "$list" "--set path." "$program" run "$bar" --folder none --set path.control=arc_length --set "path.$list"
  done
  grep -q __asan_init "$program" || # whose shadow of the memory alone takes terabytes of address space
    (ulimit -v 100000 && refused "little memory" "of address space" "$program" run "$bar" --folder none
     refused "little memory to check" "of address space" "$program" check "$bar"
     exit $failed) || failed=1
  is_absent none
}

files() {
  printf '\xef\xbb\xbf' | cat - "$bar" >mark.yaml
  expect 0 "a byte order mark" "$program" check mark.yaml
  { cat "$bar"; for i in $(seq 20000); do echo "key$i: 1"; done; } >keys.yaml
  refused "unknown keys" "more" "$program" check keys.yaml
  refused "a device" "/dev/zero: cannot be read" "$program" check /dev/zero
  echo 'sweep: {deck: /dev/zero, thickness: [1, 2]}' >sweep.yaml
  refused "a device in a sweep" "/dev/zero" "$program" sweep sweep.yaml
  expect 4 "a full disk" bash -c "'$program' check '$bar' >/dev/full"
}

locked_folder() {
  "$program" run "$beam" --folder taken --quiet &
  local pid=$!
  for _ in $(seq 500); do [ -e taken/effective_deck.yaml ] && break; sleep 0.01; done
  kill -STOP $pid
  refused "a folder in use" "taken: another run is at work" "$program" run "$beam" --folder taken --overwrite --quiet
  refused "a run in use" "taken: another run is at work" "$program" resume taken --quiet
  kill -KILL $pid
  wait $pid 2>/dev/null
  rm -f taken/restart.h5
  refused "a run without restart" "--overwrite\` starts it again" "$program" resume taken
  expect 0 "a folder that was left" "$program" run "$bar" --folder taken --overwrite --quiet
}

# HDF5 would loop for ever in some of these.
damaged_fields() {
  "$program" run "$beam" --folder whole --quiet --set path.stop.after_steps=6 --set record.fields_every=2
  local place size
  size=$(stat -c %s whole/fields/mesh.h5)
  for place in 40 $((size / 2)) $((size - 1)); do
    rm -rf damaged
    cp -r whole damaged
    printf '\xfe' | dd of=damaged/fields/mesh.h5 bs=1 seek=$place conv=notrunc status=none
    expect 0 "a report without its mesh, byte $place" timeout -s KILL 20 "$program" report damaged
    grep -q "fields/mesh.h5: cannot be read: its checksum does not fit its content" damaged/report.html ||
      complain "the report does not say what is damaged"
    refused "verifying, byte $place" "cannot be read" "$program" verify damaged
    refused "going on, byte $place" "cannot be continued" "$program" resume damaged --quiet --set path.stop.after_steps=8
  done
  truncate -s 4000 damaged/fields/000006.h5
  cp whole/fields/mesh.h5 damaged/fields/
  refused "a step cut short" "000006.h5: cannot be continued" "$program" resume damaged --quiet --set path.stop.after_steps=8
}

for part in ${PARTS:-commands_in_geometry broken_geometry interrupted_meshing loads limits files locked_folder damaged_fields}
do $part; done
exit $failed
