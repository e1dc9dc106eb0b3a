#include "core/recording/checks/step_evidence.h"

#include "core/numerics/dense_solvers.h"
#include "core/numerics/fft.h"
#include "core/numerics/phase.h"
#include "core/numerics/statistics.h"

#include <Eigen/Core>

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace vybeg {
namespace {

using Complex = std::complex<double>;

Eigen::Index order_of(std::size_t samples) {
    return samples >= 192 ? 2 : samples >= 48 ? 1 : 0;
}

std::size_t terms(std::size_t lines) {
    return 2 * lines + 1;
}

// Lines of a short segment as slowly varying waves, one least-squares fit for both channels:
//     x[j] = sum over lines of Re(P_i(u) e^{i w_i j}) + P_0(u),  u = (j - middle) / (length / 2),
// P polynomials of the order that the length allows, 1 from 48 samples on, 2 from 192. j counts
// from the start of the segment.
class LocalLines {
public:
    // Precondition: segment.c.size() >= least_samples(w.size()).
    LocalLines(const TwoChannels& segment, std::vector<double> w)
        : w_(std::move(w)),
          length_(static_cast<double>(segment.c.size())),
          order_(order_of(segment.c.size())) {
        const auto rows = static_cast<Eigen::Index>(segment.c.size());
        while (order_ > 0 &&
               3 * (order_ + 1) * static_cast<Eigen::Index>(terms(w_.size())) > rows) {
            --order_;
        }
        const Eigen::Index powers = order_ + 1;
        Eigen::MatrixXd basis(rows, column(w_.size()));
        const Eigen::ArrayXd places =
            Eigen::ArrayXd::LinSpaced(rows, u(0), u(static_cast<double>(rows - 1)));
        basis.col(0).setOnes();
        for (Eigen::Index q = 1; q < powers; ++q) {
            basis.col(q) = basis.col(q - 1).array() * places;
        }
        for (std::size_t i = 0; i < w_.size(); ++i) {
            const Eigen::Index at = column(i);
            for (Eigen::Index j = 0; j < rows; ++j) {
                const double turn = w_[i] * static_cast<double>(j);
                basis(j, at) = std::cos(turn);
                basis(j, at + 1) = -std::sin(turn);
            }
            for (Eigen::Index q = 1; q < powers; ++q) {
                basis.col(at + 2 * q) = basis.col(at + 2 * q - 2).array() * places;
                basis.col(at + 2 * q + 1) = basis.col(at + 2 * q - 1).array() * places;
            }
        }
        Eigen::MatrixX2d samples(rows, 2);
        samples.col(0) = Eigen::Map<const Eigen::VectorXd>(segment.c.data(), rows);
        samples.col(1) = Eigen::Map<const Eigen::VectorXd>(segment.d.data(), rows);
        Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(basis.cols(), basis.cols());
        normal.selfadjointView<Eigen::Lower>().rankUpdate(basis.transpose());
        const Eigen::LDLT<Eigen::MatrixXd> solver(normal.selfadjointView<Eigen::Lower>());
        coefficients_ = solver.solve(basis.transpose() * samples);
        inverse_ = solver.solve(Eigen::MatrixXd::Identity(basis.cols(), basis.cols()));
        residual_ = samples - basis * coefficients_;
        noise_variance_ = residual_.squaredNorm() /
                          (2 * static_cast<double>(std::max<Eigen::Index>(1, rows - basis.cols())));
    }

    static std::size_t least_samples(std::size_t lines) {
        // Three times as many samples as unknowns of a linear envelope.
        const std::size_t least = 3 * terms(lines);
        return std::max<std::size_t>(48, 2 * least);
    }

    // P_i(u) e^{i w_i j} of the channels c and d, at any j, whole or not.
    Eigen::Vector2cd phasor(std::size_t line, double j) const {
        const Eigen::Index at = column(line);
        Eigen::Vector2cd sum = Eigen::Vector2cd::Zero();
        double power = 1;
        for (Eigen::Index q = 0; q <= order_; ++q) {
            for (Eigen::Index channel = 0; channel < 2; ++channel) {
                sum[channel] += power * Complex(coefficients_(at + 2 * q, channel),
                                                coefficients_(at + 2 * q + 1, channel));
            }
            power *= u(j);
        }
        return sum * std::polar(1.0, w_[line] * j);
    }

    // Variance of the real part of a channel's phasor; the imaginary one has the same.
    double variance(std::size_t line, double j) const {
        const Eigen::Index at = column(line);
        double sum = 0;
        for (Eigen::Index p = 0; p <= order_; ++p) {
            for (Eigen::Index q = 0; q <= order_; ++q) {
                const double both =
                    inverse_(at + 2 * p, at + 2 * q) + inverse_(at + 2 * p + 1, at + 2 * q + 1);
                sum += 0.5 * both * std::pow(u(j), static_cast<double>(p + q));
            }
        }
        return noise_variance_ * sum;
    }

    // Noise variance of a sample, mean of both channels.
    double noise_variance() const { return noise_variance_; }
    // Mean of |P_i|^2 over the segment, both channels summed.
    double power(std::size_t line) const {
        constexpr int places = 16;
        double sum = 0;
        for (int k = 0; k < places; ++k) {
            sum += phasor(line, length_ * (k + 0.5) / places).squaredNorm();
        }
        return sum / places;
    }

    // Sum of all lines and the offset at j.
    Eigen::Vector2d sample(double j) const {
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        double power = 1;
        for (Eigen::Index q = 0; q <= order_; ++q) {
            sum += power * coefficients_.row(q).transpose();
            power *= u(j);
        }
        for (std::size_t i = 0; i < w_.size(); ++i) {
            sum += phasor(i, j).real();
        }
        return sum;
    }

    // Residual of the fit, samples x channels.
    const Eigen::MatrixX2d& residual() const { return residual_; }

private:
    double u(double j) const { return 2 * j / length_ - 1; }
    Eigen::Index column(std::size_t line) const {
        return static_cast<Eigen::Index>(terms(line)) * (order_ + 1);
    }

    std::vector<double> w_;
    double length_;
    Eigen::Index order_;
    double noise_variance_ = 0;      // of a sample, the mean of both channels
    Eigen::MatrixX2d coefficients_;  // offset's powers of u, then lines' cos and sin of each power
    Eigen::MatrixXd inverse_;        // of the normal matrix
    Eigen::MatrixX2d residual_;
};

constexpr std::size_t most_lines = 8;
constexpr double weakest = 1e-4;    // power, relative to the strongest line
constexpr double above_noise = 20;  // power, relative to the median of the spectrum
constexpr double least_apart_bins = 1.5;

// Adds the power spectrum of both channels' Hann-windowed residuals, bins 0 to size/2.
void add_spectrum(const Eigen::MatrixX2d& residual, const Fft& fft, std::vector<double>& spectrum) {
    const Eigen::Index length = residual.rows();
    std::vector<Complex> data(fft.size());
    const double turn = 2 * std::numbers::pi / static_cast<double>(length);
    for (Eigen::Index j = 0; j < length; ++j) {
        const double hann = 0.5 - 0.5 * std::cos(turn * (static_cast<double>(j) + 0.5));
        data[static_cast<std::size_t>(j)] = {hann * residual(j, 0), hann * residual(j, 1)};
    }
    fft.forward(data);
    const double scale = 1 / static_cast<double>(length * length);
    for (std::size_t k = 0; k < spectrum.size(); ++k) {
        spectrum[k] +=
            scale * (std::norm(data[k]) + std::norm(data[(fft.size() - k) % fft.size()]));
    }
}

struct Peak {
    double w = 0;
    double power = 0;
};

// The highest peak of the spectrum with enough distance from the known lines and from both ends.
std::optional<Peak> highest_peak(const std::vector<double>& spectrum, const std::vector<double>& w,
                                 double apart) {
    const double bin = std::numbers::pi / static_cast<double>(spectrum.size() - 1);
    std::size_t best = 0;
    for (std::size_t k = 1; k + 1 < spectrum.size(); ++k) {
        const double at = bin * static_cast<double>(k);
        const bool is_free =
            at > apart && at < std::numbers::pi - apart &&
            std::ranges::none_of(w, [=](double known) { return std::abs(at - known) < apart; });
        if (is_free && (best == 0 || spectrum[k] > spectrum[best])) {
            best = k;
        }
    }
    if (best == 0) {
        return std::nullopt;
    }
    const double left = std::log(spectrum[best - 1] + 1e-300);
    const double top = std::log(spectrum[best] + 1e-300);
    const double right = std::log(spectrum[best + 1] + 1e-300);
    const double curvature = left - 2 * top + right;
    const double shift =
        curvature < 0 ? std::clamp(0.5 * (left - right) / curvature, -0.5, 0.5) : 0;
    return Peak{bin * (static_cast<double>(best) + shift), spectrum[best]};
}

// The frequencies (rad per sample, ascending in no order, strongest first) of the strong lines of
// two segments of about the same length: above the noise and a hundredth of the amplitude of the
// strongest one, at most eight. Lines closer than 1.5 bins of the shorter segment count as one with
// varying amplitude.
std::vector<double> strong_lines(const TwoChannels& before, const TwoChannels& after) {
    const std::size_t shorter = std::min(before.c.size(), after.c.size());
    const Fft fft(4 * std::bit_ceil(std::max(before.c.size(), after.c.size())));
    const double apart = least_apart_bins * 2 * std::numbers::pi / static_cast<double>(shorter);
    std::vector<double> w;
    double strongest = 0;
    while (w.size() < most_lines && LocalLines::least_samples(w.size() + 1) <= shorter) {
        std::vector<double> spectrum(fft.size() / 2 + 1);
        add_spectrum(LocalLines(before, w).residual(), fft, spectrum);
        add_spectrum(LocalLines(after, w).residual(), fft, spectrum);
        const std::optional<Peak> peak = highest_peak(spectrum, w, apart);
        if (!peak || peak->power < weakest * strongest ||
            peak->power < above_noise * median(spectrum)) {
            break;
        }
        strongest = std::max(strongest, peak->power);
        w.push_back(peak->w);
    }
    return w;
}

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
