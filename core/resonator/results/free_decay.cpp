#include "core/resonator/results/free_decay.h"

#include "core/base/number_text.h"
#include "core/numerics/statistics.h"
#include "core/resonator/fit/map_fit.h"
#include "core/resonator/model/phasor_run.h"
#include "core/resonator/results/misfit_cause.h"
#include "core/resonator/results/reported_estimates.h"
#include "core/resonator/results/resonator_parameters.h"
#include "core/resonator/results/set_fit.h"
#include "core/resonator/runs/decay.h"
#include "core/resonator/runs/merge_windows.h"
#include "core/resonator/runs/sum_of_modes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

constexpr double clear = 5;             // standard deviations
constexpr std::size_t least_part = 16;  // windows

bool warns_of(const ResonatorFit& fit, std::initializer_list<DiagnosticKind> kinds) {
    return std::ranges::any_of(fit.warnings, [&](const Diagnostic& warning) {
        return std::ranges::find(kinds, warning.kind) != kinds.end();
    });
}

// Whether the fit leaves a motion that is not that of a damping by another law.
bool leaves_motion(const ResonatorFit& fit) {
    return warns_of(fit, {DiagnosticKind::residual_above_noise, DiagnosticKind::residual_coloured,
                          DiagnosticKind::motion_not_model, DiagnosticKind::misfit_settling,
                          DiagnosticKind::misfit_neighbour, DiagnosticKind::misfit_channel,
                          DiagnosticKind::misfit_pickoff, DiagnosticKind::misfit_springs,
                          DiagnosticKind::mode_grows, DiagnosticKind::fit_not_converged});
}

// Whether the fit leaves noise only.
bool explains_all(const ResonatorFit& fit) {
    return !leaves_motion(fit) && !warns_of(fit, {DiagnosticKind::misfit_damping});
}

// Whether the set holds a recording for which a verdict may be the cause.
bool is_refused(const ResonatorFit& fit) {
    return warns_of(fit,
                    {DiagnosticKind::structured_refused, DiagnosticKind::foreign_among,
                     DiagnosticKind::set_inconsistent, DiagnosticKind::anisotropy_not_passive});
}

// Whether the motion has another cause that the fit has named.
bool named_otherwise(const ResonatorFit& fit) {
    return warns_of(fit, {DiagnosticKind::misfit_settling, DiagnosticKind::misfit_channel,
                          DiagnosticKind::fitted_phase_step});
}

// Causes that a verdict on a recording of the fit replaces. On one left out of the set it replaces
// the way in which this recording differs.
void withdraw(std::size_t recording, ResonatorFit& fit) {
    if (fit.left_out == recording) {
        for (Diagnostic& warning : fit.warnings) {
            if (warning.kind == DiagnosticKind::foreign_recording) {
                warning.args[1] = Phrase::tr("it is no free decay");
            }
        }
        return;
    }
    std::erase_if(fit.warnings, [](const Diagnostic& warning) {
        return warning.kind == DiagnosticKind::misfit_damping ||
               warning.kind == DiagnosticKind::misfit_neighbour ||
               warning.kind == DiagnosticKind::misfit_pickoff ||
               warning.kind == DiagnosticKind::structured_refused;
    });
}

// Two modes with amplitudes of their own in each channel, if they leave noise only.
std::optional<ModeSum> two_modes(const PhasorRun& run) {
    const std::optional<ModeSum> sum = sum_of_modes(run, 2);
    const bool noise = sum && sum->chi2 < noise_limit(sum->freedom);
    return noise ? sum : std::nullopt;
}

// Whether what a motion leaves of a run is one line far from the carrier from start to end, which
// decays steadily: neither another damping nor the rest of a drive or of a knock.
bool leaves_a_line(const PhasorRun& run, const std::vector<Phasors>& z) {
    constexpr std::size_t parts = 8;
    constexpr double pure = 0.9;         // correlation from window to window
    constexpr double same = 0.2;         // rad from window to window
    constexpr double steady = 1.5;       // of the power's ratios from part to part
    constexpr double least_cycles = 20;  // from the carrier, over the run
    const std::size_t count = run.time_s.size();
    if (run.phase_lost || count < parts * least_part) {
        return false;
    }
    std::complex<double> of_wave = 0;  // from window to window
    std::vector<std::complex<double>> turns;
    std::vector<double> powers;
    for (std::size_t part = 0; part < parts; ++part) {
        std::complex<double> turn = 0;
        double power = 0;
        Phasors before{};
        for (std::size_t k = count * part / parts; k < count * (part + 1) / parts; ++k) {
            const Phasors left{run.c[k] - z[k].c, run.d[k] - z[k].d};
            turn += std::conj(before.c) * left.c + std::conj(before.d) * left.d;
            power += std::norm(left.c) + std::norm(left.d);
            before = left;
            if (k > 0) {
                of_wave += std::conj(z[k - 1].c) * z[k].c + std::conj(z[k - 1].d) * z[k].d;
            }
        }
        turns.push_back(turn);
        powers.push_back(power);
        if (!(std::abs(turn) > pure * power) || !(std::abs(std::arg(turn / turns[0])) < same)) {
            return false;
        }
    }
    std::vector<double> ratios;
    for (std::size_t part = 1; part < parts; ++part) {
        ratios.push_back(powers[part] / powers[part - 1]);
    }
    const auto [least, most] = std::ranges::minmax(ratios);
    const double cycles = std::abs(std::arg(turns[0] * std::conj(of_wave))) /
                          (2 * std::numbers::pi) * static_cast<double>(count);
    return most < steady * least && cycles > least_cycles;
}

// Windows from one index to another.
struct Part {
    std::size_t first = 0;
    std::size_t end = 0;

    std::size_t size() const { return end - first; }
};

class Judgement {
public:
    Judgement(std::span<const PhasorRun> runs, const FitOptions& options, const JobControl& job,
              ResonatorFit& fit)
        : options_(with_assumed(options)), job_(job), fit_(fit) {
        for (const PhasorRun& run : runs) {
            runs_.push_back(usable_windows(run));
            laws_.push_back(decay_law(runs_.back()));
        }
    }

    // All recordings, or that which the set leaves out.
    void add(bool all) {
        for (std::size_t k = 0; k < runs_.size() && !job_.cancelled(); ++k) {
            if (!(all || fit_.left_out == k) || laws_[k].windows == 0 || driven(k)) {
                continue;
            }
            // They are a free decay, also where the fit has missed it.
            if (const std::optional<ModeSum> two = two_modes(runs_[k])) {
                judge_modes(k, *two);
                continue;
            }
            const ResonatorFit* alone = &fit_;
            std::optional<ResonatorFit> single;
            if (runs_.size() > 1) {
                if (leaves_a_line(runs_[k], predicted_phasors(fit_.motion, k, runs_[k].time_s))) {
                    continue;
                }
                single = fitted(runs_[k]);
                alone = single ? &*single : nullptr;
            }
            if (alone != nullptr) {
                judge(k, *alone);
            }
        }
    }

private:
    std::optional<ResonatorFit> fitted(const PhasorRun& run) const {
        Result<ResonatorFit> fit = fit_resonator({&run, 1}, options_, job_);
        return fit ? std::optional(std::move(*fit)) : std::nullopt;
    }

    void say(DiagnosticKind kind, std::vector<MessageArg> args) {
        fit_.warnings.push_back({kind, std::move(args)});
    }

    void say_driven(std::size_t k, MessageArg how) {
        if (fit_.left_out == k) {
            withdraw(k, fit_);
        }
        say(DiagnosticKind::no_free_decay, {recording_arg(k), std::move(how)});
    }

    // Growth, or an amplitude held while those of the others fall.
    bool driven(std::size_t k) {
        constexpr double least_growth = 0.01;
        constexpr double most_of_it = 0.8;
        constexpr double held_below = 0.1;  // of the others' rate
        const DecayLaw& law = laws_[k];
        const double rate = law.line_per_s;
        const double length_s = runs_[k].time_s.back() - runs_[k].time_s.front();
        const double is_line = law.still_chi2 - law.line_chi2;
        if (rate < -clear * law.per_s_sd && -rate * length_s > least_growth &&
            is_line > most_of_it * (law.still_chi2 - static_cast<double>(law.windows))) {
            say_driven(k, Phrase::tr("its amplitude grows, by %1 1/s (standard deviation %2)",
                                     {number_arg(-rate, 3), number_arg(law.per_s_sd, 2)}));
            return true;
        }
        std::vector<double> others;
        for (std::size_t j = 0; j < laws_.size(); ++j) {
            if (j != k && laws_[j].windows > 0) {
                others.push_back(laws_[j].line_per_s);
            }
        }
        if (others.empty()) {
            return false;
        }
        const double usual = median(others);
        const double most = held_below * usual;
        const double model = modelled_rate(k);
        if (!(usual > 0) || !(std::abs(rate) + 2 * law.per_s_sd < most) ||
            !(model - rate > std::max(most, clear * law.per_s_sd))) {
            return false;
        }
        say_driven(k, Phrase::tr("its amplitude is held (decay rate %1 1/s), while that of the "
                                 "other recordings decays (%2 1/s)",
                                 {number_arg(rate, 2), number_arg(usual, 3)}));
        return true;
    }

    // A drive at its own frequency holds one motion while that of the start decays.
    void judge_modes(std::size_t k, const ModeSum& two) {
        constexpr double held_below = 0.02;  // of the other's rate, the deviation included
        constexpr double least_share = 0.1;  // of the other's amplitude
        constexpr double least_fall = 1;     // of the logarithm of the other's amplitude
        const std::size_t held = two.rates[0].real() > two.rates[1].real() ? 0 : 1;
        const std::size_t other = 1 - held;
        const double rate = -two.rates[held].real();
        const double usual = -two.rates[other].real();
        const double width = 3 * two.rate_sd[held];
        const double length_s = runs_[k].time_s.back() - runs_[k].time_s.front();
        if (std::abs(rate) < width && std::abs(rate) + width < held_below * usual &&
            usual * length_s > least_fall &&
            two.shapes[held].norm() > least_share * two.shapes[other].norm()) {
            withdraw(k, fit_);
            say(DiagnosticKind::no_free_decay,
                {recording_arg(k),
                 Phrase::tr("one of its two motions is held, as by a drive (decay rate %1 1/s), "
                            "while the other decays (%2 1/s)",
                            {number_arg(rate, 2), number_arg(usual, 3)})});
        }
    }

    // Decay rate of the amplitude that the fit of the set predicts for a recording.
    double modelled_rate(std::size_t k) const {
        PhasorRun expected = runs_[k];
        const std::vector<Phasors> z = predicted_phasors(fit_.motion, k, expected.time_s);
        for (std::size_t window = 0; window < z.size(); ++window) {
            expected.c[window] = z[window].c;
            expected.d[window] = z[window].d;
        }
        return decay_law(expected).line_per_s;
    }

    // A recording that is not two modes.
    void judge(std::size_t k, const ResonatorFit& alone) {
        const DecayLaw& law = laws_[k];
        const bool unlike = warns_of(alone, {DiagnosticKind::structured_refused});
        if (explains_all(alone) && !unlike) {
            return;
        }
        const PhasorRun& run = runs_[k];
        const std::size_t of_fit = runs_.size() > 1 ? 0 : k;
        const double left =
            log_amplitude_chi2(run, predicted_phasors(alone.motion, of_fit, run.time_s));
        const double needed = 25 * law.scatter();
        constexpr double at_noise = 1.5;
        constexpr double little = 0.02;
        const auto count = static_cast<double>(law.windows);
        const bool exact =
            law.scatter() < at_noise || law.chi2 - count < little * (law.line_chi2 - count);
        const bool by_law = law.departs() && (left - law.chi2 > needed || (unlike && exact));
        if (by_law && exact) {
            add_law(k);
        } else if (leaves_motion(alone) && !named_otherwise(alone)) {
            if (const std::optional<Part> part = free_part(seen_windows(run))) {
                withdraw(k, fit_);
                say(DiagnosticKind::no_free_decay_part,
                    {recording_arg(k),
                     number_arg(std::max(run.time_s[part->first] - run.window_s / 2, 0.0), 4),
                     number_arg(run.time_s[part->end - 1] + run.window_s / 2, 4)});
            } else if (by_law) {
                add_law(k);
            }
        }
    }

    void add_law(std::size_t k) {
        constexpr double dominates = 0.5;
        const DecayLaw& law = laws_[k];
        const double exponent = law.power - 1;
        fit_.runs[k].law = law;
        if (std::abs(exponent) > dominates) {
            withdraw(k, fit_);
            say(DiagnosticKind::no_free_decay,
                {recording_arg(k), Phrase::tr("its damping is by %1, the decay rate goes with the "
                                              "amplitude to the power %2 (standard deviation %3)",
                                              {friction_words(exponent), number_arg(exponent, 3),
                                               number_arg(law.power_sd, 2)})});
        } else if (fit_.left_out != k && !warns_of(fit_, {DiagnosticKind::misfit_damping})) {
            say(DiagnosticKind::misfit_damping,
                {friction_words(exponent), number_arg(100 * std::abs(exponent), 2)});
        }
    }

    // The fit of a part that it explains; without breaks, as a part that has one is not free.
    std::optional<ResonatorFit> fit_of(const PhasorRun& run, const Part& part) const {
        if (part.size() < least_part || job_.cancelled()) {
            return {};
        }
        const std::vector<PhasorRun> kept{kept_windows(run, part.first, part.end)};
        const std::unique_ptr<SetFit> set =
            solved_set(kept, {largest_amplitude(kept), options_, job_});
        if (!set->at_noise()) {
            return {};
        }
        ResonatorFit fit = set->described();
        return explains_all(fit) ? std::optional(std::move(fit)) : std::nullopt;
    }

    // The part that decays freely, if the rest does not. `run`: its windows with a wave.
    std::optional<Part> free_part(const PhasorRun& run) const {
        const std::size_t count = run.time_s.size();
        for (const auto& [from, to] : {std::pair(1, 3), std::pair(2, 4), std::pair(0, 2)}) {
            const auto quarter = [count](int k) { return count * static_cast<std::size_t>(k) / 4; };
            Part part{quarter(from), quarter(to)};
            std::optional<ResonatorFit> fit = fit_of(run, part);
            if (!fit) {
                continue;
            }
            extend(run, part, *fit);
            const bool whole = part.size() == count;
            return whole || rest_is_similar(run, part) ? std::nullopt : std::optional(part);
        }
        return {};
    }

    // Extends the part as far as the motion continues as fitted, as long as that part still fits.
    void extend(const PhasorRun& run, Part& part, ResonatorFit fit) const {
        constexpr int rounds = 3;
        for (int round = 0; round < rounds; ++round) {
            Part wider = continued(run, part, fit);
            std::optional<ResonatorFit> next;
            for (int attempt = 0; attempt < 3 && wider.size() > part.size(); ++attempt) {
                next = fit_of(run, wider);
                if (next) {
                    break;
                }
                wider.first = (2 * wider.first + part.first + 2) / 3;
                wider.end = (2 * wider.end + part.end) / 3;
            }
            if (!next) {
                return;
            }
            const bool little = 20 * (wider.size() - part.size()) < part.size();
            part = wider;
            fit = std::move(*next);
            if (little) {
                return;
            }
        }
    }

    static Part continued(const PhasorRun& run, const Part& part, const ResonatorFit& fit) {
        constexpr std::size_t block = 4;
        constexpr double departs = 4;  // mean square over that of the noise
        const std::vector<Phasors> z = predicted_phasors(fit.motion, 0, run.time_s);
        const auto continues = [&](std::size_t first, std::size_t end) {
            double sum = 0;
            for (std::size_t k = first; k < end; ++k) {
                sum += (std::norm(run.c[k] - z[k].c) + std::norm(run.d[k] - z[k].d)) /
                       (run.sd[k] * run.sd[k]);
            }
            return sum < departs * 4 * static_cast<double>(end - first);
        };
        Part wider = part;
        while (wider.first > 0) {
            const std::size_t next = wider.first - std::min(block, wider.first);
            if (!continues(next, wider.first)) {
                break;
            }
            wider.first = next;
        }
        while (wider.end < run.time_s.size()) {
            const std::size_t next = std::min(wider.end + block, run.time_s.size());
            if (!continues(wider.end, next)) {
                break;
            }
            wider.end = next;
        }
        return wider;
    }

    // Whether what lies outside the part decays freely at a similar rate: an event, not a drive.
    bool rest_is_similar(const PhasorRun& run, const Part& part) const {
        constexpr double similar = 0.3;
        const auto rate_of = [&](const Part& where) {
            return decay_law(kept_windows(run, where.first, where.end)).line_per_s;
        };
        const double usual = rate_of(part);
        for (const Part& rest : {Part{0, part.first}, Part{part.end, run.time_s.size()}}) {
            if (rest.size() < least_part) {
                continue;
            }
            if (fit_of(run, rest) && std::abs(rate_of(rest) - usual) < similar * std::abs(usual)) {
                return true;
            }
        }
        return false;
    }

    std::vector<PhasorRun> runs_;
    std::vector<DecayLaw> laws_;
    FitOptions options_;  // what the usual errors of channels explain is no motion
    const JobControl& job_;
    ResonatorFit& fit_;
};

// Weighted mean over recordings; its deviation by the scatter where that is the larger.
class Mean {
public:
    void add(double value, double sd) {
        values_.push_back(value);
        weights_.push_back(1 / (sd * sd));
    }

    Estimate estimate() const {
        double sum = 0;
        double all = 0;
        for (std::size_t k = 0; k < values_.size(); ++k) {
            sum += weights_[k] * values_[k];
            all += weights_[k];
        }
        const double mean = sum / all;
        double chi2 = 0;
        for (std::size_t k = 0; k < values_.size(); ++k) {
            chi2 += weights_[k] * (values_[k] - mean) * (values_[k] - mean);
        }
        const double freedom = std::max(static_cast<double>(values_.size()) - 1, 1.0);
        return {mean, std::sqrt(std::max(1.0, chi2 / freedom) / all), {}};
    }

private:
    std::vector<double> values_;
    std::vector<double> weights_;
};

ModeEstimate mode_of(const Mean& f_hz, const Mean& decay_per_s) {
    ModeEstimate mode;
    mode.f_hz = f_hz.estimate();
    mode.tau_s = decay_time(decay_per_s.estimate());
    mode.q = std::numbers::pi * mode.f_hz.value * mode.tau_s;
    return mode;
}

}  // namespace

Result<ResonatorFit> fit_one_projection(std::span<const PhasorRun> runs) {
    const Reason reason{ReasonCode::same_projection, {}};
    ResonatorFit fit;
    fit.model = ResonatorModel::free;
    refuse_resonator(reason, fit);
    RunEstimate run;
    refuse(run_parameters, reason, run);
    fit.runs.assign(runs.size(), run);
    std::array<Mean, 2> f_hz;  // of each mode
    std::array<Mean, 2> decay_per_s;
    double chi2 = 0;
    double freedom = 0;
    double squares = 0;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        const PhasorRun good = usable_windows(runs[k]);
        const std::optional<ModeSum> sum = sum_of_modes(good, 2);
        if (!sum) {
            return Error{ErrorCode::fit_failed,
                         "recording " + std::to_string(k + 1),
                         {Phrase::tr("there is no wave")}};
        }
        for (std::size_t mode = 0; mode < f_hz.size(); ++mode) {
            constexpr double turn = 2 * std::numbers::pi;
            const double sd = sum->rate_sd[mode];
            f_hz[mode].add(good.f_ref_hz + sum->rates[mode].imag() / turn, sd / turn);
            decay_per_s[mode].add(-sum->rates[mode].real(), sd);
        }
        chi2 += sum->chi2;
        freedom += sum->freedom;
        squares += sum->chi2 / sum->freedom * good.sd.front() * good.sd.front();
        if (shares_projection(good)) {
            fit.warnings.push_back({DiagnosticKind::same_projection, {recording_arg(k)}});
        }
    }
    fit.chi2_per_dof = chi2 / freedom;
    fit.residual_rms = std::sqrt(squares / static_cast<double>(runs.size()));
    if (!(fit.chi2_per_dof < noise_bound(freedom))) {
        fit.warnings.push_back(
            {DiagnosticKind::residual_above_noise, {number_arg(fit.chi2_per_dof, 3)}});
    }
    for (std::size_t mode = 0; mode < f_hz.size(); ++mode) {
        fit.modes.push_back(mode_of(f_hz[mode], decay_per_s[mode]));
    }
    return fit;
}

void judge_free_decay(std::span<const PhasorRun> runs, const FitOptions& options,
                      const JobControl& job, ResonatorFit& fit) {
    const bool all = !explains_all(fit) || is_refused(fit);
    if (all || fit.left_out) {
        Judgement(runs, options, job, fit).add(all);
    }
}

}  // namespace vybeg
