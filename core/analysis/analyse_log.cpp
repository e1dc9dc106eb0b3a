#include "core/analysis/analyse_log.h"

#include "core/analysis/phasor_log.h"
#include "core/analysis/power_log.h"
#include "core/analysis/setting_table.h"
#include "core/estimators/wave/estimator.h"
#include "core/estimators/wave/wave_state.h"
#include "core/numerics/statistics.h"
#include "core/track/unwrap.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>

namespace vybeg {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

// Row of a track that is written.
class Row {
public:
    Row(Track& track, std::size_t row) : track_(track), row_(row) {}

    void put(SlowVariable variable, double value, double sd) {
        track_.values(variable)[row_] = value;
        track_.sds(variable)[row_] = sd;
    }

private:
    Track& track_;
    std::size_t row_;
};

double power_at(const PhasorRun& run, std::size_t k) {
    return std::norm(run.c[k]) + std::norm(run.d[k]);
}

// Turns of the phase from a window to the next, relative to f_ref.
double advance(const PhasorRun& run, std::size_t k) {
    return std::arg(std::conj(run.c[k]) * run.c[k + 1] + std::conj(run.d[k]) * run.d[k + 1]) /
           two_pi;
}

// Across the neighbours, whose noise remains.
void put_frequency(const PhasorRun& run, std::size_t k, Row& row) {
    const std::size_t first = k > 0 ? k - 1 : 0;
    const std::size_t last = std::min(k + 1, run.time_s.size() - 1);
    if (first == last) {
        return;
    }
    double turns = 0;
    for (std::size_t at = first; at < last; ++at) {
        turns += advance(run, at);
    }
    const double seconds = run.time_s[last] - run.time_s[first];
    const double before = run.sd[first] / std::sqrt(power_at(run, first));
    const double behind = run.sd[last] / std::sqrt(power_at(run, last));
    const std::size_t lag = last - first;
    const double shared =
        lag < run.noise_correlation.size() ? run.noise_correlation[lag] * before * behind : 0;
    const double sd = std::sqrt(before * before + behind * behind - 2 * shared);
    row.put(SlowVariable::f, run.f_ref_hz + turns / seconds, sd / (two_pi * seconds));
}

void put_wave(const PhasorRun& run, std::size_t k, Track& track) {
    Row row(track, k);
    const Phasors phasors{run.c[k], run.d[k]};
    const WaveState state = to_wave_state(phasors);
    const double sd = run.sd[k];
    row.put(SlowVariable::a_A, state.a_A, sd);
    row.put(SlowVariable::a_B, state.a_B, sd);
    track.values(SlowVariable::delta_phi_CD)[k] = phase_difference(phasors);
    // The smaller travelling wave has a deviation of sd sqrt(2) in modulus.
    const double smaller = state.a_A - std::abs(state.a_B);
    if (!(smaller * smaller > 18 * sd * sd && smaller > 1e-12 * state.a_A)) {
        set(track.flags()[k], Flag::circular);
        return;
    }
    const double difference = state.a_A * state.a_A - state.a_B * state.a_B;
    const double sd_angle = sd * std::sqrt(power_at(run, k)) / difference;
    row.put(SlowVariable::two_theta_A, state.two_theta_A, sd_angle);
    if (!run.phase_lost) {
        // alpha is that of the carrier at the window's centre.
        const double turned = state.alpha - two_pi * std::fmod(run.f_ref_hz * run.time_s[k], 1.0);
        row.put(SlowVariable::alpha, std::remainder(turned, two_pi), sd_angle);
    }
}

Track track_of(const PhasorRun& run, double noise_sd) {
    Track track(run.time_s.size());
    for (std::size_t k = 0; k < run.time_s.size(); ++k) {
        track.time_s()[k] = run.time_s[k];
        track.values(SlowVariable::noise)[k] = noise_sd;
        put_wave(run, k, track);
        if (!run.phase_lost) {
            Row row(track, k);
            put_frequency(run, k, row);
        }
    }
    unwrap_angle(track, 0);
    return track;
}

Result<PhasorLog> read_as_phasors(const std::filesystem::path& path, const OpenOptions& options,
                                  const LogChoice& choice, const SignalSettings& signal,
                                  const JobControl& job) {
    if (!choice.without_phase()) {
        return read_phasor_log(path, options, choice, signal, job);
    }
    constexpr std::size_t all_rows = std::numeric_limits<std::size_t>::max() / 2;
    const auto powers = TRY(read_power_log(path, options, choice, signal, job));
    PhasorLog log{phasors_without_phase(powers, all_rows), 0,
                  static_cast<std::int64_t>(powers.time_s.size()), 1, 0};
    if (log.run.time_s.empty()) {
        return Error{ErrorCode::no_valid_samples, path.string(), {}};
    }
    for (double& time : log.run.time_s) {
        time += powers.time_s.front();
    }
    log.run.f_ref_hz = std::numeric_limits<double>::quiet_NaN();
    log.noise_sd = median(log.run.sd);
    return log;
}

}  // namespace

Result<Analysis> analyse_log(const std::filesystem::path& path, const OpenOptions& options,
                             const LogChoice& choice, const Settings& settings,
                             const JobControl& job) {
    TRY(validate(settings));
    const double begun = job.now();
    const auto log = TRY(read_as_phasors(path, options, choice, settings, job));
    Analysis analysis;
    analysis.timing.read_s = job.now() - begun;
    analysis.timing.threads = 1;
    analysis.settings = settings;
    analysis.settings.f0_hz = log.run.f_ref_hz;
    analysis.settings.window = analysis.settings.hop = log.rows_per_window;
    analysis.settings.periods.reset();
    analysis.plan = {0, log.rows_per_window, log.rows_per_window,
                     static_cast<std::int64_t>(log.run.time_s.size())};
    analysis.residual = std::numeric_limits<double>::quiet_NaN();
    analysis.track = track_of(log.run, log.noise_sd);
    // Neighbours of a window but one share the phase between them.
    analysis.f_correlation = {1, 0, -0.5};
    analysis.means = summarise(analysis.track, 1, analysis.f_correlation);
    return analysis;
}

}  // namespace vybeg
