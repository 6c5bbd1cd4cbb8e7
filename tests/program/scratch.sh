# Sourced by the program tests: a folder of their own to work in, and how they complain.
#   open_scratch      enters the folder; it is removed at the end
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
failed=0

open_scratch() { cd "$work" || exit 1; }

complain() {
  echo "FAILED: $1"
  failed=1
}

same() { cmp -s "$1" "$2" || complain "$1 and $2 differ"; }
