#include "core/resonator/model/priors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vybeg {
namespace {

constexpr double flat = std::numeric_limits<double>::infinity();

Priors flat_priors(std::span<const ScaledRun> runs, const ParameterLayout& layout) {
    Priors priors{Eigen::VectorXd::Zero(layout.size()),
                  Eigen::VectorXd::Constant(layout.size(), flat)};
    priors.mean[kappa_at] = 1;
    for (const ToleratedError& error : channel_errors) {
        priors.sd[error.parameter] = 0;
    }
    priors.sd[cubic_at] = priors.sd[free_rotation_at] = 0;
    for (std::size_t run = 0; run < runs.size(); ++run) {
        priors.sd[layout.at(run, drift_at)] = 0.1 / runs[run].duration_s;
    }
    return priors;
}

}  // namespace

std::vector<Eigen::Index> Priors::active() const {
    std::vector<Eigen::Index> indices;
    for (Eigen::Index k = 0; k < sd.size(); ++k) {
        if (sd[k] > 0) {
            indices.push_back(k);
        }
    }
    return indices;
}

PriorKind prior_kind(const ParameterLayout& layout, Eigen::Index parameter) {
    if (std::ranges::find(channel_errors, parameter, &ToleratedError::parameter) !=
        channel_errors.end()) {
        return PriorKind::channel;
    }
    bool physical = parameter < shared_count && parameter != decay_at;
    for (std::size_t run = 0; run < layout.runs(); ++run) {
        physical = physical || parameter == layout.at(run, drift_at);
    }
    return physical ? PriorKind::physical : PriorKind::none;
}

Priors structured_priors(std::span<const ScaledRun> runs, const ParameterLayout& layout,
                         const ChannelTolerance& tolerance) {
    Priors priors = flat_priors(runs, layout);
    priors.sd[split_cos_at] = priors.sd[split_sin_at] = 3;
    priors.sd[damping_cos_at] = priors.sd[damping_sin_at] = 1;
    priors.sd[rotation_at] = 3;
    for (const ToleratedError& error : channel_errors) {
        priors.sd[error.parameter] = tolerance[error.source];
    }
    return priors;
}

Priors free_priors(std::span<const ScaledRun> runs, const ParameterLayout& layout) {
    Priors priors = flat_priors(runs, layout);
    // In units of one radian, or of a decay by e, from one window to the next.
    double fastest = 0;
    for (const ScaledRun& run : runs) {
        fastest = std::max(fastest, 1 / run.step_s);
    }
    for (const int rate : {split_cos_at, split_sin_at, damping_cos_at, damping_sin_at, rotation_at,
                           free_rotation_at}) {
        priors.sd[rate] = 100 * fastest;
    }
    return priors;
}

void open_cubic(Priors& priors, std::span<const ScaledRun> runs) {
    double power = 0;
    for (const ScaledRun& run : runs) {
        power += run.power / static_cast<double>(runs.size());
    }
    priors.sd[cubic_at] = 1 / power;
}

void set_damping(Priors& priors, double width_per_s) {
    priors.sd[damping_cos_at] = priors.sd[damping_sin_at] = std::max(std::abs(width_per_s), 1e-6);
}

}  // namespace vybeg
