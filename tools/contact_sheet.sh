#!/usr/bin/env bash
# Renders every model under a folder into one labelled picture, for the eye. Needs ImageMagick (Debian: imagemagick).
#
# usage: contact_sheet.sh FOLDER SHEET.jpg [TORRANCE [RENDER OPTIONS...]]
set -euo pipefail

(($# >= 2)) || { sed -n '4s/^# //p' "$0" >&2; exit 2; }
command -v montage >/dev/null || { echo "contact_sheet: install imagemagick" >&2; exit 1; }
folder=$1
sheet=$2
torrance=${3:-$(dirname "$0")/../build/release/bin/torrance}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

labelled=()
while IFS= read -r -d '' model; do
    picture=$work/${#labelled[@]}.png
    if "$torrance" render "$model" --quiet --resolution 320x320 --samples 4 --output "$picture" "${@:4}"; then
        labelled+=(-label "$(basename "${model%.*}")" "$picture")
    fi
done < <(find "$folder" \( -name '*.gltf' -o -name '*.glb' -o -name '*.obj' \) -print0 | sort -z)

((${#labelled[@]})) || { echo "contact_sheet: nothing under $folder could be drawn" >&2; exit 1; }
montage "${labelled[@]}" -tile 8x -geometry +4+4 -background '#202020' -fill white -pointsize 15 -quality 88 "$sheet"
