#include "core/analysis/frame_check.h"

#include "core/numerics/statistics.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace vybeg {
namespace {

using ChannelRows = std::vector<std::complex<double>>;

// How a channel moves, relative to its size.
struct ChannelMotion {
    double beat = 0;      // rms of the amplitude about an exponential
    double turn = 0;      // rms across its mean direction
    double smooth = 0;    // correlation of that with the next one: noise has none
    double backward = 0;  // share against its mean direction
};

// Rms of log |z| about a straight line, weighted as the phasors' noise has it.
double beat_of(const ChannelRows& z) {
    const auto log_of = [&z](std::size_t k) {
        const double weight = std::norm(z[k]);
        return LinePoint{static_cast<double>(k), std::log(weight) / 2, weight};
    };
    const LineFit line = fit_line(z.size(), log_of);
    if (!(line.weight > 0)) {
        return 0;
    }
    double squares = 0;
    for (std::size_t k = 0; k < z.size(); ++k) {
        if (const LinePoint at = log_of(k); at.weight > 0) {
            squares += at.weight * (at.y - line.mean_y) * (at.y - line.mean_y);
        }
    }
    const double left = squares - (line.spread > 0 ? line.slope * line.slope * line.spread : 0);
    return std::sqrt(std::max(left, 0.0) / line.weight);
}

ChannelMotion motion_of(const ChannelRows& z) {
    std::complex<double> sum = 0;
    for (const auto& each : z) {
        sum += each * std::abs(each);
    }
    const std::complex<double> back = std::polar(1.0, -std::arg(sum));
    double across = 0;
    double along = 0;
    double neighbours = 0;
    double before = 0;
    double backward = 0;
    for (const auto& each : z) {
        const std::complex<double> turned = each * back;
        across += turned.imag() * turned.imag();
        along += turned.real() * turned.real();
        neighbours += before * turned.imag();
        before = turned.imag();
        backward += turned.real() < 0 ? 1 : 0;
    }
    ChannelMotion motion;
    motion.beat = beat_of(z);
    motion.turn = along > 0 ? std::sqrt(across / along) : 0;
    motion.smooth = across > 0 ? neighbours / across : 0;
    motion.backward = backward / static_cast<double>(z.size());
    return motion;
}

// A loop that follows the phase leaves only its part faster than the loop; across a null of the
// amplitude it does not come out backward.
bool is_followed(const ChannelMotion& channel, const ChannelMotion& other) {
    constexpr double still = 0.02;  // part of what a beat turns
    constexpr double certain = 0.8;
    constexpr double few = 0.01;
    return channel.turn < still * channel.beat && channel.backward < few &&
           other.smooth > certain && still * other.turn > channel.turn;
}

// Mean square of the turn over so many rows about its mean, rad^2.
double wander_of(const ChannelRows& z, std::size_t lag) {
    const auto turned = [&](std::size_t k) { return z[k] * std::conj(z[k - lag]); };
    std::complex<double> sum = 0;
    for (std::size_t k = lag; k < z.size(); ++k) {
        sum += turned(k);
    }
    double across = 0;
    double all = 0;
    for (std::size_t k = lag; k < z.size(); ++k) {
        const std::complex<double> turn = turned(k);
        all += std::norm(turn);
        across += std::norm(turn - std::polar(std::abs(turn), std::arg(sum)));
    }
    return all > 0 ? across / all : 0;
}

// Sums over the second differences of the image of h = 1 and of the phasors.
struct ImageSums {
    double image = 0;         // |second difference of the image|^2
    double image_itself = 0;  // |image|^2
    std::complex<double> product = 0;
    double rows = 0;  // |second difference of the phasors|^2
    std::size_t count = 0;
};

// Whether the window follows that before without a gap.
bool goes_on(const PhasorRun& run, std::size_t k) {
    return run.time_s[k] - run.time_s[k - 1] < 1.5 * run.window_s;
}

// What the linear recurrence of the motion leaves of a run, in stretches of windows.
struct Recurrence {
    double sd = 0;         // of the noise of a window's real or imaginary part
    double explained = 1;  // share of the power
};

Recurrence recurrence_of(const PhasorRun& run, double neighbours) {
    double power = 0;
    double left = 0;
    constexpr Eigen::Index stretch = 40;
    constexpr Eigen::Index least = 7;
    Eigen::MatrixX2cd before(stretch, 2);
    Eigen::MatrixX2cd after(stretch, 2);
    std::vector<double> variances;
    Eigen::Index steps = 0;
    for (std::size_t k = 1; k < run.c.size(); ++k) {
        if (goes_on(run, k)) {
            before.row(steps) << run.c[k - 1], run.d[k - 1];
            after.row(steps) << run.c[k], run.d[k];
            ++steps;
        }
        const bool last = k + 1 == run.c.size() && steps >= least;
        if (steps == stretch || last) {
            const auto from = before.topRows(steps);
            const auto to = after.topRows(steps);
            const Eigen::Matrix2cd a = from.colPivHouseholderQr().solve(to);
            const double rest = (to - from * a).squaredNorm();
            const double each = rest / static_cast<double>(4 * (steps - 2));
            const double grows = 1 + a.squaredNorm() / 2 - neighbours * a.trace().real();
            variances.push_back(each / grows);
            power += to.squaredNorm();
            left += rest;
            steps = 0;
        }
    }
    return variances.empty()
               ? Recurrence{}
               : Recurrence{std::sqrt(median(std::move(variances))), 1 - left / power};
}

// Whether windows follow their neighbours, as noise does not: a wave of much noise does so in the
// sum of all, a beat in each stretch.
bool holds_wave(const PhasorRun& run, double neighbours, double explained) {
    constexpr double more_than_noise = 0.3;
    if (explained > more_than_noise) {
        return true;
    }
    constexpr std::size_t few = 20;
    constexpr double deviations = 5;
    std::complex<double> follows = 0;
    double power = 0;
    std::size_t pairs = 0;
    for (std::size_t k = 1; k < run.c.size(); ++k) {
        if (goes_on(run, k)) {
            follows += run.product(k - 1, k);
            power += run.power(k);
            ++pairs;
        }
    }
    const double of_noise = neighbours + deviations / std::sqrt(2.0 * static_cast<double>(pairs));
    return pairs < few || std::abs(follows) > of_noise * power;
}

}  // namespace

std::optional<Diagnostic> mirrored_channel(const ChannelRows& c, const ChannelRows& d,
                                           double step_s) {
    constexpr double alike = 0.25;
    constexpr double certain = 10;
    std::array<double, 2> rates{};
    for (const std::size_t channel : {0, 1}) {
        const ChannelRows& z = channel == 0 ? c : d;
        std::complex<double> sum = 0;
        for (std::size_t k = 1; k < z.size(); ++k) {
            sum += z[k] * std::conj(z[k - 1]);
        }
        double across = 0;
        for (std::size_t k = 1; k < z.size(); ++k) {
            const double off = (z[k] * std::conj(z[k - 1]) * std::conj(sum)).imag();
            across += off * off;
        }
        const double angle = std::arg(sum);
        if (std::abs(angle) < certain * std::sqrt(across) / std::norm(sum)) {
            return std::nullopt;
        }
        rates[channel] = angle / (2 * std::numbers::pi * step_s);
    }
    if (std::abs(rates[0] + rates[1]) < alike * std::abs(rates[0] - rates[1])) {
        return Diagnostic{DiagnosticKind::phasors_mirrored,
                          {number_arg(rates[0], 3, "Hz"), number_arg(rates[1], 3, "Hz")}};
    }
    return std::nullopt;
}

std::optional<Diagnostic> followed_channel(const ChannelRows& c, const ChannelRows& d) {
    constexpr std::size_t few = 50;
    if (c.size() < few) {
        return std::nullopt;
    }
    const ChannelMotion of_c = motion_of(c);
    const ChannelMotion of_d = motion_of(d);
    if (is_followed(of_c, of_d)) {
        return Diagnostic{DiagnosticKind::reference_follows, {"C", "D"}};
    }
    if (is_followed(of_d, of_c)) {
        return Diagnostic{DiagnosticKind::reference_follows, {"D", "C"}};
    }
    return std::nullopt;
}

std::optional<Diagnostic> backward_oscillator(const ChannelRows& c, const ChannelRows& d,
                                              const ChannelRows& turn) {
    constexpr std::size_t lags = 100;  // in the rows
    constexpr double certain = 5;      // by itself a wave wanders less than a fifth of that
    if (turn.empty()) {
        return std::nullopt;
    }
    const std::size_t lag = std::max<std::size_t>(c.size() / lags, 1);
    double least = std::numeric_limits<double>::infinity();
    for (const ChannelRows* told : {&c, &d}) {
        ChannelRows other = *told;
        for (std::size_t k = 0; k < other.size(); ++k) {
            other[k] *= std::conj(turn[k] * turn[k]);
        }
        const double by_other = wander_of(other, lag);
        least = std::min(least, by_other > 0 ? std::sqrt(wander_of(*told, lag) / by_other) : 0);
    }
    if (!(least > certain)) {
        return std::nullopt;
    }
    return Diagnostic{DiagnosticKind::oscillator_backward, {number_arg(least, 2)}};
}

void remove_image(double f_ref_hz, const std::vector<double>& time_s, ChannelRows& c,
                  ChannelRows& d) {
    constexpr double even = 0.01;
    constexpr double most_image = 0.2;    // of a filter that lets no more than that through
    constexpr double least_moves = 1e-4;  // an image that folds near zero is motion
    constexpr double above_noise = 25;
    const auto image_of = [&](const ChannelRows& z, std::size_t k) {
        const double turns = std::fmod(2 * f_ref_hz * time_s[k], 1.0);
        return std::conj(z[k]) * std::polar(1.0, -2 * std::numbers::pi * turns);
    };
    ImageSums sums;
    for (std::size_t k = 1; k + 1 < time_s.size(); ++k) {
        const double before = time_s[k] - time_s[k - 1];
        const double behind = time_s[k + 1] - time_s[k];
        if (std::abs(behind - before) > even * before) {
            continue;
        }
        for (const ChannelRows* channel : {&c, &d}) {
            const ChannelRows& z = *channel;
            const std::complex<double> image = image_of(z, k);
            const std::complex<double> bent = image_of(z, k - 1) - 2.0 * image + image_of(z, k + 1);
            const std::complex<double> rows = z[k - 1] - 2.0 * z[k] + z[k + 1];
            sums.image += std::norm(bent);
            sums.image_itself += std::norm(image);
            sums.product += std::conj(bent) * rows;
            sums.rows += std::norm(rows);
            ++sums.count;
        }
    }
    if (!(sums.image > least_moves * sums.image_itself)) {
        return;
    }
    const std::complex<double> h = sums.product / sums.image;
    const double explained = std::norm(h) * sums.image;
    const double noise = (sums.rows - explained) / static_cast<double>(sums.count);
    if (std::abs(h) > most_image || !(explained > above_noise * noise)) {
        return;
    }
    for (ChannelRows* channel : {&c, &d}) {
        for (std::size_t k = 0; k < channel->size(); ++k) {
            std::complex<double>& z = (*channel)[k];
            z = (z - h * image_of(*channel, k)) / (1 - std::norm(h));
        }
    }
}

std::optional<double> noise_beside_wave(const PhasorRun& run, double neighbours) {
    const Recurrence found = recurrence_of(run, neighbours);
    return holds_wave(run, neighbours, found.explained) ? std::optional(found.sd) : std::nullopt;
}

}  // namespace vybeg
