# Sourced by the benchmarks: one way to print a row, and what they share of a running server.
short=0

heading() { printf '%-66s %-12s %12s\n' "what" "to reach" "measured"; }

# row WHAT RELATION LIMIT UNIT MEASURED; RELATION "-" for a figure without a limit.
row() {
  local verdict=ok limit="$3"
  if [ "$2" = - ]; then
    verdict="" limit=""
  elif ! awk -v m="$5" -v l="$3" "BEGIN {exit !(m == m + 0 && m $2 l)}"; then
    verdict="SHORT" short=1
  fi
  # Padded here, for printf counts bytes.
  printf '%s%*s %2s %-9s %12s  %-10s load %s  %s\n' "$1" "$((66 - ${#1}))" "" "$2" "$limit" "$(awk -v m="$5" 'BEGIN {printf m == int(m) && m < 1e9 ? "%d" : "%.4g", m}')" "$4" \
    "$(cut -d' ' -f1 /proc/loadavg)" "$verdict"
}

# Rows from a program (measure.h tells their form), which fails when it fails.
rows() {
  local what relation limit unit measured
  while IFS=$'\t' read -r what relation limit unit measured; do
    row "$what" "$relation" "$limit" "$unit" "$measured"
  done < <("$@" || { code=$?; printf '%s\t==\t0\texit code\t%s\n' "${1##*/} ${2:-}" "$code"; })
}

median() { sort -g | awk '{v[NR] = $1} END {print v[int((NR + 1) / 2)]}'; }

# A server of `$lares` with its data in `$work`.
port=$((20000 + RANDOM % 20000))
url="http://127.0.0.1:$port"
server=""
serve() { "$lares" serve --port "$port" --data "$work/store" --log-level off >/dev/null 2>"$work/log" & server=$!; }
ready() { until curl -fs -o /dev/null "$url/readyz"; do sleep 0.005; done; }
stop() { kill -TERM "$server"; wait "$server" 2>/dev/null || true; server=""; }
clean_up() {
  [ -n "$server" ] && { kill -KILL "$server"; wait "$server"; } 2>/dev/null
  rm -rf "$work"
}
