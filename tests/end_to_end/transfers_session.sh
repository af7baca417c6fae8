#!/usr/bin/env bash
# Large layers, lost answers and dead zones, with `kill -9` of the server in between.
. "$(dirname "$0")/session.sh"
export XDG_CACHE_HOME="$work/cache"
start_server
cd "$session_root" || exit 1

kill_server() { kill -KILL "$server" 2>/dev/null; wait "$server" 2>/dev/null; }
sha256() { sha256sum <"$1" | cut -d' ' -f1; }
# check WHAT COMMAND… : counts, and says what does not hold.
check() {
  local what="$1"
  shift
  checks=$((checks + 1))
  "$@" || { failures=$((failures + 1)); echo "FAILED: $what"; }
}
tus() { curl -sS -H 'Tus-Resumable: 1.0.0' "$@"; }
offset() { tus -I "$LARES_SERVER$1" | tr -d '\r' | sed -n 's/^Upload-Offset: //p'; }

# What the answer acknowledges is there after kill -9; what it does not, is not in the way.
head -c 3000000 /dev/urandom >"$work/map.bin"
tus -X POST -H 'Upload-Length: 3000000' -D "$work/head" -o /dev/null "$LARES_SERVER/v1/uploads"
upload="$(tr -d '\r' <"$work/head" | sed -n 's/^Location: //p')"
piece() { # OFFSET BYTES [curl's options]
  local at="$1" size="$2"
  shift 2
  tail -c "+$((at + 1))" "$work/map.bin" | head -c "$size" |
    tus -X PATCH -H "Upload-Offset: $at" -H 'Content-Type: application/offset+octet-stream' \
      --data-binary @- -o /dev/null -w '%{http_code}' "$@" "$LARES_SERVER$upload"
}
check "the first piece is taken" [ "$(piece 0 1000000)" = 204 ]
piece 1000000 2000000 --limit-rate 1000k >/dev/null 2>&1 &
sleep 0.4
kill_server
wait $! 2>/dev/null
start_server
at="$(offset "$upload")"
check "acknowledged bytes are there: $at" [ "$at" -ge 1000000 ]
check "the upload goes on" [ "$(piece "$at" 3000000)" = 204 ]
expect 0 curl -fsS -F "features=$upload;type=application/vnd.lares.upload;filename=map.bin" \
  "$LARES_SERVER/v1/environments/hall/versions"
has "$(sha256 "$work/map.bin")"
kill_server
start_server
expect 0 lares environment get hall --out "$work/hall"
expect 0 cmp "$work/hall/features.bin" "$work/map.bin"
expect 0 tus -f -X DELETE "$LARES_SERVER$upload"

# A large layer reaches its server although that is killed again and again.
head -c 150000000 /dev/urandom >"$work/large.bin"
lares environment put large --layer "features=$work/large.bin" >"$work/put.out" 2>&1 &
putting=$!
for pause in 0.7 0.9 1.1; do
  sleep "$pause"
  kill -0 "$putting" 2>/dev/null || break
  kill_server
  start_server
done
wait "$putting"
code=$?
check "put ended with $code: $(cat "$work/put.out")" [ "$code" = 0 ]
expect 0 curl -fsS "$LARES_SERVER/v1/environments/large/versions"
has "$(sha256 "$work/large.bin")" '"count":1'

# Each request with a key is done once, whenever the server is killed.
RANDOM="${LARES_SEED:-7}"
rounds=8
for round in $(seq "$rounds"); do
  { sleep "0.0$((RANDOM % 10))"; kill -KILL "$server"; } 2>/dev/null &
  killer=$!
  for _ in $(seq 20); do
    answer="$(curl -s -o "$work/answer.$round" -w '%{http_code}' -H "Idempotency-Key: round-$round" \
      -F "note=round $round" -F "features=@$work/map.bin" "$LARES_SERVER/v1/environments/once/versions")"
    case "$answer" in 2??) break ;; esac
    kill -0 "$server" 2>/dev/null || start_server
  done
  wait "$killer" 2>/dev/null
  # One that was killed just now may still be seen for a moment.
  curl -fs -o /dev/null "$LARES_SERVER/readyz" || start_server
  check "round $round was answered: $answer" [ "${answer:0:1}" = 2 ]
done
expect 0 curl -fsS "$LARES_SERVER/v1/environments/once/versions"
has "\"count\":$rounds"
expect 0 curl -fsS -H "Idempotency-Key: round-$rounds" -F "note=round $rounds" \
  -F "features=@$work/map.bin" "$LARES_SERVER/v1/environments/once/versions"
check "the first answer comes again" [ "$output" = "$(cat "$work/answer.$rounds")" ]
expect 22 curl -fsS -H "Idempotency-Key: round-1" -F "note=another" \
  -F "features=@$work/map.bin" "$LARES_SERVER/v1/environments/once/versions"
has 422

# In a dead zone.
stop_server
expect 6 lares environment get hall --out "$work/hall"
expect 0 lares environment get hall --out "$work/hall" --offline-ok
has "no Lares server answers" "version 1 of hall as it was got"
expect 0 cmp "$work/hall/features.bin" "$work/map.bin"
expect 6 lares environment get elsewhere --out "$work/elsewhere" --offline-ok
