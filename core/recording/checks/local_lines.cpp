#include "core/recording/checks/local_lines.h"

#include "core/numerics/dense_solvers.h"
#include "core/numerics/fft.h"
#include "core/numerics/statistics.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace vybeg {
namespace {

using Complex = std::complex<double>;

constexpr std::size_t most_lines = 8;
constexpr double weakest = 1e-4;    // power, relative to the strongest line
constexpr double above_noise = 20;  // power, relative to the median of the spectrum
constexpr double least_apart_bins = 1.5;

Eigen::Index order_of(std::size_t samples) {
    return samples >= 192 ? 2 : samples >= 48 ? 1 : 0;
}

std::size_t terms(std::size_t lines) {
    return 2 * lines + 1;
}

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

}  // namespace

std::size_t LocalLines::least_samples(std::size_t lines) {
    // Three times as many samples as unknowns of a linear envelope.
    const std::size_t least = 3 * terms(lines);
    return std::max<std::size_t>(48, 2 * least);
}

LocalLines::LocalLines(const TwoChannels& segment, std::vector<double> w)
    : w_(std::move(w)),
      length_(static_cast<double>(segment.c.size())),
      order_(order_of(segment.c.size())) {
    const auto rows = static_cast<Eigen::Index>(segment.c.size());
    while (order_ > 0 && 3 * (order_ + 1) * static_cast<Eigen::Index>(terms(w_.size())) > rows) {
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

Eigen::Index LocalLines::column(std::size_t line) const {
    return static_cast<Eigen::Index>(terms(line)) * (order_ + 1);
}

Eigen::Vector2cd LocalLines::phasor(std::size_t line, double j) const {
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

double LocalLines::variance(std::size_t line, double j) const {
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

double LocalLines::power(std::size_t line) const {
    constexpr int places = 16;
    double sum = 0;
    for (int k = 0; k < places; ++k) {
        sum += phasor(line, length_ * (k + 0.5) / places).squaredNorm();
    }
    return sum / places;
}

Eigen::Vector2d LocalLines::sample(double j) const {
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

}  // namespace vybeg
