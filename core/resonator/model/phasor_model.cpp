#include "core/resonator/model/phasor_model.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace vybeg {
namespace {

using Complex = std::complex<double>;
using Eigen::Vector2cd;
using std::numbers::pi;

constexpr Complex i{0, 1};

// Column of a run's own parameter among the derivatives.
constexpr int own_column(int own) {
    return int{shared_count} + own;
}

// Derivatives of the motion: by the rates, by the start, by the cubic term.
constexpr int start_column = rate_count;
constexpr int cubic_column = rate_count + 4;
constexpr int motion_columns = rate_count + 5;
using MotionDerivatives = Eigen::Matrix<Complex, 2, motion_columns>;

struct Motion {
    Vector2cd z;
    MotionDerivatives by;
};

// Most of the time goes into the derivatives.
enum class Wanted { motion, derivatives };

// z and its derivatives through exp(M t).
Motion propagated(const SlowDynamics::Propagation& step, const Motion& from, Wanted wanted) {
    Motion to;
    to.z = step.value * from.z;
    if (wanted == Wanted::motion) {
        return to;
    }
    to.by = step.value * from.by;
    for (int rate = 0; rate < rate_count; ++rate) {
        to.by.col(rate) += step.by_rate[static_cast<std::size_t>(rate)] * from.z;
    }
    return to;
}

// Phases of u+ and u- by the cubic term in the time t.
Motion kicked(const Motion& from, double cubic, double t, const ScaledRun& run, Wanted wanted) {
    // The spring depends on the whole amplitude, of which the mean over a window loses a part.
    const double g = 2 * pi / 3 * t / run.power_kept;
    const Complex plus = from.z[0] + i * from.z[1];
    const Complex minus = from.z[0] - i * from.z[1];
    const double p = std::norm(plus) + 2 * std::norm(minus) - 3 * run.power;
    const double m = std::norm(minus) + 2 * std::norm(plus) - 3 * run.power;
    const Complex turn_plus = std::polar(1.0, cubic * g * p);
    const Complex turn_minus = std::polar(1.0, cubic * g * m);
    const auto back = [](Complex u_plus, Complex u_minus) {
        return Vector2cd((u_plus + u_minus) / 2.0, (u_plus - u_minus) / (2.0 * i));
    };
    Motion to;
    to.z = back(turn_plus * plus, turn_minus * minus);
    if (wanted == Wanted::motion) {
        return to;
    }
    for (int k = 0; k < motion_columns; ++k) {
        const Complex d_plus = from.by(0, k) + i * from.by(1, k);
        const Complex d_minus = from.by(0, k) - i * from.by(1, k);
        const double more_plus = 2 * (std::conj(plus) * d_plus).real();
        const double more_minus = 2 * (std::conj(minus) * d_minus).real();
        double by_p = cubic * g * (more_plus + 2 * more_minus);
        double by_m = cubic * g * (more_minus + 2 * more_plus);
        if (k == cubic_column) {
            by_p += g * p;
            by_m += g * m;
        }
        to.by.col(k) =
            back(turn_plus * (d_plus + i * by_p * plus), turn_minus * (d_minus + i * by_m * minus));
    }
    return to;
}

// Decides where a product with exp(M h) leads from one window to the next: not over gaps, and
// limited in number because of rounding.
class Walk {
public:
    bool step_to(double time_s, double step_s) {
        constexpr int most_steps = 64;
        const bool whole = std::abs(time_s - time_s_ - step_s) < 1e-10 * step_s;
        steps_ = whole && steps_ < most_steps ? steps_ + 1 : 0;
        time_s_ = time_s;
        return steps_ > 0;
    }

private:
    double time_s_ = -std::numeric_limits<double>::infinity();
    int steps_ = 0;
};

// Sums of the parameters of the breaks before a time.
class PassedBreaks {
public:
    PassedBreaks(const ScaledRun& run, const Eigen::VectorXd& own) : run_(run), own_(own) {}

    // Precondition: times do not fall from call to call. Returns whether the start has changed.
    bool pass(double time_s) {
        bool restarts = false;
        for (; next_ < run_.breaks.size() && time_s > run_.breaks[next_].time_s; ++next_) {
            const BreakKind kind = run_.breaks[next_].kind;
            if (kind == BreakKind::phase) {
                phase_ += own_[at_];
            } else if (kind == BreakKind::gain) {
                gain_ += own_.segment<2>(at_);
            } else if (kind == BreakKind::start) {
                start_ += Vector2cd(Complex(own_[at_], own_[at_ + 1]),
                                    Complex(own_[at_ + 2], own_[at_ + 3]));
                restarts = true;
            }
            at_ += break_size(kind);
        }
        return restarts;
    }

    double phase() const { return phase_; }
    const Eigen::Vector2d& gain() const { return gain_; }  // logarithms
    const Vector2cd& start() const { return start_; }

private:
    const ScaledRun& run_;
    const Eigen::VectorXd& own_;
    std::size_t next_ = 0;
    Eigen::Index at_ = own_count;
    double phase_ = 0;
    Eigen::Vector2d gain_ = Eigen::Vector2d::Zero();
    Vector2cd start_ = Vector2cd::Zero();
};

// Motion z at the windows, without the run's own phase.
class MotionSteps {
public:
    MotionSteps(const ScaledRun& run, const Eigen::VectorXd& shared, const Eigen::VectorXd& own,
                bool with_cubic, Wanted wanted)
        : run_(run),
          dynamics_(rates_of(shared)),
          cubic_(shared[cubic_at]),
          steps_(with_cubic),
          wanted_(wanted) {
        start_ = start_of(own);
        now_.z = start_of(own);
        now_.by.setZero();
        for (int k = 0; k < 2; ++k) {
            now_.by(k, start_column + 2 * k) = 1;
            now_.by(k, start_column + 2 * k + 1) = i;
        }
        begin_ = now_;
    }

    // Continues as the motion whose start differs by `change`.
    void restart(const Vector2cd& change) {
        begin_.z = start_ + change;
        now_ = begin_;
        walk_ = {};
        time_s_ = 0;
    }

    // Precondition: windows in order.
    Motion at(std::size_t window) {
        const double t = run_.time_s[window];
        if (!steps_) {
            // Whole steps from the window before; at intervals exactly from the start.
            if (walk_.step_to(t, run_.step_s)) {
                if (!step_) {
                    step_ = dynamics_.propagation(run_.step_s);
                }
                now_ = propagated(*step_, now_, wanted_);
            } else {
                now_ = propagated(dynamics_.propagation(t), begin_, wanted_);
            }
            return now_;
        }
        // A gap is crossed in steps of a window.
        const double length = t - time_s_;
        const auto count = std::max(1.0, std::round(length / run_.step_s));
        const double h = length / count;
        if (!step_ || std::abs(h - h_) > 1e-9 * h_) {
            step_ = dynamics_.propagation(h);
            h_ = h;
        }
        for (double k = 0; k < count; ++k) {
            now_ = kicked(now_, cubic_, h / 2, run_, wanted_);
            now_ = kicked(propagated(*step_, now_, wanted_), cubic_, h / 2, run_, wanted_);
        }
        time_s_ = t;
        return now_;
    }

private:
    const ScaledRun& run_;
    SlowDynamics dynamics_;
    double cubic_;
    bool steps_;
    Wanted wanted_;
    Vector2cd start_;
    Motion begin_;
    Motion now_;
    Walk walk_;
    double time_s_ = 0;
    double h_ = 0;
    std::optional<SlowDynamics::Propagation> step_;
};

// Factors from the motion to the channels at a window's time.
struct Channels {
    Complex c;      // e^{gain_C + i phi}
    Complex d;      // e^{gain_D + i phi}/kappa
    Complex gain;   // that of D times g
    Complex cross;  // that of D times sin skew + i crosstalk
    double u = 0;
    double x = 0;
};

Channels channels_at(const ScaledRun& run, const Eigen::VectorXd& shared,
                     const Eigen::VectorXd& own, const PassedBreaks& breaks, double t) {
    Channels channels;
    channels.u = t - run.reference_s;
    channels.x = t / run.duration_s;
    const double phi =
        2 * pi * channels.u * (own[frequency_at] + own[drift_at] * channels.u / 2) + breaks.phase();
    channels.c = channels.d = std::polar(1.0, phi);
    if (breaks.gain() != Eigen::Vector2d::Zero()) {
        channels.c *= std::exp(breaks.gain()[0]);
        channels.d *= std::exp(breaks.gain()[1]);
    }
    channels.d /= shared[kappa_at];
    const double beside = shared[phase_at] + shared[phase_drift_at] * channels.x;
    channels.gain = (1 + shared[gain_drift_at] * channels.x) * channels.d;
    if (beside != 0) {
        channels.gain *= std::polar(1.0, beside);
    }
    channels.cross = channels.d * Complex(std::sin(shared[skew_at]), shared[crosstalk_at]);
    return channels;
}

Vector2cd turned(double two_theta_zero, Vector2cd z) {
    if (two_theta_zero != 0) {
        turn_channels(two_theta_zero, z[0], z[1]);
    }
    return z;
}

// `z`: of the recorded channels, not turned.
Vector2cd seen(const Channels& channels, const Vector2cd& z) {
    return {channels.c * z[0], channels.gain * z[1] + channels.cross * z[0]};
}

// From the wave of a run to its phasors, both turned by its angle zero.
Vector2cd seen(const ScaledRun& run, const Channels& channels, const Vector2cd& z) {
    return turned(run.two_theta_zero, seen(channels, turned(-run.two_theta_zero, z)));
}

// Measured less predicted phasors of a window.
Vector2cd left_of(const ScaledRun& run, std::size_t window, const Vector2cd& expected) {
    if (!run.phase_lost) {
        return run.weighted(window, run.z[window] - expected);
    }
    const Complex along = (run.whitening * expected).dot(run.whitening * run.z[window]);
    return run.weighted(window, run.z[window] * std::polar(1.0, -std::arg(along)) - expected);
}

}  // namespace

Eigen::VectorXd shared_of(const ScaledRun& run, const Eigen::VectorXd& shared) {
    Eigen::VectorXd own = shared;
    own[decay_at] *= 1 + run.deviation.decay;
    own[split_cos_at] *= 1 + run.deviation.split;
    own[split_sin_at] *= 1 + run.deviation.split;
    own[kappa_at] *= 1 + run.deviation.kappa;
    return own;
}

SlowRates rates_of(const Eigen::VectorXd& shared) {
    SlowRates rates;
    for (int k = 0; k < rate_count; ++k) {
        rates.*all_rates[static_cast<std::size_t>(k)] = shared[k];
    }
    return rates;
}

Vector2cd start_of(const Eigen::VectorXd& own) {
    return {Complex{own[start_at], own[start_at + 1]},
            Complex{own[start_at + 2], own[start_at + 3]}};
}

std::vector<Vector2cd> expected_phasors(const ScaledRun& run, const Eigen::VectorXd& of_set,
                                        const Eigen::VectorXd& own, std::size_t windows) {
    const Eigen::VectorXd shared = shared_of(run, of_set);
    std::vector<Vector2cd> expected;
    expected.reserve(windows);
    PassedBreaks breaks(run, own);
    if (shared[cubic_at] == 0) {
        const SlowDynamics dynamics(rates_of(shared));
        Vector2cd start = start_of(own);
        const Eigen::Matrix2cd step = dynamics.propagator(run.step_s);
        Walk walk;
        Vector2cd z = start;
        for (std::size_t k = 0; k < windows; ++k) {
            const double t = run.time_s[k];
            if (breaks.pass(t)) {
                start = start_of(own) + breaks.start();
                walk = {};
            }
            z = walk.step_to(t, run.step_s) ? Vector2cd(step * z) : dynamics.propagator(t) * start;
            expected.push_back(seen(run, channels_at(run, shared, own, breaks, t), z));
        }
        return expected;
    }
    MotionSteps motion(run, shared, own, true, Wanted::motion);
    for (std::size_t k = 0; k < windows; ++k) {
        if (breaks.pass(run.time_s[k])) {
            motion.restart(breaks.start());
        }
        expected.push_back(
            seen(run, channels_at(run, shared, own, breaks, run.time_s[k]), motion.at(k).z));
    }
    return expected;
}

Linearised linearised(const ScaledRun& run, const Eigen::VectorXd& of_set,
                      const Eigen::VectorXd& own, std::size_t windows, bool with_cubic) {
    const Eigen::VectorXd shared = shared_of(run, of_set);
    const auto rows = static_cast<Eigen::Index>(4 * windows);
    Linearised out{Eigen::VectorXd(rows), RowMajor::Zero(rows, shared_count + own.size())};
    MotionSteps motion(run, shared, own, with_cubic || shared[cubic_at] != 0, Wanted::derivatives);
    PassedBreaks breaks(run, own);
    const double kappa = shared[kappa_at];
    const bool alike = run.whitening == Eigen::Matrix2d::Identity();
    for (std::size_t k = 0; k < windows; ++k) {
        if (breaks.pass(run.time_s[k])) {
            motion.restart(breaks.start());
        }
        const Channels channels = channels_at(run, shared, own, breaks, run.time_s[k]);
        const Motion at = motion.at(k);
        const double weight = run.weight[k];
        const Vector2cd wave = turned(-run.two_theta_zero, at.z);
        const Vector2cd of_channels = seen(channels, wave);
        const Vector2cd expected = turned(run.two_theta_zero, of_channels);
        const auto row = static_cast<Eigen::Index>(4 * k);
        const Vector2cd left = left_of(run, k, expected);
        out.residual.segment<4>(row) << left[0].real(), left[0].imag(), left[1].real(),
            left[1].imag();
        const auto put = [&](int column, const Vector2cd& change) {
            const Vector2cd by = alike ? change : Vector2cd(run.whitening * change);
            out.by_parameter(row, column) = weight * by[0].real();
            out.by_parameter(row + 1, column) = weight * by[0].imag();
            out.by_parameter(row + 2, column) = weight * by[1].real();
            out.by_parameter(row + 3, column) = weight * by[1].imag();
        };
        for (int rate = 0; rate < rate_count; ++rate) {
            put(rate, seen(run, channels, at.by.col(rate)));
        }
        for (int part = 0; part < 4; ++part) {
            put(own_column(start_at + part), seen(run, channels, at.by.col(start_column + part)));
        }
        if (with_cubic) {
            put(cubic_at, seen(run, channels, at.by.col(cubic_column)));
        }
        // Of the recorded channels.
        const auto put_channels = [&](int column, const Vector2cd& change) {
            put(column, turned(run.two_theta_zero, change));
        };
        const Complex d_gain = channels.gain * wave[1];
        const Complex d_cross = channels.d * wave[0];
        put_channels(kappa_at, {0, -of_channels[1] / kappa});
        put_channels(skew_at, {0, std::cos(shared[skew_at]) * d_cross});
        put_channels(crosstalk_at, {0, i * d_cross});
        put_channels(phase_at, {0, i * d_gain});
        put_channels(phase_drift_at, {0, i * channels.x * d_gain});
        put_channels(gain_drift_at,
                     {0, channels.x / (1 + shared[gain_drift_at] * channels.x) * d_gain});
        put(own_column(frequency_at), 2 * pi * channels.u * i * expected);
        put(own_column(drift_at), pi * channels.u * channels.u * i * expected);
        int column = own_column(own_count);
        for (const RunBreak& each : run.breaks) {
            if (run.time_s[k] <= each.time_s) {
                break;
            }
            if (each.kind == BreakKind::phase) {
                put(column, i * expected);
            } else if (each.kind == BreakKind::gain) {
                put_channels(column, {of_channels[0], 0});
                put_channels(column + 1, {0, of_channels[1]});
            } else if (each.kind == BreakKind::start) {
                for (int part = 0; part < 4; ++part) {
                    put(column + part, seen(run, channels, at.by.col(start_column + part)));
                }
            }
            column += break_size(each.kind);
        }
        if (run.phase_lost) {
            const Vector2cd turned = i * (run.whitening * expected);
            Eigen::Vector4d phase(turned[0].real(), turned[0].imag(), turned[1].real(),
                                  turned[1].imag());
            phase.normalize();
            const Eigen::RowVectorXd common =
                phase.transpose() * out.by_parameter.middleRows<4>(row);
            out.by_parameter.middleRows<4>(row) -= phase * common;
        }
    }
    out.by_parameter.col(decay_at) *= 1 + run.deviation.decay;
    out.by_parameter.middleCols<2>(split_cos_at) *= 1 + run.deviation.split;
    out.by_parameter.col(kappa_at) *= 1 + run.deviation.kappa;
    return out;
}

double chi_square(const ScaledRun& run, const Eigen::VectorXd& shared, const Eigen::VectorXd& own,
                  std::size_t windows) {
    const std::vector<Vector2cd> expected = expected_phasors(run, shared, own, windows);
    double sum = 0;
    for (std::size_t k = 0; k < windows; ++k) {
        sum += left_of(run, k, expected[k]).squaredNorm();
    }
    return sum;
}

}  // namespace vybeg
