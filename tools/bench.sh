#!/usr/bin/env bash
# Measures Torrance, and other renderers beside it where they are installed, and writes docs/performance.md. Takes an hour
# with five peers and three models; every figure is taken in turn with those that it is compared with.
#
# usage: bench.sh [TORRANCE [PAGE.md]]     default: build/release/bin/torrance docs/performance.md
#   TORRANCE_PEERS   folder with run.sh, which times other renderers; without it Torrance is measured alone
#   TORRANCE_ASSETS  folder that is searched for the models and the environment; without it the demo scene is measured
#   BENCH_PEERS      which of run.sh's peers, default "three babylon-aniso1 playcanvas filament vtk f3d"
#   BENCH_MODELS     names of .glb files, default "BoomBoxWithAxes WaterBottle MetalRoughSpheresNoTextures"
#   BENCH_ROUNDS     default 3
#   BENCH_FRAMES     of a peer in a round, default 20
#   BENCH_SECONDS    for Torrance's frames in a round, default 5
#   BENCH_PARTS      default "frames growth memory kernels"; figures of parts left out are those of the last run
#   BENCH_WORK       where raw figures are kept, default build/bench
set -euo pipefail
cd "$(dirname "$0")/.."

torrance=$(realpath "${1:-build/release/bin/torrance}")
page=${2:-docs/performance.md}
peers=${BENCH_PEERS:-three babylon-aniso1 playcanvas filament vtk f3d}
models=${BENCH_MODELS:-BoomBoxWithAxes WaterBottle MetalRoughSpheresNoTextures}
parts=${BENCH_PARTS:-frames growth memory kernels}
work=$(realpath -m "${BENCH_WORK:-build/bench}")
size=1024
environment_name=royal_esplanade_1k.hdr
[[ -x $torrance ]] || { echo "bench: there is no program $torrance; build it with cmake --build --preset release" >&2; exit 2; }
mkdir -p "$work"

find_asset() { # find_asset NAME: the first file of this name below TORRANCE_ASSETS; nothing where there is none
    [[ -n ${TORRANCE_ASSETS:-} ]] || return 0
    find "$TORRANCE_ASSETS" -name "$1" -type f -print | sort | head -n 1
}

say() { echo "bench: $*" >&2; }

# One line for each figure of a peer: a process from its start to its picture, then frames in a process that stays.
# peer MODEL ENVIRONMENT SAMPLES PEER RUNS CACHE RUN
peer() {
    local name row
    name=$(basename "$1" .glb)
    row=$(PEERS=$4 RUNS=$5 FRAMES=${BENCH_FRAMES:-20} MSAA=$3 IMAGES=$work/images XDG_CACHE_HOME=$6 \
        "$TORRANCE_PEERS/run.sh" "$1" "$2" "$size" 2>>"$work/peers.log" | grep "^| $4 " || true)
    [[ -n $row ]] || { say "$4 gave no figures for $name, see $work/peers.log"; return 0; }
    awk -F ' *[|] *' -v model="$name" -v samples="$3" -v run="$7" '{
        number = "^[0-9.]+$"
        printf "{\"who\": \"%s\", \"model\": \"%s\", \"samples\": %s, \"run\": \"%s\"", $2, model, samples, run
        if ($4 ~ number) printf ", \"wall_ms\": %s", $4
        if ($6 ~ number) printf ", \"cpu_ms\": %s", $6
        if ($8 ~ number) printf ", \"start_s\": %s, \"start_cpu_s\": %s, \"pss_mib\": %s", $8, $10, $11
        print "}"
    }' <<<"$row" >>"$work/frames.jsonl"
}

# The same of Torrance. ours NAME SAMPLES CACHE RUN INPUT...; RUN is empty where only frames are timed. SAMPLES is a number, and with
# "-reconstructed" behind it one shading a pixel.
ours() {
    local name=$1 cache=$3 run=$4
    local start='{}' samples=${2%-*} sampling=()
    [[ $2 == *-reconstructed ]] && sampling=(--pixel-sampling reconstructed)
    if [[ -n $run ]]; then
        start=$(XDG_CACHE_HOME=$cache tools/measure_process.py "$torrance" render "${@:5}" -r "${size}x$size" \
            --samples "$samples" --quiet -o "$work/images/torrance-$name.png")
    fi
    "$torrance" bench "${@:5}" -r "${size}x$size" --samples "$samples" "${sampling[@]}" --seconds "${BENCH_SECONDS:-5}" --quiet \
        --json "$work/bench.json" >/dev/null
    python3 - "$name" "$2" "$run" "$start" "$work/bench.json" >>"$work/frames.jsonl" <<'PYTHON'
import json, sys
name, samples, run, start, file = sys.argv[1:]
start, bench = json.loads(start), json.load(open(file))
result = bench["results"][0]
line = {"who": "torrance", "model": name, "samples": int(samples.split("-")[0]), "sampling": samples.partition("-")[2] or "supersampled", "run": run,
        "cpu_ms": result["cpu_ms"]["median"], "wall_ms": result["wall_ms"]["median"],
        "held_mib": result["held_mib"], "triangles": result["triangles"],
        "passes": {k: v["cpu_ms"]["median"] for k, v in result["passes"].items()},
        "start_up": {k: v["wall_ms"] for k, v in {**bench["start_up"], **result["start_up"]}.items()}}
if start:
    line |= {"start_s": start["wall_s"], "start_cpu_s": start["cpu_s"], "pss_mib": start["peak_pss_mib"]}
print(json.dumps(line))
PYTHON
}

# Each peer and Torrance after it, first with empty caches, then with those that the first run has left; then several samples.
round_with_peers() { # round_with_peers MODEL ENVIRONMENT
    local name prepared=$work/prepared/$1.glb peer cache
    local drawn=("$prepared" -e "$2" --camera-index 0 --background '#000000')
    name=$(basename "$1")
    for peer in $peers; do
        cache=$(mktemp -d)
        mkdir "$cache/peer" # Mesa makes no parents
        for run in first second; do
            peer "$work/models/$1.glb" "$2" 1 "$peer" 1 "$cache/peer" "$run"
            ours "$name" 1 "$cache/torrance" "$run" "${drawn[@]}"
        done
        rm -rf "$cache"
        [[ $peer == f3d ]] && continue # start to picture only
        peer "$work/models/$1.glb" "$2" 4 "$peer" 0 "$work/cache" ""
        ours "$name" 4 "$work/cache" "" "${drawn[@]}"
        ours "$name" 4-reconstructed "$work/cache" "" "${drawn[@]}"
    done
}

round_alone() { # round_alone NAME INPUT...
    local cache
    cache=$(mktemp -d)
    ours "$1" 1 "$cache" first "${@:2}"
    ours "$1" 1 "$cache" second "${@:2}"
    ours "$1" 4 "$cache" "" "${@:2}"
    ours "$1" 4-reconstructed "$cache" "" "${@:2}"
    rm -rf "$cache"
}

# The model as every peer draws it: with a camera and a light.
prepare() { # prepare MODEL ENVIRONMENT
    local file
    file=$(find_asset "$1.glb")
    [[ -n $file ]] || { say "there is no $1.glb below TORRANCE_ASSETS"; return 1; }
    cp "$file" "$work/models/$1.glb"
    PEERS=' ' RUNS=0 "$TORRANCE_PEERS/run.sh" "$work/models/$1.glb" "$2" "$size" >/dev/null 2>>"$work/peers.log"
    cp "$TORRANCE_PEERS/out/$1.prep.glb" "$work/prepared/$1.glb"
}

measure_frames() {
    local environment model round
    environment=$(find_asset "$environment_name")
    rm -rf "$work/frames.jsonl" "$work/peers.log" "$work/cache"
    mkdir -p "$work/models" "$work/prepared" "$work/images" "$work/cache"
    if [[ -z ${TORRANCE_PEERS:-} || -z $environment ]]; then
        say "without TORRANCE_PEERS and TORRANCE_ASSETS: Torrance alone"
        for ((round = 1; round <= ${BENCH_ROUNDS:-3}; ++round)); do
            say "round $round: demo"
            round_alone demo demo
            for model in $models; do
                [[ -z $(find_asset "$model.glb") ]] || round_alone "$model" "$(find_asset "$model.glb")"
            done
        done
        return
    fi
    for model in $models; do
        prepare "$model" "$environment" || continue
        for ((round = 1; round <= ${BENCH_ROUNDS:-3}; ++round)); do
            say "round $round of ${BENCH_ROUNDS:-3}: $model"
            round_with_peers "$model" "$environment"
        done
    done
    cp "$TORRANCE_PEERS/package.json" "$work/peers.json"
}

measure_growth() {
    say "growth"
    "$torrance" bench --growth all --quiet --json "$work/growth.json" --csv "$work/growth.csv" >/dev/null ||
        say "something grows by more than in proportion"
}

measure_memory() {
    say "memory"
    tools/soak.sh 10000 "$torrance" --primitive cube --json "$work/soak.json" --quiet >/dev/null || say "memory grows"
    tools/measure_process.py "$torrance" render --primitive sphere -r 8192x8192 --quiet -o "$work/large.png" >"$work/large.json"
    rm -f "$work/large.png"
}

# What prepares a picture, kernel by kernel: a program beside torrance in the build tree, where Google Benchmark was found.
measure_kernels() {
    local program
    program=$(dirname "$torrance")/../tools/bench_kernels/bench_kernels
    [[ -x $program ]] || { say "there is no bench_kernels: install libbenchmark-dev and build again"; return; }
    say "kernels"
    "$program" --benchmark_repetitions=5 --benchmark_report_aggregates_only=true --benchmark_out_format=json \
        --benchmark_out="$work/kernels.json" >/dev/null 2>>"$work/kernels.log"
}

for part in $parts; do
    "measure_$part"
done
python3 tools/bench_page.py "$work" "$page"
