#!/usr/bin/env python3
"""Draws models under environments to tolerances, and says whether each was kept and what a frame cost.

usage: tolerance_acceptance.py [--torrance PROGRAM] [--environments NAME,...] [--tolerances E,...] [--size WxH]
                               [--seconds S] [--no-frames] [--page FILE] MODEL...

A tolerance that is not kept is a failure of the choice unless every slot stood at its nearest method: then the exact plan
does not keep it either. Exit code 1 where there is such a failure. A case that takes longer than --seconds is ended, and
said to be; it is no failure. A line is printed for each case: its mean error (and its interval's end), the methods that were
found, how many pictures it took and CPU ms a frame, which --no-frames leaves out. The page has a table for each tolerance, and says for each two of them
how much longer the nearer takes a frame, by models.
"""
import argparse
import collections
import itertools
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile


def parsed():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--torrance", default="build/release/bin/torrance")
    parser.add_argument("--environments", default="studio,sky")
    parser.add_argument("--tolerances", default="5%,1%,0.3%")
    parser.add_argument("--size", default="256x256")
    parser.add_argument("--seconds", type=float, default=600, help="the most that a picture may take")
    parser.add_argument("--no-frames", action="store_true", help="do not measure what a frame costs")
    parser.add_argument("--page", help="write the table to this file, as Markdown")
    parser.add_argument("models", nargs="+")
    return parser.parse_args()


def draw(o, model, environment, tolerance, folder):
    """One picture: what its certificate says, or None where the model cannot be drawn or nothing is seen of it. Throws
    subprocess.TimeoutExpired."""
    picture = folder / "picture.png"
    certificate = folder / "picture.png.certificate.json"
    certificate.unlink(missing_ok=True)
    subprocess.run([o.torrance, "render", model, "-e", environment, "-r", o.size, f"--tolerance={tolerance}", "-o",
                    str(picture), "--quiet"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False,
                   timeout=o.seconds)
    if not certificate.exists():
        return None
    return json.loads(certificate.read_text())


def option(name):
    """The option of a member of a trial's methods: slots by their names, numbers of directions by whose they are."""
    samples = {"environment_specular_samples": "environment-samples", "area_light_samples": "light-samples"}
    return samples.get(name, name.replace("_", "-"))


def frame_ms(o, model, environment, methods, of_materials):
    """CPU ms a frame over all threads: the median of a few."""
    options = [f"--{option(name)}={value}" for name, value in methods.items()]
    options += [f"--material-methods={text}" for text in of_materials]
    bench = subprocess.run([o.torrance, "bench", model, "-e", environment, "-r", o.size, *options, "--frames=9",
                            "--seconds=2", "--quiet", "--json=-"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                           check=True)
    return json.loads(bench.stdout)["results"][0]["cpu_ms"]["median"]


def pay_off(rows, tolerances):
    """Of pictures of one model and environment: how much longer a frame takes within the next tolerance."""
    frames = {(row["model"], row["environment"], row["tolerance"]): row["ms"] for row in rows if row["ms"]}
    lines = []
    for far, near in itertools.combinations(tolerances, 2):
        ratios = {}
        for model, environment, tolerance in frames:
            if tolerance == far and (model, environment, near) in frames:
                ratios.setdefault(model, []).append(frames[model, environment, near] / frames[model, environment, far])
        medians = [statistics.median(of) for of in ratios.values()]
        if medians:
            lines.append(f"a frame within {near} takes {statistics.median(medians):.3g} times as long as one within {far} "
                         f"on the median of {len(medians)} models ({min(medians):.3g} to {max(medians):.3g})")
    return lines


def percent(number):
    return "unbounded" if number is None else f"{100 * number:.2g} %"


COLUMNS = ["model", "environment", "tolerance", "verdict", "mean", "specular", "filter", "pictures", "ms"]


def row_of(o, model, environment, tolerance, result):
    found, mean = result["tolerance"], result["shading"]["mean"]
    last = found["trials"][-1]["methods"]
    samples = last.get("environment_specular_samples")
    cheaper = result["plan"]["of_materials"]
    return {"model": model_name(model), "environment": pathlib.Path(environment).stem, "tolerance": tolerance,
            "verdict": "kept" if found["holds"] else ("out of reach" if found["nearest"] else "NOT KEPT"),
            "mean": f"{percent(mean['value'])} (to {percent(mean['high'])})",
            "specular": last.get("environment_specular", "as asked") + (f" {samples}" if samples else "") +
            (f", cheaper for {len(cheaper)}" if cheaper else ""),
            "filter": last.get("texture_filter", ""), "pictures": len(found["trials"]),
            "ms": None if o.no_frames else frame_ms(o, model, environment, last, cheaper)}


def model_name(model):
    """Files of one name in folders of their own are told apart by these."""
    path = pathlib.Path(model)
    return path.stem if path.stem == path.parent.name else f"{path.parent.name}/{path.stem}"


def text_of(row):
    return [f"{row[key]:.3g}" if isinstance(row[key], float) else str(row[key] or "-") for key in COLUMNS]


def table_of(rows, tolerance):
    """Models by environments: mean error and the specular method, and the verdict where it is not "kept"."""
    cells = {(row["model"], row["environment"]): f"{row['mean'].split(' (')[0]}, {row['specular']}" +
             ("" if row["verdict"] == "kept" else f", **{row['verdict']}**") for row in rows if row["tolerance"] == tolerance}
    environments = list(dict.fromkeys(environment for _, environment in cells))
    models = list(dict.fromkeys(model for model, _ in cells))
    table = [[f"within {tolerance}", *environments], ["---"] * (1 + len(environments)),
             *([model, *(cells.get((model, environment), "") for environment in environments)] for model in models)]
    return ["", *("| " + " | ".join(line) + " |" for line in table)]


def main():
    o = parsed()
    rows, ended = [], 0
    tolerances = o.tolerances.split(",")
    with tempfile.TemporaryDirectory() as name:
        for model, environment, tolerance in itertools.product(o.models, o.environments.split(","), tolerances):
            try:
                result = draw(o, model, environment, tolerance, pathlib.Path(name))
            except subprocess.TimeoutExpired:
                print(f"{model_name(model)} {pathlib.Path(environment).stem} {tolerance} ended", flush=True)
                ended += 1
                continue
            if result is None:
                continue
            rows.append(row_of(o, model, environment, tolerance, result))
            print(" ".join(text_of(rows[-1])), flush=True)
    count = collections.Counter(row["verdict"] for row in rows)
    summary = [f"{count['kept']} of {len(rows)} pictures are within, {count['out of reach']} are out of reach of the nearest "
               f"methods, {count['NOT KEPT']} fail, {ended} took too long", *pay_off(rows, tolerances)]
    print("\n".join(summary))
    if o.page:
        lines = [*(f"- {line}" for line in summary), *(line for tolerance in tolerances for line in table_of(rows, tolerance))]
        pathlib.Path(o.page).write_text("\n".join(lines) + "\n")
    return 1 if count["NOT KEPT"] else 0


if __name__ == "__main__":
    sys.exit(main())
