#pragma once

#include "core/resonator/fit/fit_start.h"
#include "core/resonator/fit/fitted_break.h"
#include "core/resonator/results/describe_fit.h"
#include "core/resonator/results/fit_options.h"
#include "core/resonator/results/resonator_result.h"
#include "core/resonator/results/set_examination.h"
#include "core/resonator/runs/merge_windows.h"
#include "core/resonator/runs/sum_of_modes.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace vybeg {

// Where the trial of a break begins: near the most likely parameters. It takes neither further
// starts nor the free model, and does not examine whether the runs belong together.
struct TrialStart {
    Eigen::VectorXd p;                    // empty: no trial, the whole fit from nothing
    std::vector<RunDeviation> deviation;  // how much the runs differ; empty: not at all
};

// Largest amplitude of a channel, recording units; 0 without a wave.
double largest_amplitude(std::span<const PhasorRun> runs);

// What all fits of a set share. `scale`: unit of the phasors.
struct FitTask {
    double scale;
    const FitOptions& options;
    const JobControl& job;
};

// The whole fit of one set, step by step.
class SetFit {
public:
    // `fine`: the runs before merging of windows; `whitenings` of merge_windows.h, empty: none.
    SetFit(std::vector<PhasorRun> runs, std::span<const PhasorRun> fine,
           std::span<const Eigen::Matrix2d> whitenings, const FitTask& task,
           const TrialStart& start = {});

    // The present parameters of a set with one break more, whose parameters are zero.
    TrialStart with_room_for(const FittedBreak& found) const;

    // Finds the most likely parameters.
    void solve();

    // The number of windows of a run that they need.
    NeededWindows needed() const { return needed_windows(motion(), set_.fine); }

    const SetExamination& examination() const { return examination_; }

    // Whether the runs are those of one resonator.
    bool agrees() const { return examination_.agrees(); }

    // A run's own parameters that fit it best with the shared ones of another set.
    Eigen::VectorXd own_given(const Eigen::VectorXd& shared, std::size_t run) const;

    // Whether this solution explains its windows about as well as `other`.
    bool explains_as_much_as(const SetFit& other) const;

    double chi2_per_dof() const { return set_.fit.chi2 / degrees_of_freedom(problem_); }
    bool at_noise() const { return chi2_per_dof() < noise_bound(degrees_of_freedom(problem_)); }

    double excess() const { return set_.fit.chi2 - degrees_of_freedom(problem_); }

    // Breaks, one of a kind, that may explain the residual; none if something smooth explains it as
    // well.
    std::vector<FittedBreak> unexplained_breaks() const;

    // Whether the residual is the noise of the windows, of their colour too, in both halves.
    bool is_white() const;

    std::array<double, 2> size_of(const FittedBreak& each) const {
        return fitted_size(problem_, set_.fit.p, each);
    }

    // Whether the channel errors lie within three of their tolerances.
    bool has_usual_channels() const;

    // Whether the fit is finished, the runs agree, the residual has the size of the noise, the
    // structured model is not refused, and the channels are usual.
    bool explains() const;

    // Whether channel errors of such tolerances may leave only noise: a fit from the present
    // parameters, with these tolerances for priors, comes near it. Of runs that agree.
    bool may_be_explained_by(const ChannelTolerance& tolerance) const;

    FittedMotion motion() const { return motion_of(set_); }

    // Results of the present parameters.
    ResonatorFit described();

private:
    // Whether the set is one at all. A cause common to all runs that leaves only noise is named
    // instead; nearly so where no single run makes the difference.
    void examine();

    // Whether the residual is a coloured noise, the same in both halves of all runs: slow noise
    // moves the runs apart more than white noise of their windows.
    bool is_noise() const;

    bool is_trial() const { return start_.size() > 0; }

    void find_main();

    // The fit from the known start, and from still waves where that leaves more than noise.
    StillFit fit_near_start();

    // Opens a dependence of the frequency on the amplitude only if the data require it, because
    // elliptic waves would otherwise lose their rotation.
    void try_cubic();

    // Whether a spread or one foreign run explains a set whose runs disagree with the cubic term,
    // which bends the frequency of runs that do not belong together. If so, that stays its result.
    bool explained_without_cubic(const MapFit& plain, const Priors& plain_priors);

    // Without the cubic term the other parameters compensated for it and are far from their values.
    // The fit needs many steps, or a new start at still waves.
    void polish_cubic();

    // Whether the free model explains the runs together, and each of them alone is none of a
    // calibrated pair: then nothing of the structured model says that they do not belong together.
    bool is_of_free_runs() const;

    // Gives the problem the priors of the free model, and fits it near the present parameters, or
    // from nothing. That model has no cubic term, because |z|^2 of channels of unknown scale beats.
    MapFit fit_freely(FitProblem& free) const;

    void choose_model();

    // The sum of two modes of a run by itself, without the drift of its frequency at p: what no M
    // explains better. Empty where the run is not such a sum in the model either.
    std::optional<ModeSum> modes_of(std::size_t run, const Eigen::VectorXd& p) const;

    // Whether two modes of its own leave a run far above its noise.
    bool is_no_motion(const Eigen::VectorXd& p) const;

    std::vector<PhasorRun> runs_;
    FitTask task_;
    FitProblem problem_;
    FittedSet set_;            // refers to the runs and the problem
    Eigen::VectorXd start_;    // of a trial; else empty
    bool phase_left_ = false;  // still waves explain everything except the phase
    bool no_motion_ = false;   // a run is known to be no motion that a model has
    SetExamination examination_;
    double free_over_structured_ = 0;
    bool structured_refused_ = false;  // with a finding
    std::vector<Diagnostic> warnings_;
};

// The set with as many windows of a run as its solution needs; it refers to the runs.
std::unique_ptr<SetFit> solved_set(const std::vector<PhasorRun>& runs, const FitTask& task,
                                   const TrialStart& start = {});

}  // namespace vybeg
