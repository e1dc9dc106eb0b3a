#include "core/resonator/runs/decay_time.h"

namespace vybeg {

Estimate decay_time(double per_s, double sd, double u) {
    constexpr double given_from = 5;
    constexpr double limit = 2;
    const double width = u > sd ? u : sd;
    if (per_s >= given_from * width) {
        return {1 / per_s, sd / (per_s * per_s), {}, u / (per_s * per_s)};
    }
    const double fastest = per_s + limit * width;
    if (fastest <= 0) {
        return {.reason = {ReasonCode::grows, {number_arg(-per_s, 3), number_arg(width, 2)}}};
    }
    const double slowest = per_s - limit * width;
    if (slowest > 0) {
        return {.reason = {ReasonCode::decay_limits,
                           {number_arg(1 / fastest, 3), number_arg(1 / slowest, 3)}}};
    }
    return {.reason = {ReasonCode::no_decay, {number_arg(1 / fastest, 3)}}};
}

}  // namespace vybeg
