# Sourced by the tests of sweeps: what stands in sweep.csv, and how they wait.
# cells FOLDER COLUMN: a column of sweep.csv as one line.
cells() {
  /usr/bin/python3 -c 'import csv, sys
print(*(row.get(sys.argv[2], "no such column") for row in csv.DictReader(open(sys.argv[1]))))' "$1/sweep.csv" "$2"
}
has() { [ "$(cells "$1" "$2")" == "$3" ] || complain "$1: $2 is '$(cells "$1" "$2")' instead of '$3'"; }
# wait_for COMMAND...: until it is true, a minute at most.
wait_for() {
  for _ in $(seq 6000); do
    "$@" 2>/dev/null && return
    sleep 0.01
  done
  complain "waited in vain for: $*"
}
has_rows() { [ "$(wc -l <"$1/curve.csv")" -ge "$2" ]; }

# the_same_table ONE OTHER: sweep.csv but for times, memory and where it was computed.
the_same_table() {
  /usr/bin/python3 -c 'import csv, sys
own = ("timings.", "peak_memory_mib", "provenance.")
one, other = ([{key: value for key, value in row.items() if not key.startswith(own)}
               for row in csv.DictReader(open(name + "/sweep.csv"))] for name in sys.argv[1:])
sys.exit(one != other)' "$1" "$2" || complain "$1 and $2 have other tables"
}
