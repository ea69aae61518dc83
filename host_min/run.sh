#!/usr/bin/env bash
# Installs what is missing, builds Release into build/, and shades the default scene with every technique into out/: pictures, records, one table.
# GNOMON_MINIMAL=1 does the same without the oracle, and so without VTK, CGAL, Embree and Chromium: the first picture comes sooner, `--check` is
# refused.
# Arguments are handed to `gnomon shade`: ./host_min/run.sh --size 512x512 --check, or ./host_min/run.sh my.glb --technique d-hybrid
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. host_min/setup.sh
cmake -G Ninja -B build -DCMAKE_BUILD_TYPE=Release "${gnomon_cmake_options[@]}" ${GNOMON_CMAKE_ARGS:-} > /dev/null
cmake --build build --target gnomon ${GNOMON_BUILD_ARGS:-}
scene=scenes/show_garden.glb
if [ $# -gt 0 ] && [[ "$1" != -* ]]; then scene=$1; shift; fi
has() { local wanted=$1 given; shift; for given in "$@"; do [[ "$given" == "$wanted" || "$given" == "$wanted="* ]] && return 0; done; return 1; }
has --technique "$@" || set -- --technique all "$@"
has --out "$@" || set -- --out out "$@"
mkdir -p out
has --json "$@" || set -- --json out/record.jsonl "$@"
build/bin/gnomon shade "$scene" "$@"
echo "pictures and EXR layers are in out/, the record in out/record.jsonl (unless you chose other places)"
