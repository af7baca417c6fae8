#!/usr/bin/env bash
# Every command in a ```sh block of README.md and docs/*.md works as written. Lines that begin with
# ./ are not run here (./start is run by the demonstration session, ./check runs this).
. "$(dirname "$0")/session.sh"
start_server
cd "$session_root" || exit 1
# Blocks of Turtle that begin with "# name.ttl" are files of the reader's.
for document in docs/*.md; do
  awk -v home="$HOME" '/^```turtle$/ {getline; if ($2 ~ /\.ttl$/) file = home "/" $2}
    /^```/ {file = ""; next} file {print > file}' "$document"
done
for document in README.md docs/*.md; do
  while IFS= read -r line; do
    case "$line" in "" | "#"* | "./"* | "git clone"* | "cd "*) continue ;; esac
    code=0
    case "$line" in *"# exit code "*) code="${line##*# exit code }"; code="${code%%[!0-9]*}" ;; esac
    expect "$code" bash -c "set -o pipefail; ${line%%  #*}"
  done < <(awk '/^```sh$/ {on = 1; next} /^```/ {on = 0} on' "$document")
done
