#include "core/resonator/model_choice.h"

#include "core/base/number_text.h"
#include "core/resonator/candidate_fits.h"
#include "core/resonator/drift_choice.h"
#include "core/resonator/identifiability.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vybeg {
namespace {

// A gain ratio is worth telling when it is known this well.
constexpr double largest_kappa_sd = 0.01;
// Electrodes of one amplifier card; channels that differ by more are no pair.
constexpr double least_kappa = 0.8;
// A wave turning by less sees rotation and anisotropy in one mixture.
constexpr double least_turn_deg = 22.5;

class Choice {
public:
    Choice(std::span<const ScaledRun> runs, const FitOptions& options, const JobControl& job)
        : runs_(runs), options_(options), job_(job), fits_(runs, options.fit_drift, job) {}

    Result<ModelChoice> make() {
        for (const auto step : {&Choice::fit_models, &Choice::look_for_kappa,
                                &Choice::look_for_drift, &Choice::finish}) {
            if (const Status done = (this->*step)(); !done) {
                return done.error();
            }
        }
        return std::move(made_);
    }

private:
    void take(const ModelSpace& space, const ModelFit& fit) {
        made_.space = space;
        made_.fit = fit;
        made_.dof = degrees(runs_, space);
        made_.enlargement = enlargement_of(fit.chi2, made_.dof);
    }

    Status fit_models() {
        if (const Status done = fits_.fit_still(); !done) {
            return done;
        }
        if (const Status done = fits_.fit_structured(); !done) {
            return done;
        }
        take(fits_.structured_space(), fits_.structured());
        if (const Status done = fits_.fit_free(); !done) {
            return done;
        }
        const double free_scale =
            enlargement_of(fits_.free().chi2, degrees(runs_, fits_.free_space()));
        made_.free_over_structured = (made_.fit.chi2 - fits_.free().chi2) / free_scale;
        bool free_better = significant(made_.free_over_structured, 1);
        if (free_better && options_.estimate_kappa) {
            // An unbalanced pair is free in the same way.
            if (const Status done = fits_.fit_kappa(); !done) {
                return done;
            }
            const double left = (fits_.kappa().chi2 - fits_.free().chi2) / free_scale;
            const double kappa = fits_.kappa().state.shared[kappa_index];
            if (!significant(left, 1) && kappa > least_kappa && kappa < 1 / least_kappa &&
                kappa_sd(fits_.kappa(), fits_.kappa_space()) < largest_kappa_sd) {
                made_.free_over_structured = left;
                free_better = false;
                unbalanced_ = true;
                take(fits_.kappa_space(), fits_.kappa());
            }
        }
        if (options_.model == FitOptions::Model::free ||
            (free_better && options_.model == FitOptions::Model::automatic)) {
            made_.model = ResonatorModel::free;
            take(fits_.free_space(), fits_.free());
            if (options_.model == FitOptions::Model::automatic) {
                made_.warnings.push_back({DiagnosticKind::structured_refused,
                                          {short_text(made_.free_over_structured, 3)}});
            }
            return {};
        }
        return choose_rates();
    }

    // Whether the rates can be told from each other, or the wave stood too still.
    Status choose_rates() {
        const ModelFit& still = fits_.still();
        const ModelFit& all = made_.fit;
        // Looked at where the unseen rates are zero: along what the data do not see the full fit
        // follows the noise, far enough to see itself there. It is believed by itself only where it
        // fits better than a still wave by more than chance.
        const Sight before = sight(covariance(runs_, made_.space, still.state));
        const Sight after = sight(covariance(runs_, made_.space, all.state));
        const bool moved = significant((still.chi2 - all.chi2) / made_.enlargement, 3);
        const double root = std::sqrt(made_.enlargement);
        const auto seen = [&](double sd_before, double sd_after, double enough) {
            return moved ? sd_after <= blur_limit * after.best || root * sd_after <= enough
                         : sd_before <= blur_limit * before.best;
        };
        const Shared& shared = all.state.shared;
        // Half the anisotropy is at most the decay: a fifth of that is already an upper bound.
        const double decay = std::abs(shared[rate_count - 1]);
        made_.split_seen = seen(before.split, after.split, split_size(shared) / 5);
        made_.damping_seen =
            seen(before.damping, after.damping, std::max(damping_size(shared), decay) / 5);
        made_.rotation_seen = made_.damping_seen;
        if (made_.split_seen) {
            return {};
        }
        if (made_.damping_seen) {
            if (const Status done = fits_.fit_still_split(); !done) {
                return done;
            }
            take(fits_.still_split_space(), fits_.still_split());
            return {};
        }
        take(fits_.still_space(), still);
        made_.warnings.push_back({DiagnosticKind::decay_of_one_direction, {}});
        return {};
    }

    double kappa_sd(const ModelFit& fit, const ModelSpace& space) const {
        const double variance = covariance(runs_, space, fit.state)(kappa_index, kappa_index);
        return std::sqrt(variance * enlargement_of(fit.chi2, degrees(runs_, space)));
    }

    Status look_for_kappa() {
        if (made_.model == ResonatorModel::free) {
            made_.kappa.reason = {ReasonCode::free_model, {}};
            return {};
        }
        if (!options_.estimate_kappa) {
            made_.kappa.reason = {ReasonCode::not_asked, {}};
            return {};
        }
        // With all else free, it is the split that shows kappa; with equal damping, the rotation.
        const ModelSpace beside = fits_.kappa_space();
        const ModelSpace alone = fits_.kappa_alone_space();
        const ModelFit all = unbalanced_ ? fits_.kappa() : fits_.structured();
        const double sd_beside = kappa_sd(all, beside);
        const double turned = turned_deg(runs_);
        const bool moves = made_.split_seen || made_.damping_seen;
        bool like_damping = false;
        if (moves && turned >= least_turn_deg && sd_beside > 1e-4) {
            if (const Status done = fits_.fit_kappa_alone(); !done) {
                return done;
            }
            const double sd = kappa_sd(fits_.kappa_alone(), alone);
            const double rise = (fits_.kappa_alone().chi2 - all.chi2) / made_.enlargement;
            like_damping = significant(rise, unbalanced_ ? 2 : 1);
            if (!like_damping && sd < std::min(largest_kappa_sd, sd_beside / 3)) {
                if (use_kappa(alone, fits_.kappa_alone(), sd)) {
                    made_.damping_seen = false;
                    made_.equal_damping = true;
                }
                made_.warnings.push_back({DiagnosticKind::kappa_assumes_equal_damping, {}});
                return {};
            }
        }
        if (made_.split_seen && sd_beside < largest_kappa_sd) {
            if (!unbalanced_) {
                if (const Status done = fits_.fit_kappa(); !done) {
                    return done;
                }
            }
            use_kappa(beside, fits_.kappa(), sd_beside);
            return {};
        }
        if (like_damping) {
            made_.kappa.reason = {ReasonCode::kappa_like_damping, {}};
        } else if (turned < least_turn_deg) {
            made_.kappa.reason = {ReasonCode::kappa_still_wave,
                                  {short_text(turned, 3), short_text(least_turn_deg, 3)}};
        } else {
            made_.kappa.reason = {ReasonCode::kappa_not_seen, {}};
        }
        return {};
    }

    // A ratio of 1 within its noise is taken as 1, and everything else is the sharper for it.
    // Returns whether the fit with kappa is the one taken.
    bool use_kappa(const ModelSpace& space, const ModelFit& fit, double sd) {
        made_.kappa.value = fit.state.shared[kappa_index];
        made_.kappa.sd = sd;
        if (unbalanced_ || std::abs(made_.kappa.value - 1) >= 5 * sd) {
            take(space, fit);
            return true;
        }
        return false;
    }

    Status look_for_drift() {
        if (!options_.fit_drift) {
            const Estimate none{.reason = {ReasonCode::not_asked, {}}};
            made_.drift_hz_per_s.assign(runs_.size(), none);
            made_.frequency_per_power = none;
            return {};
        }
        // |z|^2 of channels of unknown scale beats: a dependence on it would follow the beat.
        Result<DriftChoice> drift = choose_drift(runs_, made_.space, made_.fit,
                                                 made_.model == ResonatorModel::structured, job_);
        if (!drift) {
            return drift.error();
        }
        take(drift->space, drift->fit);
        made_.drift_hz_per_s = std::move(drift->drift_hz_per_s);
        made_.frequency_per_power = drift->frequency_per_power;
        return {};
    }

    Status finish() {
        made_.covariance = covariance(runs_, made_.space, made_.fit.state);
        if (!made_.fit.converged) {
            made_.warnings.push_back({DiagnosticKind::fit_not_converged, {}});
        }
        return {};
    }

    std::span<const ScaledRun> runs_;
    const FitOptions& options_;
    const JobControl& job_;
    CandidateFits fits_;
    bool unbalanced_ = false;  // kappa alone makes the structured model as good as the free one
    ModelChoice made_;
};

}  // namespace

Result<ModelChoice> choose_model(std::span<const ScaledRun> runs, const FitOptions& options,
                                 const JobControl& job) {
    return Choice(runs, options, job).make();
}

}  // namespace vybeg
