#!/usr/bin/env bash
# Draws the pictures of docs/sources.md: each source system, and every term of source A. The same build draws the same bytes.
#
# usage: make_docs_pictures.sh [TORRANCE [FOLDER]]
set -euo pipefail
cd "$(dirname "$0")/.."
torrance=${1:-build/release/bin/torrance}
folder=${2:-docs/sources}
maps=$(dirname "$torrance")/../share/torrance/assets/maps/worn_copper
mkdir -p "$folder"

drawBefore() { # drawBefore BACKGROUND NAME SIZE OPTIONS...
    "$torrance" render --quiet --primitive sphere -r "$3x$3" --samples 16 --background "$1" --quality 88 -o "$folder/$2.jpg" "${@:4}" >/dev/null
}

draw() { # draw NAME SIZE OPTIONS...
    drawBefore '#000000' "$@"
}

drawIn() { # drawIn ENVIRONMENT NAME SIZE OPTIONS...
    drawBefore environment "${@:2}" --environment "$1" --base-color '#c8503c' --roughness 0.35
}

for preset in phong cook-torrance-beckmann ggx-burley schlick-beckmann smith-r torrance-sparrow-blinn; do
    draw "$preset" 240 --preset "$preset" --base-color '#c8503c' --metallic 0 --roughness 0.35
done
for preset in phong ggx-burley torrance-sparrow-blinn; do
    drawIn studio "$preset-environment" 240 --preset "$preset" --metallic 0
done
drawIn sky phong-refraction 240 --preset phong --parameter refraction=1 --orbit 200,85
drawIn studio ggx-burley-environment-metal 240 --preset ggx-burley --metallic 1
draw ue4-direct 240 --preset ue4-direct --maps "$maps"

for quirk in ue4-direct:double-fresnel schlick-beckmann:double-fresnel ggx-burley:no-cosine \
    cook-torrance-beckmann:pi-denominator cook-torrance-beckmann:energy-sketch; do
    draw "${quirk/:/-}" 160 --preset "${quirk%:*}" --quirk "${quirk#*:}" --base-color '#c8503c' --metallic 0.5 --roughness 0.35
done

drawIn studio phong-reflection 160 --preset phong --parameter reflection=0.25,fresnel-exponent=0
drawIn studio ggx-burley-fresnel-at-view 160 --preset ggx-burley --quirk fresnel-at-view --metallic 0.5

for term in albedo roughness metallic light_intensity half_vector n_dot_l D G1 G V F0 F specular diffuse brdf final; do
    draw "ue4-direct-$term" 128 --preset ue4-direct --maps "$maps" --view "$term"
done
