#include "core/analysis/phasor_windows.h"
#include "core/base/number_text.h"
#include "core/numerics/fft.h"
#include "core/numerics/kaiser.h"
#include "core/numerics/statistics.h"
#include "core/recording/checks/recording_check.h"
#include "core/windows/carrier_search.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace vybeg {
namespace {

constexpr std::int64_t most_segments = 32;
constexpr std::size_t longest_segment = std::size_t{1} << 20;
constexpr std::size_t most_frames_at_once = std::size_t{1} << 21;
// Half the main lobe of the window, and the distance from a line beyond which its skirt is gone.
constexpr std::ptrdiff_t main_lobe = 7;
constexpr std::ptrdiff_t skirt = 8;

// Side lobes of -150 dB: those of -92 dB hold as much as noise 60 dB below the carrier.
constexpr double kaiser_beta = 20;

// Power in the bins [first, first + size), in units of the variance per sample of white noise: of C
// and D in each segment, and the mean of both and of all segments.
struct Spectrum {
    double bin_hz = 0;
    std::ptrdiff_t first = 0;
    std::vector<std::array<std::vector<double>, 2>> segments;
    std::vector<double> mean;

    double hz(std::ptrdiff_t k) const { return static_cast<double>(first + k) * bin_hz; }
};

Result<Spectrum> spectrum_of(const ConditionedRecording& prepared, std::size_t size,
                             const Band& reach, double rate_hz, const JobControl& job) {
    Spectrum spectrum;
    spectrum.bin_hz = rate_hz / static_cast<double>(size);
    const auto half = static_cast<std::ptrdiff_t>(size / 2);
    spectrum.first = std::clamp(static_cast<std::ptrdiff_t>(reach.low_hz / spectrum.bin_hz),
                                std::ptrdiff_t{1}, half - 1);
    const auto end = std::clamp(static_cast<std::ptrdiff_t>(reach.high_hz / spectrum.bin_hz) + 2,
                                spectrum.first + 1, half);
    const auto bins = static_cast<std::size_t>(end - spectrum.first);
    spectrum.mean.assign(bins, 0);
    const std::vector<double> weights = kaiser_weights(size, kaiser_beta);
    double squares = 0;
    for (const double weight : weights) {
        squares += weight * weight;
    }
    // What the band-pass cannot fill at both ends is missing; segments overlap by half.
    const auto length = static_cast<std::int64_t>(size);
    const std::int64_t first = std::max(prepared.first, prepared.filter_reach);
    const std::int64_t last =
        std::min(prepared.end, prepared.ahead->frames() - prepared.filter_reach) - length;
    if (last < first) {
        return spectrum;
    }
    const std::int64_t segments = std::min({2 * (last - first) / length + 1, most_segments,
                                            static_cast<std::int64_t>(most_frames_at_once / size)});
    const std::int64_t step = prepared.ahead->seeks()
                                  ? (last - first) / std::max<std::int64_t>(segments - 1, 1)
                                  : length / 2;
    const Fft transform(size);
    std::vector<double> c(size);
    std::vector<double> d(size);
    std::vector<std::complex<double>> data(size);
    const std::int64_t least_still = least_still_frames(prepared.f0_hz, rate_hz);
    const auto add_segments = [&](bool with_still) -> Status {
        for (std::int64_t s = 0; s < segments; ++s) {
            TRY(job.go_on());
            TRY(prepared.ahead->read(first + s * step, c, d));
            bool whole = with_still || !stand_still(c, d, least_still);
            for (std::size_t j = 0; j < size; ++j) {
                whole = whole && std::isfinite(c[j]) && std::isfinite(d[j]);
                data[j] = {weights[j] * c[j], weights[j] * d[j]};
            }
            if (!whole) {
                continue;
            }
            transform.forward(data);
            auto& [of_c, of_d] = spectrum.segments.emplace_back();
            of_c.resize(bins);
            of_d.resize(bins);
            for (std::size_t k = 0; k < bins; ++k) {
                const std::size_t bin = static_cast<std::size_t>(spectrum.first) + k;
                // The transform of C + iD.
                const std::complex<double> above = data[bin];
                const std::complex<double> below = std::conj(data[size - bin]);
                of_c[k] = 0.25 * std::norm(above + below) / squares;
                of_d[k] = 0.25 * std::norm(above - below) / squares;
                spectrum.mean[k] += (of_c[k] + of_d[k]) / 2;
            }
        }
        return {};
    };
    TRY(add_segments(false));
    if (spectrum.segments.empty()) {  // samples were filled everywhere
        TRY(add_segments(true));
    }
    for (double& power : spectrum.mean) {
        power /= static_cast<double>(std::max<std::size_t>(spectrum.segments.size(), 1));
    }
    return spectrum;
}

struct Line {
    std::ptrdiff_t bin = 0;
    double f_hz = 0;
    double power = 0;
};

// Whether a valley a tenth as high lies between a peak and the higher bins around it.
bool stands_alone(const std::vector<double>& mean, std::ptrdiff_t peak) {
    const auto size = std::ssize(mean);
    const double height = mean[static_cast<std::size_t>(peak)];
    for (const std::ptrdiff_t way : {-1, 1}) {
        double valley = height;
        for (std::ptrdiff_t k = peak; k >= 0 && k < size; k += way) {
            const double here = mean[static_cast<std::size_t>(k)];
            valley = std::min(valley, here);
            if (here > height && valley > height / 10) {
                return false;
            }
        }
    }
    return true;
}

std::vector<Line> lines_of(const Spectrum& spectrum) {
    constexpr double least_of_strongest = 1e-7;
    const std::vector<double>& mean = spectrum.mean;
    std::vector<Line> lines;
    if (spectrum.segments.empty() || std::ssize(mean) < 2 * main_lobe + 3) {
        return lines;
    }
    // As in the search for the carrier, 16 dB for one segment; the mean of many scatters less.
    const double over = 1 + 39 / std::sqrt(static_cast<double>(spectrum.segments.size()));
    const double least =
        std::max(over * median(mean), least_of_strongest * *std::ranges::max_element(mean));
    for (std::ptrdiff_t k = 1; k + 1 < std::ssize(mean); ++k) {
        const auto at = static_cast<std::size_t>(k);
        if (mean[at] < least || mean[at] < mean[at - 1] || mean[at] <= mean[at + 1] ||
            !stands_alone(mean, k)) {
            continue;
        }
        const double shift = peak_shift(mean[at - 1], mean[at], mean[at + 1]);
        lines.push_back({k, spectrum.hz(k) + shift * spectrum.bin_hz, mean[at]});
    }
    return lines;
}

// The median density between the lines, segment by segment, so that a strike or a lost sample in
// one of them does not count.
void find_noise(const Spectrum& spectrum, const std::vector<Line>& lines, const Band& reach,
                CarrierLines& found) {
    std::vector<std::ptrdiff_t> between;
    for (std::ptrdiff_t k = 0; k < std::ssize(spectrum.mean); ++k) {
        const bool near = std::ranges::any_of(
            lines, [k](const Line& line) { return std::abs(k - line.bin) <= skirt; });
        if (!near && spectrum.hz(k) >= reach.low_hz && spectrum.hz(k) <= reach.high_hz) {
            between.push_back(k);
        }
    }
    if (between.size() < 8 || spectrum.segments.empty()) {
        return;
    }
    constexpr double correlated_bins = 2.5;  // of this window to an independent one
    const auto bins = static_cast<double>(between.size());
    // Each channel by itself: the median of a sum depends on how alike the channels' noises are.
    std::array<double, 2> density{};
    for (std::size_t channel = 0; channel < density.size(); ++channel) {
        std::vector<double> densities;
        for (const std::array<std::vector<double>, 2>& segment : spectrum.segments) {
            std::vector<double> powers;
            powers.reserve(between.size());
            for (const std::ptrdiff_t k : between) {
                powers.push_back(segment[channel][static_cast<std::size_t>(k)]);
            }
            // Of n exponentially distributed numbers the median has the mean ln 2 + 1/(2n).
            densities.push_back(median(std::move(powers)) /
                                (std::numbers::ln2 + correlated_bins / 2 / bins));
        }
        density[channel] = median(std::move(densities));
    }
    found.segments = static_cast<int>(spectrum.segments.size());
    found.noise_power = (density[0] + density[1]) / 2;
    // A median has 1.44 times the deviation of a mean, that of the segments 1.25 times.
    const double independent = bins * found.segments / correlated_bins;
    found.relative_sd = 1.44 * 1.25 / std::sqrt(independent) * std::hypot(density[0], density[1]) /
                        (density[0] + density[1]);
}

std::size_t segment_size(const ConditionedRecording& prepared, const SignalSettings& settings,
                         std::int64_t window, double rate_hz) {
    constexpr double per_window = 64;
    constexpr double per_band = 60;
    double wish = per_window * static_cast<double>(window);
    if (settings.filter) {
        wish = std::max(wish,
                        per_band * rate_hz / (settings.filter->high_hz - settings.filter->low_hz));
    }
    const auto frames = static_cast<std::size_t>(
        std::max<std::int64_t>(prepared.end - prepared.first - 2 * prepared.filter_reach, 1));
    const auto wished = std::bit_ceil(
        static_cast<std::size_t>(std::min(wish, static_cast<double>(longest_segment))));
    return std::min(wished, std::bit_floor(frames));
}

Band within(Band reach, const SignalSettings& settings, double rate_hz) {
    const Band band = settings.filter.value_or(Band{0, rate_hz / 2});
    return {std::max(reach.low_hz, band.low_hz), std::min(reach.high_hz, band.high_hz)};
}

// The line that is the carrier: the strongest one of the main lobe around f0, else the strongest.
std::optional<Line> strongest_near(const std::vector<Line>& lines, double f0_hz, double lobe_hz) {
    const auto weaker = [&](const Line& a, const Line& b) {
        const bool near_a = std::abs(a.f_hz - f0_hz) <= lobe_hz;
        const bool near_b = std::abs(b.f_hz - f0_hz) <= lobe_hz;
        return near_a != near_b ? near_b : a.power < b.power;
    };
    const auto found = std::ranges::max_element(lines, weaker);
    return found == lines.end() ? std::nullopt : std::optional(*found);
}

Result<std::vector<double>> mains_of(const ConditionedRecording& prepared, double lobe_hz,
                                     double rate_hz) {
    constexpr double seconds = 4;
    const auto count = static_cast<std::size_t>(
        std::min(static_cast<double>(prepared.end - prepared.first), seconds * rate_hz));
    std::vector<double> c(count);
    std::vector<double> d(count);
    TRY(prepared.ahead->read(prepared.first, c, d));
    std::vector<double> found;
    for (const MainsLine& line : mains_lines(c, d, rate_hz)) {
        if (std::abs(line.f_hz - prepared.f0_hz) > 4 * lobe_hz && line.f_hz < prepared.f0_hz) {
            found.push_back(line.f_hz);
        }
    }
    return found;
}

// Revolutions of a mode's phasor in a window: where the program chooses, and the engineer.
constexpr double most_turn = 0.1;
constexpr double most_chosen_turn = 0.25;

struct Length {
    std::int64_t samples = 0;
    bool chosen = false;  // by the engineer
};

Result<Length> wished_length(const PhasorWindowSettings& wished,
                             const ConditionedRecording& prepared, double rate_hz) {
    Length length;
    if (wished.periods) {
        length = {window_of_periods(*wished.periods, prepared.f0_hz, rate_hz), true};
    } else if (wished.window) {
        length = {*wished.window, true};
    } else {
        length.samples =
            default_phasor_window(prepared.end - prepared.first, prepared.f0_hz, rate_hz);
    }
    const std::int64_t least = least_phasor_window(prepared.f0_hz, rate_hz);
    if (length.samples < least) {
        return Error{
            ErrorCode::fit_window_too_short, "", {count_arg(length.samples), count_arg(least)}};
    }
    return length;
}

// How far the farther of the outer lines lies from a frequency, Hz.
double farthest(const CarrierLines& lines, double f_hz) {
    return std::max(std::abs(lines.lowest_hz - f_hz), std::abs(lines.highest_hz - f_hz));
}

// The window in which lines `away` from the reference turn by no more than they may.
Result<std::int64_t> slow_enough(const Length& wish, const CarrierLines& lines, double reference_hz,
                                 double rate_hz) {
    const double away = farthest(lines, reference_hz);
    const double most = wish.chosen ? most_chosen_turn : most_turn;
    if (away * static_cast<double>(wish.samples) <= most * rate_hz) {
        return wish.samples;
    }
    const auto fitting = static_cast<std::int64_t>(most * rate_hz / away);
    const std::int64_t least = least_phasor_window(reference_hz, rate_hz);
    const std::string low = short_text(lines.lowest_hz);
    const std::string high = short_text(lines.highest_hz);
    if (fitting < least) {
        return Error{ErrorCode::fit_beat_too_fast, "", {low, high, count_arg(least)}};
    }
    if (wish.chosen) {
        return Error{ErrorCode::fit_window_turns,
                     "",
                     {count_arg(wish.samples), low, high, count_arg(fitting)}};
    }
    return fitting;
}

// The same recording, prepared at another carrier without looking for anything again.
Result<ConditionedRecording> prepared_at(double f_hz, const ConditionedRecording& before,
                                         const Recording& recording, SignalSettings settings,
                                         const JobControl& job) {
    settings.f0_hz = f_hz;
    settings.calibration = before.calibration;
    Result<ConditionedRecording> prepared = prepare(recording, settings, job);
    if (prepared) {
        prepared->carrier_s += before.carrier_s;
    }
    return prepared;
}

// Looks at up to 32 segments of the prepared range, each of 64 windows (`window` samples) where
// the range is long enough, with a Kaiser window whose side lobes of -150 dB keep an offset and
// other modes out of the carrier's surroundings. A line is a peak of the mean spectrum
// above its noise and above 1e-7 of the strongest one. The modes' lines are those
// within 80 Hz (at most an eighth of the carrier, and within the band-pass) of the strongest line
// of the main lobe around f0; where the main lobe has none and the engineer gave f0, of the
// strongest line within 400 Hz (at most a third of f0). Errors: those of the source,
// carrier_not_near where the engineer gave f0 and there is no line, interrupted.
Result<CarrierLines> carrier_lines(const ConditionedRecording& prepared,
                                   const SignalSettings& settings, std::int64_t window,
                                   double rate_hz, const JobControl& job) {
    const double f0 = prepared.f0_hz;
    CarrierLines found;
    found.strongest_hz = found.lowest_hz = found.highest_hz = f0;
    const std::size_t size = segment_size(prepared, settings, window, rate_hz);
    if (size < 16) {
        return found;
    }
    const double lobe = rate_hz / static_cast<double>(window);
    const double far = std::min(settings.f0_hz ? 400.0 : 80.0, f0 / (settings.f0_hz ? 3 : 8));
    const Band wide = within({f0 - far, f0 + far}, settings, rate_hz);
    auto spectrum = TRY(spectrum_of(prepared, size, wide, rate_hz, job));
    std::vector<Line> lines = lines_of(spectrum);
    const std::optional<Line> carrier = strongest_near(lines, f0, lobe);
    if (!carrier && settings.f0_hz && !spectrum.segments.empty()) {
        return Error{ErrorCode::carrier_not_near, "", {number_arg(f0), number_arg(far, 3)}};
    }
    if (carrier) {
        const double near = std::min(80.0, carrier->f_hz / 8);
        found.strongest_hz = found.lowest_hz = found.highest_hz = carrier->f_hz;
        for (const Line& line : lines) {
            if (std::abs(line.f_hz - carrier->f_hz) <= near) {
                found.lowest_hz = std::min(found.lowest_hz, line.f_hz);
                found.highest_hz = std::max(found.highest_hz, line.f_hz);
            }
        }
        find_noise(spectrum, lines,
                   within({carrier->f_hz - near, carrier->f_hz + near}, settings, rate_hz), found);
    }
    found.mains_hz = TRY(mains_of(prepared, lobe, rate_hz));
    return found;
}

}  // namespace

std::int64_t least_phasor_window(double f0_hz, double rate_hz) {
    return std::max<std::int64_t>(16, static_cast<std::int64_t>(std::ceil(2 * rate_hz / f0_hz)));
}

std::int64_t default_phasor_window(std::int64_t frames, double f0_hz, double rate_hz) {
    constexpr double wish_s = 0.015;
    constexpr double periods = 12;
    const auto wish =
        static_cast<std::int64_t>(std::llround(std::max(wish_s, periods / f0_hz) * rate_hz));
    return std::max(
        {std::min(wish, frames / 64), frames / 16384 + 1, least_phasor_window(f0_hz, rate_hz)});
}

Result<WindowChoice> choose_windows(const Recording& recording, const SignalSettings& settings,
                                    const PhasorWindowSettings& wished, const JobControl& job) {
    const double rate = recording.rate_hz;
    auto prepared = TRY(prepare(recording, settings, job));
    const auto wish = TRY(wished_length(wished, prepared, rate));
    const double begun = job.now();
    auto lines = TRY(carrier_lines(prepared, settings, wish.samples, rate, job));
    prepared.carrier_s += job.now() - begun;
    const double given = prepared.f0_hz;
    const double turn = farthest(lines, given) * static_cast<double>(wish.samples) / rate;
    if (turn > most_turn) {
        prepared = TRY(prepared_at((lines.lowest_hz + lines.highest_hz) / 2, prepared, recording,
                                   settings, job));
    }
    auto length = TRY(slow_enough(wish, lines, prepared.f0_hz, rate));
    if (wished.snap) {
        length = snap_window(length, prepared.f0_hz, rate);
    }
    const double lobe_hz = rate / static_cast<double>(wish.samples);
    if (settings.f0_hz && std::abs(lines.strongest_hz - given) > lobe_hz) {
        prepared.diagnostics.push_back({DiagnosticKind::carrier_elsewhere,
                                        {number_arg(given), number_arg(lines.strongest_hz)}});
    }
    const auto start = TRY(start_findings(*recording.source, rate, prepared.f0_hz));
    add_findings(start, prepared.diagnostics);
    WindowChoice choice;
    choice.plan = plan_windows(prepared.first, prepared.end, length, length);
    if (choice.plan.count == 0) {
        return Error{ErrorCode::window_too_long,
                     "",
                     {count_arg(length), count_arg(prepared.end - prepared.first)}};
    }
    choice.prepared = std::move(prepared);
    choice.lines = std::move(lines);
    return choice;
}

}  // namespace vybeg
