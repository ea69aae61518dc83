#!/usr/bin/env bash
# The overnight check: more than 10^8 view samples against the exact oracle, and adversarial scenes against brute force; all must be right.
#   validation/long_run.sh [SIZE [FUZZ_SECONDS]]        default 1024x1024 600; writes out/long_run/*.jsonl and a summary on standard output
# Paths: every fourth frame of two scenes, all lights, every certified technique. Adversarial: hard cases over 8 insertion orders, their test on all
# rungs and orders at subgroup widths 4, 8 and 16, and the fuzzer.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
size=${1:-1024x1024}
seconds=${2:-600}
[ "${GNOMON_MINIMAL:-0}" != 1 ] || { echo "long_run.sh: this needs everything: unset GNOMON_MINIMAL" >&2; exit 2; }
. host_min/setup.sh
cmake -G Ninja -B build -DCMAKE_BUILD_TYPE=Release "${gnomon_cmake_options[@]}" > /dev/null
cmake --build build --target gnomon gnomon-scenes gnomon-hard-cases gnomon-fuzz hard_cases_test
out=out/long_run
mkdir -p "$out"
rm -f "$out"/*.jsonl
build/bin/gnomon-scenes make playground --out "$out" > /dev/null
sum() { grep -ho "\"$1\": *[0-9]*" "$out"/*.jsonl | awk -F: '{ total += $2 } END { printf "%d", total }'; }
for scene in scenes/show_garden.glb "$out/playground.glb"; do
  for frame in $(seq 0 4 56); do
    build/bin/gnomon shade "$scene" --technique all --precision certified --light all --frame "$frame" --size "$size" --check --no-pictures \
      --json "$out/$(basename "$scene" .glb)-$frame.jsonl" > /dev/null
    echo "$(basename "$scene" .glb) frame $frame: $(sum checked) checked so far, $(sum wrong) wrong"
  done
done
build/bin/gnomon-hard-cases > "$out/hard_cases.md"
GNOMON_LONG=1 ctest --test-dir build -R '^hard_cases_test' --timeout 7200 --output-on-failure  # every rung, 8 orders, three subgroup widths
build/bin/gnomon-fuzz --seconds "$seconds" --seed "${GNOMON_SEED:-1}" | tee "$out/fuzz.txt" | tail -n 3
echo "view samples checked: $(sum checked), wrong: $(sum wrong), leaks: $(sum leaks), self: $(sum self)"
echo "hard cases: $out/hard_cases.md; fuzzing: $out/fuzz.txt"
[ "$(sum wrong)" = 0 ]
