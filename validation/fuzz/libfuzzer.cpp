// SPDX-License-Identifier: MIT
// Entry point of LLVM's libFuzzer (clang++ -fsanitize=fuzzer); see run.sh.
#include <cstdio>
#include <cstdlib>

#include "validation/fuzz/finding.hpp"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    const gno::fuzz::Finding finding = gno::fuzz::examine({data, size});
    if (finding.what.empty()) return 0;
    std::fprintf(stderr, "%s", finding.what.c_str());
    std::abort();
}
