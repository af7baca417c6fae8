#!/usr/bin/env bash
# Prolog goals from outside: what one costs, and what others notice while two hostile ones run.
# Called by benchmarks/run with the build's folder. A row each; exits 1 when one falls short.
set -euo pipefail
lares="$(readlink -f "$1/server/cli/lares")"
work="$(mktemp -d)"
trap clean_up EXIT
export LARES_SHARE="${LARES_SHARE:-$PWD}"
. benchmarks/rows.sh
[ "${2:-}" = without-heading ] || heading
serve
ready

ask() { curl -s -o /dev/null -w '%{time_total}\n' -H 'Content-Type: application/json' -d "$1" "$url/v1/prolog"; }
milliseconds() { awk '{printf "%.1f\n", $1 * 1000}'; }
# p99 of 2000 small GETs on one connection, in ms.
p99() {
  local urls=()
  for _ in $(seq 2000); do urls+=(-o /dev/null "$url/healthz"); done
  curl -s -w '%{time_total}\n' "${urls[@]}" | sort -n | awk '{v[NR] = $1} END {printf "%.3f\n", v[int(NR * 0.99)] * 1000}'
}

all_classes='{"goal": "rdf(X, rdf:type, owl:Class)", "limit": 1}'
row "first goal over the catalogue" "<" 200 ms "$(ask "$all_classes" | milliseconds)"
sleep 1
row "a later goal" "<" 200 ms \
  "$(for _ in 1 2 3 4 5; do ask "$all_classes"; sleep 0.5; done | median | milliseconds)"

hostile() {
  while :; do
    for goal in 'repeat, fail' 'X is 7**(7**10)' 'numlist(1, 100000000, L), fail' 'findall(X, repeat, L)'; do
      ask "{\"goal\": \"$goal\", \"timeout_s\": 3}" >/dev/null
    done
  done
}
# A circle of 6 000 links, whose closure is too large, put again and again.
exploding() {
  awk 'BEGIN {
    print "@prefix : <http://example.org/> . @prefix owl: <http://www.w3.org/2002/07/owl#> ."
    print ":o a owl:Ontology . :p a owl:TransitiveProperty ."
    for (i = 0; i < 6000; ++i) printf ":n%d :p :n%d .\n", i, (i + 1) % 6000
  }' >"$work/circle.ttl"
  while :; do "$lares" ontology put "$work/circle.ttl" --server "$url" >/dev/null 2>&1; done
}
cross_product() {
  while :; do
    curl -s -o /dev/null --data-urlencode \
      'query=SELECT (COUNT(*) AS ?n) { ?a ?b ?c . ?d ?e ?f . ?g ?h ?i }' "$url/v1/sparql"
  done
}
# beside WHAT COMMAND COMMAND: what both at once do to other clients.
beside() {
  "$2" & local one=$!
  "$3" & local two=$!
  sleep 1
  local busy
  busy="$(for _ in 1 2 3 4 5; do p99; done | median)"
  kill $one $two
  wait $one $two 2>/dev/null || true
  row "  … beside $1" - - ms "$busy"
  row "  … its ratio" "<" 2 times "$(awk "BEGIN {print $busy / $quiet}")"
}
quiet="$(for _ in 1 2 3 4 5; do p99; done | median)"
row "p99 of small GETs, quiet" - - ms "$quiet"
beside "two hostile goals" hostile hostile
beside "an ontology that explodes and a query for everything" exploding cross_product

stop # what it still closes would count
serve
ready
resident() { awk '/VmRSS/ {print $2}' "/proc/$server/status"; }
before="$(resident)"
curl -s --limit-rate 4M -o "$work/answers" -H 'Content-Type: application/json' -H 'Accept: application/x-ndjson' \
  -d '{"goal": "between(1, 1000000, X)", "limit": 1000000, "timeout_s": 60}' "$url/v1/prolog"
row "1 000 000 answers to a slow reader: growth of the server" "<" 16 MiB \
  "$(awk "BEGIN {print ($(resident) - $before) / 1024}")"
row "  … of them missing" "<" 1 lines "$((1000001 - $(wc -l <"$work/answers")))"
exit "$short"
