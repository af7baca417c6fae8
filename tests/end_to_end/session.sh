# Sourced by the sessions: a server on a port and folder of its own, `lares` on PATH, and checks that
# count. Ends the session with 1 when a check failed.
set -uo pipefail
session_root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
work="$(mktemp -d)"
mkdir "$work/bin"
ln -s "$LARES_BINARY" "$work/bin/lares"
export PATH="$work/bin:$PATH" HOME="$work/home" XDG_DATA_HOME="$work/home/data"
mkdir -p "$HOME"
failures=0 checks=0 server=""

free_port() {
  local port
  while :; do
    port=$((20000 + RANDOM % 20000))
    (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null || { echo "$port"; return; }
  done
}

start_server() {
  port="${port:-$(free_port)}"
  export LARES_SERVER="http://127.0.0.1:$port"
  lares serve --port "$port" --data "$work/store" >"$work/serve.out" 2>"$work/serve.log" &
  server=$!
  for _ in $(seq 150); do
    lares status >/dev/null 2>&1 && return
    kill -0 "$server" 2>/dev/null || break
    sleep 0.1
  done
  echo "the server did not start:" && cat "$work/serve.out" "$work/serve.log"
  exit 1
}

stop_server() { kill -TERM "$server" 2>/dev/null; wait "$server" 2>/dev/null; }

finish() {
  [ -n "$server" ] && { kill -KILL "$server"; wait "$server"; } 2>/dev/null
  rm -rf "$work"
  echo "$((checks - failures)) of $checks checks hold"
  [ "$failures" = 0 ]
  exit $?
}
trap finish EXIT

# expect CODE COMMAND… : runs it, keeps what it printed in $output, checks the exit code.
expect() {
  local wanted="$1" code=0
  shift
  output="$("$@" 2>&1)" || code=$?
  checks=$((checks + 1))
  if [ "$code" != "$wanted" ]; then
    failures=$((failures + 1))
    printf 'FAILED: %s\n  exit code %s, expected %s\n%s\n' "$*" "$code" "$wanted" "$output"
  fi
}

# has TEXT… : each stands in $output.
has() {
  local text
  for text in "$@"; do
    checks=$((checks + 1))
    grep -qF -- "$text" <<<"$output" || {
      failures=$((failures + 1))
      printf "FAILED: '%s' is missing in:\n%s\n" "$text" "$output"
    }
  done
}

# lacks TEXT… : none stands in $output.
lacks() {
  local text
  for text in "$@"; do
    checks=$((checks + 1))
    grep -qF -- "$text" <<<"$output" && {
      failures=$((failures + 1))
      printf "FAILED: '%s' should not be in:\n%s\n" "$text" "$output"
    }
  done
}

need_data() {
  [ -n "${LARES_DATA:-}" ] || { echo "LARES_DATA is not set: skipped"; trap - EXIT; rm -rf "$work"; exit 77; }
}
