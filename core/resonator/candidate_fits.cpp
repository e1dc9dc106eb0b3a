#include "core/resonator/candidate_fits.h"

#include "core/resonator/identifiability.h"
#include "core/resonator/start_values.h"

#include <cmath>
#include <utility>

namespace vybeg {
namespace {

// Places in the shared parameters.
enum Place { split_cos, split_sin, damping_cos, damping_sin, rotation, skew, decay };

// A free M that is a structured one seen with a gain ratio kappa: K^-1 M K with K = diag(1, kappa)
// leaves Im M_12 = kappa Im S_12 and Im M_21 = Im S_21/kappa, and those of S are equal.
std::optional<FitState> without_kappa(FitState free) {
    const Eigen::Matrix2cd m = SlowDynamics(rates_of(free.shared)).matrix();
    const double square = m(0, 1).imag() / m(1, 0).imag();
    if (!(square > 0) || !std::isfinite(square)) {
        return std::nullopt;
    }
    const double kappa = std::sqrt(square);
    Eigen::Matrix2cd s = m;
    s(0, 1) /= kappa;
    s(1, 0) *= kappa;
    FitState state{to_shared(rates_of(s)), std::move(free.runs)};
    state.shared[skew] = 0;
    state.shared[kappa_index] = kappa;
    state.shared[power_index] = free.shared[power_index];
    for (Own& own : state.runs) {
        own.segment<2>(start_index + 2) *= kappa;
    }
    return state;
}

}  // namespace

CandidateFits::CandidateFits(std::span<const ScaledRun> runs, bool drift, const JobControl& job)
    : runs_(runs), drift_(drift), job_(job) {}

ModelSpace CandidateFits::still_split_space() const {
    ModelSpace space = space_of({rotation, decay, split_cos, damping_cos, damping_sin}, drift_);
    space.basis.col(2) = still_space_.basis.col(2);
    return space;
}

ModelSpace CandidateFits::structured_space() const {
    return space_of({split_cos, split_sin, damping_cos, damping_sin, rotation, decay}, drift_);
}

ModelSpace CandidateFits::free_space() const {
    return space_of({split_cos, split_sin, damping_cos, damping_sin, rotation, skew, decay},
                    drift_);
}

ModelSpace CandidateFits::kappa_space() const {
    return space_of({split_cos, split_sin, damping_cos, damping_sin, rotation, decay, kappa_index},
                    drift_);
}

ModelSpace CandidateFits::kappa_alone_space() const {
    return space_of({split_cos, split_sin, rotation, decay, kappa_index}, drift_);
}

Status CandidateFits::fit(std::optional<ModelFit>& into, const ModelSpace& space,
                          const FitState& start) {
    Result<ModelFit> fitted = fit_model(runs_, space, start, job_);
    if (!fitted) {
        return fitted.error();
    }
    into = std::move(*fitted);
    return {};
}

Status CandidateFits::fit_again(std::optional<ModelFit>& into, const ModelSpace& space,
                                const FitState& start) {
    if (!std::isfinite(chi_square(runs_, start))) {
        return {};
    }
    const ModelFit before = *into;
    if (const Status done = fit(into, space, start); !done) {
        return done;
    }
    if (before.chi2 < into->chi2) {
        into = before;
    }
    return {};
}

Status CandidateFits::fit_still() {
    const FitState start = still_start(runs_);
    still_space_ = space_of({rotation, decay, split_cos}, drift_);
    still_space_.basis.col(2).setZero();
    still_space_.basis.col(2).head<2>() = seen_direction(start);
    return fit(still_, still_space_, start);
}

Status CandidateFits::fit_still_split() {
    return fit(still_split_, still_split_space(), still_->state);
}

Status CandidateFits::fit_structured() {
    if (const Status done = fit(structured_, structured_space(), still_->state);
        !done || enlargement_of(structured_->chi2, degrees(runs_, structured_space())) == 1) {
        return done;
    }
    // It does not follow the phasors: perhaps it began too far away.
    pencil_ = pencil_start(runs_);
    if (!pencil_) {
        return {};
    }
    FitState calibrated = *pencil_;
    calibrated.shared[skew] = 0;
    return fit_again(structured_, structured_space(), calibrated);
}

Status CandidateFits::fit_free() {
    if (const Status done = fit(free_, free_space(), structured_->state); !done || !pencil_) {
        return done;
    }
    // The structured fit of what is not structured ends anywhere, and this one began there.
    return fit_again(free_, free_space(), *pencil_);
}

Status CandidateFits::fit_kappa() {
    if (const Status done = fit(kappa_, kappa_space(), structured_->state); !done || !free_) {
        return done;
    }
    const std::optional<FitState> balanced = without_kappa(free_->state);
    return balanced ? fit_again(kappa_, kappa_space(), *balanced) : Status{};
}

Status CandidateFits::fit_kappa_alone() {
    FitState start = structured_->state;
    start.shared[damping_cos] = 0;
    start.shared[damping_sin] = 0;
    return fit(kappa_alone_, kappa_alone_space(), start);
}

}  // namespace vybeg
