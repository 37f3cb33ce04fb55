#!/usr/bin/env bash
# bench_kernels runs all its kernels, and says of each what an item takes and what memory alone would.
#
# usage: bench_kernels_test.sh BENCH_KERNELS
set -euo pipefail

file=$(mktemp)
trap 'rm -f "$file"' EXIT
"$1" --benchmark_min_time=0.001 --benchmark_out_format=json --benchmark_out="$file" >/dev/null
python3 - "$file" <<'PYTHON'
import json, math, sys

kernels = json.load(open(sys.argv[1], encoding="utf-8"))["benchmarks"]
names = {kernel["run_name"] for kernel in kernels}
assert {"mips/colour", "mips/data", "mips/normal", "prefilter", "harmonics", "display", "encode", "tangents", "culling"} <= names, names
for kernel in kernels:
    assert not kernel.get("error_occurred"), kernel
    for figure in ("items", "ns_an_item", "memory_ns_an_item"):
        assert math.isfinite(kernel[figure]) and kernel[figure] > 0, kernel
PYTHON
