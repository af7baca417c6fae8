#!/usr/bin/env bash
# The rows of `benchmarks/run planning`. Called by it with the build folder.
set -euo pipefail
build="$1"
. benchmarks/rows.sh
heading
for what in match plans ranking repairs; do rows "$build/benchmarks/planning_bench" "$what"; done
if [ -n "${LARES_DATA:-}" ]; then
  rows "$build/benchmarks/urdf_bench" "$LARES_DATA/roboearth/urdf/pr2.urdf"
else
  echo "LARES_DATA is not set: PR2's import is not measured."
fi
# Every plan's tree is valid against its schema and walked through the states of its JSON.
count() { sed -n 's|.*] \([0-9]*\) tests* from.* ran.*|\1|p' <<<"$1"; }
for test in export_test behavior_tree_test; do
  result="$("$build/tests/recipes/$test" 2>&1)" && failed=0 || failed="$(grep -c '^\[  FAILED  \] .*ms)$' <<<"$result")"
  row "$test: behaviour trees against schema and JSON, failures of $(count "$result") tests" == 0 tests "$failed"
done
exit "$short"
