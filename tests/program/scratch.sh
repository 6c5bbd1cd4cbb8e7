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

# expect CODE WHAT COMMAND...: the command's exit code; its output goes to said.log.
expect() {
  local code=$1 what=$2
  shift 2
  "$@" >said.log 2>&1
  local got=$?
  [ $got -eq "$code" ] || complain "$what: exit code $got instead of $code; it said: $(tail -n 3 said.log)"
}

said() { grep -qF -- "$1" said.log || complain "expected '$1' in: $(cat said.log)"; }
exists() { [ -e "$1" ] || complain "there is no $1"; }
is_absent() { [ ! -e "$1" ] || complain "there is a $1"; }
