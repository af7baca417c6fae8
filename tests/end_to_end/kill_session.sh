#!/usr/bin/env bash
# `kill -9` at any moment: what the server acknowledged is there after a restart, whole, and nothing
# half-done is visible. The ledger holds "ID SHA-256" of each acknowledged write.
. "$(dirname "$0")/session.sh"
ledger="$work/ledger"
: >"$ledger"
RANDOM="${LARES_SEED:-7}"
kills="${LARES_KILLS:-20}"

# Puts robots and environment versions until the server is gone; one line in the ledger for each 2xx.
write_until_killed() {
  local round="$1" i=0 file answer
  while kill -0 "$server" 2>/dev/null; do
    i=$((i + 1))
    file="$work/write-$round.ttl"
    {
      cat "$session_root/robots/models/scout.ttl"
      echo "# write $round.$i"
    } >"$file"
    answer="$(curl -s -o /dev/null -w '%{http_code}' -X PUT -H 'Content-Type: text/turtle' \
      --data-binary "@$file" "$LARES_SERVER/v1/robots/robot-$round-$i")"
    case "$answer" in 2??) echo "robot robot-$round-$i $(sha256sum <"$file" | cut -d' ' -f1)" >>"$ledger" ;; esac
    head -c $((RANDOM * 20)) /dev/urandom >"$file.bin"
    answer="$(curl -s -o /dev/null -w '%{http_code}' -F "features=@$file.bin" \
      "$LARES_SERVER/v1/environments/env-$round/versions")"
    case "$answer" in 2??) echo "environment env-$round/$i $(sha256sum <"$file.bin" | cut -d' ' -f1)" >>"$ledger" ;; esac
  done
}

verify() {
  local kind name wanted found
  while read -r kind name wanted; do
    checks=$((checks + 1))
    case "$kind" in
      robot) found="$(curl -fs "$LARES_SERVER/v1/robots/$name" | sha256sum)" ;;
      environment)
        found="$(curl -fs "$LARES_SERVER/v1/environments/${name%/*}/versions/${name#*/}/layers/features" | sha256sum)" ;;
    esac
    [ "${found%% *}" = "$wanted" ] || {
      failures=$((failures + 1))
      echo "FAILED: $kind $name was acknowledged and is lost or changed"
    }
  done < <(if [ "${1:-}" = all ]; then cat "$ledger"; else grep -E "(robot|env)-$1[-/]" "$ledger"; fi)
}

# On a busy machine few writes are acknowledged between two kills: then there are more of them.
round=0
while [ "$round" -lt "$kills" ] ||
  { [ "$(wc -l <"$ledger")" -le "$kills" ] && [ "$round" -lt $((3 * kills)) ]; }; do
  round=$((round + 1))
  start_server
  [ "$round" -gt 1 ] && verify "$((round - 1))"
  write_until_killed "$round" 2>/dev/null &
  writer=$!
  sleep "0.$((RANDOM % 5))$((RANDOM % 10))"
  kill -KILL "$server" 2>/dev/null
  wait "$server" 2>/dev/null
  wait "$writer" 2>/dev/null
done
rounds="$round"
start_server
verify all
# Every version and document that is listed can be read whole.
expect 0 lares environment list --json
for round in $(seq "$rounds"); do
  versions="$(curl -fs "$LARES_SERVER/v1/environments/env-$round" | grep -o '"latest": *[0-9]*' | grep -o '[0-9]*$')"
  for number in $(seq "${versions:-0}"); do
    expect 0 curl -fs -o /dev/null "$LARES_SERVER/v1/environments/env-$round/versions/$number/layers/features"
  done
done
checks=$((checks + 1))
leftovers="$(find "$work/store" -path '*incoming*' -type f | wc -l)"
[ "$leftovers" = 0 ] || { failures=$((failures + 1)); echo "FAILED: $leftovers half-written files"; }
echo "$(wc -l <"$ledger") acknowledged writes, $rounds kills"
[ "$(wc -l <"$ledger")" -gt "$kills" ] || { failures=$((failures + 1)); echo "FAILED: too few writes to judge"; }
