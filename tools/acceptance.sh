#!/usr/bin/env bash
# Renders real models, small, each in a process of its own: every one is drawn, or refused in one line that names it. None
# crashes or hangs, none is black, none has a pixel that is not finite.
#
# usage: acceptance.sh [TORRANCE]     TORRANCE: the program, default build/release/bin/torrance
#   TORRANCE_ASSETS   the folder that is searched for .gltf, .glb and .obj, default ../shared/assets
#   TORRANCE_JOBS     models at a time, default 2
set -euo pipefail
cd "$(dirname "$0")/.."

assets=${TORRANCE_ASSETS:-../shared/assets}
export TORRANCE=${1:-build/release/bin/torrance}
[[ -d $assets ]] || { echo "acceptance: there is no folder $assets; set TORRANCE_ASSETS" >&2; exit 2; }
[[ -x $TORRANCE ]] || { echo "acceptance: there is no program $TORRANCE" >&2; exit 2; }
work=$(mktemp -d)
export work
trap 'rm -rf "$work"' EXIT

# A black picture: what every other one must differ from.
printf '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 64 +X 64\n' >"$work/black.hdr"
head -c $((64 * 64 * 4)) /dev/zero >>"$work/black.hdr"

check() { # check MODEL: prints one line, "drawn", "refused" or "FAILED" first
    local model=$1 name code=0
    name=$(printf '%s' "$model" | tr -c 'A-Za-z0-9\n' _)
    local picture=$work/$name.exr log=$work/$name.log result=$work/$name.json
    timeout 120 "$TORRANCE" render "$model" --quiet --resolution 64x64 --background '#000000' --output "$picture" 2>"$log" || code=$?
    if ((code == 3)) && [[ $(wc -l <"$log") == 1 ]] && grep -qF "$(basename "$model")" "$log" && [[ ! -e $picture ]]; then
        echo "refused $model: $(cat "$log")"
        return
    fi
    if ((code != 0)); then
        echo "FAILED  $model: exit code $code: $(head -c 500 "$log" | tr '\n' ' ')"
        return
    fi
    "$TORRANCE" compare "$work/black.hdr" "$picture" --quiet --json "$result" 2>"$log" || true
    python3 - "$result" "$model" <<'PYTHON'
import json, sys
measured = json.load(open(sys.argv[1]))
fault = "not finite" if measured["non_finite"] else "black" if measured["rmse"] < 1e-4 else None
print(f"FAILED  {sys.argv[2]}: {fault}" if fault else f"drawn   {sys.argv[2]}")
PYTHON
    rm -f "$picture"
}
export -f check

find "$assets" \( -name '*.gltf' -o -name '*.glb' -o -name '*.obj' \) -print0 | sort -z >"$work/models"
[[ -s $work/models ]] || { echo "acceptance: there is no model under $assets" >&2; exit 2; }
# Each result has a file of its own, so that lines of two processes do not mix.
export results=$work/results
mkdir "$results"
xargs -0 -P "${TORRANCE_JOBS:-2}" -I{} bash -c 'check "$1" >"$(mktemp -p "$results")"' _ {} <"$work/models"

sort "$results"/* | grep -v '^drawn' || true
count() { cat "$results"/* | grep -c "^$1" || true; }
echo "acceptance: $(tr -cd '\0' <"$work/models" | wc -c) models: $(count drawn) drawn, $(count refused) refused, $(count FAILED) failed"
(($(count drawn) + $(count refused) == $(tr -cd '\0' <"$work/models" | wc -c)))
