#!/usr/bin/env bash
# The generator writes the same bytes again, on one thread, as it wrote for the build on all.
# usage: same_assets.sh MAKE_ASSETS BUILT_FOLDER
set -euo pipefail
again=$(mktemp -d)
trap 'rm -rf "$again"' EXIT
TORRANCE_THREADS=1 "$1" "$again"
diff -r --exclude=made "$again" "$2"
