#pragma once

#include "core/estimators/wave/wave_state.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace vybeg {

// Why a window's value is missing or doubtful. A window may have several reasons.
enum class Flag : std::uint16_t {
    no_quadrature = 1,  // the algorithm does not estimate a_B
    circular = 2,       // a_A = |a_B| within the noise: the angle is undefined
    // Samples are missing inside the window or around it where they are needed (no values), or were
    // lost inside it (values mix the times before and after the loss).
    gap = 4,
    not_converged = 8,
    at_bound = 16,          // the frequency reached the edge of the main lobe
    clipped = 32,           // samples inside the window lie at the rail of the converter
    filter_transient = 64,  // the band-pass at the window reaches beyond an end of the recording
    delay_reach = 128,      // the quarter-period delay reaches beyond the samples (algorithm 2)
    // The closed form lies more than one standard deviation from the best wave of its window.
    leakage = 256,
    // A slow variable bends inside the window by 0.6 of its standard deviation, the residual is far
    // above the recording's noise, or the branch of the angle between windows is unknown.
    moving = 512,
};

using Flags = std::uint16_t;  // any number of Flag, or-ed

inline constexpr Flags operator|(Flag a, Flag b) {
    return static_cast<Flags>(static_cast<Flags>(a) | static_cast<Flags>(b));
}
inline constexpr bool has(Flags flags, Flag flag) {
    return (flags & static_cast<Flags>(flag)) != 0;
}
inline constexpr void set(Flags& flags, Flag flag) {
    flags = static_cast<Flags>(flags | static_cast<Flags>(flag));
}

// Text of the flags in the track CSV, joined by ';', e.g. "gap;not-converged"; empty without flags.
std::string flags_text(Flags flags);
// Upper limit of the length of such a text.
inline constexpr std::size_t longest_flags_text = 128;

enum class Algorithm {
    in_phase,
    phase_shift,
    moving_axes,
    demodulation,
    conjugate_gradient,
    maximum_likelihood
};

inline constexpr std::array all_algorithms{
    Algorithm::in_phase,     Algorithm::phase_shift,        Algorithm::moving_axes,
    Algorithm::demodulation, Algorithm::conjugate_gradient, Algorithm::maximum_likelihood};

// Command-line name, e.g. "maximum-likelihood", and back.
std::string_view algorithm_name(Algorithm algorithm);
// All names, separated by commas, the last by "or".
std::string algorithm_names();
std::optional<Algorithm> algorithm_from_name(std::string_view name);

// Start of the conjugate gradient in each window: the in-phase closed form (`first`), or the result
// of the window before (`previous`).
enum class StartRule { first, previous };

// Start values typed by the user; they replace the in-phase start of the first window (rule
// `previous`) or of every window (rule `first`). alpha is at the centre of the first window and is
// carried to the others with the frequency.
struct StartValues {
    WaveState state;
    double f_hz = 0;

    friend bool operator==(const StartValues&, const StartValues&) = default;
};

// White noise that gives the phasors and the frequency of a window their actual uncertainty; sd per
// sample and channel, recording units.
struct EquivalentNoise {
    double phasors = 0;
    double frequency = 0;

    friend bool operator==(const EquivalentNoise&, const EquivalentNoise&) = default;
};

// Estimate of one window. A value that does not exist is NaN; `flags` holds the reasons.
struct WaveEstimate {
    WaveState state;          // alpha at the window's centre
    double f_hz = 0;          // omega / 2 pi, the mean frequency f_cp
    double delta_phi_CD = 0;  // rad, in (-pi, pi]
    double rms = 0;           // sqrt(F), recording units
    double noise = 0;  // per sample and channel, recording units: sqrt(n F/(2n - parameters))
    // The same of the best wave, without the linear part of the wave's motion inside the window, 2n
    // - 8 degrees of freedom: the deviations are those of this noise.
    double steady_noise = 0;
    double orthogonality = 0;  // <S_A S_B> / (<S_A^2> + <S_B^2>), the check of (30)
    WaveErrors sd;             // one standard deviation each
    WaveErrors leakage;  // algorithms 1 to 4: values less those of the best wave; 0 for 5 and 6
    Flags flags = 0;
};

// Consecutive windows over one segment of samples. c and d have equal length; window k covers
// [first + k hop, first + k hop + length). Samples around the windows are context for some
// algorithms.
struct WindowBlock {
    std::span<const double> c;
    std::span<const double> d;
    std::int64_t first = 0;
    std::int64_t length = 0;
    std::int64_t hop = 0;
};

// Options of an estimator for one analysis.
struct EstimatorOptions {
    std::int64_t length = 0;  // samples per window
    double rate_hz = 0;
    double f0_hz =
        0;  // carrier; the search is bracketed to its main lobe, |f - f0| < rate / length
    StartRule start = StartRule::first;                 // conjugate gradient only
    std::optional<StartValues> initial = std::nullopt;  // conjugate gradient only
    double first_centre_s = 0;                          // time to which initial->state.alpha refers
    // Known noise, for noise that is not white; otherwise it follows from the residual of each
    // window.
    std::optional<EquivalentNoise> noise = std::nullopt;
};

class Estimator {
public:
    virtual ~Estimator() = default;

    // Number of samples needed on both sides of a window; without them it is flagged delay-reach.
    virtual std::int64_t context() const { return 0; }

    // Whether the estimate of a window needs that of the window before; such blocks are not
    // distributed over threads.
    virtual bool sequential() const { return false; }

    // Fills out[k] for the windows of a block; centre_s is the time of window 0's centre.
    virtual void estimate(const WindowBlock& block, double centre_s,
                          std::span<WaveEstimate> out) = 0;
};

// One estimator for one thread of one analysis.
std::unique_ptr<Estimator> make_estimator(Algorithm algorithm, const EstimatorOptions& options);

}  // namespace vybeg
