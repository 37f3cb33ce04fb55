#!/usr/bin/env python3
"""Holds the sources to the tables of src/README.md: who includes whom, and where each library's headers may appear.

usage: check_layers.py [SOURCE_DIR]     exit code 0: all hold; 1: each violation on a line of its own; 2: the tables are broken
"""

import re
import sys
from pathlib import Path

INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)')
DEPENDS = re.compile(r"torrance_library\(\s*(\w+)(.*?)\)", re.DOTALL)


class BrokenTable(Exception):
    pass


def read_table(readme, kind):
    """The rows `names: values` of the code block called `kind`, as {name: set of values}, in order."""
    block = re.search(rf"^```{kind}\n(.*?)^```", readme, re.DOTALL | re.MULTILINE)
    if not block:
        raise BrokenTable(f"src/README.md: there is no code block called {kind}")
    table = {}
    for row in block.group(1).splitlines():
        names, colon, values = row.partition(":")
        if not colon:
            raise BrokenTable(f"src/README.md: no colon in the row '{row}'")
        for name in names.split():
            table[name] = set(values.split())
    return table


def table_faults(layers, readme, source):
    """What is wrong with the table itself: a cycle, a folder without a row or a paragraph."""
    seen = {"shaders"}
    for folder, allowed in layers.items():
        for name in sorted(allowed - seen):
            yield f"src/README.md: the row of {folder} names {name}, which no row above it describes"
        seen.add(folder)
    for folder in sorted(path.parent.name for path in source.glob("*/CMakeLists.txt")):
        if folder not in layers:
            yield f"src/README.md: no row for src/{folder}"
        if f"\n## {folder}\n" not in readme:
            yield f"src/README.md: no paragraph for src/{folder}"


def is_standard(header):
    """C++'s own headers have neither an extension nor a folder."""
    return "." not in header and "/" not in header


def third_party_fault(header, folder, third_party):
    if is_standard(header):
        return None
    for prefix, folders in third_party.items():
        if header.startswith(prefix):
            return None if folder in folders or "*" in folders else f"<{header}> belongs to {' '.join(sorted(folders))}"
    return f"<{header}> is in no row of the third-party table"


def read_depends(cmake):
    """The folders that a CMakeLists.txt says its library depends on."""
    call = DEPENDS.search(cmake)
    if not call:
        return set()
    depends = re.search(r"\bDEPENDS\b([^A-Z]*)", call.group(2))
    return set(depends.group(1).split()) if depends else set()


def file_faults(path, source, layers, third_party, depends):
    folder = path.relative_to(source).parts[0]
    allowed = layers.get(folder, set())
    own_header = path.with_suffix(".h")
    first = True
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        own, library = match.groups()
        where = f"{path.relative_to(source.parent)}:{number}"
        if first and path.suffix == ".cpp" and own_header.exists() and own != str(own_header.relative_to(source)):
            yield f"{where}: a file includes its own header first, \"{own_header.relative_to(source)}\""
        first = False
        if library:
            fault = third_party_fault(library, folder, third_party)
            if fault:
                yield f"{where}: {fault}"
            continue
        target = own.split("/")[0]
        if "/" not in own:
            yield f"{where}: \"{own}\" is named without its folder"
        elif target != folder and target not in allowed:
            yield f"{where}: {folder} may not include {target}"
        elif target not in (folder, "shaders") and target not in depends:
            yield f"{where}: {folder} includes {target}, which src/{folder}/CMakeLists.txt does not name in DEPENDS"


def violations(root):
    source = root / "src"
    readme = (source / "README.md").read_text(encoding="utf-8")
    layers = read_table(readme, "layers")
    third_party = read_table(readme, "third-party")
    yield from table_faults(layers, readme, source)
    for cmake in sorted(source.glob("*/CMakeLists.txt")):
        folder = cmake.parent.name
        depends = read_depends(cmake.read_text(encoding="utf-8"))
        for name in sorted(depends - layers.get(folder, set())):
            yield f"src/{folder}/CMakeLists.txt: {folder} may not depend on {name}"
        for path in sorted(cmake.parent.rglob("*")):
            if path.suffix in (".h", ".cpp", ".c", ".hpp"):
                yield from file_faults(path, source, layers, third_party, depends)


def main():
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent
    try:
        found = list(violations(root))
    except BrokenTable as fault:
        print(fault)
        return 2
    for line in found:
        print(line)
    print(f"check_layers: {len(found)} violation{'' if len(found) == 1 else 's'}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
