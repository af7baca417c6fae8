#!/usr/bin/env bash
# Goals of every kind against a real server: it lives, stays small, and no process is left.
. "$(dirname "$0")/session.sh"
start_server

resident_kb() { awk '/VmRSS/ {print $2}' "/proc/$server/status"; }
workers() { cat "/proc/$server/task/"*/children 2>/dev/null | wc -w; }
goal() { lares prolog --timeout 1.5 "$@"; }
open_files() { ls "/proc/$server/fd" | wc -l; }

expect 0 goal "subclass(lares:'Cup', lares:'Cup')"; has yes
expect 0 goal "rdf(X, rdfs:subClassOf, lares:'Container'), X == lares:'Cup'"
expect 0 goal "fail"; has no
expect 3 goal "X is foo + 1"; has "foo"
expect 3 goal "member(X, [1"; has "1:"
expect 0 bash -c "printf 'X = 1.\n\nmember(Y,\n [2, 3]).\n' | lares prolog"; has "X = 1" "Y = 2" "Y = 3"
expect 0 lares --json prolog "X = 1"; has '{"answer":{"X":1}}' '"outcome":"yes"'
expect 4 goal "true" --environment nowhere

before="$(resident_kb)" files="$(open_files)"
hostile() { # CODE GOAL
  local begin end
  begin="$(date +%s%N)"
  expect "$1" goal "$2"
  end="$(date +%s%N)"
  expect 0 test "$(((end - begin) / 1000000))" -lt 4000
  expect 0 curl -fsS "$LARES_SERVER/healthz"
}
hostile 8 "X is 7**(7**10)"
hostile 3 "repeat, assertz(a(1)), fail"; 
hostile 8 "repeat, fail"
hostile 8 "repeat, catch((repeat, fail), _, true), fail"
for g in "format(atom(A), '~*c', [2000000000, 0'x])" "numlist(1, 100000000, L), fail" \
         "findall(X, repeat, L)" "between(1, inf, N), atom_concat(aaaaaaaa, N, A), atom_length(A, 1)"; do
  begin="$(date +%s)"
  lares prolog --timeout 1.5 "$g" >/dev/null 2>&1
  expect 0 test "$(($(date +%s) - begin))" -le 4
done
for g in "process_create(path(id), [], [])" "shell(id)" "fork(P)" "tcp_socket(S)" "halt" \
         "open('/etc/passwd', read, S)" "open('/tmp/x', write, S)" "thread_create(true, T)"; do
  hostile 3 "$g"
done
head -c 1000 /dev/urandom | tr -d '\0' >"$work/garbage"
printf 'X = 1.\n' | cat "$work/garbage" - | lares prolog >/dev/null 2>&1
expect 0 curl -fsS "$LARES_SERVER/healthz"

# A reader that takes little holds little, and one that goes away frees its process.
curl -sS --limit-rate 200k -m 3 -o /dev/null -H 'Content-Type: application/json' \
  -H 'Accept: application/x-ndjson' -d '{"goal": "between(1, 1000000, X)", "limit": 1000000}' \
  "$LARES_SERVER/v1/prolog" 2>/dev/null
for _ in 1 2 3 4 5 6 7 8 9 10 11 12; do
  curl -s -o /dev/null -H 'Content-Type: application/json' -d '{"goal": "repeat, fail", "timeout_s": 1}' \
    "$LARES_SERVER/v1/prolog" &
  clients[$_]=$!
done
wait "${clients[@]}"
sleep 1
expect 0 test "$(workers)" -eq 0
expect 0 test "$(open_files)" -le "$((files + 4))"
expect 0 test "$(($(resident_kb) - before))" -lt 65536
expect 0 curl -fsS "$LARES_SERVER/metrics"; has 'lares_prolog_workers_running 0' 'lares_prolog_goals_total{ended="time"}'
