#!/usr/bin/env bash
# install_test.sh BUILD SOURCE WORK: installs the component gnomon of BUILD into WORK, builds a project against it that knows nothing of the source
# tree, and runs it. GLM must not be needed: whoever includes it fails.
set -euo pipefail
build=$1 source=$2 work=$3
rm -rf "$work"
mkdir -p "$work"
cmake --install "$build" --prefix "$work/prefix" --component gnomon > "$work/install.txt"
for file in include/gnomon/core/pass.hpp include/gnomon/top/query_hybrid.glsl include/gnomon/LICENSE \
    share/gnomon/spirv/top/examples/build.comp.spv; do
  test -s "$work/prefix/$file" || { echo "not installed: $file"; exit 1; }
done
mkdir -p "$work/no_glm/glm"
echo '#error "GLM is not there"' > "$work/no_glm/glm/glm.hpp"
cp -r "$source/validation/outside" "$work/outside"
CXXFLAGS="-I$work/no_glm" cmake -S "$work/outside" -B "$work/outside/build" -DCMAKE_PREFIX_PATH="$work/prefix" > "$work/configure.txt"
cmake --build "$work/outside/build" > "$work/build.txt" || { cat "$work/build.txt"; exit 1; }
"$work/outside/build/outside"
