#!/usr/bin/env bash
# Installs the Debian packages that are missing. Their names stand after "# debian:" in third_party_cmake/dependencies.cmake.
set -euo pipefail
cd "$(dirname "$0")/.."

mapfile -t wanted < <(sed -n 's/.*# debian: *//p' third_party_cmake/dependencies.cmake | tr -s ' ' '\n')

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "packages: this is no Debian system; install the equivalents of: ${wanted[*]}" >&2
    exit 0
fi

missing=()
for package in "${wanted[@]}"; do
    state=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
    [[ $state == installed ]] || missing+=("$package")
done

if ((${#missing[@]} == 0)); then
    echo "packages: all ${#wanted[@]} are installed"
    exit 0
fi
echo "packages: missing ${missing[*]}"

as_root=()
if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
        echo "packages: run as root: apt-get install ${missing[*]}" >&2
        exit 1
    fi
    as_root=(sudo)
fi
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
