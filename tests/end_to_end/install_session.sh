#!/usr/bin/env bash
# What `cmake --install` puts anywhere runs from there, and tells systemd when it is ready.
. "$(dirname "$0")/session.sh"
trap 'rm -rf "$work"; echo "$((checks - failures)) of $checks checks hold"; [ "$failures" = 0 ]; exit' EXIT
build="$(dirname "$LARES_BINARY")/../.."
prefix="$work/prefix"
unset LARES_SHARE
expect 0 cmake --install "$build" --prefix "$prefix"
expect 0 "$prefix/bin/lares" --version && has "lares "
for file in ontology/core.ttl ontology/priors/lares.tsv ontology/aliases.tsv recipes/skills/navigation.ttl \
  recipes/library/patrol.ttl robots/models/scout.ttl; do
  expect 0 test -s "$prefix/share/lares/$file"
done
expect 0 gzip -t "$prefix/share/man/man1/lares.1.gz" "$prefix/share/man/man1/lares-plan-diff.1.gz"
expect 0 bash -n "$prefix/share/bash-completion/completions/lares"
expect 0 test -s "$prefix/share/zsh/vendor-completions/_lares"
expect 0 test -s "$prefix/share/fish/vendor_completions.d/lares.fish"
expect 0 test -s "$prefix/share/doc/lares/install.md"
expect 0 test -s "$prefix/lib/systemd/system/lares.service"

if ! command -v python3 >/dev/null; then
  echo "python3 is not installed: what systemd is told is not checked"
  exit 0
fi
# The protocol as systemd speaks it: a datagram when it is ready, one when it stops.
cat >"$work/supervise.py" <<'PYTHON'
import os, socket, subprocess, sys, urllib.request

binary, folder = sys.argv[1:]
for name in (folder + "/notify", "\0lares-test-%d" % os.getpid()):
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as listener:
        listener.bind(name)
        listener.settimeout(100)
        told = name.replace("\0", "@")
        with open(folder + "/serve.log", "ab") as log:
            server = subprocess.Popen(
                [binary, "serve", "--port", "0", "--data", folder + "/notified"],
                env={**os.environ, "NOTIFY_SOCKET": told}, stdout=log, stderr=log)
        ready = listener.recv(1000).decode().split("\n")
        assert ready[0] == "READY=1", ready
        url = ready[1].rsplit(" ", 1)[1]
        assert b"ready" in urllib.request.urlopen(url + "/readyz").read()
        server.terminate()
        assert listener.recv(1000) == b"STOPPING=1"
        assert server.wait(60) == 0
print("told")
PYTHON
expect 0 python3 "$work/supervise.py" "$prefix/bin/lares" "$work" && has told
# A socket that is none, or nobody's, is no fault.
for path in "$work/nobody" relative "/$(printf 'x%.0s' $(seq 200))"; do
  expect 124 env NOTIFY_SOCKET="$path" timeout 5 "$prefix/bin/lares" serve --port 0 --data "$work/alone" &&
    has "Lares is ready"
done
