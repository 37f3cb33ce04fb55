#!/usr/bin/env python3
"""Opens the pages of `torrance chart` in a real browser, wide and as narrow as a phone: no error on the console, nothing
asked of a network, every panel drawn, pictures and numbers where the pointer rests on a mark.

usage: chart_page_test.py TORRANCE     exit code 77: there is no Chromium, or no Vega"""
import html
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

BEFORE = """<script>
window.problems = [];
addEventListener("error", e => problems.push(String(e.message)));
addEventListener("unhandledrejection", e => problems.push(String(e.reason)));
for (const level of ["error", "warn"]) console[level] = (...text) => problems.push(text.join(" "));
</script>"""

AFTER = """<script>
setTimeout(() => {
  const report = { problems, panels: [], tip: null };
  report.network = performance.getEntriesByType("resource").map(e => e.name).filter(name => !name.startsWith("data:"));
  report.width = document.documentElement.scrollWidth;
  for (const place of document.querySelectorAll(".chart"))
    report.panels.push({ id: place.id, marks: place.querySelectorAll(".mark-symbol path, .mark-rect.dots path").length,
                         axes: place.querySelectorAll(".role-axis").length,
                         rules: place.querySelectorAll(".mark-rule.limits line").length });
  const dot = document.querySelector(".chart .mark-symbol path"), box = dot.getBoundingClientRect();
  dot.dispatchEvent(new MouseEvent("mousemove", { bubbles: true, clientX: box.x + box.width / 2, clientY: box.y + box.height / 2 }));
  const tip = document.getElementById("tip");
  setTimeout(() => {
    report.tip = { shown: getComputedStyle(tip).display, text: tip.textContent,
                   images: [...tip.querySelectorAll("img")].map(image => image.naturalWidth) };
    const at = tip.getBoundingClientRect();
    report.inside = at.left >= 0 && at.top >= 0 && at.right <= innerWidth;
    document.body.dataset.report = JSON.stringify(report);
  }, 300);
}, 300);
</script></body>"""


def browser():
    for name in ("chromium", "chromium-browser", "google-chrome"):
        if shutil.which(name):
            return name
    return None


def report_of(program, page, width):
    with tempfile.TemporaryDirectory() as profile:
        run = subprocess.run(
            [program, "--headless=new", "--no-sandbox", "--disable-gpu", f"--user-data-dir={profile}",
             f"--window-size={width},900", "--virtual-time-budget=10000", "--timeout=60000", "--dump-dom", page.as_uri()],
            capture_output=True, text=True, timeout=240)
    found = re.search(r'data-report="([^"]*)"', run.stdout)
    assert found, f"{page}: the page did not come to its end: {run.stderr[-2000:]}"
    return json.loads(html.unescape(found.group(1)))


def check(program, page, panels, images, rules):
    text = page.read_text()
    copy = page.with_name("opened_" + page.name)
    copy.write_text(text.replace("<body>", "<body>" + BEFORE, 1).replace("</body>", AFTER, 1))
    for width in (1100, 500):
        report = report_of(program, copy, width)
        where = f"{page.name}, {width} wide: {json.dumps(report)[:1500]}"
        assert not report["problems"], where
        assert not report["network"], where
        assert len(report["panels"]) == panels, where
        assert all(panel["marks"] > 0 and panel["axes"] >= 2 for panel in report["panels"]), where
        assert [panel["rules"] for panel in report["panels"]] == rules, where
        assert report["tip"]["shown"] == "block" and report["tip"]["text"], where
        assert len(report["tip"]["images"]) == images and all(size > 0 for size in report["tip"]["images"]), where
        assert report["inside"] and report["width"] <= width, where


def main():
    torrance = sys.argv[1]
    program = browser()
    if not program:
        print("skipped: there is no Chromium")
        return 77
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for options in (["--slot", "tone,transfer"],
                        ["--primitive", "sphere", "-r", "16x16", "-e", "none", "--light", "directional:direction=-0.3,-1,-1,intensity=3"]):
            subprocess.run([torrance, "chart", "-o", name, "--seconds", "0", "--quiet", *options], check=True)
        if not (folder / "methods.html").exists():
            print("skipped: Torrance was built without Vega")
            return 77
        check(program, folder / "methods.html", panels=2, images=2, rules=[0, 0])
        check(program, folder / "plans.html", panels=3, images=2, rules=[0, 1, 0])  # of the standard tolerance, in the panel of shading
    return 0


if __name__ == "__main__":
    sys.exit(main())
