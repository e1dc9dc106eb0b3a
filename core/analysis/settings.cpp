#include "core/analysis/settings.h"

#include <tbb/info.h>

#include <algorithm>

namespace vybeg {

bool same_carrier_search(const SignalSettings& a, SignalSettings b) {
    b.f0_hz = a.f0_hz;
    return a == b;
}

int threads_of(int asked) {
    const int cores = tbb::info::default_concurrency();
    return asked > 0 ? std::min(asked, cores) : cores;
}

}  // namespace vybeg
