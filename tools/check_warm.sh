#!/usr/bin/env bash
# After `torrance warm`: how many models need nothing compiled by the driver? Each is drawn with a copy of the warmed
# cache, so that none profits from another; a file more in the driver's part of it is something compiled.
#
# usage: check_warm.sh [TORRANCE]     TORRANCE: the program, default build/release/bin/torrance
#   TORRANCE_ASSETS   the folder that is searched for .gltf, .glb and .obj, default ../shared/assets
#   TORRANCE_SHARE    percent of the models that can be drawn which must need nothing, default 90
set -euo pipefail
cd "$(dirname "$0")/.."

assets=${TORRANCE_ASSETS:-../shared/assets}
torrance=${1:-build/release/bin/torrance}
[[ -d $assets ]] || { echo "check_warm: there is no folder $assets; set TORRANCE_ASSETS" >&2; exit 2; }
[[ -x $torrance ]] || { echo "check_warm: there is no program $torrance" >&2; exit 2; }
warmed=${XDG_CACHE_HOME:-$HOME/.cache}/torrance
"$torrance" warm --quiet
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

driver_files() { find "$1" -path '*/mesa_shader_cache/*' -type f ! -name index | wc -l; }
# The folder's name is the same, for Mesa keeps its files by their contents alone.
drawn=0 still=0
before=$(driver_files "$warmed")
while IFS= read -r -d '' model; do
    rm -rf "$work/torrance"
    cp -al "$warmed" "$work/torrance"
    find "$work/torrance" -name index -exec sh -c 'cp "$1" "$1.own" && mv "$1.own" "$1"' _ {} \; # it is written in place
    XDG_CACHE_HOME=$work "$torrance" render "$model" --quiet --resolution 1024x1024 --output "$work/picture.png" 2>/dev/null || continue
    drawn=$((drawn + 1))
    new=$(($(driver_files "$work/torrance") - before))
    if ((new == 0)); then still=$((still + 1)); else echo "$new compiled for $model"; fi
done < <(find "$assets" \( -name '*.gltf' -o -name '*.glb' -o -name '*.obj' \) -print0 | sort -z)

((drawn > 0)) || { echo "check_warm: there is no model under $assets that can be drawn" >&2; exit 2; }
echo "check_warm: $still of $drawn models that can be drawn need nothing compiled"
((100 * still >= ${TORRANCE_SHARE:-90} * drawn))
