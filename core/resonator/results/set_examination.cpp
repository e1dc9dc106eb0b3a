#include "core/resonator/results/set_examination.h"

#include "core/numerics/dense_solvers.h"
#include "core/resonator/fit/fit_start.h"
#include "core/resonator/noise/residual_noise.h"
#include "core/resonator/results/reported_estimates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <span>
#include <utility>

namespace vybeg {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Sets of fewer runs do not show whether they belong together: free parameters absorb what differs.
constexpr std::size_t least_to_show = 4;
// Chi^2 between the first suspect and the next; by which an exchange has to lower it.
constexpr double margin = 12;
// Chi^2 of channel errors beyond their tolerances: with such, all runs but one may be turned.
constexpr double far_channels = 100;
// Chi^2 above that of its own fit up to which a run counts as brought back.
constexpr double brought_back = 25;
// Sets without one run that are fitted; one more without a run whose own noise is this many times
// that of its windows.
constexpr std::size_t most_trials = 4;
constexpr double own_misfit = 100;
constexpr int refit_steps = 60;

// Some runs of a set with their fit.
struct PartFit {
    FitProblem problem;
    MapFit fit;
};

// From a start; where the fit from there costs no more than `hopeful`, which the other takes many
// times longer for, from nothing, too.
PartFit part_fit(FitProblem problem, const VectorXd& start, const JobControl& job,
                 double hopeful = std::numeric_limits<double>::infinity()) {
    FitProblem anew = problem;
    MapFit fit = fit_from(problem, start, job);
    if (!(fit.cost > hopeful)) {
        MapFit from_nothing = fit_from_nothing(anew, job);
        if (!(fit.cost < from_nothing.cost)) {
            fit = std::move(from_nothing);
            problem = std::move(anew);
        }
    }
    return {std::move(problem), std::move(fit)};
}

std::vector<std::size_t> all_of(std::size_t count) {
    std::vector<std::size_t> all(count);
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}

std::vector<std::size_t> all_but(std::size_t count, std::size_t out) {
    std::vector<std::size_t> kept = all_of(count);
    kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(out));
    return kept;
}

// The variance of a run's noise in units of that of its windows, by its own fit: the misfit
// of that belongs to its model and noise, not to the set.
double own_noise(const PartFit& alone, const Posterior& at, const JobControl& job) {
    const double ratio = alone.fit.chi2 / degrees_of_freedom(alone.problem);
    return std::max(std::isfinite(ratio) ? ratio : 1.0, widening(alone.problem, at, job));
}

// What a run alone shows of the rates: the logarithm of their volume under the priors over that
// after the fit.
double known_by(const Posterior& at) {
    double sum = 0;
    for (std::size_t k = 0; k < at.active.size() && at.active[k] < rate_count; ++k) {
        const auto row = static_cast<Index>(k);
        sum -= std::log(at.covariance(row, row));
    }
    return std::isfinite(sum) ? sum : -std::numeric_limits<double>::infinity();
}

// The run with other channels: `of_channels` of C and D.
ScaledRun transformed(ScaledRun run, const Eigen::Matrix2d& of_channels) {
    const Eigen::Matrix2d turn = run.turn();
    const Eigen::Matrix2d to = turn * of_channels * turn.transpose();
    for (Eigen::Vector2cd& z : run.z) {
        z = to * z;
    }
    const Eigen::Matrix2d colour = to * run.whitening.inverse();
    const Eigen::Matrix2d covariance = colour * colour.transpose();
    const Eigen::Matrix2d lower = covariance.llt().matrixL();
    run.whitening = lower.inverse();
    return run;
}

// The run with its channels exchanged, and with the other sign of D, each with its words.
std::array<std::pair<const char*, ScaledRun>, 2> with_other_channels(const ScaledRun& run) {
    return {{{VYBEG_MESSAGE("Words", "the channels C and D of %1 are exchanged"),
              transformed(run, Eigen::Matrix2d{{0, 1}, {1, 0}})},
             {VYBEG_MESSAGE("Words", "the sign of channel D of %1 is reversed"),
              transformed(run, Eigen::Matrix2d{{1, 0}, {0, -1}})}}};
}

// Words for a run whose decay rate is not that of the others.
MessageArg decay_words(const MessageArg& run, double its, double theirs) {
    if (!(its > 0.1 * theirs)) {
        return Phrase::tr("%1 hardly decays, the decay time of the others is %2 s",
                          {run, number_arg(1 / theirs, 3)});
    }
    return Phrase::tr("the decay time of %1 is %2 s, that of the others %3 s",
                      {run, number_arg(1 / its, 4), number_arg(1 / theirs, 4)});
}

class Examination {
public:
    Examination(const FitProblem& problem, const MapFit& joint, std::optional<double> spread,
                const JobControl& job)
        : problem_(problem),
          joint_(joint),
          told_spread_(spread),
          job_(job),
          count_(problem.runs.size()),
          structured_(problem.priors.sd[free_rotation_at] == 0),
          noise_(count_, 1) {}

    SetExamination made() {
        SetExamination out;
        if (!possible()) {
            return out;
        }
        if (runs_agree(problem_, joint_.p)) {
            return count_ >= least_to_show && name_turned(out, true) ? out : agreeing();
        }
        for (std::size_t k = 0; k < count_ && !job_.cancelled(); ++k) {
            alone_.push_back(fit_alone(k, problem_.runs[k]));
            const Posterior at = posterior(alone_.back().problem, alone_.back().fit);
            noise_[k] = own_noise(alone_.back(), at, job_);
            known_.push_back(known_by(at));
        }
        if (job_.cancelled()) {
            return out;
        }
        out.own_noise = std::ranges::max(noise_);
        if (name_turned(out, false)) {
            return out;
        }
        if (runs_agree(problem_, joint_.p, noise_)) {
            return agreeing();
        }
        if (structured_) {
            Spread spread = spread_of(problem_, joint_.p, noise_, true, job_);
            if (spread.explains) {
                out.verdict = SetVerdict::spread;
                out.spread = std::move(spread);
                return out;
            }
        }
        leave_one_out(out);
        return out;
    }

    // Result for runs that agree, with the stated spread or, of two or three runs, the assumed one.
    SetExamination agreeing() const {
        SetExamination out;
        if (!possible() || !structured_) {
            return out;
        }
        if (told_spread_) {
            const RunDeviation largest = largest_spread();
            const double share = *told_spread_ / largest[decay_deviates];
            out.spread.sd = {*told_spread_, share * largest[split_deviates],
                             share * largest[kappa_deviates]};
        } else if (count_ < least_to_show) {
            out.spread.sd = spread_of(problem_, joint_.p, noise_, false, job_).sd;
        }
        return out;
    }

private:
    // One run agrees with itself.
    bool possible() const { return count_ > 1 && joint_.p.allFinite(); }

    // A run by itself, `run` in its place.
    PartFit fit_alone(std::size_t k, const ScaledRun& run) const {
        FitProblem problem = part_of(problem_, std::array{k});
        problem.runs[0] = run;
        return part_fit(std::move(problem), part_of(problem_.layout, joint_.p, std::array{k}),
                        job_);
    }

    // Whether the run, with its own start and frequency, is nearly one of the joint fit; of a set
    // that agrees most runs with other channels are far from it.
    bool may_belong(std::size_t k, const ScaledRun& run) const {
        constexpr double far = 1e3;  // chi^2 per degree of freedom
        FitProblem one = part_of(problem_, std::array{k});
        one.runs[0] = run;
        one.priors.mean.head(shared_count) = joint_.p.head(shared_count);
        one.priors.sd.head(shared_count).setZero();
        const VectorXd start = part_of(problem_.layout, joint_.p, std::array{k});
        return minimise(one, start, refit_steps, job_).chi2 < far * degrees_of_freedom(one);
    }

    // Exchanged channels or a reversed sign of D in one run, which a spread or an event would hide,
    // or for which the run's own frequency and start and small changes of what the runs share
    // nearly make up. `agrees`: the set does.
    bool name_turned(SetExamination& out, bool agrees) const {
        if (!structured_ || count_ > 2 * most_trials) {
            return false;
        }
        struct Trial {
            double fall = 0;
            std::size_t run = 0;
            const char* cause = nullptr;
        };
        const double enough = margin * std::ranges::max(noise_);
        std::vector<Trial> better;
        for (std::size_t k = 0; k < count_ && !job_.cancelled(); ++k) {
            for (const auto& [cause, run] : with_other_channels(problem_.runs[k])) {
                if (agrees && !may_belong(k, run)) {
                    continue;
                }
                FitProblem problem = problem_;
                problem.runs[k] = run;
                const PartFit turned = part_fit(std::move(problem), joint_.p, job_, joint_.cost);
                const double fall = joint_.cost - turned.fit.cost;
                const bool likely = turned.fit.cost < turned.fit.chi2 + far_channels;
                if (fall > enough && likely && runs_agree(turned.problem, turned.fit.p, noise_)) {
                    better.push_back({fall, k, cause});
                }
            }
        }
        if (better.empty()) {
            return false;
        }
        std::ranges::stable_sort(better, std::greater(), &Trial::fall);
        for (const Trial& trial : better) {
            if (trial.fall > better.front().fall - enough &&
                std::ranges::find(out.foreign, trial.run) == out.foreign.end()) {
                out.foreign.push_back(trial.run);
            }
        }
        out.cause = words(better.front().cause, {recording_arg(better.front().run)});
        out.cost = joint_.cost - better.front().fall;
        out.by_channels = true;
        out.verdict = out.foreign.size() > 1 ? SetVerdict::several : SetVerdict::foreign;
        return true;
    }

    // The runs whose removal to try, the likeliest first.
    std::vector<std::size_t> suspects() const {
        std::vector<std::size_t> order = all_of(count_);
        if (count_ > most_trials) {
            const std::vector<double> falls = falls_without(problem_, joint_.p, noise_);
            std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
                return falls[a] > falls[b];  // NaN before none
            });
            order.resize(most_trials);
            // In units of such a noise, the disagreement of a run with a large event is the least.
            const auto noisiest = std::ranges::max_element(noise_);
            const auto place = static_cast<std::size_t>(noisiest - noise_.begin());
            if (*noisiest > own_misfit && std::ranges::find(order, place) == order.end()) {
                order.push_back(place);
            }
        }
        return order;
    }

    // The set without a run, from the set's parameters and from those of the two runs with the
    // most information: where the others agree, one of these is near.
    PartFit without(std::size_t out) const {
        const std::vector<std::size_t> which = all_but(count_, out);
        VectorXd own = part_of(problem_.layout, joint_.p, which);
        std::vector<std::size_t> order = which;
        std::ranges::stable_sort(
            order, [this](std::size_t a, std::size_t b) { return known_[a] > known_[b]; });
        order.resize(std::min<std::size_t>(order.size(), 2));
        std::vector<VectorXd> starts{own};
        Index next = shared_count;
        for (const std::size_t k : which) {
            const VectorXd& alone = alone_[k].fit.p;
            own.segment(next, alone.size() - shared_count) =
                alone.tail(alone.size() - shared_count);
            next += alone.size() - shared_count;
        }
        for (const std::size_t k : order) {
            own.head(shared_count) = alone_[k].fit.p.head(shared_count);
            starts.push_back(own);
        }
        FitProblem problem = part_of(problem_, which);
        MapFit best;
        best.cost = std::numeric_limits<double>::infinity();
        for (const VectorXd& start : starts) {
            FitProblem trial = problem;
            MapFit fit = fit_from(trial, start, job_);
            if (fit.cost < best.cost || best.p.size() == 0) {
                best = std::move(fit);
                problem = std::move(trial);
            }
        }
        return {std::move(problem), std::move(best)};
    }

    void leave_one_out(SetExamination& out) {
        struct Trial {
            std::size_t run = 0;
            double apart = 0;  // cost of the others together and of the run alone
        };
        const double mean_noise =
            std::accumulate(noise_.begin(), noise_.end(), 0.0) / static_cast<double>(count_);
        std::vector<Trial> fitting;
        for (const std::size_t k : suspects()) {
            if (job_.cancelled()) {
                return;
            }
            std::vector<double> noise = noise_;
            noise.erase(noise.begin() + static_cast<std::ptrdiff_t>(k));
            const PartFit& rest = rest_.emplace(k, without(k)).first->second;
            if (count_ == 2 || runs_agree(rest.problem, rest.fit.p, noise)) {
                fitting.push_back({k, rest.fit.cost + alone_[k].fit.cost});
            }
        }
        out.verdict = SetVerdict::refused;
        if (fitting.empty()) {
            return;
        }
        std::ranges::stable_sort(fitting, {}, &Trial::apart);
        for (const Trial& trial : fitting) {
            if (trial.apart < fitting.front().apart + margin * mean_noise) {
                out.foreign.push_back(trial.run);
            }
        }
        out.cost = fitting.front().apart;
        out.verdict = out.foreign.size() > 1 ? SetVerdict::several : SetVerdict::foreign;
        name_cause(out);
    }

    // Least chi^2 above that of its own fit of a run, its start and frequency free, the shared
    // parameters from the others with their covariance; those of `open` as well free.
    struct Prediction {
        double beyond = 0;
        VectorXd p;
    };

    Prediction predicted(std::size_t k, const ScaledRun& run, const MapFit& own,
                         std::initializer_list<int> open) const {
        const PartFit& others = rest_.at(k);
        const Posterior at = posterior(others.problem, others.fit);
        const std::vector<Index> active = active_shared(others.problem);
        const auto n = static_cast<Index>(active.size());
        MatrixXd covariance = at.covariance.topLeftCorner(n, n);
        FitProblem trial = part_of(problem_, std::array{k});
        trial.runs[0] = run;
        for (const int parameter : open) {
            const double wide =
                parameter == kappa_at ? 0.1 : std::max(1 / run.duration_s, others.fit.p[decay_at]);
            const auto place = std::ranges::find(active, Index{parameter}) - active.begin();
            if (place < n) {
                covariance(place, place) += wide * wide;
            } else {
                trial.priors.sd[parameter] = wide;
            }
        }
        const VectorXd unit =
            covariance.diagonal().cwiseMax(std::numeric_limits<double>::min()).cwiseSqrt();
        const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(MatrixXd(
            unit.cwiseInverse().asDiagonal() * covariance * unit.cwiseInverse().asDiagonal()));
        for (Index row = 0; row < n; ++row) {
            HeldDirection held{VectorXd::Zero(trial.layout.size()), 0,
                               std::sqrt(std::max(eigen.eigenvalues()[row], 1e-14) * noise_[k])};
            held.direction(active) = eigen.eigenvectors().col(row).cwiseQuotient(unit);
            held.value = held.direction.head(shared_count).dot(others.fit.p.head(shared_count));
            trial.held.push_back(std::move(held));
            trial.priors.sd[active[static_cast<std::size_t>(row)]] =
                std::numeric_limits<double>::infinity();
        }
        VectorXd from_others = own.p;
        from_others.head(shared_count) = others.fit.p.head(shared_count);
        Prediction best{std::numeric_limits<double>::infinity(), own.p};
        for (const VectorXd& start : {own.p, from_others}) {
            const MapFit fit = minimise(trial, start, refit_steps, job_);
            const double beyond = (fit.cost - own.cost) / noise_[k];
            if (beyond < best.beyond) {
                best = {beyond, fit.p};
            }
        }
        return best;
    }

    void name_cause(SetExamination& out) const {
        const std::size_t k = out.foreign.front();
        const ScaledRun& run = problem_.runs[k];
        const MapFit& own = alone_[k].fit;
        const double plain = predicted(k, run, own, {}).beyond;
        const double enough = std::min(brought_back, plain - margin);
        double best = enough;
        const MessageArg name = recording_arg(k);
        out.cause = Phrase::tr("more than one number of %1 differs", {name});
        const auto consider = [&](double beyond, MessageArg cause) {
            if (beyond < best) {
                best = beyond;
                out.cause = std::move(cause);
            }
        };
        for (const auto& [cause, turned] : with_other_channels(run)) {
            consider(predicted(k, turned, fit_alone(k, turned).fit, {}).beyond,
                     words(cause, {name}));
        }
        if (best < enough || !structured_) {
            return;
        }
        // A parameter of its own: each of them costs one.
        const VectorXd& others = rest_.at(k).fit.p;
        const Prediction kappa = predicted(k, run, own, {kappa_at});
        const Prediction decay = predicted(k, run, own, {decay_at});
        const Prediction split = predicted(k, run, own, {split_cos_at, split_sin_at});
        const Prediction turn = predicted(k, run, own, {rotation_at});
        best = brought_back;
        consider(kappa.beyond,
                 Phrase::tr("the gain ratio of %1 is %2 times that of the others",
                            {name, number_arg(kappa.p[kappa_at] / others[kappa_at], 4)}));
        consider(decay.beyond, decay_words(name, decay.p[decay_at], others[decay_at]));
        consider(split.beyond,
                 Phrase::tr("the split or the stiffness axis of %1 is another", {name}));
        consider(turn.beyond, Phrase::tr("the wave of %1 turns at another rate", {name}));
    }

    const FitProblem& problem_;
    const MapFit& joint_;
    std::optional<double> told_spread_;
    const JobControl& job_;
    std::size_t count_;
    bool structured_;
    std::vector<double> noise_;
    std::vector<PartFit> alone_;
    std::vector<double> known_;            // what each run shows of the rates alone, logarithm
    std::map<std::size_t, PartFit> rest_;  // without a run
};

// One or several parts as a list; `both`: the words between two of them.
MessageArg listed(const std::vector<MessageArg>& parts, const char* both) {
    MessageArg list = parts.front();
    for (std::size_t k = 1; k < parts.size(); ++k) {
        list = words(both, {list, parts[k]});
    }
    return list;
}

// "A", "A or B", ...
MessageArg either(const std::vector<std::size_t>& runs) {
    std::vector<MessageArg> names;
    std::ranges::transform(runs, std::back_inserter(names), recording_arg);
    return listed(names, VYBEG_MESSAGE("Words", "%1 or %2"));
}

// The numbers that scatter by three deviates, or by the most.
MessageArg differing(const SetExamination& examination) {
    constexpr double clearly = 3;
    constexpr std::array texts{VYBEG_MESSAGE("Words", "the decay rate by %1 %"),
                               VYBEG_MESSAGE("Words", "the split by %1 %"),
                               VYBEG_MESSAGE("Words", "the gain ratio by %1 %")};
    const RunDeviation& sd = examination.spread.sd;
    const RunDeviation& clear = examination.spread.clear;
    const double least = std::min(clearly, std::max({clear[0], clear[1], clear[2]}));
    std::vector<MessageArg> named;
    for (int of = 0; of < deviation_count; ++of) {
        if (clear[of] >= least) {
            named.push_back(
                words(texts[static_cast<std::size_t>(of)], {number_arg(100 * sd[of], 2)}));
        }
    }
    if (named.empty()) {  // not finite
        return {};
    }
    return listed(named, VYBEG_MESSAGE("Words", "%1, %2"));
}

}  // namespace

SetExamination examine_set(const FitProblem& problem, const MapFit& joint,
                           std::optional<double> spread, const JobControl& job) {
    return Examination(problem, joint, spread, job).made();
}

SetExamination agreeing_set(const FitProblem& problem, const MapFit& joint,
                            std::optional<double> spread, const JobControl& job) {
    return Examination(problem, joint, spread, job).agreeing();
}

void add_findings(const SetExamination& examination, bool assumed, ResonatorFit& fit) {
    const auto add = [&fit](DiagnosticKind kind, std::vector<MessageArg> args) {
        fit.warnings.insert(fit.warnings.begin(), Diagnostic{kind, std::move(args)});
    };
    const RunDeviation& sd = examination.spread.sd;
    switch (examination.verdict) {
        case SetVerdict::fits:
            if (assumed && sd[decay_deviates] > 0) {
                add(DiagnosticKind::set_too_small, {number_arg(100 * sd[decay_deviates], 2),
                                                    number_arg(100 * sd[split_deviates], 2),
                                                    number_arg(100 * sd[kappa_deviates], 2)});
            }
            break;
        case SetVerdict::spread:
            add(DiagnosticKind::recordings_differ, {differing(examination)});
            break;
        case SetVerdict::refused: add(DiagnosticKind::set_inconsistent, {}); break;
        case SetVerdict::foreign:
        case SetVerdict::several:
            add(examination.verdict == SetVerdict::foreign ? DiagnosticKind::foreign_recording
                                                           : DiagnosticKind::foreign_among,
                {either(examination.foreign), examination.cause});
            break;
    }
}

void conclude(SetExamination examination, bool assumed, ResonatorFit& fit) {
    if (!examination.agrees()) {
        refuse_all({ReasonCode::set_refused, {}}, fit);
    }
    if (examination.verdict == SetVerdict::foreign) {
        examination.verdict = SetVerdict::several;
    }
    add_findings(examination, assumed, fit);
}

}  // namespace vybeg
