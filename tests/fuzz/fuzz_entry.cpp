// The entry of libFuzzer for one reader, VYBEG_TRY_FILE: stops where a file does what none may.
#include "tests/fuzz/trial.h"

#include <cstdio>
#include <cstdlib>

#ifdef VYBEG_LIBRARY  // what vybeg-reader has for memory; and the libraries leave some of it behind
extern "C" const char* __asan_default_options() {
    return "detect_leaks=0:allocator_may_return_null=1:max_allocation_size_mb=64";
}
#endif

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const vybeg::fuzz::Verdict verdict =
        vybeg::fuzz::VYBEG_TRY_FILE({reinterpret_cast<const char*>(data), size});
    if (!verdict.fault.empty()) {
        std::fprintf(stderr, "%s\n", verdict.fault.c_str());
        std::abort();
    }
    return 0;
}
