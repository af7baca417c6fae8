#!/usr/bin/env bash
# Prolog goals from outside: what one costs, and what others notice while two hostile ones run.
# Called by benchmarks/run with the build's folder. A row each; exits 1 when one falls short.
set -euo pipefail
lares="$(readlink -f "$1/server/cli/lares")"
work="$(mktemp -d)" port=$((20000 + RANDOM % 20000)) failed=0
url="http://127.0.0.1:$port"
LARES_SHARE="${LARES_SHARE:-$PWD}" "$lares" serve --port "$port" --data "$work/data" \
  --log-level off >/dev/null &
server=$!
trap 'kill -KILL $server; wait $server 2>/dev/null; rm -rf "$work"' EXIT
for _ in $(seq 300); do curl -fs "$url/readyz" >/dev/null && break; sleep 0.1; done

ask() { curl -s -o /dev/null -w '%{time_total}\n' -H 'Content-Type: application/json' -d "$1" "$url/v1/prolog"; }
row() { # WHAT LIMIT VALUE UNIT
  local mark=""
  awk "BEGIN {exit !($3 > $2)}" && { mark=" : short"; failed=1; }
  printf '| %s | < %s %s | %s%s | load %s |\n' "$1" "$2" "$4" "$3" "$mark" "$(cut -d' ' -f1 /proc/loadavg)"
}
milliseconds() { awk '{printf "%.1f\n", $1 * 1000}'; }
median() { sort -n | awk '{v[NR] = $1} END {print v[int((NR + 1) / 2)]}'; }
# p99 of 2000 small GETs on one connection, in ms.
p99() {
  local urls=()
  for _ in $(seq 2000); do urls+=(-o /dev/null "$url/healthz"); done
  curl -s -w '%{time_total}\n' "${urls[@]}" | sort -n | awk '{v[NR] = $1} END {printf "%.3f\n", v[int(NR * 0.99)] * 1000}'
}

first="$(ask '{"goal": "rdf(X, rdf:type, owl:Class)", "limit": 1}' | milliseconds)"
row "first goal over the catalogue" 200 "$first" ms
sleep 1
row "a later goal, median of 5" 200 "$(for _ in 1 2 3 4 5; do ask '{"goal": "rdf(X, rdf:type, owl:Class)", "limit": 1}'; sleep 0.5; done | median | milliseconds)" ms

hostile() {
  while :; do
    for goal in 'repeat, fail' 'X is 7**(7**10)' 'numlist(1, 100000000, L), fail' 'findall(X, repeat, L)'; do
      ask "{\"goal\": \"$goal\", \"timeout_s\": 3}" >/dev/null
    done
  done
}
quiet="$(for _ in 1 2 3 4 5; do p99; done | median)"
hostile & one=$!
hostile & two=$!
sleep 1
busy="$(for _ in 1 2 3 4 5; do p99; done | median)"
kill $one $two
wait $one $two 2>/dev/null || true
printf '| p99 of small GETs, quiet and beside two hostile goals |  | %s and %s ms | load %s |\n' "$quiet" "$busy" "$(cut -d' ' -f1 /proc/loadavg)"
row "its ratio" 2 "$(awk "BEGIN {printf \"%.2f\", $busy / $quiet}")" times

before="$(awk '/VmRSS/ {print $2}' /proc/$server/status)"
curl -s --limit-rate 4M -o "$work/answers" -H 'Content-Type: application/json' -H 'Accept: application/x-ndjson' \
  -d '{"goal": "between(1, 1000000, X)", "limit": 1000000, "timeout_s": 60}' "$url/v1/prolog"
after="$(awk '/VmRSS/ {print $2}' /proc/$server/status)"
row "1 000 000 answers to a slow reader: growth of the server" 16 "$(awk "BEGIN {printf \"%.1f\", ($after - $before) / 1024}")" MiB
row "of them missing" 1 "$((1000001 - $(wc -l <"$work/answers")))" lines
exit $failed
