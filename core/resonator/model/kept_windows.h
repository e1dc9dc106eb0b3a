#pragma once

#include "core/resonator/model/phasor_run.h"

#include <cstddef>

namespace vybeg {

// The run with only those windows for which keep(index) is true.
template <class Keep>
PhasorRun kept_windows(const PhasorRun& run, const Keep& keep) {
    PhasorRun kept = run;
    kept.time_s.clear();
    kept.c.clear();
    kept.d.clear();
    kept.sd.clear();
    for (std::size_t k = 0; k < run.time_s.size(); ++k) {
        if (keep(k)) {
            kept.time_s.push_back(run.time_s[k]);
            kept.c.push_back(run.c[k]);
            kept.d.push_back(run.d[k]);
            kept.sd.push_back(run.sd[k]);
        }
    }
    return kept;
}

}  // namespace vybeg
