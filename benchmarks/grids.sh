#!/usr/bin/env bash
# The rows of `benchmarks/run grids`. Called by it with the build folder.
set -euo pipefail
build="$1"
. benchmarks/rows.sh
heading
rows "$build/benchmarks/grid_bench"
exit "$short"
