// The wave's own four numbers against the motion that was simulated.
//
// Statistical model: a pull is the error over the deviation told; over N independent runs the mean
// of its squares is 1 within sqrt(2/N).
#include "core/resonator/runs/wave_motion.h"
#include "tests/closeness.h"
#include "tests/core/resonator/known_resonator.h"
#include "tests/test_registry.h"

#include <array>
#include <cmath>

namespace test_wave_motion {

using namespace vybeg;
using namespace vybeg::test;

namespace {

constexpr std::int64_t window = 500;

using Numbers = std::array<Estimate, 4>;

Numbers numbers(const WaveMotion& wave) {
    return {wave.f_hz, wave.decay_per_s, wave.theta_rate_rad_s, wave.quadrature_rate_per_s};
}

// The same windows without noise; the deviations, hence the weights, are those of `noise`.
PhasorRun silent(FreeDecay decay, double offset_hz) {
    const double sd = decay.noise * std::sqrt(2.0 / window);
    decay.noise = 0;
    PhasorRun run = simulated_phasors(decay, window, 1, offset_hz);
    run.sd.assign(run.sd.size(), sd);
    return run;
}

// Adds noise around the reference frequency with a Lorentz line of half width w, exact from window
// to window; `size` is the deviation of each of the four parts.
void add_noise_about_the_carrier(PhasorRun& run, double half_width_hz, double size,
                                 std::uint64_t seed) {
    GaussianNoise noise(seed);
    const double keep = std::exp(-2 * std::numbers::pi * half_width_hz * run.window_s);
    const double fresh = size * std::sqrt(1 - keep * keep);
    std::array<double, 4> state{};
    bool first = true;
    for (std::size_t k = 0; k < run.time_s.size(); ++k) {
        for (std::size_t i = 0; i < 4; i += 2) {
            const auto [a, b] = noise.next();
            state[i] = first ? size * a : keep * state[i] + fresh * a;
            state[i + 1] = first ? size * b : keep * state[i + 1] + fresh * b;
        }
        first = false;
        run.c[k] += std::complex(state[0], state[1]);
        run.d[k] += std::complex(state[2], state[3]);
    }
}

struct Pulls {
    std::array<double, 4> squares{};
    int runs = 0;

    void add(const WaveMotion& found, const WaveMotion& truth) {
        const Numbers is = numbers(found);
        const Numbers should = numbers(truth);
        for (std::size_t i = 0; i < 4; ++i) {
            const double pull = (is[i].value - should[i].value) / is[i].sd;
            squares[i] += pull * pull;
        }
        ++runs;
    }
    double rms(std::size_t i) const { return std::sqrt(squares[i] / runs); }
    QString text() const {
        return QString("rms pulls: f %1, decay %2, angle %3, quadrature %4")
            .arg(rms(0))
            .arg(rms(1))
            .arg(rms(2))
            .arg(rms(3));
    }
    bool within(double least, double most) const {
        for (std::size_t i = 0; i < 4; ++i) {
            if (!(rms(i) >= least && rms(i) <= most)) {
                return false;
            }
        }
        return true;
    }
};

// Window means by so many points that a window may hold a quarter of a beat.
PhasorRun exact_means(const FreeDecay& decay, std::int64_t samples, std::uint64_t seed,
                      double offset_hz) {
    const SlowMotion motion(decay);
    const Eigen::Vector2cd start = motion.at_frame(0);
    const double window_s = static_cast<double>(samples) / decay.rate_hz;
    constexpr int points = 64;
    return noisy_phasors(decay, samples, seed, [&](std::int64_t, double t) {
        Eigen::Vector2cd z = Eigen::Vector2cd::Zero();
        for (int k = 0; k < points; ++k) {
            const double u = t + ((k + 0.5) / points - 0.5) * window_s;
            z += std::polar(1.0 / points, 2 * std::numbers::pi * offset_hz * u) *
                 (motion.propagator(u) * start);
        }
        return z;
    });
}

// A resonator of a split, started at an angle with some quadrature.
FreeDecay wave(double split_hz, double theta_deg, double a_B) {
    FreeDecay decay = reference();
    decay.split_hz = split_hz;
    decay.theta_w = 0.2;
    decay.damping_anisotropy_per_s = 2e-4;
    decay.theta_tau = 0.5;
    decay.two_theta_A = 2 * theta_deg * std::numbers::pi / 180;
    decay.a_B = a_B;
    decay.noise = 3e-3;
    return decay;
}

}  // namespace

class TestWaveMotion : public QObject {
    Q_OBJECT

private slots:
    void its_numbers_are_those_of_a_steady_motion() {
        FreeDecay decay = reference();
        decay.tau_s = 40;
        decay.omega_rad_s = 0.02;
        decay.noise = 1e-4;
        const WaveMotion found = wave_motion(simulated_phasors(decay, window, 3, 0.7));
        VYBEG_NEAR(found.f_hz, decay.f0_hz + 0.7, 4, 1e-5);
        VYBEG_NEAR(found.tau_s, 40, 4, 1e-2);
        VYBEG_NEAR(found.decay_per_s, 1.0 / 40, 4, 1e-5);
        VYBEG_NEAR(found.theta_rate_rad_s, -0.277 * 0.02, 4, 1e-5);
        VYBEG_NEAR(found.quadrature_rate_per_s, 0, 4, 1e-5);
        // By the growth of the quadrature, d(a_B/a_A)/dt = pi split sin 4(theta_A - theta_w).
        FreeDecay split = reference();
        split.split_hz = 1e-4;
        split.noise = 1e-4;
        const WaveMotion grown = wave_motion(simulated_phasors(split, window, 3));
        VYBEG_NEAR(grown.quadrature_rate_per_s, std::numbers::pi * 1e-4 * std::sin(0.6), 4, 1e-5);
    }

    void their_deviations_are_right_in_white_noise() {
        for (const auto& [split, angle, a_B] :
             {std::array{1e-6, 10.0, 0.0}, {1e-4, 40.0, 0.1}, {1e-3, -70.0, -0.3}}) {
            const FreeDecay decay = wave(split, angle, a_B);
            const WaveMotion truth = wave_motion(silent(decay, 0.3));
            Pulls pulls;
            std::array<std::vector<double>, 4> cost;  // deviation told over that of white noise
            for (std::uint64_t seed = 1; seed <= 60; ++seed) {
                const WaveMotion found = wave_motion(simulated_phasors(decay, window, seed, 0.3));
                pulls.add(found, truth);
                for (std::size_t i = 0; i < 4; ++i) {
                    cost[i].push_back(numbers(found)[i].sd / numbers(truth)[i].sd);
                }
            }
            QVERIFY2(pulls.within(0.75, 1.25), qPrintable(pulls.text()));
            // White noise costs nothing where the motion has no bend: below 5 % in 9 of 10 runs.
            for (std::vector<double>& each : cost) {
                std::ranges::sort(each);
                if (split <= 1e-4) {
                    VYBEG_LESS(each[53], 1.05);
                }
            }
        }
    }

    // Phases are summed from window to window: the products of two windows' noises, too.
    void noise_near_the_wave_costs_no_more_than_the_bound() {
        for (const double noise : {0.03, 0.12, 0.25}) {
            FreeDecay decay = reference();
            decay.seconds = 17;
            decay.tau_s = 1e300;
            decay.noise = noise;
            double squares = 0;
            double pulls = 0;
            constexpr int seeds = 40;
            for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
                const Estimate f = wave_motion(simulated_phasors(decay, 500, seed)).f_hz;
                squares += std::pow(f.value - decay.f0_hz, 2) / seeds;
                pulls += std::pow((f.value - decay.f0_hz) / f.sd, 2) / seeds;
            }
            // sqrt(6/N) sd/(pi a T), N samples.
            const double bound =
                std::sqrt(6 / (17 * decay.rate_hz)) * noise / (std::numbers::pi * 17);
            const QString text = QString("noise %1: error over the bound %2, rms pull %3")
                                     .arg(noise)
                                     .arg(std::sqrt(squares) / bound)
                                     .arg(std::sqrt(pulls));
            VYBEG_LESS(std::sqrt(squares), 1.6 * bound, qPrintable(text));
            VYBEG_MORE(std::sqrt(pulls), 0.7, qPrintable(text));
            VYBEG_LESS(std::sqrt(pulls), 1.3, qPrintable(text));
        }
    }

    void a_curved_motion_has_no_smaller_deviation() {
        for (const double split : {0.01, 0.03, 0.2}) {
            const FreeDecay decay = wave(split, 10, 0.1);
            const WaveMotion truth = wave_motion(silent(decay, 0));
            Pulls pulls;
            for (std::uint64_t seed = 1; seed <= 30; ++seed) {
                pulls.add(wave_motion(simulated_phasors(decay, window, seed)), truth);
            }
            QVERIFY2(pulls.within(0, 1.4), qPrintable(pulls.text()));
        }
    }

    void a_fast_beat_loses_nothing_in_the_windows() {
        for (const double split : {0.5, 1.5, 2.58}) {
            FreeDecay decay = wave(split, 17, 0);
            decay.theta_w = 0.8664;
            decay.damping_anisotropy_per_s = 0;
            decay.tau_s = 1500;
            decay.noise = 1e-3;
            decay.seconds = 14;
            // The modes' frequencies by their shares of the power, which stay; one of them is near
            // the reference.
            const double angle = 4 * (17 * std::numbers::pi / 180 - decay.theta_w);
            const double offset = 0.4 * split;
            const double truth = decay.f0_hz + offset + 0.5 * split * std::cos(angle);
            for (std::uint64_t seed = 1; seed <= 4; ++seed) {
                const WaveMotion found =
                    wave_motion(simulated_phasors(decay, window, seed, offset));
                VYBEG_NEAR(found.f_hz, truth, 5, 1e-4);
            }
        }
    }

    // As the program chooses windows for wide splits: five in a cycle of the beat and more.
    void beats_of_five_windows_and_more_are_followed() {
        for (const double split : {7.0, 15.0, 40.0}) {
            for (const double per_cycle : {5.0, 8.0, 13.0}) {
                FreeDecay decay = wave(split, 17, 0);
                decay.theta_w = 0.8664;
                decay.damping_anisotropy_per_s = 0;
                decay.tau_s = 1500;
                decay.noise = 1e-3;
                decay.seconds = 14;
                const double angle = 4 * (17 * std::numbers::pi / 180 - decay.theta_w);
                const auto samples = static_cast<std::int64_t>(decay.rate_hz / split / per_cycle);
                for (const double share : {-0.3, 0.4}) {
                    const double offset = share * split;
                    const double truth = decay.f0_hz + offset + 0.5 * split * std::cos(angle);
                    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
                        const PhasorRun run = exact_means(decay, samples, seed, offset);
                        VYBEG_NEAR(wave_motion(run).f_hz, truth, 4.5, 1e-3);
                    }
                }
            }
        }
    }

    void noise_about_the_carrier_is_in_the_deviations_data() {
        QTest::addColumn<double>("half_width_hz");
        QTest::addColumn<double>("size");
        for (const double width : {0.02, 0.05, 0.2, 1.0}) {
            for (const double size : {1e-5, 1e-4, 1e-3}) {
                QTest::addRow("%g Hz, %g", width, size) << width << size;
            }
        }
    }

    void noise_about_the_carrier_is_in_the_deviations() {
        QFETCH(double, half_width_hz);
        QFETCH(double, size);
        FreeDecay decay = wave(1e-4, 30, 0.05);
        decay.noise = 1e-3;
        const WaveMotion truth = wave_motion(silent(decay, 0));
        Pulls pulls;
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            PhasorRun run = simulated_phasors(decay, window, seed);
            add_noise_about_the_carrier(run, half_width_hz, size, 500 + seed);
            pulls.add(wave_motion(run), truth);
        }
        QVERIFY2(pulls.within(0.4, 1.5), qPrintable(pulls.text()));
    }

    void a_phase_that_breaks_costs_the_frequency_no_truth() {
        const FreeDecay decay = wave(1e-4, 25, 0.05);
        PhasorRun silence = silent(decay, 0);
        silence.breaks = {{9.3}, {17.1}};
        const WaveMotion truth = wave_motion(silence);
        Pulls pulls;
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            PhasorRun run = simulated_phasors(decay, window, seed);
            run.breaks = silence.breaks;
            for (std::size_t k = 0; k < run.time_s.size(); ++k) {
                const auto turn = std::polar(1.0, run.time_s[k] < 9.3    ? 0.0
                                                  : run.time_s[k] < 17.1 ? 1.0
                                                                         : 2.8);
                run.c[k] *= turn;
                run.d[k] *= turn;
            }
            pulls.add(wave_motion(run), truth);
        }
        QVERIFY2(pulls.within(0.7, 1.3), qPrintable(pulls.text()));
    }

    void outliers_are_left_out() {
        const FreeDecay decay = wave(1e-4, 25, 0.05);
        const WaveMotion truth = wave_motion(silent(decay, 0));
        Pulls pulls;
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            PhasorRun run = simulated_phasors(decay, window, seed);
            for (std::size_t k = 3; k < 100; k += 7) {
                run.c[k] *= 1.2;
                run.d[k] += std::complex(0.1, -0.3);
            }
            pulls.add(wave_motion(run), truth);
        }
        QVERIFY2(pulls.within(0.7, 1.3), qPrintable(pulls.text()));
    }

    // A wave at 45 degrees of 2theta from an axis swings through the circular state; beside it the
    // angle turns fast, this way or that.
    void a_wave_near_the_circular_state_has_the_right_sense_or_none() {
        int given = 0;
        int refused = 0;
        for (const double beside_deg : {-20.0, -5.0, -2.0, -1.0, -0.3, -0.1, -0.02, 0.0, 0.02, 0.1,
                                        0.3, 1.0, 2.0, 5.0, 20.0}) {
            FreeDecay decay = wave(0.05, 0, 0);
            decay.two_theta_A =
                2 * (decay.theta_w + std::numbers::pi / 8 + beside_deg * std::numbers::pi / 180);
            FreeDecay clean = decay;
            clean.noise = 1e-9;
            const double truth =
                wave_motion(simulated_phasors(clean, window / 40, 1)).theta_rate_rad_s.value;
            for (std::uint64_t seed = 1; seed <= 8; ++seed) {
                const Estimate rate =
                    wave_motion(simulated_phasors(decay, window, seed)).theta_rate_rad_s;
                if (rate.given()) {
                    VYBEG_NEAR(rate, truth, 4, 0.1);
                    ++given;
                } else {
                    QCOMPARE(rate.reason.code, ReasonCode::circular_wave);
                    ++refused;
                }
            }
        }
        VYBEG_AT_LEAST(given, 32);
        VYBEG_AT_LEAST(refused, 16);
    }

    void what_is_not_there_has_its_reason() {
        FreeDecay decay = reference();
        decay.tau_s = 1e300;
        const WaveMotion undamped = wave_motion(simulated_phasors(decay, window, 1));
        QCOMPARE(undamped.tau_s.reason.code, ReasonCode::no_decay);
        QVERIFY(undamped.decay_per_s.given());
        PhasorRun growing = simulated_phasors(reference(), window, 1);
        for (std::size_t k = 0; k < growing.time_s.size(); ++k) {
            growing.c[k] *= std::exp(growing.time_s[k] / 100);
            growing.d[k] *= std::exp(growing.time_s[k] / 100);
        }
        QCOMPARE(wave_motion(growing).tau_s.reason.code, ReasonCode::grows);
        decay.a_B = 1;
        const WaveMotion circular = wave_motion(simulated_phasors(decay, window, 1));
        QCOMPARE(circular.theta_rate_rad_s.reason.code, ReasonCode::circular_wave);
        QCOMPARE(circular.quadrature_rate_per_s.reason.code, ReasonCode::circular_wave);
        QVERIFY(circular.f_hz.given());
        decay.seconds = 0.08;
        QCOMPARE(wave_motion(simulated_phasors(decay, window, 1)).f_hz.reason.code,
                 ReasonCode::too_few_windows);
    }
};

VYBEG_TEST(TestWaveMotion, statistical, unsanitized)

}  // namespace test_wave_motion

#include "test_wave_motion.moc"
