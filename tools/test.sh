#!/usr/bin/env bash
# Installs what is missing, builds, runs every test. CTest's own summary is the last thing printed.
set -euo pipefail
cd "$(dirname "$0")/.."

tools/packages.sh
cmake --preset dev
cmake --build --preset dev
exec ctest --preset dev -j2
