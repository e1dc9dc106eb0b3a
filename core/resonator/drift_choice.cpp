#include "core/resonator/drift_choice.h"

#include "core/resonator/identifiability.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vybeg {
namespace {

FitState steady_state(FitState state) {
    for (Own& own : state.runs) {
        own[drift_index] = 0;
    }
    return state;
}

ModelSpace with_power_term(ModelSpace space) {
    const Eigen::Index column = space.basis.cols();
    space.basis.conservativeResize(Eigen::NoChange, column + 1);
    space.basis.col(column) = Shared::Unit(power_index);
    return space;
}

// Whether the fall of chi^2 from one fit to the next is half of what stood above the noise.
bool explains(const ModelFit& before, double dof, const ModelFit& after) {
    const double excess = std::max(0.0, before.chi2 - dof - 4 * std::sqrt(2 * dof));
    return before.chi2 - after.chi2 >= excess / 2;
}

struct Drifts {
    std::vector<Estimate> each;
    bool significant = false;  // together
};

Drifts drifts_of(std::span<const ScaledRun> runs, const ModelSpace& space, const ModelFit& fit) {
    const Eigen::MatrixXd all =
        covariance(runs, space, fit.state) * enlargement_of(fit.chi2, degrees(runs, space));
    const auto count = static_cast<Eigen::Index>(runs.size());
    const auto at = [](Eigen::Index k) { return shared_count + own_count * k + drift_index; };
    Drifts drifts;
    Eigen::VectorXd drift(count);
    Eigen::MatrixXd spread(count, count);
    for (Eigen::Index k = 0; k < count; ++k) {
        drift[k] = fit.state.runs[static_cast<std::size_t>(k)][drift_index];
        for (Eigen::Index l = 0; l < count; ++l) {
            spread(k, l) = all(at(k), at(l));
        }
        drifts.each.push_back({drift[k], std::sqrt(spread(k, k)), {}});
    }
    drifts.significant = significant(drift.dot(spread.inverse() * drift), static_cast<int>(count));
    return drifts;
}

}  // namespace

Result<DriftChoice> choose_drift(std::span<const ScaledRun> runs, const ModelSpace& space,
                                 const ModelFit& drifting, bool with_power, const JobControl& job) {
    ModelSpace steady_space = space;
    steady_space.drift = false;
    Result<ModelFit> steady = fit_model(runs, steady_space, steady_state(drifting.state), job);
    if (!steady) {
        return steady.error();
    }
    const Estimate misfit{.reason = {ReasonCode::residual_from_elsewhere, {}}};
    const Drifts found = drifts_of(runs, space, drifting);
    const bool explained = explains(*steady, degrees(runs, steady_space), drifting);
    const bool drifts = found.significant && explained;
    DriftChoice choice;
    choice.space = drifts ? space : steady_space;
    choice.fit = drifts ? drifting : *steady;
    choice.drift_hz_per_s = found.each;
    if (found.significant && !explained) {
        choice.drift_hz_per_s.assign(runs.size(), misfit);
    }
    if (!with_power) {
        choice.frequency_per_power.reason = {ReasonCode::free_model, {}};
        return choice;
    }

    const ModelSpace power_space = with_power_term(choice.space);
    Result<ModelFit> power = fit_model(runs, power_space, choice.fit.state, job);
    if (!power) {
        return power.error();
    }
    const double variance = covariance(runs, power_space, power->state)(power_index, power_index) *
                            enlargement_of(power->chi2, degrees(runs, power_space));
    const Estimate value{power->state.shared[power_index], std::sqrt(variance), {}};
    const bool beyond_chance = std::abs(value.value) > 4 * value.sd;
    if (beyond_chance && explains(choice.fit, degrees(runs, choice.space), *power)) {
        choice.frequency_per_power = value;
        choice.space = power_space;
        choice.fit = std::move(*power);
        if (drifts) {
            choice.drift_hz_per_s = drifts_of(runs, power_space, choice.fit).each;
        }
    } else if (beyond_chance) {
        choice.frequency_per_power = misfit;
    } else if (drifts) {
        choice.frequency_per_power.reason = {ReasonCode::amplitude_like_drift, {}};
    } else {
        choice.frequency_per_power = value;
    }
    return choice;
}

}  // namespace vybeg
