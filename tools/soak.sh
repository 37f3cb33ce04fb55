#!/usr/bin/env bash
# Renders many pictures in one process, each from its scene to the bytes of a PNG, and fails where the process's memory
# grows by more than 2 % after the first hundred.
#
# usage: soak.sh [N [TORRANCE [BENCH OPTIONS...]]]     default: 10000 build/release/bin/torrance --primitive cube
set -euo pipefail
cd "$(dirname "$0")/.."

renders=${1:-10000}
torrance=${2:-build/release/bin/torrance}
options=("${@:3}")
((${#options[@]})) || options=(--primitive cube)
exec "$torrance" bench --soak "$renders" -r 64x64 "${options[@]}"
