#!/usr/bin/env bash
# What is installed is the program and its data, nothing else, and it draws from any folder, wherever the tree is moved to.
# usage: install_test.sh BUILD_FOLDER
set -euo pipefail
unset TORRANCE_DATA
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT

cmake --install "$1" --prefix "$tree/first" >/dev/null
mv "$tree/first" "$tree/moved here"
cd "$tree/moved here"

stray=$(find . -type f -not -path './bin/torrance' -not -path './bin/torrance-view' -not -path './lib/*torrance/torrance_openimageio.so' -not -path './share/torrance/shaders/*.glsl' -not -path './share/torrance/shaders/*.h' \
    -not -path './share/torrance/shaders/*.vert' -not -path './share/torrance/shaders/*.frag' \
    -not -path './share/torrance/assets/demo/demo.gltf' -not -path './share/torrance/assets/demo/demo.bin' \
    -not -path './share/torrance/dfg_*.bin' -not -path './share/torrance/assets/demo/*.png' -not -path './share/torrance/assets/environments/*.hdr' \
    -not -path './share/torrance/assets/maps/*.png' -not -path './share/torrance/methods.measured.json' \
    -not -path './share/torrance/chart/page.js' -not -path './share/torrance/chart/page.css' -not -path './share/torrance/chart/vega.js')
[[ -z $stray ]] || { echo "installed, but nobody needs it: $stray"; exit 1; }

mkdir ../elsewhere
cd ../elsewhere
"../moved here/bin/torrance" render demo --resolution 64x48 --output picture.png
[[ $(head -c 4 picture.png | tail -c 3) == PNG ]]
