#!/usr/bin/env bash
# Every line of the client and its tests is typed, strictly, as Python 3.9 has types.
set -euo pipefail
command -v mypy >/dev/null || { echo "mypy is not installed: skipped"; exit 77; }
root="$(cd "$(dirname "$0")/../../.." && pwd)"
cd "$root/clients/python"
cache="$(mktemp -d)"
trap 'rm -rf "$cache"' EXIT
mypy --strict --python-version 3.9 --cache-dir "$cache" -p lares
mypy --strict --python-version 3.9 --cache-dir "$cache" tools/make_types.py
MYPYPATH="$root/clients/python:$root/tests/clients/python" \
  mypy --strict --python-version 3.9 --cache-dir "$cache" "$root"/tests/clients/python/*.py
