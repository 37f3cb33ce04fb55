#!/usr/bin/env python3
"""Draws models under environments to tolerances, and says whether each was kept and what a frame cost.

usage: tolerance_acceptance.py [--torrance PROGRAM] [--environments NAME,...] [--tolerances E,...] [--size WxH]
                               [--page FILE] MODEL...

A tolerance that is not kept is a failure of the choice unless every slot stood at its nearest method: then the exact plan
does not keep it either. Exit code 1 where there is such a failure.
"""
import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile


def parsed():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--torrance", default="build/release/bin/torrance")
    parser.add_argument("--environments", default="studio,sky")
    parser.add_argument("--tolerances", default="5%,1%,0.3%")
    parser.add_argument("--size", default="256x256")
    parser.add_argument("--page", help="write the table to this file, as Markdown")
    parser.add_argument("models", nargs="+")
    return parser.parse_args()


def draw(o, model, environment, tolerance, folder):
    """One picture: what its certificate says, or None where the model cannot be drawn or nothing is seen of it."""
    picture = folder / "picture.png"
    certificate = folder / "picture.png.certificate.json"
    certificate.unlink(missing_ok=True)
    subprocess.run([o.torrance, "render", model, "-e", environment, "-r", o.size, f"--tolerance={tolerance}", "-o",
                    str(picture), "--quiet"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    if not certificate.exists():
        return None
    return json.loads(certificate.read_text())


def percent(number):
    return "unbounded" if number is None else f"{100 * number:.2g} %"


def main():
    o = parsed()
    rows, failures = [], 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for model in o.models:
            for environment in o.environments.split(","):
                for tolerance in o.tolerances.split(","):
                    result = draw(o, model, environment, tolerance, folder)
                    if result is None:
                        continue
                    found, mean = result["tolerance"], result["shading"]["mean"]
                    last = found["trials"][-1]["methods"]
                    specular = last.get("environment_specular", "as asked")
                    samples = last.get("environment_specular_samples")
                    chosen = specular + (f" {samples}" if samples else "")
                    nearest = found["holds"] or found["nearest"]
                    failures += 0 if nearest else 1
                    rows.append((pathlib.Path(model).stem, pathlib.Path(environment).stem, tolerance,
                                 "kept" if found["holds"] else ("out of reach" if nearest else "NOT KEPT"),
                                 f"{percent(mean['value'])} (to {percent(mean['high'])})", chosen,
                                 str(len(found["trials"]))))
                    print(" ".join(rows[-1]), flush=True)
    kept = sum(row[3] == "kept" for row in rows)
    out = sum(row[3] == "out of reach" for row in rows)
    print(f"{kept} of {len(rows)} pictures are within, {out} are out of reach of the nearest methods, {failures} fail")
    if o.page:
        head = ("model", "environment", "tolerance", "", "mean error", "environment_specular", "pictures")
        lines = ["| " + " | ".join(cells) + " |" for cells in (head, ["---"] * len(head), *rows)]
        pathlib.Path(o.page).write_text("\n".join(lines) + "\n")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
