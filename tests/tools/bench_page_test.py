#!/usr/bin/env python3
"""tools/bench_page.py takes medians over rounds, ratios to the best peer, and says what is not there.

usage: bench_page_test.py SOURCE_DIR
"""

import json
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree
from pathlib import Path

SCRIPT = Path(sys.argv.pop(1)) / "tools" / "bench_page.py"

ABOUT = {"date": "1967-05-01", "program": "torrance 0", "processor": "Z80", "cores": 2, "system": "CP/M",
         "device": "llvmpipe", "driver": "Mesa 22"}


def ours(run, cpu, start=None):
    line = {"who": "torrance", "model": "Teapot", "samples": 1, "run": run, "cpu_ms": cpu, "wall_ms": cpu / 2,
            "held_mib": 10, "passes": {"surfaces": cpu}, "start_up": {"load": 3}}
    return line | ({"start_s": start, "pss_mib": 100} if start else {})


def peer(who, run, cpu, start=None):
    line = {"who": who, "model": "Teapot", "samples": 1, "run": run, "cpu_ms": cpu, "wall_ms": cpu / 2}
    return line | ({"start_s": start, "pss_mib": 400} if start else {})


# Medians: ours 60, three 120, vtk 240 ms; starts 0.5 s of ours, first 4 s of three and 5 s of vtk.
FRAMES = [ours("first", 70, 0.5), ours("second", 50, 0.2), ours("", 60),
          peer("three", "first", 100, 4), peer("three", "second", 120, 4), peer("three", "", 140),
          peer("vtk", "first", 240, 5), peer("vtk", "second", 240, 2), peer("vtk", "", 240)]


def estimate(value, sure=True):
    return {"median": value, "low": 0.9 * value if sure else None, "high": 1.1 * value if sure else None, "count": 9}


def cost(values, slope, kind, sure=True):
    unit = {"ns_a_unit": estimate(slope, sure)} | {"ms": [estimate(v, sure) for v in values]}
    return unit | {"bytes_a_unit": estimate(slope, sure), "exponent": estimate(1.0, sure), "growth": kind}


GROWTH = ABOUT | {"series": [{"series": "lights", "unit": "light", "rounds": 9, "sizes": [1, 16, 256], "draws": [1, 1, 1],
                              "frame": cost([10, 25, 265], 1e6, "at most linear"), "preparation": cost([1, 1, 1], 1, "none"),
                              "memory": cost([5, 5, 5], 48, "super-linear")}]}


def page(files):
    """The page, and the chart where there is one."""
    with tempfile.TemporaryDirectory() as folder:
        for name, content in files.items():
            (Path(folder) / name).write_text(content, encoding="utf-8")
        subprocess.run([sys.executable, SCRIPT, folder, Path(folder) / "page.md"], check=True)
        chart = Path(folder) / "page-growth.svg"
        return (Path(folder) / "page.md").read_text(encoding="utf-8"), chart.read_text() if chart.exists() else None


def lines(values):
    return "".join(json.dumps(value) + "\n" for value in values)


class BenchPage(unittest.TestCase):
    def test_compares_with_the_best_peer(self):
        text, _ = page({"frames.jsonl": lines(FRAMES), "bench.json": json.dumps(ABOUT)})
        self.assertIn("2 cores of Z80, CP/M", text)
        self.assertIn("1967-05-01", text)
        self.assertIn("| Teapot | 60.0 | 30.0 | **0.50** | three | 120 (100 to 140) | 240 (240 to 240) |", text)
        self.assertIn("| Teapot | three | 4.00 | 4.00 | 400 |", text)
        # 0.5 s to the 4 s of three, 0.2 s to the 2 s of vtk, 100 MiB to 400
        self.assertRegex(text, r"\| Teapot \| \*\*0\.12\*\* \(three\) \| \*\*0\.10\*\* \(vtk\) \| \*\*0\.25\*\* \(three\) \|")

    def test_stands_without_peers(self):
        text, _ = page({"frames.jsonl": lines(FRAMES[:3]), "bench.json": json.dumps(ABOUT)})
        self.assertIn("| Teapot | 60.0 | 30.0 |\n", text)
        self.assertNotIn("ratio", text)
        self.assertNotIn("## Growth", text)

    def test_charts_growth(self):
        text, chart = page({"growth.json": json.dumps(GROWTH)})
        self.assertIn("| lights | 1 to 256 | frame | 1 ms [900 µs, 1.1 ms] | 1.00 [0.90, 1.10] | at most linear |", text)
        self.assertIn("| lights | 1 to 256 | preparation | - | - | does not grow |", text)
        self.assertIn("| **super-linear** |", text)
        self.assertIn("(page-growth.svg)", text)
        lines_drawn = [e for e in xml.etree.ElementTree.fromstring(chart).iter() if e.tag.endswith("polyline")]
        self.assertEqual(len(lines_drawn), 2)
        self.assertNotIn("Measured with", text)
        later = GROWTH | {"program": "torrance 1"}
        text, _ = page({"frames.jsonl": lines(FRAMES), "bench.json": json.dumps(ABOUT), "growth.json": json.dumps(later)})
        self.assertIn("Measured with torrance 1.", text)

    def test_says_what_memory_does(self):
        soak = {"renders": 10000, "growth": 0.01, "after_warm_up": {"own_bytes": 2**20, "allocated_bytes": 2**19},
                "at_end": {"own_bytes": 1.01 * 2**20, "allocated_bytes": 2**19}}
        text, _ = page({"growth.json": json.dumps(GROWTH), "soak.json": json.dumps(soak)})
        self.assertIn("10,000 renders", text)
        self.assertIn("+1.00 %", text)

    def test_puts_kernels_beside_memory(self):
        def kernel(aggregate, time):
            return {"run_name": "display", "aggregate_name": aggregate, "ns_an_item": time, "memory_ns_an_item": 2}
        kernels = {"benchmarks": [kernel("mean", 9), kernel("median", 5), kernel("stddev", 1)]}
        text, _ = page({"growth.json": json.dumps(GROWTH), "kernels.json": json.dumps(kernels)})
        self.assertRegex(text, r"1024 x 1024: a pixel \| 5\.00 \| 2\.00 \| 2\.50 \|")
        self.assertNotIn("9.00", text)


unittest.main()
