#include "core/numerics/statistics.h"
#include "core/recording/checks/recording_check.h"
#include "core/recording/conditioning/conditioned_source.h"
#include "core/residuals/find_residuals.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

namespace vybeg {
namespace {

// Two digits, rounded down.
double rounded_down(double value) {
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
    return std::floor(value / unit) * unit;
}

}  // namespace

std::optional<Band> filter_without(double line_hz, const SignalSettings& settings,
                                   const Recording& recording) {
    const double f0 = *settings.f0_hz;
    const double half_rate = recording.rate_hz / 2;
    const double far = std::abs(line_hz - f0);
    if (!(far > 0)) {
        return std::nullopt;
    }
    // The stopband begins half the band's width beyond an edge, provided that there is room.
    const double reach = rounded_down(std::min({0.49 * far, 0.5 * f0, 0.5 * (half_rate - f0)}));
    Band band{f0 - reach, f0 + reach};
    if (reach >= 20) {
        band = {std::round(band.low_hz), std::round(band.high_hz)};
    }
    if (settings.filter) {
        if (line_hz < settings.filter->low_hz || line_hz > settings.filter->high_hz) {
            return std::nullopt;
        }
        band = {std::max(band.low_hz, settings.filter->low_hz),
                std::min(band.high_hz, settings.filter->high_hz)};
    }
    const bool possible =
        0 < band.low_hz && band.low_hz < f0 && f0 < band.high_hz && band.high_hz < half_rate;
    if (!possible ||
        10 * band_pass_reach(band.low_hz, band.high_hz, recording.rate_hz) > recording.frames()) {
        return std::nullopt;
    }
    return band;
}

namespace {

// The probability of one line or more in the spectrum of white noise.
constexpr double false_line_probability = 0.01;
constexpr std::size_t least_bins = 64;
constexpr std::size_t most_peaks = 400;
constexpr std::size_t most_lines = 24;
constexpr std::ptrdiff_t main_lobe = 2;  // bins to each side, of a Hann window
constexpr std::ptrdiff_t guard = 3;      // bins to each side that a line takes from its noise
// Segments that overlap by half are not independent: their densities count for one part in 1.056
// less (the correlation of 1/6 squared, twice), a line's product with the noise for 1.17.
constexpr double overlap_of_densities = 1.056;
constexpr double overlap_of_lines = 1.17;

// The noise around a bin: the higher of the medians on both sides, so that the edge of a band-pass
// is no line.
double noise_floor(const std::vector<double>& density, int segments, std::ptrdiff_t bin) {
    const auto span = std::clamp<std::ptrdiff_t>(std::ssize(density) / 8, 8, 32);
    // Zero where too few bins lie there. Bin 0 holds what the mean has left.
    const auto beside = [&](std::ptrdiff_t first) {
        const std::ptrdiff_t end = std::min(first + span, std::ssize(density));
        first = std::max<std::ptrdiff_t>(first, 1);
        return end - first < span / 2 ? 0
                                      : median({density.begin() + first, density.begin() + end});
    };
    // Of the mean of exponential distributions.
    const double median_over_mean = chi2_ratio(0, 2.0 * segments);
    return std::max(beside(bin - guard - span), beside(bin + guard + 1)) / median_over_mean;
}

struct Peak {
    std::ptrdiff_t bin = 0;
    double ratio = 0;         // to the noise
    std::size_t channel = 0;  // in which it rises
};

// Bins that may hold a line: all but the ends, inside a band-pass. Beyond it line and noise are as
// far apart as before, and both of no matter.
struct Bins {
    std::ptrdiff_t first = main_lobe;
    std::ptrdiff_t end = 0;
};

Bins bins_of(const ResidualSpectrum& spectrum, const SignalSettings& settings) {
    Bins bins{main_lobe, std::ssize(spectrum.mean[0]) - main_lobe};
    if (settings.filter) {
        const auto bin_at = [&](double f_hz) {
            return static_cast<std::ptrdiff_t>(f_hz / spectrum.bin_hz);
        };
        bins.first = std::max(bins.first, bin_at(settings.filter->low_hz) + 1);
        bins.end = std::min(bins.end, bin_at(settings.filter->high_hz) + 1);
    }
    return bins;
}

// Local maxima above `least` times their noise.
void add_peaks(const Densities& densities, std::size_t channel, int segments, double least,
               const Bins& bins, std::vector<Peak>& peaks) {
    const std::vector<double>& density = densities[channel];
    for (std::ptrdiff_t k = bins.first; k < bins.end; ++k) {
        const auto at = [&](std::ptrdiff_t bin) { return density[static_cast<std::size_t>(bin)]; };
        if (at(k) <= at(k - 1) || at(k) < at(k + 1)) {
            continue;
        }
        const double floor = noise_floor(density, segments, k);
        if (floor > 0 && at(k) > least * floor) {
            peaks.push_back({k, at(k) / floor, channel});
        }
    }
}

// Largest density of a line of unit density beyond its main lobe: a side lobe of the Hann window is
// 1 / (pi x (x^2 - 1)) at x bins from the line, which lies up to half a bin from its own and loses
// 1.42 dB there.
double side_lobe(std::ptrdiff_t bins_away) {
    const double x = static_cast<double>(bins_away) - 0.5;
    const double amplitude = 1 / (std::numbers::pi * x * (x * x - 1));
    return 1.39 * amplitude * amplitude;
}

// The highest of each group of peaks that one line makes in both channels, with its side lobes.
std::vector<Peak> distinct(std::vector<Peak> peaks, const Densities& densities) {
    std::ranges::sort(peaks, std::ranges::greater{}, &Peak::ratio);
    // The noise doubles a side lobe at times.
    constexpr double margin = 2;
    const auto belongs = [&](const Peak& peak, const Peak& to) {
        const std::ptrdiff_t away = std::abs(to.bin - peak.bin);
        const std::vector<double>& density = densities[peak.channel];
        return away <= main_lobe ||
               density[static_cast<std::size_t>(peak.bin)] <
                   margin * side_lobe(away) * density[static_cast<std::size_t>(to.bin)];
    };
    std::vector<Peak> kept;
    for (const Peak& peak : peaks) {
        const bool known =
            std::ranges::any_of(kept, [&](const Peak& other) { return belongs(peak, other); });
        if (!known && kept.size() < most_peaks) {
            kept.push_back(peak);
        }
    }
    return kept;
}

// Mean square of a line, and its variance.
struct LinePower {
    double power = 0;
    double variance = 0;
};

LinePower line_power(const std::vector<double>& density, std::ptrdiff_t bin, int segments,
                     double bin_hz) {
    const double floor = noise_floor(density, segments, bin);
    LinePower line;
    for (std::ptrdiff_t k = bin - main_lobe; k <= bin + main_lobe; ++k) {
        line.power += (density[static_cast<std::size_t>(k)] - floor) * bin_hz;
    }
    line.power = std::max(line.power, 0.0);
    // The product of the line with the noise in its five bins, and the noise by itself; both with
    // the correlations -2/3 and 1/6 of neighbouring bins under a Hann window.
    const double noise = floor * bin_hz;
    line.variance = (3.89 * line.power * noise * overlap_of_lines +
                     8.72 * noise * noise * overlap_of_densities) /
                    segments;
    return line;
}

// Frequency by the ratio of the two largest amplitudes, which is (2 - x)/(1 + x) at a distance of x
// bins from the larger one. Both channels together.
double frequency_of(const ResidualSpectrum& spectrum, std::ptrdiff_t bin) {
    const auto amplitude = [&](std::ptrdiff_t k) {
        const auto at = static_cast<std::size_t>(k);
        return std::sqrt(spectrum.mean[0][at] + spectrum.mean[1][at]);
    };
    const std::ptrdiff_t side = amplitude(bin + 1) > amplitude(bin - 1) ? 1 : -1;
    const double ratio = amplitude(bin + side) / amplitude(bin);
    const double shift = std::clamp((2 * ratio - 1) / (ratio + 1), -0.5, 0.5);
    return (static_cast<double>(bin) + static_cast<double>(side) * shift) * spectrum.bin_hz;
}

// Whether the power of both channels falls from the first half to the second by more than a fifth,
// beyond doubt.
bool decays(const ResidualSpectrum& spectrum, std::ptrdiff_t bin) {
    std::array<LinePower, 2> halves;
    for (std::size_t half = 0; half < halves.size(); ++half) {
        if (spectrum.segments_of_half[half] == 0) {
            return false;
        }
        for (const std::vector<double>& density : spectrum.halves[half]) {
            const LinePower line =
                line_power(density, bin, spectrum.segments_of_half[half], spectrum.bin_hz);
            halves[half].power += line.power;
            halves[half].variance += line.variance;
        }
    }
    constexpr double least = 0.8;
    const double doubt = std::sqrt(halves[1].variance + least * least * halves[0].variance);
    return halves[1].power < least * halves[0].power - 4 * doubt;
}

constexpr int highest_order = 10;
constexpr double grid_tolerance = 2e-3;  // of the mains' frequency
constexpr double most_bin_hz = 5;        // above which lines of the mains are not resolved

class Namer {
public:
    Namer(const std::vector<ResidualLine>& lines, const Analysis& analysis, double rate_hz,
          double bin_hz)
        : lines_(lines),
          f0_hz_(analysis.f0_hz()),
          rate_hz_(rate_hz),
          tolerance_hz_(0.75 * bin_hz),
          lobe_hz_(rate_hz / static_cast<double>(analysis.plan.length)),
          window_rate_hz_(rate_hz / static_cast<double>(analysis.plan.hop)) {}

    std::optional<LineName> name(const ResidualLine& line) const {
        const double f_hz = line.f_hz;
        const double off = f_hz - f0_hz_;
        // Long windows have all their side lobes near the carrier.
        const bool beside_window_rate = window_rate_hz_ > 4 * tolerance_hz_;
        const double near =
            beside_window_rate ? tolerance_hz_ : std::max(3 * lobe_hz_, 2 * tolerance_hz_);
        if (std::abs(off) <= near) {
            return LineName{LineOrigin::wave, 0, 0};
        }
        const double windows = std::round(off / window_rate_hz_);
        if (beside_window_rate && windows != 0 && is_at_window_rate(line, windows)) {
            return LineName{LineOrigin::window_rate, static_cast<int>(windows), window_rate_hz_};
        }
        if (const ResidualLine* source = imaged(line)) {
            return LineName{LineOrigin::window_image, 0, source->f_hz};
        }
        if (const auto found = mains(f_hz)) {
            return found;
        }
        if (const auto found = harmonic(f_hz)) {
            return found;
        }
        // A modulation makes lines on both sides.
        if (const auto found = mains(std::abs(off)); found && is_there(f0_hz_ - off)) {
            return LineName{LineOrigin::carrier_by_mains, found->order, found->base_hz};
        }
        return std::nullopt;
    }

private:
    bool is_there(double f_hz) const {
        return std::ranges::any_of(lines_, [&](const ResidualLine& line) {
            return std::abs(line.f_hz - f_hz) <= tolerance_hz_;
        });
    }

    // Higher orders fall as those of a sawtooth, at least as fast as the inverse of the order: a
    // stronger line lies there by chance.
    bool is_at_window_rate(const ResidualLine& line, double order) const {
        constexpr double above_sawtooth = 3;
        const auto is_at = [&](const ResidualLine& other, double other_order) {
            return std::abs(other.f_hz - f0_hz_ - other_order * window_rate_hz_) <= tolerance_hz_;
        };
        return is_at(line, order) &&
               (std::abs(order) <= 1 || std::ranges::any_of(lines_, [&](const ResidualLine& first) {
                    return (is_at(first, 1) || is_at(first, -1)) &&
                           power(line) * order * order <=
                               above_sawtooth * above_sawtooth * power(first);
                }));
    }

    // The strongest line of which the windows make this one. What a window takes up of a line
    // follows the phase of the carrier in it: the image lies beside the carrier, at the line or its
    // mirror image about the carrier, plus a multiple of the rate of the windows.
    const ResidualLine* imaged(const ResidualLine& image) const {
        constexpr double least_ratio = 25;  // of the powers
        // Where the images are sparse, so that a line lies at one of them by chance in a few per
        // cent.
        constexpr double sparse = 150;
        const ResidualLine* found = nullptr;
        if (window_rate_hz_ < sparse * tolerance_hz_ ||
            std::abs(image.f_hz - f0_hz_) > 3 * lobe_hz_) {
            return found;
        }
        for (const ResidualLine& line : lines_) {
            if (power(line) < least_ratio * power(image) ||
                (found && power(line) < power(*found))) {
                continue;
            }
            for (const double side : {line.f_hz, -line.f_hz}) {
                for (const double mirror : {0.0, 2 * f0_hz_}) {
                    const double off = image.f_hz - side - mirror;
                    if (std::abs(std::remainder(off, window_rate_hz_)) <= tolerance_hz_) {
                        found = &line;
                    }
                }
            }
        }
        return found;
    }

    static double power(const ResidualLine& line) {
        return line.amplitude_c * line.amplitude_c + line.amplitude_d * line.amplitude_d;
    }

    // Of two supplies, that of which another line is there, too.
    std::optional<LineName> mains(double f_hz) const {
        std::optional<LineName> best;
        bool best_seen = false;
        for (const double base : supplies_hz) {
            if (tolerance_hz_ > most_bin_hz || base < 4 * tolerance_hz_) {
                continue;
            }
            const double order = std::round(f_hz / base);
            const double tolerance = tolerance_hz_ + grid_tolerance * f_hz;
            if (order < 1 || order > highest_order || std::abs(f_hz - order * base) > tolerance) {
                continue;
            }
            const bool seen = std::ranges::any_of(lines_, [&](const ResidualLine& line) {
                return std::abs(line.f_hz - base) <= tolerance_hz_ + grid_tolerance * base;
            });
            if (!best || (seen && !best_seen)) {
                best = LineName{LineOrigin::mains, static_cast<int>(order), base};
                best_seen = seen;
            }
        }
        return best;
    }

    std::optional<LineName> harmonic(double f_hz) const {
        for (int order = 2; order <= highest_order; ++order) {
            const double at = order * f0_hz_;
            const double folded = std::abs(std::remainder(at, rate_hz_));
            if (std::abs(f_hz - folded) <= tolerance_hz_) {
                return LineName{
                    at < rate_hz_ / 2 ? LineOrigin::carrier_harmonic : LineOrigin::folded_harmonic,
                    order, f0_hz_};
            }
        }
        return std::nullopt;
    }

    const std::vector<ResidualLine>& lines_;
    double f0_hz_;
    double rate_hz_;
    double tolerance_hz_;
    double lobe_hz_;
    double window_rate_hz_;
};

// Names lines by their frequencies: the wave itself, the rate of the windows, images of stronger
// lines by the windows, the mains and its harmonics up to the tenth, harmonics of the carrier up to
// the tenth, also folded, and the carrier modulated by the mains. Lines that are none of these keep
// their origin.
void name_lines(std::vector<ResidualLine>& lines, const Analysis& analysis, double rate_hz,
                double bin_hz) {
    const Namer namer(lines, analysis, rate_hz, bin_hz);
    for (ResidualLine& line : lines) {
        if (const auto name = namer.name(line)) {
            static_cast<LineName&>(line) = *name;
        }
        if (line.origin == LineOrigin::wave || line.origin == LineOrigin::window_rate ||
            line.origin == LineOrigin::window_image) {
            line.filter.reset();  // not in the samples by itself
        }
    }
}

}  // namespace

std::vector<ResidualLine> residual_lines(const ResidualSpectrum& spectrum,
                                         const Recording& recording, const Analysis& analysis) {
    std::vector<ResidualLine> lines;
    if (spectrum.mean[0].size() < least_bins) {
        return lines;
    }
    const int independent = std::max(1, static_cast<int>(spectrum.segments / overlap_of_densities));
    const auto bins = static_cast<double>(2 * spectrum.mean[0].size());
    const double least = ratio_exceeded(independent, false_line_probability / bins);
    const Bins looked_at = bins_of(spectrum, analysis.settings);
    std::vector<Peak> peaks;
    for (std::size_t channel = 0; channel < spectrum.mean.size(); ++channel) {
        add_peaks(spectrum.mean, channel, spectrum.segments, least, looked_at, peaks);
    }
    for (const Peak& peak : distinct(std::move(peaks), spectrum.mean)) {
        ResidualLine line;
        line.f_hz = frequency_of(spectrum, peak.bin);
        const auto channel = [&](std::size_t k, double& amplitude, double& sd) {
            const LinePower found =
                line_power(spectrum.mean[k], peak.bin, spectrum.segments, spectrum.bin_hz);
            amplitude = std::sqrt(2 * found.power);
            // Of a line below its noise the amplitude is known to its limit only.
            sd = std::sqrt(found.variance / std::max(2 * found.power, std::sqrt(found.variance)));
        };
        channel(0, line.amplitude_c, line.sd_c);
        channel(1, line.amplitude_d, line.sd_d);
        if (decays(spectrum, peak.bin)) {
            line.origin = LineOrigin::other_mode;
        }
        line.filter = filter_without(line.f_hz, analysis.settings, recording);
        lines.push_back(line);
    }
    name_lines(lines, analysis, recording.rate_hz, spectrum.bin_hz);
    // Waves that change inside long windows make dozens of these.
    std::erase_if(lines, [](const ResidualLine& line) {
        return line.origin == LineOrigin::window_rate && std::abs(line.order) > 2;
    });
    lines.resize(std::min(lines.size(), most_lines));
    std::ranges::sort(lines, {}, &ResidualLine::f_hz);
    return lines;
}

}  // namespace vybeg
