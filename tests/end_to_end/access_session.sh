#!/usr/bin/env bash
# docs/access.md as written, from the first token to the log of writes, and what it must not let pass.
. "$(dirname "$0")/session.sh"
cd "$work" || exit 1
unset LARES_TOKEN LARES_CA
port="$(free_port)"

# Its ```bash blocks are one shell's; the port is this session's.
{
  echo 'set -euo pipefail'
  awk '/^```bash$/ {on = 1; next} /^```/ {on = 0} on' "$session_root/docs/access.md" |
    sed "s/8443/$port/g"
  echo 'echo "the last line was reached"; echo $! >/dev/null; jobs -p >server.pid'
} >session.sh
expect 0 bash session.sh
has "kitchen-bot" "flat-*" "flat-1" "there is no environment 'lab-1'" "revoked" \
  "putEnvironmentVersion" "createToken" "revokeToken" "/v1/environments/flat-1/versions/1" \
  "the last line was reached"
server="$(cat server.pid)"
output="$(lares --version; grep -l "$(cut -d_ -f3 admin.token)" lares-data/* serve.out 2>/dev/null)"
lacks "lares-data"

export LARES_SERVER="https://localhost:$port" LARES_CA="$work/host.pem"
expect 3 lares environment list
has "asks for a token"
expect 3 env LARES_TOKEN=lares_guess lares environment list
has "not known here"
expect 0 lares environment list --token-file robot.token
has "flat-1"
expect 3 lares token list --token-file robot.token
has "takes the role admin"
expect 3 lares recipe put "$session_root/recipes/library/object-search.ttl" --token-file robot.token
expect 3 env -u LARES_CA lares environment list --token-file robot.token
has "--ca FILE"
expect 3 env LARES_SERVER="http://192.0.2.1:80" lares environment list --token-file robot.token
has "is not sent to"
expect 5 lares token revoke "$(cut -d_ -f2 admin.token)" --token-file admin.token
has "the last token of an admin"
# The store is the server's.
expect 5 lares token create --role reader --label late --data lares-data

# A token for seconds.
expect 0 lares token create --role reader --label short --expires 1s --token-file admin.token
lares token create --role reader --label short --expires 2s --token-file admin.token \
  >short.token 2>/dev/null
sleep 2.1
expect 3 lares environment list --token-file short.token
has "expired"
stop_server

# Other machines are not served without tokens, nor without TLS.
mkdir empty
expect 3 lares serve --host 0.0.0.0 --port 0 --data empty
has "there is no TLS"
expect 3 lares serve --host 0.0.0.0 --port 0 --data empty --tls-cert host.pem --tls-key host.key
has "only with tokens" "lares token create --role admin"
expect 3 lares serve --behind-proxy --port 0 --data empty
has "only with tokens"
expect 3 lares serve --host 0.0.0.0 --port 0 --data lares-data
has "there is no TLS"
expect 3 lares serve --host nowhere --port 0 --data lares-data --tls-cert host.pem --tls-key host.key
has "no address to listen on"
expect 3 lares serve --port 0 --data lares-data --tls-cert path.txt --tls-key host.key
has "path.txt"
expect 2 lares serve --port 0 --data lares-data --tls-cert host.pem
expect 5 lares token create --role robot --label x --data empty
has "first token must be an admin's"
