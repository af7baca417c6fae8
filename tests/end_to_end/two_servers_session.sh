#!/usr/bin/env bash
# Two servers on one PostgreSQL, set up by the words of docs/store.md alone; then one is killed while
# the other takes writes, and nothing is lost.
. "$(dirname "$0")/session.sh"
cd "$session_root" || exit 1
programs=/usr/lib/postgresql/15/bin
[ -x "$programs/initdb" ] || { echo "PostgreSQL 15 is not installed"; exit 77; }

# A PostgreSQL of this session's own, on a socket below /tmp: paths of sockets are short.
folder="$(mktemp -d /tmp/lares-pg-XXXXXX)"
as_postgres() { "$@"; }
if [ "$(id -u)" = 0 ]; then
  chown postgres "$folder"
  as_postgres() { (cd / && setpriv --reuid=postgres --regid=postgres --clear-groups "$@"); }
fi
as_postgres "$programs/initdb" -D "$folder/data" -U postgres -A trust -E UTF8 --locale=C.UTF-8 >"$folder.log" 2>&1 || { cat "$folder.log"; exit 1; }
as_postgres "$programs/postgres" -D "$folder/data" -k "$folder" -c listen_addresses= >>"$folder.log" 2>&1 &
postgres=$!
servers=""
tidy() {
  kill -KILL $servers 2>/dev/null
  # Its own process: what this shell started may ignore the signal.
  kill -INT "$(head -n 1 "$folder/data/postmaster.pid" 2>/dev/null)" 2>/dev/null
  wait "$postgres" 2>/dev/null
  rm -rf "$folder" "$folder.log"
}
trap 'tidy; finish' EXIT
export PGHOST="$folder"
for _ in $(seq 200); do "$programs/psql" -U postgres -c 'SELECT 1' >/dev/null 2>&1 && break; sleep 0.05; done

# The document's own commands, with this session's ports and folder.
sudo() { shift 2; PGUSER=postgres "$@"; }
first=$((20000 + RANDOM % 20000))
second=$((first + 1))
commands="$(awk '/^```bash$/ {on = 1; next} /^```/ {on = 0} on' docs/store.md |
  sed "s|8081|$first|g; s|8082|$second|g; s|/srv/lares/blobs|$HOME/blobs|g")"
[ "$(grep -c . <<<"$commands")" -ge 9 ] || { echo "docs/store.md has lost its commands"; exit 1; }
while IFS= read -r line; do
  [ -n "$line" ] || continue
  case "$line" in
    *"&") eval "${line%&}" >>"$HOME/servers.log" 2>&1 & servers="$servers $!" ;;
    *)
      for port in $first $second; do
        [ -n "$servers" ] && until curl -fs -o /dev/null "http://127.0.0.1:$port/readyz"; do sleep 0.1; done
      done
      checks=$((checks + 1))
      output="$(eval "$line" 2>&1)" || { failures=$((failures + 1)); printf 'FAILED: %s\n%s\n' "$line" "$output"; }
      case "$line" in export*) eval "$line" ;; esac ;;
  esac
done <<<"$commands"
has "blue cup"

# The second server is killed again and again; what either acknowledged is there.
serve_second() {
  lares serve --store "$LARES_STORE" --blobs "$LARES_BLOBS" --port "$second" >>"$HOME/servers.log" 2>&1 &
  victim=$!
}
kill -KILL "${servers##* }" 2>/dev/null
ledger="$HOME/ledger"
write_to() { # PORT NAME
  local i=0 number
  while [ ! -e "$HOME/stop" ]; do
    i=$((i + 1))
    printf '%s.5 0 0 0 0 0 0 1\n' "$i" >"$HOME/path-$2.txt"
    number="$(curl -fsS --max-time 20 -F "trajectory=@$HOME/path-$2.txt" -F "note=$2-$i" \
      "http://127.0.0.1:$1/v1/environments/$2/versions" 2>/dev/null | sed -n 's/^ *"number": \([0-9]*\).*/\1/p' | head -n 1)"
    [ -n "$number" ] && echo "$2 $number $2-$i" >>"$ledger-$2"
  done
}
touch "$ledger-steady" "$ledger-shaken"
write_to "$first" steady & steady=$!
write_to "$second" shaken & shaken=$!
for _ in 1 2 3 4; do
  serve_second
  servers="$servers $victim"
  # Killed while it takes writes, once it took some.
  before="$(wc -l <"$ledger-shaken")"
  for _ in $(seq 300); do
    [ "$(wc -l <"$ledger-shaken")" -gt "$((before + 1))" ] && break
    sleep 0.1
  done
  kill -KILL "$victim"
  wait "$victim" 2>/dev/null
done
touch "$HOME/stop"
wait "$steady" "$shaken"
for name in steady shaken; do
  expect 0 test "$(wc -l <"$ledger-$name")" -ge 8
  while read -r environment number note; do
    expect 0 curl -fsS "http://127.0.0.1:$first/v1/environments/$environment/versions/$number"
    has "\"note\": \"$note\""
  done <"$ledger-$name"
done
expect 0 lares store verify --store "$LARES_STORE" --blobs "$LARES_BLOBS"
expect 0 lares store backup "$HOME/backup" --store "$LARES_STORE" --blobs "$LARES_BLOBS"
digest="$(sed -n 's/^digest //p' <<<"$output")"
expect 0 lares store restore "$HOME/backup" --data "$HOME/folder"
has "$digest"
