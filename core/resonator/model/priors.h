#pragma once

#include "core/resonator/model/channel_tolerance.h"
#include "core/resonator/model/parameters.h"
#include "core/resonator/model/scaled_run.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace vybeg {

// Gaussian priors of the parameters, independent of each other. A width of zero holds a parameter
// at its mean; an infinite width leaves a parameter to the data.
struct Priors {
    Eigen::VectorXd mean;
    Eigen::VectorXd sd;

    // Indices of the parameters that are not held.
    std::vector<Eigen::Index> active() const;
};

// Kind of information of a parameter's prior.
enum class PriorKind {
    none,      // flat: data only
    physical,  // wide, without information: results that rest on it are not given
    channel,   // known properties of the electronics: enters the combined uncertainty
};
PriorKind prior_kind(const ParameterLayout& layout, Eigen::Index parameter);

// The priors of the structured model (FIT section 1): split 0 +- 3 Hz in each component, rotation 0
// +- 3 rad/s, drift of each run 0 +- 0.1 Hz/duration, channels as `tolerance` says, the damping
// anisotropy 0 +- 1 1/s until set_damping(); the cubic term and the free rotation held.
Priors structured_priors(std::span<const ScaledRun> runs, const ParameterLayout& layout,
                         const ChannelTolerance& tolerance);

// The priors of the free model: any M, no channels; so wide that they only limit the fit along
// directions that one wave does not determine.
Priors free_priors(std::span<const ScaledRun> runs, const ParameterLayout& layout);

// Opens the cubic term: 0 +- 1 Hz at the mean power of the runs.
void open_cubic(Priors& priors, std::span<const ScaledRun> runs);

// The damping anisotropy is 0 +- `width_per_s` in each component. Passivity allows 2/tau, so that
// 1/tau carries no information.
void set_damping(Priors& priors, double width_per_s);

}  // namespace vybeg
