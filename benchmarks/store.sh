#!/usr/bin/env bash
# The rows of `benchmarks/run store`. Called by it with the build folder.
# LARES_KILLS (500), LARES_UPLOAD_MB (1024), LARES_SOAK_MINUTES (30) make it shorter.
set -euo pipefail
build="$1"
lares="$build/server/cli/lares"
work="$(mktemp -d)"
trap clean_up EXIT
export LARES_SHARE="$PWD"
. benchmarks/rows.sh
heading

# A test program as a row: its failures, of how many tests.
tests_row() {
  local what="$1" program="$2" filter="$3" result failed ran
  result="$("$build/tests/server/$program" --gtest_filter="$filter" 2>&1)" || true
  failed="$(grep -c '^\[  FAILED  \] .*ms)$' <<<"$result" || true)"
  ran="$(sed -n 's|.*] \([0-9]*\) tests* from.* ran.*|\1|p' <<<"$result")"
  [ -n "$ran" ] || failed=1
  row "$what$(sed -n 's|^\([0-9]* kills, .*\)|: \1|p' <<<"$result" | head -n 1), failures" == 0 tests "$failed"
}

TMPDIR=/dev/shm rows "$build/benchmarks/store_bench" find 100000
export LARES_KILLS="${LARES_KILLS:-500}"
tests_row "ledger over kill -9" store_kill_test 'StoreKillTest.Every*'
tests_row "two processes over one PostgreSQL, one killed" store_kill_test 'StoreKillTest.Two*'
tests_row "ledger over dropped unsynced writes, short writes, failing calls" store_fault_test '*'
tests_row "route × role × foreign id" access_matrix_test '*'
rows "$build/benchmarks/store_bench" uploads "$lares" "${LARES_UPLOAD_MB:-1024}" 16
serve; ready
rows "$build/benchmarks/store_hostile" "$port"
stop
rows "$build/benchmarks/store_bench" soak "$lares" "${LARES_SOAK_MINUTES:-30}"
exit "$short"
