#!/usr/bin/env python3
"""Writes docs/performance.md from the figures that tools/bench.sh has taken, and a chart beside it.

usage: bench_page.py FOLDER PAGE.md
"""
import json
import math
import statistics
import sys
from pathlib import Path

FOLDER, PAGE = Path(sys.argv[1]), Path(sys.argv[2])
MODEL_NOTES = {
    "BoomBoxWithAxes": "16,688 triangles, 5 draws, 5 textures",
    "WaterBottle": "4,510 triangles, 1 draw, 4 textures",
    "MetalRoughSpheresNoTextures": "1,040,409 triangles, 123 draws",
}


def read_json(name):
    path = FOLDER / name
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else None


def read_lines(name):
    path = FOLDER / name
    return [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()] if path.exists() else []


FRAMES = read_lines("frames.jsonl")
BENCH = read_json("bench.json")
GROWTH = read_json("growth.json")
KERNELS = read_json("kernels.json")
KERNEL_NOTES = {
    "mips/colour": "levels of a texture of 2048 x 2048, sRGB: a texel of the finest",
    "mips/data": "the same of plain values",
    "mips/normal": "the same of normals",
    "prefilter": "maps of a panorama of 1024 x 512: a texel of the maps",
    "harmonics": "its spherical harmonics: a texel of the panorama",
    "display": "exposure, tone curve, sRGB, codes of 1024 x 1024: a pixel",
    "encode": "PNG of the same: a pixel",
    "tangents": "MikkTSpace on a sphere: a triangle",
    "culling": "which triangles of a sphere show: a triangle",
}


def figures(who, model, samples, key, run=None, sampling="supersampled"):
    return [f[key] for f in FRAMES if key in f and (f["who"], f["model"], f["samples"]) == (who, model, samples)
            and (run is None or f["run"] == run) and f.get("sampling", sampling) == sampling]


def middle(values):
    return statistics.median(values) if values else None


def digits(value):
    """Three of them, without an exponent."""
    if value is None:
        return "-"
    if value == 0:
        return "0"
    return f"{value:,.{max(0, 2 - math.floor(math.log10(abs(value))))}f}"


def spread(values, form=digits):
    """Median and, in brackets, least and greatest."""
    if not values:
        return "-"
    return f"{form(middle(values))} ({form(min(values))} to {form(max(values))})" if len(values) > 1 else form(values[0])


def table(columns, rows):
    lines = ["| " + " | ".join(columns) + " |", "|" + "---|" * len(columns)]
    return lines + ["| " + " | ".join(row) + " |" for row in rows] + [""]


def keep_order(values):
    return list(dict.fromkeys(values))


def peers():
    return [who for who in keep_order(f["who"] for f in FRAMES) if who != "torrance"]


def best_peer(model, samples, key, run=None):
    known = [(middle(figures(who, model, samples, key, run)), who) for who in peers()]
    known = [pair for pair in known if pair[0] is not None]
    return min(known, default=(None, None))


def against(ours, theirs):
    return "-" if ours is None or theirs is None else f"{ours / theirs:.2f}"


FRAME_TABLES = [
    (1, "supersampled", "One sample"),
    (4, "reconstructed", "4 samples of depth and one shading a pixel, and MSAA 4x of the peers, which is the same"),
    (4, "supersampled", "4 samples, each shaded, and MSAA 4x of the peers"),
]


def frame_tables():
    text = []
    models = keep_order(f["model"] for f in FRAMES)
    for samples, sampling, title in FRAME_TABLES:
        rows = []
        for model in models:
            cpu = figures("torrance", model, samples, "cpu_ms", sampling=sampling)
            wall = figures("torrance", model, samples, "wall_ms", sampling=sampling)
            best, who = best_peer(model, samples, "cpu_ms")
            row = [model, digits(middle(cpu)), digits(middle(wall))]
            if peers():
                row += [f"**{against(middle(cpu), best)}**" if who else "-", who or "-"]
                row += [spread(figures(p, model, samples, "cpu_ms")) for p in peers() if p != "f3d"]
            rows.append(row)
        columns = ["model", "Torrance, CPU ms", "wall ms"]
        if peers():
            columns += ["CPU ratio to the best peer", "best"] + [f"{p}, CPU ms" for p in peers() if p != "f3d"]
        text += [f"### {title}", ""]
        text += table(columns, rows)
    return text


def start_table():
    rows = []
    for model in keep_order(f["model"] for f in FRAMES):
        for who in ["torrance"] + peers():
            first = figures(who, model, 1, "start_s", "first")
            second = figures(who, model, 1, "start_s", "second")
            memory = figures(who, model, 1, "pss_mib", "first")
            if first:
                rows.append([model, who, spread(first), spread(second), spread(memory)])
    text = table(["model", "renderer", "first run, s", "second run, s", "peak PSS, MiB"], rows)
    if not peers():
        return text
    ratios = []
    for model in keep_order(f["model"] for f in FRAMES):
        row = [model]
        for key, run in (("start_s", "first"), ("start_s", "second"), ("pss_mib", "first")):
            best, who = best_peer(model, 1, key, run)
            ours = middle(figures("torrance", model, 1, key, run))
            row.append(f"**{against(ours, best)}** ({who})" if who else "-")
        ratios.append(row)
    return text + ["As ratios to the best peer of each column:", ""] + table(
        ["model", "first run", "second run", "peak PSS"], ratios)


def part_tables():
    """What Torrance's own frame and start consist of."""
    rows, starts = [], []
    for model in keep_order(f["model"] for f in FRAMES):
        lines = [f for f in FRAMES if f["who"] == "torrance" and f["model"] == model and f["samples"] == 1]
        if not lines:
            continue
        names = keep_order(name for line in lines for name in line["passes"])
        parts = ", ".join(f"{name} {digits(middle([x['passes'][name] for x in lines if name in x['passes']]))}"
                          for name in names)
        rows.append([model, parts, digits(middle([x["held_mib"] for x in lines]))])
        names = keep_order(name for line in lines for name in line["start_up"])
        starts.append([model] + [digits(middle([x["start_up"][n] for x in lines])) for n in names])
    return (["Passes of Torrance's frame, each submitted by itself (CPU ms), and what the scene holds in memory:", ""]
            + table(["model", "passes", "held, MiB"], rows)
            + ["Phases of a start with warm caches (wall ms; device and environment once a process):", ""]
            + table(["model"] + names, starts))


def with_prefix(value, unit):
    for factor, prefix in ((1e9, "G"), (1e6, "M"), (1e3, "k"), (1, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n")):
        if abs(value) >= 0.9995 * factor:
            return f"{value / factor:.3g} {prefix}{unit}"
    return f"{value / 1e-9:.2g} n{unit}"


def interval(estimate):
    if estimate["low"] is None or estimate["high"] is None:
        return f"{estimate['median']:.2f}" if estimate["median"] is not None else "-"
    return f"{estimate['median']:.2f} [{estimate['low']:.2f}, {estimate['high']:.2f}]"


VERDICTS = {"none": "does not grow", "at most linear": "at most linear"}


def growth_table():
    rows = []
    for series in GROWTH["series"]:
        for cost in ("frame", "preparation", "memory"):
            c = series[cost]
            slope, unit, scale = (c["bytes_a_unit"], "B", 1.0) if cost == "memory" else (c["ns_a_unit"], "s", 1e-9)
            sure = "" if slope["low"] is None else (
                f" [{with_prefix(slope['low'] * scale, unit)}, {with_prefix(slope['high'] * scale, unit)}]")
            none = c["growth"] == "none"
            rows.append([series["series"], f"{series['sizes'][0]:,.0f} to {series['sizes'][-1]:,.0f}", cost,
                         "-" if none else with_prefix(slope["median"] * scale, unit) + sure,
                         "-" if none else interval(c["exponent"]),
                         VERDICTS.get(c["growth"], f"**{c['growth']}**")])
    return table(["more", "from, to", "cost", "a unit", "exponent at the top", "verdict"], rows)


# The chart: a panel a series, size to the right and milliseconds upwards, both logarithmic.
PANEL, GAP, MARGIN = 200, 34, 46
COLORS = {"frame": "#2a6fb0", "preparation": "#c05a1c"}


def panel(series, left):
    values = {cost: [e["median"] for e in series[cost]["ms"]] for cost in COLORS}
    every = [v for list_ in values.values() for v in list_ if v > 0]
    low, high = math.floor(math.log10(min(every))), math.ceil(math.log10(max(every)))
    first, last = math.log10(series["sizes"][0]), math.log10(series["sizes"][-1])

    def place(size, value):
        x = left + PANEL * (math.log10(size) - first) / (last - first)
        y = MARGIN + PANEL * (high - math.log10(max(value, 10.0 ** low))) / (high - low)
        return f"{x:.1f},{y:.1f}"

    lines = [f'<text x="{left}" y="{MARGIN - 10}" font-weight="bold">{series["series"]}</text>']
    for power in range(low, high + 1):
        y = MARGIN + PANEL * (high - power) / (high - low)
        lines.append(f'<path d="M{left},{y:.1f}h{PANEL}" stroke="#8886"/>'
                     f'<text x="{left - 4}" y="{y + 4:.1f}" text-anchor="end">{10.0 ** power:g}</text>')
    for size, anchor in ((series["sizes"][0], "start"), (series["sizes"][-1], "end")):
        x = left + (0 if anchor == "start" else PANEL)
        lines.append(f'<text x="{x}" y="{MARGIN + PANEL + 16}" text-anchor="{anchor}">{size:,.0f}</text>')
    for cost, color in COLORS.items():
        points = " ".join(place(s, v) for s, v in zip(series["sizes"], values[cost]))
        lines.append(f'<polyline points="{points}" fill="none" stroke="{color}" stroke-width="2"/>')
        lines += [f'<circle cx="{p.split(",")[0]}" cy="{p.split(",")[1]}" r="2.5" fill="{color}"/>'
                  for p in points.split()]
    return lines


def chart():
    width = MARGIN + len(GROWTH["series"]) * (PANEL + GAP)
    height = PANEL + 2 * MARGIN
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" '
             'font-size="11" fill="#888">']
    for i, series in enumerate(GROWTH["series"]):
        lines += panel(series, MARGIN + i * (PANEL + GAP))
    x = MARGIN
    for cost, color in COLORS.items():
        lines.append(f'<text x="{x}" y="{height - 8}" fill="{color}">{cost}, CPU ms</text>')
        x += 150
    return "\n".join(lines + ["</svg>", ""])


def mib(use, kind):
    return f"{use[kind + '_bytes'] / 2**20:.1f}"


def memory_lines():
    text, soak, large = [], read_json("soak.json"), read_json("large.json")
    if soak:
        text.append(f"- {soak['renders']:,} renders in one process, each from its scene to the bytes of a PNG: "
                    f"{mib(soak['after_warm_up'], 'own')} MiB of its own after the first hundred, {mib(soak['at_end'], 'own')} "
                    f"at the end, of them allocated {mib(soak['after_warm_up'], 'allocated')} and "
                    f"{mib(soak['at_end'], 'allocated')} ({100 * soak['growth']:+.2f} %; at most 2 %).")
    if large:
        text.append(f"- A picture of 8192x8192 from the start of the process to the PNG: {large['wall_s']:.1f} s, "
                    f"peak PSS {large['peak_pss_mib']:,.0f} MiB (a copy of the picture is {8192 * 8192 * 16 / 2**20:,.0f} MiB).")
    return text + [""]


def kernel_table():
    rows = []
    for kernel in KERNELS["benchmarks"] if KERNELS else []:
        if kernel.get("aggregate_name") == "median":
            time, memory = kernel["ns_an_item"], kernel["memory_ns_an_item"]
            name = kernel["run_name"]
            rows.append([KERNEL_NOTES.get(name, name), digits(time), digits(memory), digits(time / memory)])
    return table(["kernel: item", "CPU ns an item", "memory alone, ns", "ratio"], rows) if rows else []


def peer_versions():
    package = read_json("peers.json")
    if not package or not peers():
        return []
    names = {"three": "three", "babylon-aniso1": "@babylonjs/core", "playcanvas": "playcanvas", "filament": "filament",
             "khronos": "@khronosgroup/gltf-viewer"}
    known = [f"{names[p]} {package['dependencies'][names[p]]}" for p in peers() if p in names]
    return [f"- Peers: {', '.join(known)} in Chromium on the same driver (ANGLE on Vulkan); VTK and f3d on its OpenGL.", ""]


def measured_with(part, about):
    """Of a part that another program has measured than that of the page's head."""
    program = part.get("program", about["program"])
    return "" if program == about["program"] else f" Measured with {program}."


def page():
    about = BENCH or GROWTH
    rounds = max([len(figures("torrance", f["model"], 1, "cpu_ms")) for f in FRAMES], default=0)
    text = ["# Performance", "",
            "Written by `tools/bench.sh`; do not edit.", "",
            f"- {about['date']}, {about['program']}",
            f"- {about['cores']} cores of {about['processor']}, {about['system']}",
            f"- {about['device']}, {about['driver']}"]
    text += peer_versions() or [""]
    if FRAMES:
        notes = [f"{m}: {MODEL_NOTES[m]}" for m in keep_order(f["model"] for f in FRAMES) if m in MODEL_NOTES]
        text += ["## Frames", "",
                 "CPU ms a frame are those of all threads (for the peers: of all their processes): where the processor draws "
                 "that is the whole cost, and it hardly changes with what else the machine does. 1024x1024, the same model, "
                 "camera, environment and light of 3 lux for all"
                 + (f" ({'; '.join(notes)})" if notes else "") + ". Torrance is measured after every peer, a round after the "
                 f"other; medians of up to {rounds} measurements, of peers with the least and the greatest in brackets.", ""]
        text += frame_tables() + part_tables()
        text += ["## From the start of the process to the picture", "",
                 "First run: with empty caches of shaders and of prefiltered environments; second: with what the first has "
                 "left. Files are in the page cache. PSS is that of the whole process tree.", ""]
        text += start_table()
    if GROWTH:
        chart_file = PAGE.with_name(PAGE.stem + "-growth.svg")
        chart_file.write_text(chart(), encoding="utf-8")
        text += ["## Growth", "",
                 "Scenes made in memory by `torrance bench --growth all`, 1024x1024. A line a + b n is fitted to each of "
                 f"{GROWTH['series'][0]['rounds']} rounds over all sizes; b is their median with its 95 % interval, and so is "
                 "the exponent p of a + b n^p through the three greatest sizes. Super-linear is what lies above 1.15: n log n "
                 "at a thousand does not." + measured_with(GROWTH, about), "",
                 f"![Frame and preparation against size]({chart_file.name})", ""]
        text += growth_table()
    memory = memory_lines()
    if len(memory) > 1:
        text += ["## Memory", ""] + memory
    if kernels := kernel_table():
        text += ["## Kernels", "",
                 "What prepares a picture on the processor, by `bench_kernels`: processor time of all threads, the median of "
                 "five runs. Memory alone is what reading and writing the bytes once would take, at the pace of a copy "
                 "measured in the same run.", ""] + kernels
    return "\n".join(text).rstrip() + "\n"


PAGE.write_text(page(), encoding="utf-8")
