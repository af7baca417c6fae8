#!/usr/bin/env bash
# The rows of `benchmarks/run knowledge`. Called by it with the build folder.
set -euo pipefail
build="$1"
lares="$build/server/cli/lares"
work="$(mktemp -d)"
trap clean_up EXIT
export LARES_SHARE="$PWD"
. benchmarks/rows.sh
now() { date +%s.%N; }

heading

# In the process: parsing, lookups, planning, places.
rows "$build/benchmarks/knowledge_bench"

# A hundred environments stored, then five cold starts.
serve; ready
for i in $(seq 100); do
  "$lares" environment put "flat-$i" --type Home --layer semantic=demo/flat.ttl --server "$url" >/dev/null
done
"$lares" recipe put recipes/library/object-search.ttl --server "$url" >/dev/null
stop
for _ in 1 2 3 4 5; do
  begin="$(now)"; serve; ready; end="$(now)"; stop
  echo "$end $begin" | awk '{print $1 - $2}'
done >"$work/starts"
row "ready with all own knowledge and 100 environments stored" "<" 1 s "$(median <"$work/starts")"

# Small GETs.
serve; ready
for _ in 1 2 3 4 5; do
  wrk -t2 -c16 -d3s --latency "$url/v1/recipes/object-search" >"$work/wrk"
  awk '/Requests\/sec/ {print $2}' "$work/wrk" >>"$work/rates"
  awk '$1 == "99%" {v = $2; f = v ~ /us$/ ? 0.001 : v ~ /ms$/ ? 1 : 1000; sub(/[a-z]+$/, "", v); print v * f}' \
    "$work/wrk" >>"$work/p99"
done
row "small GETs, 16 clients" ">" 10000 "1/s" "$(median <"$work/rates")"
row "small GETs, 16 clients, p99" "<" 5 ms "$(median <"$work/p99")"

# A layer of 200 MB up and down: what the server's memory peak grows by.
head -c 200000000 /dev/urandom >"$work/features.bin"
peak() { awk '/VmHWM/ {print $2 / 1024}' "/proc/$server/status"; }
for i in 1 2 3 4 5; do
  stop; serve; ready
  "$lares" where Cup --server "$url" >/dev/null
  before="$(peak)"
  begin="$(now)"
  "$lares" environment put big --layer features="$work/features.bin" --note "$i" --server "$url" >/dev/null
  "$lares" environment get big --out "$work/down-$i" --server "$url" >/dev/null
  end="$(now)"
  cmp -s "$work/features.bin" "$work/down-$i"/features* || { echo "the layer came back changed" >&2; exit 1; }
  rm -rf "$work/down-$i"
  echo "$(peak) $before" | awk '{print $1 - $2}' >>"$work/growth"
  echo "$end $begin" | awk '{print $1 - $2}' >>"$work/updown"
  printf '%s' "$i" >>"$work/features.bin" # the next one is another blob
done
row "200 MB layer up and down: growth of the server's memory peak" "<" 16 MiB "$(median <"$work/growth")"
row "  … and the time for both, checks and syncs included" - - s "$(median <"$work/updown")"
exit "$short"
