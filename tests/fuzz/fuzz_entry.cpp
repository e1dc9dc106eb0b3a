// The entry of libFuzzer for the reader that VYBEG_FORMAT names: stops where a file does what none
// may.
#include "tests/fuzz/trial.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace {

vybeg::fuzz::TryFile reader;

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
    const char* const format = std::getenv("VYBEG_FORMAT");
    reader = vybeg::fuzz::reader_of(format ? format : "");
    reader = reader ? reader : vybeg::fuzz::library_of(format ? format : "");
    if (!reader) {
        std::fputs("VYBEG_FORMAT names no format\n", stderr);
        std::exit(2);
    }
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const vybeg::fuzz::Verdict verdict = reader({reinterpret_cast<const char*>(data), size});
    if (!verdict.fault.empty()) {
        std::fprintf(stderr, "%s\n", verdict.fault.c_str());
        std::abort();
    }
    return 0;
}
