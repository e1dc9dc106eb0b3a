#pragma once

#include "core/estimators/wave/flags.h"
#include "core/estimators/wave/wave_state.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

namespace vybeg {

enum class Algorithm {
    in_phase,
    phase_shift,
    moving_axes,
    demodulation,
    conjugate_gradient,
    maximum_likelihood
};

// Command-line name, e.g. "maximum-likelihood", and back.
std::string_view algorithm_name(Algorithm algorithm);
std::optional<Algorithm> algorithm_from_name(std::string_view name);

// Where the conjugate gradient starts each window: from the in-phase closed form, or from the
// result of the window before.
enum class StartRule { first, previous };

// Start values typed by the engineer; they replace the in-phase start of the first window (rule
// `previous`) or of every window (rule `first`). alpha is at the centre of the first window and is
// carried to the others with the frequency.
struct StartValues {
    WaveState state;
    double f_hz = 0;

    friend bool operator==(const StartValues&, const StartValues&) = default;
};

// White noise, sd per sample and channel in recording units, under which the phasors and the
// frequency of a window would be as uncertain as they are.
struct EquivalentNoise {
    double phasors = 0;
    double frequency = 0;

    friend bool operator==(const EquivalentNoise&, const EquivalentNoise&) = default;
};

// What is found in one window. NaN where a value does not exist; `flags` says why.
struct WaveEstimate {
    WaveState state;          // alpha at the window's centre
    double f_hz = 0;          // omega / 2 pi, the mean frequency f_cp
    double delta_phi_CD = 0;  // rad, in (-pi, pi]
    double rms = 0;           // sqrt(F), recording units
    double noise = 0;  // per sample and channel, recording units: sqrt(n F/(2n - parameters))
    double orthogonality = 0;  // <S_A S_B> / (<S_A^2> + <S_B^2>), the check of (30)
    WaveState sd;              // one standard deviation each
    double sd_f_hz = 0;
    double sd_delta_phi_CD = 0;
    double leakage_f_hz = 0;  // algorithms 1 to 4: f_hz less that of the best wave; else 0
    Flags flags = 0;
};

// Consecutive windows over one stretch of samples. c and d have equal length; window k covers
// [first + k hop, first + k hop + length) of them. What lies around is context, which some
// algorithms use.
struct WindowBlock {
    std::span<const double> c;
    std::span<const double> d;
    std::int64_t first = 0;
    std::int64_t length = 0;
    std::int64_t hop = 0;
};

// How an estimator is set up for one analysis.
struct EstimatorOptions {
    std::int64_t length = 0;  // samples per window
    double rate_hz = 0;
    double f0_hz =
        0;  // carrier; the search is bracketed to its main lobe, |f - f0| < rate / length
    StartRule start = StartRule::first;  // conjugate gradient only
    std::optional<StartValues> initial;  // conjugate gradient only
    double first_centre_s = 0;           // where initial->state.alpha holds
    // Known where the noise is not white; else the residual of each window tells it.
    std::optional<EquivalentNoise> noise = std::nullopt;
};

class Estimator {
public:
    virtual ~Estimator() = default;

    // Samples needed on both sides of a window; a window without them is flagged as gap.
    virtual std::int64_t context() const { return 0; }

    // True where a window's estimate needs the one before it: such blocks are not spread over
    // threads.
    virtual bool sequential() const { return false; }

    // Fills out[k] for the windows of a block; centre_s is the time of window 0's centre.
    virtual void estimate(const WindowBlock& block, double centre_s,
                          std::span<WaveEstimate> out) = 0;
};

// One estimator for one thread of one analysis.
std::unique_ptr<Estimator> make_estimator(Algorithm algorithm, const EstimatorOptions& options);

}  // namespace vybeg
