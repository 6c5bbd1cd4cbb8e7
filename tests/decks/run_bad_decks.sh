#!/bin/bash
# Runs `dda check` and `dda run` on every deck below this folder: each must end with 2, say every line of its expected.txt
# but those that begin with "! ", and leave nothing behind.
#   run_bad_decks.sh PROGRAM FOLDER_OF_DECKS
set -u
program=$(realpath "$1")
decks=$(realpath "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0

complain() {
  echo "FAILED $1: $2"
  failed=1
}

for folder in "$decks"/*/; do
  name=$(basename "$folder")
  mkdir "$work/$name" && cd "$work/$name" || exit 1
  cp "$folder"/* .
  before=$(ls)
  for command in check run; do
    "$program" $command deck.yaml >out.log 2>&1
    code=$?
    said=$(cat out.log)
    rm out.log
    [ $code -eq 2 ] || complain "$name" "$command: exit code $code instead of 2; it said: $said"
    [ "$(ls)" = "$before" ] || complain "$name" "$command left something behind: $(ls)"
    while IFS= read -r line; do
      if [[ "$line" == "! "* ]]; then
        [[ "$said" != *"${line#! }"* ]] || complain "$name" "$command: '${line#! }' is not true: $said"
      else
        [[ "$said" == *"$line"* ]] || complain "$name" "$command: expected '$line' in: $said"
      fi
    done <expected.txt
  done
done
exit $failed
