#include "core/resonator/model/phasor_model.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

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

// A motion z as real numbers, Re z_1, Im z_1, Re z_2, Im z_2: a linear map of them is one
// real matrix, and the derivatives by several parameters are its product with their rows.
using Real = Eigen::Vector4d;
using RealMap = Eigen::Matrix4d;
template <int count>
using RealRows = Eigen::Matrix<double, 4, count, Eigen::RowMajor>;

RealMap real(const Eigen::Matrix2cd& map) {
    RealMap out;
    for (Eigen::Index row = 0; row < 2; ++row) {
        for (Eigen::Index column = 0; column < 2; ++column) {
            const Complex at = map(row, column);
            out.block<2, 2>(2 * row, 2 * column) << at.real(), -at.imag(), at.imag(), at.real();
        }
    }
    return out;
}

// Most of the time goes into the derivatives.
enum class Wanted { motion, derivatives };

// exp(M t) and, if wanted, its derivatives by the rates, for a z of each of the four units.
struct Propagation {
    Propagation(const SlowDynamics& dynamics, double t, Wanted wanted) {
        if (wanted == Wanted::motion) {
            value = dynamics.propagator(t);
            by_rate.fill(RealRows<rate_count>::Zero());
            return;
        }
        const SlowDynamics::Propagation step = dynamics.propagation(t);
        value = step.value;
        real_value = real(step.value);
        for (int rate = 0; rate < rate_count; ++rate) {
            const RealMap by = real(step.by_rate[static_cast<std::size_t>(rate)]);
            for (std::size_t part = 0; part < 4; ++part) {
                by_rate[part].col(rate) = by.col(static_cast<Eigen::Index>(part));
            }
        }
    }

    RealRows<rate_count> by_rates(const Vector2cd& z) const {
        return z[0].real() * by_rate[0] + z[0].imag() * by_rate[1] + z[1].real() * by_rate[2] +
               z[1].imag() * by_rate[3];
    }

    Eigen::Matrix2cd value;
    RealMap real_value = RealMap::Zero();
    std::array<RealRows<rate_count>, 4> by_rate;
};

// Derivatives of the motion.
struct MotionDerivatives {
    RealRows<rate_count> by_rates = RealRows<rate_count>::Zero();
    RealMap by_start = RealMap::Identity();
    Real by_cubic = Real::Zero();

    // Of the motion after a map.
    void follow(const RealMap& map) {
        by_rates = map.lazyProduct(by_rates).eval();
        by_start = map.lazyProduct(by_start).eval();
        by_cubic = map.lazyProduct(by_cubic).eval();
    }
};

struct Motion {
    Vector2cd z;
    MotionDerivatives by;
};

// Moves on through exp(M t).
void propagate(Motion& motion, const Propagation& step, Wanted wanted) {
    if (wanted == Wanted::derivatives) {
        motion.by.follow(step.real_value);
        motion.by.by_rates += step.by_rates(motion.z);
    }
    motion.z = step.value * motion.z;
}

// What the cubic term does in a time to u+ and u-: their phases change, and by as much again in as
// long a time that follows.
struct Kick {
    Kick(const Vector2cd& z, double cubic, double t, const ScaledRun& run) {
        // The spring depends on the whole amplitude, of which the mean over a window loses a part.
        const double by_power = 2 * pi / 3 * t / run.power_kept;
        const double plus = std::norm(z[0] + i * z[1]);
        const double minus = std::norm(z[0] - i * z[1]);
        of_plus = by_power * (plus + 2 * minus - 3 * run.power);
        of_minus = by_power * (minus + 2 * plus - 3 * run.power);
        half_turn_plus = std::polar(0.5, cubic * of_plus);
        half_turn_minus = std::polar(0.5, cubic * of_minus);
        cubic_by_power = cubic * by_power;
    }

    double of_plus;  // phases for a cubic term of one
    double of_minus;
    double cubic_by_power;
    Complex half_turn_plus;  // half the factors
    Complex half_turn_minus;
};

void kick(Motion& motion, const Kick& by, Wanted wanted) {
    const Complex plus = motion.z[0] + i * motion.z[1];
    const Complex minus = motion.z[0] - i * motion.z[1];
    const Complex plus_after = by.half_turn_plus * plus;
    const Complex minus_after = by.half_turn_minus * minus;
    motion.z = {plus_after + minus_after, -i * (plus_after - minus_after)};
    if (wanted == Wanted::motion) {
        return;
    }
    // Changes of z by a phase of u+ and of u-, and gradients of |u+|^2/2 and |u-|^2/2 before.
    const Real by_phase_plus = real_parts({i * plus_after, plus_after});
    const Real by_phase_minus = real_parts({i * minus_after, -minus_after});
    const Real of_plus = real_parts({plus, -i * plus});
    const Real of_minus = real_parts({minus, i * minus});
    const Complex mean = by.half_turn_plus + by.half_turn_minus;
    const Complex apart = i * (by.half_turn_plus - by.half_turn_minus);
    Eigen::Matrix2cd turned;
    turned << mean, apart, -apart, mean;
    const double g = by.cubic_by_power;
    const RealMap map = real(turned) +
                        by_phase_plus * (g * (2 * of_plus + 4 * of_minus)).transpose() +
                        by_phase_minus * (g * (2 * of_minus + 4 * of_plus)).transpose();
    motion.by.follow(map);
    motion.by.by_cubic += by.of_plus * by_phase_plus + by.of_minus * by_phase_minus;
}

// The breaks before a time together.
class PassedBreaks {
public:
    PassedBreaks(const ScaledRun& run, const Eigen::VectorXd& own) : run_(run), own_(own) {}

    // Precondition: times do not fall from call to call. Returns whether the start has changed.
    bool pass(double time_s) {
        bool restarts = false;
        for (; next_ < run_.breaks.size() && time_s > run_.breaks[next_].time_s; ++next_) {
            const BreakKind kind = run_.breaks[next_].kind;
            if (kind == BreakKind::phase) {
                factors_ *= std::polar(1.0, own_[at_]);
            } else if (kind == BreakKind::gain) {
                factors_.array() *= own_.segment<2>(at_).array().exp();
            } else if (kind == BreakKind::start) {
                start_ += of_real_parts(own_.segment<4>(at_));
                restarts = true;
            }
            at_ += break_size(kind);
        }
        return restarts;
    }

    const Vector2cd& factors() const { return factors_; }  // of C and D
    const Vector2cd& start() const { return start_; }

private:
    const ScaledRun& run_;
    const Eigen::VectorXd& own_;
    std::size_t next_ = 0;
    Eigen::Index at_ = own_count;
    Vector2cd factors_ = Vector2cd::Ones();
    Vector2cd start_ = Vector2cd::Zero();
};

// Motion z at the windows, without the run's own phase.
class MotionSteps {
public:
    MotionSteps(const ScaledRun& run, const Eigen::VectorXd& shared, const Eigen::VectorXd& own,
                bool with_cubic, Wanted wanted)
        : run_(run),
          dynamics_(shared),
          cubic_(shared[cubic_at]),
          steps_(with_cubic),
          wanted_(wanted) {
        start_ = of_real_parts(own.head<4>());
        begin_.z = start_;
        now_ = begin_;
    }

    // Continues as the motion whose start differs by `change`.
    void restart(const Vector2cd& change) {
        begin_.z = start_ + change;
        now_ = begin_;
        walk_ = {};
        time_s_ = 0;
        kick_.reset();
    }

    // Precondition: windows in order.
    const Motion& at(std::size_t window) {
        const double t = run_.time_s[window];
        if (!steps_) {
            // Whole steps from the window before; at intervals exactly from the start.
            if (walk_.step_to(t, run_.step_s)) {
                if (!step_) {
                    step_.emplace(dynamics_, run_.step_s, wanted_);
                }
                propagate(now_, *step_, wanted_);
            } else {
                now_ = begin_;
                propagate(now_, Propagation(dynamics_, t, wanted_), wanted_);
            }
            return now_;
        }
        // A gap is crossed in steps of a window.
        const double length = t - time_s_;
        const auto count = std::max(1.0, std::round(length / run_.step_s));
        const double h = length / count;
        if (!step_ || std::abs(h - h_) > 1e-9 * h_) {
            step_.emplace(dynamics_, h, wanted_);
            h_ = h;
            kick_.reset();
        }
        for (double k = 0; k < count; ++k) {
            kick(now_, kick_ ? *kick_ : Kick(now_.z, cubic_, h / 2, run_), wanted_);
            propagate(now_, *step_, wanted_);
            kick_.emplace(now_.z, cubic_, h / 2, run_);
            kick(now_, *kick_, wanted_);
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
    std::optional<Propagation> step_;
    std::optional<Kick> kick_;  // the last one: the next takes as long
};

// Factors from the motion to the channels at a window's time.
struct Channels {
    Complex c;      // e^{gain_C + i phi}
    Complex d;      // e^{gain_D + i phi}/kappa
    Complex gain;   // that of D times g
    Complex cross;  // that of D times sin skew + i crosstalk
    double u = 0;
    double x = 0;

    // `z`: of the recorded channels, not turned by the run's angle.
    Vector2cd seen(const Vector2cd& z) const { return {c * z[0], gain * z[1] + cross * z[0]}; }
};

class ChannelFactors {
public:
    ChannelFactors(const ScaledRun& run, const Eigen::VectorXd& shared, const Eigen::VectorXd& own)
        : run_(run),
          shared_(shared),
          own_(own),
          cross_(std::sin(shared[skew_at]), shared[crosstalk_at]),
          bend_(std::polar(1.0, 2 * pi * own[drift_at] * run.step_s * run.step_s)),
          turn_beside_(std::polar(1.0, shared[phase_drift_at] * run.step_s / run.duration_s)) {}

    // Precondition: windows in order.
    Channels at(const PassedBreaks& breaks, double t) {
        Channels channels;
        channels.u = t - run_.reference_s;
        channels.x = t / run_.duration_s;
        // A sine takes longer than all else of a window; a product from one to the next does not.
        if (walk_.step_to(t, run_.step_s)) {
            carrier_ *= turn_;
            turn_ *= bend_;
            beside_ *= turn_beside_;
        } else {
            const double u = channels.u;
            const double h = run_.step_s;
            carrier_ = std::polar(1.0, 2 * pi * u * (own_[frequency_at] + own_[drift_at] * u / 2));
            turn_ =
                std::polar(1.0, 2 * pi * h * (own_[frequency_at] + own_[drift_at] * (u + h / 2)));
            beside_ = std::polar(1.0, shared_[phase_at] + shared_[phase_drift_at] * channels.x);
        }
        channels.c = carrier_ * breaks.factors()[0];
        channels.d = carrier_ * breaks.factors()[1] / shared_[kappa_at];
        channels.gain = (1 + shared_[gain_drift_at] * channels.x) * channels.d * beside_;
        channels.cross = channels.d * cross_;
        return channels;
    }

private:
    const ScaledRun& run_;
    const Eigen::VectorXd& shared_;
    const Eigen::VectorXd& own_;
    Complex cross_;
    Walk walk_;
    Complex carrier_;      // of the run's frequency, at the window
    Complex turn_;         // of the carrier to the next window
    Complex bend_;         // of that turn
    Complex beside_;       // phase of D against C
    Complex turn_beside_;  // of it to the next window
};

// The factor by which the mean over a window changes the motion at its centre while the run's
// frequency drifts, relative to that at the run's own frequency, which belongs to the start. With
// F(s) = sinh(s w/2)/(s w/2), M with the run's frequency, and the frequency off by d rad/s:
//     F(M + i d)/F(M) = 1 + i d F'(M)/F(M) - d^2 w^2/24 + ...
// Of two modes it makes one decay faster and the other slower.
class DriftedMean {
public:
    DriftedMean(const ScaledRun& run, const Eigen::VectorXd& shared, const Eigen::VectorXd& own)
        : reference_s_(run.reference_s), drift_(2 * pi * own[drift_at]) {
        if (drifts()) {
            const double w2 = run.window_s * run.window_s;
            const Eigen::Matrix2cd m =
                SlowDynamics(shared).matrix() +
                2 * pi * own[frequency_at] * i * Eigen::Matrix2cd::Identity();
            by_offset_ = i * (w2 / 12) * (m - w2 / 60 * m * m * m);
            by_square_ = -w2 / 24;
        }
    }

    bool drifts() const { return drift_ != 0; }

    Eigen::Matrix2cd at(double t) const {
        const double off = drift_ * (t - reference_s_);
        return off * by_offset_ + (1 + by_square_ * off * off) * Eigen::Matrix2cd::Identity();
    }

private:
    double reference_s_;
    double drift_;
    Eigen::Matrix2cd by_offset_ = Eigen::Matrix2cd::Zero();
    double by_square_ = 0;
};

// Measured less predicted phasors of a window.
Vector2cd left_of(const ScaledRun& run, std::size_t window, const Vector2cd& expected) {
    if (!run.phase_lost) {
        return run.weighted(window, run.z[window] - expected);
    }
    const Complex along = (run.whitening * expected).dot(run.whitening * run.z[window]);
    return run.weighted(window, run.z[window] * std::polar(1.0, -std::arg(along)) - expected);
}

// The shared parameters as a run has them: with its deviation.
Eigen::VectorXd shared_of(const ScaledRun& run, const Eigen::VectorXd& shared) {
    Eigen::VectorXd own = shared;
    own[decay_at] *= 1 + run.deviation[decay_deviates];
    own[split_cos_at] *= 1 + run.deviation[split_deviates];
    own[split_sin_at] *= 1 + run.deviation[split_deviates];
    own[kappa_at] *= 1 + run.deviation[kappa_deviates];
    return own;
}

// Calls use(window, predicted phasors) for the first `windows` windows, until it is false.
template <class Use>
void for_expected(const ScaledRun& run, const Eigen::VectorXd& of_set, const Eigen::VectorXd& own,
                  std::size_t windows, const Use& use) {
    const Eigen::VectorXd shared = shared_of(run, of_set);
    PassedBreaks breaks(run, own);
    ChannelFactors channels(run, shared, own);
    const DriftedMean mean(run, shared, own);
    const Eigen::Matrix2d turn = run.turn();
    const auto seen = [&](double t, const Vector2cd& z) {
        const Vector2cd wave = turn.transpose() * (mean.drifts() ? Vector2cd(mean.at(t) * z) : z);
        return Vector2cd(turn * channels.at(breaks, t).seen(wave));
    };
    MotionSteps motion(run, shared, own, shared[cubic_at] != 0, Wanted::motion);
    for (std::size_t k = 0; k < windows; ++k) {
        if (breaks.pass(run.time_s[k])) {
            motion.restart(breaks.start());
        }
        if (!use(k, seen(run.time_s[k], motion.at(k).z))) {
            return;
        }
    }
}

}  // namespace

std::vector<Vector2cd> expected_phasors(const ScaledRun& run, const Eigen::VectorXd& shared,
                                        const Eigen::VectorXd& own, std::size_t windows) {
    std::vector<Vector2cd> expected;
    expected.reserve(windows);
    for_expected(run, shared, own, windows, [&](std::size_t, const Vector2cd& z) {
        expected.push_back(z);
        return true;
    });
    return expected;
}

Linearised linearised(const ScaledRun& run, const Eigen::VectorXd& of_set,
                      const Eigen::VectorXd& own, std::size_t windows, SharedColumns wanted,
                      Linearised before) {
    const Eigen::VectorXd shared = shared_of(run, of_set);
    const auto rows = static_cast<Eigen::Index>(4 * windows);
    Linearised out = std::move(before);
    if (out.by_parameter.rows() != rows || out.by_parameter.cols() != shared_count + own.size()) {
        out = {Eigen::VectorXd(rows), RowMajor::Zero(rows, shared_count + own.size())};
    }
    const bool with_cubic = wanted[cubic_at];
    MotionSteps motion(run, shared, own, with_cubic || shared[cubic_at] != 0, Wanted::derivatives);
    PassedBreaks breaks(run, own);
    ChannelFactors factors(run, shared, own);
    const DriftedMean mean(run, shared, own);
    const Eigen::Matrix2d turn = run.turn();
    const Eigen::Matrix2d whitened_turn = run.whitening * turn;
    const double kappa = shared[kappa_at];
    for (std::size_t k = 0; k < windows; ++k) {
        if (breaks.pass(run.time_s[k])) {
            motion.restart(breaks.start());
        }
        const Channels channels = factors.at(breaks, run.time_s[k]);
        const Motion& at = motion.at(k);
        Eigen::Matrix2cd to_wave = turn.transpose();
        if (mean.drifts()) {
            to_wave *= mean.at(run.time_s[k]);
        }
        const Vector2cd wave = to_wave * at.z;
        const Vector2cd of_channels = channels.seen(wave);
        const Vector2cd expected = turn * of_channels;
        const auto row = static_cast<Eigen::Index>(4 * k);
        out.residual.segment<4>(row) = real_parts(left_of(run, k, expected));
        Eigen::Matrix2cd seen;
        seen << channels.c, 0, channels.cross, channels.gain;
        const Eigen::Matrix2d to_residual = run.weight[k] * whitened_turn;
        const RealMap map = real(Eigen::Matrix2cd(to_residual * seen * to_wave));
        out.by_parameter.block<4, rate_count>(row, 0) = map.lazyProduct(at.by.by_rates);
        const RealMap by_start = map.lazyProduct(at.by.by_start);
        out.by_parameter.block<4, 4>(row, own_column(start_at)) = by_start;
        if (with_cubic) {
            out.by_parameter.block<4, 1>(row, cubic_at) = map.lazyProduct(at.by.by_cubic);
        }
        // Of the recorded channels.
        const auto put_channels = [&](int column, const Vector2cd& change) {
            out.by_parameter.block<4, 1>(row, column) = real_parts(to_residual * change);
        };
        const auto put_d = [&](int column, const Complex& change) {
            if (wanted[static_cast<std::size_t>(column)]) {
                put_channels(column, {0, change});
            }
        };
        const Complex d_gain = channels.gain * wave[1];
        const Complex d_cross = channels.d * wave[0];
        put_d(kappa_at, -of_channels[1] / kappa);
        put_d(skew_at, std::cos(shared[skew_at]) * d_cross);
        put_d(crosstalk_at, i * d_cross);
        put_d(phase_at, i * d_gain);
        put_d(phase_drift_at, i * channels.x * d_gain);
        put_d(gain_drift_at, channels.x / (1 + shared[gain_drift_at] * channels.x) * d_gain);
        const Real by_phase = real_parts(to_residual * (i * of_channels));
        out.by_parameter.block<4, 1>(row, own_column(frequency_at)) =
            2 * pi * channels.u * by_phase;
        out.by_parameter.block<4, 1>(row, own_column(drift_at)) =
            pi * channels.u * channels.u * by_phase;
        int column = own_column(own_count);
        for (const RunBreak& each : run.breaks) {
            if (run.time_s[k] <= each.time_s) {
                break;
            }
            if (each.kind == BreakKind::phase) {
                out.by_parameter.block<4, 1>(row, column) = by_phase;
            } else if (each.kind == BreakKind::gain) {
                put_channels(column, {of_channels[0], 0});
                put_channels(column + 1, {0, of_channels[1]});
            } else if (each.kind == BreakKind::start) {
                out.by_parameter.block<4, 4>(row, column) = by_start;
            }
            column += break_size(each.kind);
        }
        if (run.phase_lost) {
            const Real phase = real_parts(i * (run.whitening * expected)).normalized();
            const Eigen::RowVectorXd common =
                phase.transpose() * out.by_parameter.middleRows<4>(row);
            out.by_parameter.middleRows<4>(row) -= phase * common;
        }
    }
    out.by_parameter.col(decay_at) *= 1 + run.deviation[decay_deviates];
    out.by_parameter.middleCols<2>(split_cos_at) *= 1 + run.deviation[split_deviates];
    out.by_parameter.col(kappa_at) *= 1 + run.deviation[kappa_deviates];
    return out;
}

Eigen::VectorXd residual_of(const ScaledRun& run, const Eigen::VectorXd& shared,
                            const Eigen::VectorXd& own, std::size_t windows) {
    Eigen::VectorXd residual(static_cast<Eigen::Index>(4 * windows));
    for_expected(run, shared, own, windows, [&](std::size_t k, const Vector2cd& expected) {
        residual.segment<4>(static_cast<Eigen::Index>(4 * k)) =
            real_parts(left_of(run, k, expected));
        return true;
    });
    return residual;
}

double chi_square(const ScaledRun& run, const Eigen::VectorXd& shared, const Eigen::VectorXd& own,
                  std::size_t windows, double most) {
    double sum = 0;
    for_expected(run, shared, own, windows, [&](std::size_t k, const Vector2cd& expected) {
        sum += left_of(run, k, expected).squaredNorm();
        return !(sum > most);
    });
    return sum;
}

}  // namespace vybeg
