#!/usr/bin/env bash
# Installs what is missing, builds Release into build/, and runs every test through ctest. Arguments are handed to ctest: ./validation/run.sh -R top
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
[ "${GNOMON_MINIMAL:-0}" != 1 ] || { echo "validation/run.sh: the tests need everything: unset GNOMON_MINIMAL" >&2; exit 2; }
. host_min/setup.sh
cmake -G Ninja -B build -DCMAKE_BUILD_TYPE=Release "${gnomon_cmake_options[@]}" ${GNOMON_CMAKE_ARGS:-} > /dev/null
cmake --build build ${GNOMON_BUILD_ARGS:-}
export MESA_SHADER_CACHE_DIR="${MESA_SHADER_CACHE_DIR:-$PWD/build/shader_cache}"  # pipelines are compiled once, not once a test
mkdir -p "$MESA_SHADER_CACHE_DIR"
log=build/ctest-times.txt
status=0
ctest --test-dir build --output-on-failure --no-tests=error -j "$(nproc)" --output-log "$log" "$@" || status=$?
echo "slowest tests:"
sed -n 's/^ *[0-9]*\/[0-9]* Test *#[0-9]*: \([^ ]*\) .* \([0-9.]*\) sec.*/\2 s  \1/p' "$log" | sort -rn | sed -n 1,8p
sed -n '/tests passed/,$p' "$log" | grep -E 'tests passed|Total Test time' || true
exit $status
