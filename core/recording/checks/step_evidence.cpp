#include "core/recording/checks/step_evidence.h"

#include "core/numerics/phase.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vybeg {
namespace {

// Largest number of samples lost or doubled at a step. Buffers of fast converters are longer, but
// larger numbers would agree with any phase.
constexpr int most_samples = 100;
// Phase error from the slow change of a line inside a segment, in addition to that of the noise,
// rad.
constexpr double model_phase = 0.005;
// Largest sd of the phase; a less precise phase agrees with any number of samples.
constexpr double most_phase_sd = least_phase_step / 4;
// Largest unexplained part of the power of both channels.
constexpr double most_unexplained = 0.1;
// Least ratio of the noise variance without a step to that with it.
constexpr double least_gain = 1.5;
// Largest probability, for a certain number, that one as small agrees with a random phase.
constexpr double most_chance = 0.05;
// Largest difference across the step of a continuous line, relative to the squares on both sides.
constexpr double most_difference = 0.1;
// In addition: difference by noise, in variances.
constexpr double noise_difference = 16;

TwoChannels part(const TwoChannels& x, std::size_t begin, std::size_t end) {
    return {x.c.subspan(begin, end - begin), x.d.subspan(begin, end - begin)};
}

// Lines on both sides of a frame. Times are indices into the samples.
class TwoSides {
public:
    TwoSides(const TwoChannels& samples, std::size_t begin, std::size_t last, std::size_t first,
             std::size_t end, const std::vector<double>& w)
        : before_(part(samples, begin, last), w),
          after_(part(samples, first, end), w),
          before_begin_(static_cast<double>(begin)),
          after_begin_(static_cast<double>(first)) {}

    // Continuity of a line across `frame` with `lost` samples lost there, compared `aside` samples
    // beside it.
    struct Continuation {
        double phase = 0;       // rad, after less before
        double phase_sd = 0;    // rad
        double difference = 0;  // |after - before|^2, both channels summed
        double size = 0;        // |after|^2 + |before|^2
        double variance = 0;    // of the real part of a channel's after - before
    };

    Continuation continuation(std::size_t line, double frame, int lost, double aside = 0) const {
        // The middle of the gap, so that neither side is extrapolated far.
        const double half = 0.5 * lost;
        const Eigen::Vector2cd before = before_.phasor(line, frame + half + aside - before_begin_);
        const Eigen::Vector2cd after = after_.phasor(line, frame - half + aside - after_begin_);
        Continuation on;
        on.phase = std::arg(before.dot(after));
        on.difference = (after - before).squaredNorm();
        on.size = before.squaredNorm() + after.squaredNorm();
        on.variance = before_.variance(line, frame + half + aside - before_begin_) +
                      after_.variance(line, frame - half + aside - after_begin_);
        on.phase_sd = std::sqrt(2 * on.variance / std::max(on.size, 1e-300));
        return on;
    }

    double power(std::size_t line) const {
        return 0.5 * (before_.power(line) + after_.power(line));
    }
    double noise_variance() const {
        return 0.5 * (before_.noise_variance() + after_.noise_variance());
    }
    Eigen::Vector2d before(std::size_t j) const {
        return before_.sample(static_cast<double>(j) - before_begin_);
    }
    Eigen::Vector2d after(std::size_t j) const {
        return after_.sample(static_cast<double>(j) - after_begin_);
    }

private:
    LocalLines before_;
    LocalLines after_;
    double before_begin_;
    double after_begin_;
};

// Frame in [from, to] of the change from the lines before to those after, with the least sum of
// squares.
std::size_t change_over(const TwoSides& sides, const TwoChannels& samples, std::size_t from,
                        std::size_t to) {
    double squares = 0;  // less those of the change at `from`
    double least = 0;
    std::size_t best = from;
    for (std::size_t j = from; j < to; ++j) {
        const Eigen::Vector2d sample(samples.c[j], samples.d[j]);
        squares +=
            (sample - sides.before(j)).squaredNorm() - (sample - sides.after(j)).squaredNorm();
        if (squares < least) {
            least = squares;
            best = j + 1;
        }
    }
    return best;
}

// Samples [begin, end) around a frame that the lines on their side do not predict: one at least,
// more for several close steps. Samples outside follow from the lines before or after.
struct Unforeseen {
    std::size_t begin = 0;
    std::size_t end = 0;
};

Unforeseen unforeseen(const TwoSides& sides, const TwoChannels& samples, const Suspicion& where,
                      std::size_t frame) {
    constexpr double most_variances = 2 * 16;  // both channels
    const double most = most_variances * sides.noise_variance();
    Unforeseen found{frame - 1, frame + 1};
    for (std::size_t j = where.zone_begin; j < where.zone_end; ++j) {
        const Eigen::Vector2d sample(samples.c[j], samples.d[j]);
        const Eigen::Vector2d expected = j < frame ? sides.before(j) : sides.after(j);
        if ((sample - expected).squaredNorm() > most) {
            found.begin = std::min(found.begin, j);
            found.end = std::max(found.end, j + 1);
        }
    }
    return found;
}

double phase_tolerance(const TwoSides::Continuation& on) {
    return model_phase + 4 * on.phase_sd;
}

bool is_same(const TwoSides::Continuation& on) {
    return on.difference <= most_difference * on.size + noise_difference * on.variance;
}

// Whether a line is continuous in phase, amplitude and direction and in their slopes; in the node
// of a beat the amplitude reverses.
bool goes_on(const TwoSides& sides, std::size_t line, double frame, int lost, double aside) {
    const TwoSides::Continuation on = sides.continuation(line, frame, lost);
    return std::abs(on.phase) <= phase_tolerance(on) && is_same(on) &&
           is_same(sides.continuation(line, frame, lost, aside)) &&
           is_same(sides.continuation(line, frame, lost, -aside));
}

// Noise variance of the whole reach for lines without a step.
double variance_without_step(const TwoChannels& samples, const Suspicion& where) {
    const std::size_t middle = (where.reach_begin + where.reach_end) / 2;
    const std::vector<double> lines = strong_lines(part(samples, where.reach_begin, middle),
                                                   part(samples, middle, where.reach_end));
    return LocalLines(part(samples, where.reach_begin, where.reach_end), lines).noise_variance();
}

}  // namespace

std::optional<PhaseStep> judge_step(const TwoChannels& samples, const Suspicion& where, double w) {
    const TwoChannels before = part(samples, where.begin, where.zone_begin);
    const TwoChannels after = part(samples, where.zone_end, where.end);
    if (std::min(before.c.size(), after.c.size()) < 2 * LocalLines::least_samples(1)) {
        return std::nullopt;
    }
    const std::vector<double> lines = strong_lines(before, after);
    const auto nearest =
        std::ranges::min_element(lines, {}, [w](double line) { return std::abs(line - w); });
    // The analysed mode; a carrier stated with an error of one per cent still identifies it.
    if (nearest == lines.end() ||
        std::abs(*nearest - w) >
            std::max(0.1 * w, 2 * std::numbers::pi / static_cast<double>(before.c.size()))) {
        return std::nullopt;
    }
    const auto carrier = static_cast<std::size_t>(nearest - lines.begin());
    const TwoSides wide(samples, where.begin, where.zone_begin, where.zone_end, where.end, lines);
    const std::size_t frame = change_over(wide, samples, where.zone_begin, where.zone_end);
    const Unforeseen between = unforeseen(wide, samples, where, frame);
    const TwoSides sides(samples, where.begin, between.begin, between.end, where.end, lines);
    const auto at = static_cast<double>(frame);
    const TwoSides::Continuation step = sides.continuation(carrier, at, 0);
    // A step needs a continuous wave; steps in nodes of beats and spreading changes are excluded.
    double power = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        power += sides.power(i);
    }
    if (sides.noise_variance() > most_unexplained * power / 4 ||
        std::abs(step.phase) < least_phase_step || step.phase_sd > most_phase_sd ||
        step.size < sides.power(carrier) ||
        3 * (between.end - between.begin) > 2 * (where.zone_end - where.zone_begin)) {
        return std::nullopt;
    }
    std::vector<std::size_t> strong;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const TwoSides::Continuation on = sides.continuation(i, at, 0);
        if (i == carrier || on.size > 100 * on.variance) {
            strong.push_back(i);
        }
    }
    const auto shorter = std::min(between.begin - where.begin, where.end - between.end);
    const double aside = 0.25 * static_cast<double>(shorter);
    PhaseStep found;
    found.frame = static_cast<std::int64_t>(frame);
    found.phase_rad = wrap(step.phase);
    found.phase_sd = step.phase_sd;
    for (int size = 1; size <= most_samples; ++size) {
        for (const int lost : {size, -size}) {
            if (std::ranges::all_of(
                    strong, [&](std::size_t i) { return goes_on(sides, i, at, lost, aside); })) {
                found.candidates.push_back(lost);
            }
        }
    }
    if (found.candidates.empty() ||
        variance_without_step(samples, where) < least_gain * sides.noise_variance()) {
        return std::nullopt;
    }
    found.lost = found.candidates.front();
    // Share of random phases that agree with a number of samples.
    double chance = 1;
    for (const std::size_t i : strong) {
        chance *= std::min(1.0, phase_tolerance(sides.continuation(i, at, 0)) / std::numbers::pi);
    }
    found.is_ambiguous =
        found.candidates.size() > 1 || 2 * std::abs(found.lost) * chance > most_chance;
    return found;
}

}  // namespace vybeg
