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

draw() { # draw NAME SIZE OPTIONS...
    "$torrance" render --quiet --primitive sphere -r "$2x$2" --samples 16 --background '#000000' --quality 88 -o "$folder/$1.jpg" "${@:3}" >/dev/null
}

for preset in phong cook-torrance-beckmann ggx-burley schlick-beckmann smith-r torrance-sparrow-blinn; do
    draw "$preset" 240 --preset "$preset" --base-color '#c8503c' --metallic 0 --roughness 0.35
done
draw ue4-direct 240 --preset ue4-direct --maps "$maps"

for quirk in ue4-direct:double-fresnel schlick-beckmann:double-fresnel ggx-burley:no-cosine \
    cook-torrance-beckmann:pi-denominator cook-torrance-beckmann:energy-sketch; do
    draw "${quirk/:/-}" 160 --preset "${quirk%:*}" --quirk "${quirk#*:}" --base-color '#c8503c' --metallic 0.5 --roughness 0.35
done

for term in albedo roughness metallic light_intensity half_vector n_dot_l D G1 G V F0 F specular diffuse brdf final; do
    draw "ue4-direct-$term" 128 --preset ue4-direct --maps "$maps" --view "$term"
done
