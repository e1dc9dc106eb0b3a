#include "core/residuals/line_origin.h"

#include "core/recording/checks/start_check.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace vybeg {
namespace {

constexpr int highest_order = 10;
constexpr double grid_tolerance = 2e-3;  // of the mains' frequency
constexpr double most_bin_hz = 5;        // above which lines of the mains are not resolved

struct Name {
    LineOrigin origin = LineOrigin::unknown;
    int order = 0;
    double base_hz = 0;
};

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

    std::optional<Name> name(const ResidualLine& line) const {
        const double f_hz = line.f_hz;
        const double off = f_hz - f0_hz_;
        // Long windows have all their side lobes near the carrier.
        const bool beside_window_rate = window_rate_hz_ > 4 * tolerance_hz_;
        const double near =
            beside_window_rate ? tolerance_hz_ : std::max(3 * lobe_hz_, 2 * tolerance_hz_);
        if (std::abs(off) <= near) {
            return Name{LineOrigin::wave, 0, 0};
        }
        const double windows = std::round(off / window_rate_hz_);
        if (beside_window_rate && windows != 0 && is_at_window_rate(line, windows)) {
            return Name{LineOrigin::window_rate, static_cast<int>(windows), window_rate_hz_};
        }
        if (const ResidualLine* source = imaged(line)) {
            return Name{LineOrigin::window_image, 0, source->f_hz};
        }
        if (const auto found = mains(f_hz)) {
            return Name{LineOrigin::mains, found->order, found->base_hz};
        }
        if (const auto found = harmonic(f_hz)) {
            return found;
        }
        // A modulation makes lines on both sides.
        if (const auto found = mains(std::abs(off)); found && is_there(f0_hz_ - off)) {
            return Name{LineOrigin::carrier_by_mains, found->order, found->base_hz};
        }
        return std::nullopt;
    }

private:
    bool is_there(double f_hz) const {
        return std::ranges::any_of(lines_, [&](const ResidualLine& line) {
            return std::abs(line.f_hz - f_hz) <= tolerance_hz_;
        });
    }

    // Higher orders fall as those of a sawtooth, at least as fast as the inverse of the order: what
    // is stronger lies there by chance.
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
    std::optional<Name> mains(double f_hz) const {
        std::optional<Name> best;
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
                best = Name{LineOrigin::mains, static_cast<int>(order), base};
                best_seen = seen;
            }
        }
        return best;
    }

    std::optional<Name> harmonic(double f_hz) const {
        for (int order = 2; order <= highest_order; ++order) {
            const double at = order * f0_hz_;
            const double folded = std::abs(std::remainder(at, rate_hz_));
            if (std::abs(f_hz - folded) <= tolerance_hz_) {
                return Name{
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

}  // namespace

void name_lines(std::vector<ResidualLine>& lines, const Analysis& analysis, double rate_hz,
                double bin_hz) {
    const Namer namer(lines, analysis, rate_hz, bin_hz);
    for (ResidualLine& line : lines) {
        if (const auto name = namer.name(line)) {
            line.origin = name->origin;
            line.order = name->order;
            line.base_hz = name->base_hz;
        }
        if (line.origin == LineOrigin::wave || line.origin == LineOrigin::window_rate ||
            line.origin == LineOrigin::window_image) {
            line.filter.reset();  // not in the samples by itself
        }
    }
}

}  // namespace vybeg
