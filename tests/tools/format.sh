#!/usr/bin/env bash
# Every C++ source is as clang-format 14 writes it. Other versions format differently: without 14 the test is skipped.
set -euo pipefail
cd "$1"
command -v clang-format-14 >/dev/null || exit 77
find src tests tools -name '*.cpp' -o -name '*.h' | sort | xargs clang-format-14 --dry-run --Werror
