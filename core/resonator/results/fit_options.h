#pragma once

#include "core/resonator/model/channel_tolerance.h"

#include <optional>

namespace vybeg {

// Model, tolerances of the channels and spread between the runs that the caller states.
struct FitOptions {
    enum class Model { automatic, structured, free };
    Model model = Model::automatic;
    ChannelTolerance tolerance = untold_channels;  // priors of the fit
    // Of errors without a tolerance, which the fit holds at zero: their part of u.
    ChannelTolerance assumed{};
    // Between the runs of a set, in u: relative sd of 1/tau (that of the split and of the gain
    // ratio follow, largest_spread()). None: what two or three runs cannot show is assumed.
    std::optional<double> spread = 0;
};

// The options with the assumed tolerances as priors of the fit.
inline FitOptions with_assumed(FitOptions options) {
    for (const ToleratedError& error : channel_errors) {
        double& size = options.tolerance[error.source];
        size = size > 0 ? size : options.assumed[error.source];
    }
    return options;
}

}  // namespace vybeg
