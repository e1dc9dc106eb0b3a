#include "core/track/track.h"

#include <limits>

namespace vybeg {

Track::Track(std::size_t rows) : time_s_(rows), flags_(rows) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const SlowVariable variable : all_slow_variables) {
        values_[index(variable)].assign(rows, nan);
        if (info(variable).has_sd) {
            sds_[index(variable)].assign(rows, nan);
        }
    }
}

}  // namespace vybeg
