#!/usr/bin/env bash
# From a clone to a picture: installs what is missing, builds, fills the caches, renders the demo scene to demo.png.
set -euo pipefail
cd "$(dirname "$0")/.."

phases=()
phase() { # phase NAME COMMAND...: runs the command and notes how long it took
    local name=$1 start
    shift
    start=$(date +%s%N)
    "$@"
    phases+=("$(printf '%-10s %7.1f s' "$name" "$(($(date +%s%N) - start))e-9")")
}

configure() { cmake --preset release; }
build() { cmake --build --preset release; }
warm() { build/release/bin/torrance warm; }
render() { build/release/bin/torrance render demo --resolution 1280x960 --samples 16 --output demo.png; }

phase packages tools/packages.sh
phase configure configure
phase build build
phase warm warm
phase render render

echo
printf '%s\n' "${phases[@]}"
echo "$PWD/demo.png, $(stat -c %s demo.png) bytes, 1280 x 960 pixels"
