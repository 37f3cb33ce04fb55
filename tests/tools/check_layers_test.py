#!/usr/bin/env python3
"""tools/check_layers.py finds a violation of each kind, planted in a small tree of its own.

usage: check_layers_test.py SOURCE_DIR
"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(sys.argv.pop(1)) / "tools" / "check_layers.py"

README = """
```layers
low:
middle: low
high:   low middle
```

```third-party
png.h: low
fmt/:  *
```

## low
## middle
## high
"""

CLEAN = {
    "src/README.md": README,
    "src/low/CMakeLists.txt": "torrance_library(low LIBRARIES PNG::PNG)",
    "src/low/a.h": "#include <vector>\n",
    "src/low/a.cpp": '#include "low/a.h"\n#include <png.h>\n#include <fmt/format.h>\n',
    "src/middle/CMakeLists.txt": "torrance_library(middle DEPENDS low)",
    "src/middle/b.h": '#include "low/a.h"\n',
    "src/high/CMakeLists.txt": "torrance_library(high DEPENDS low)",
    "src/high/c.cpp": '#include "low/a.h"\n',
}


def check(changes):
    """Exit code and output of the script over the clean tree with `changes` made to it."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in {**CLEAN, **changes}.items():
            path = Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        run = subprocess.run([sys.executable, SCRIPT, folder], capture_output=True, text=True, check=False)
        return run.returncode, run.stdout


class CheckLayers(unittest.TestCase):
    def expect(self, changes, message):
        code, output = check(changes)
        self.assertEqual(code, 1, output)
        self.assertIn(message, output)
        self.assertIn("1 violation\n", output)

    def test_clean_tree(self):
        code, output = check({})
        self.assertEqual(code, 0, output)

    def test_include_upwards(self):
        self.expect({"src/low/d.h": '#include "high/c.h"\n'}, "src/low/d.h:1: low may not include high")

    def test_include_not_in_depends(self):
        self.expect({"src/high/d.h": '#include "middle/b.h"\n'}, "src/high/CMakeLists.txt does not name in DEPENDS")

    def test_depends_upwards(self):
        self.expect({"src/low/CMakeLists.txt": "torrance_library(low DEPENDS high)"}, "low may not depend on high")

    def test_library_out_of_its_folder(self):
        self.expect({"src/high/d.cpp": "#include <png.h>\n"}, "<png.h> belongs to low")

    def test_unknown_library(self):
        self.expect({"src/low/d.cpp": "#include <vulkan/vulkan.h>\n"}, "is in no row of the third-party table")

    def test_own_header_first(self):
        self.expect({"src/low/a.cpp": '#include <vector>\n#include "low/a.h"\n'}, "includes its own header first")

    def test_header_without_folder(self):
        self.expect({"src/low/a.cpp": '#include "low/a.h"\n#include "e.h"\n'}, "named without its folder")

    def test_cycle_in_the_table(self):
        self.expect({"src/README.md": README.replace("low:\n", "low: high\n")}, "the row of low names high")

    def test_folder_without_paragraph(self):
        self.expect({"src/README.md": README.replace("## low\n", "")}, "no paragraph for src/low")

    def test_missing_table(self):
        code, output = check({"src/README.md": README.replace("```layers", "```")})
        self.assertEqual(code, 2, output)


if __name__ == "__main__":
    unittest.main()
