#!/bin/sh
# SPDX-License-Identifier: MIT
# run.sh [MINUTES]: fuzzes the TOP tree on the CPU, one core, MINUTES long (default 10), with libFuzzer where clang++ is, else with gnomon-fuzz.
# Starts from the kept corpus; a finding ends it with exit code 1 and is written to build-libfuzzer/finding-*. To keep one: copy it into corpus/.
set -eu
minutes=${1:-10}
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
build="$root/build-libfuzzer"
mkdir -p "$build/pool"
sources="$here/examine.cpp $here/scene_from_bytes.cpp $root/validation/support/top_on_cpu_check.cpp $root/validation/support/top_variants.cpp"
flags="-std=c++20 -O2 -g -I$root -ffp-contract=off -frounding-math"
tree="-DGNO_TOP_STACK_SIZE=3 -DGNO_TOP_SHORT_STACK_SIZE=2 $root/validation/support/top_on_cpu.cpp"
echo "fuzzing for $minutes minutes; folder $build"
if command -v clang++ > /dev/null; then
    # shellcheck disable=SC2086
    clang++ $flags -fsanitize=fuzzer,undefined -fno-sanitize-recover=undefined -DGNO_TOP_VARIANT='"short stacks"' \
        $sources "$here/libfuzzer.cpp" $tree -o "$build/gnomon-libfuzzer"
    "$build/gnomon-libfuzzer" -max_total_time=$((minutes * 60)) -max_len=1024 -timeout=10 -print_final_stats=1 -verbosity=1 \
        -artifact_prefix="$build/finding-" "$build/pool" "$here/corpus" 2>&1 | tee "$build/log.txt" | grep -v '^#.*\(NEW\|REDUCE\)' || true
    if ls "$build"/finding-* > /dev/null 2>&1; then
        echo "finding: $(ls "$build"/finding-*)"
        exit 1
    fi
else
    # shellcheck disable=SC2086
    c++ $flags -DGNO_TOP_VARIANT='"short stacks"' $sources "$here/main.cpp" $tree -o "$build/gnomon-fuzz"
    "$build/gnomon-fuzz" --corpus "$here/corpus" --seconds $((minutes * 60)) --seed "$(date +%s)" --keep "$build/finding-1"
fi
