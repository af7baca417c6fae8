#!/usr/bin/env bash
# The rows of `benchmarks/run reasoner`. Called by it with the build's folder.
set -euo pipefail
build="$1"
work="$(mktemp -d)"
trap clean_up EXIT
export LARES_SHARE="$PWD"
. benchmarks/rows.sh
bench="$build/benchmarks/reasoner_bench"
data="${LARES_DATA:-}"
[ -n "$data" ] || echo "LARES_DATA is not set: what is measured on real files is left out" >&2

heading

# The suites say how much of them is right; a test that fails has said why in the log.
if [ -n "$data" ]; then
  "$build/tests/reasoner/owl_conformance_test" >"$work/owl" || true
  conformance="$(sed -n 's/^OWL 2 RL: \([0-9]*\) of \([0-9]*\) cases right, median \([0-9.]*\) ms.*/\1 \3/p' "$work/owl")"
  row "OWL 2 RL conformance: cases right, of 273" ">=" 273 cases "${conformance% *}"
  row "  … median time of a case" "<" 1 ms "${conformance#* }"
fi

rows "$bench" closures
for _ in 1 2 3 4 5; do "$bench" memory; done >"$work/memory"
row "our universities, 10: resident memory, dictionary included" "<" 80 "B/triple" "$(median <"$work/memory")"
rows "$build/benchmarks/overlay_bench"
rows "$bench" proofs
rows "$bench" queries

# part SUITE FILE: the part that is right of all "NAME: R of N" in a test's output, in percent.
part() { awk "/$1.*: [0-9]+ of [0-9]+/ {r += \$(NF - 2); n += \$NF} END {print n ? 100 * r / n : 0}" "$2"; }
if [ -n "$data" ]; then
  "$build/tests/reasoner/sparql/w3c_sparql_test" >"$work/sparql" || true
  row "W3C SPARQL 1.1 query, without service and entailment" ">=" 95 "%" "$(part '^sparql11' "$work/sparql")"
  "$build/tests/ontology/w3c_rdf_test" >"$work/rdf" || true
  row "W3C RDF 1.1: Turtle, TriG, N-Triples, N-Quads, RDF/XML" ">=" 98 "%" "$(part '^' "$work/rdf")"
fi

# Konclude reads the same file in the same run. What it finds punned or contradictory is listed.
konclude() {
  rows "$build/benchmarks/konclude_bench" "$@" 2>"$work/konclude"
  cat "$work/konclude" >>"$work/differences"
}
konclude "our ontology" ontology/*.ttl
if [ -n "$data" ]; then
  ontologies=("$data"/roboearth/ontology/*.owl "$data"/roboearth/srdl/*.owl)
  konclude "RoboEarth" "${ontologies[@]}"
  for robot in PR2 amigo; do
    konclude "RoboEarth with $robot" "${ontologies[@]}" "$data/roboearth/robots/$robot.owl"
  done
fi

# SWI-Prolog's rdf_db on the same file: explicit triples, loaded and matched.
if [ -n "$data" ]; then
  gzip -dc "$data/conformance/lubm/lubm-1-0-0.nt.gz" >"$work/data.nt"
else
  "$bench" university 0 >"$work/data.nt"
fi
read -r our_load our_match our_answers < <("$bench" load-and-match "$work/data.nt")
read -r their_load their_match their_answers < <(swipl benchmarks/rdf_db_bench.pl "$work/data.nt")
row "LUBM(1) loaded: Lares ÷ SWI-Prolog rdf_db" "<" 1 times "$(awk "BEGIN {print $our_load / $their_load}")"
row "  … each triple matched by S P ? and S ? O" "<" 1 times "$(awk "BEGIN {print $our_match / $their_match}")"
row "  … answers that differ" "<=" 0 answers "$((our_answers - their_answers))"

bash benchmarks/goals.sh "$build" without-heading || short=1

echo
echo "What Konclude was not given, and differences:"
sed 's/^/  /' "$work/differences"
exit "$short"
