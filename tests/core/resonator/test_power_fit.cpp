// The resonator from E, R, S, Q, which have no phase, against motions integrated in small steps.
//
// Statistical model: errors are Gaussian with the deviations told; each is held to four and a half
// of them.
#include "core/estimators/wave/wave_state.h"
#include "core/resonator/results/power_fit.h"
#include "core/resonator/results/resonator_fit.h"
#include "core/resonator/results/resonator_parameters.h"
#include "tests/closeness.h"
#include "tests/core/resonator/simulated_phasors.h"
#include "tests/core/resonator/simulated_powers.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace test_power_fit {

using namespace vybeg;
using namespace vybeg::test;

constexpr double pi = std::numbers::pi;

namespace {

PowerRun log_of_noise(double power) {
    std::mt19937_64 random(1);
    return log_of({.tau = 20}, 0.1, 30, {.power = power}, random);
}

}  // namespace

class TestPowerFit : public QObject {
    Q_OBJECT

private slots:
    // The equations by differences of a motion that does not know them. They hold for the in-phase
    // and quadrature parts of x = Cx cos wt + Sx sin wt, of which the phasor is Cx - i Sx, and not
    // for c = Cx + i Sx, with which Q would change its sign.
    void powers_obey_their_equations() {
        const Resonator of;
        const ChannelPhasors z{{0.8, 0.1}, {-0.3, 0.4}};
        constexpr double h = 1e-3;
        const auto [e, r, s, q] = powers(z);
        const auto before = powers(stepped(of, z, -h));
        const auto after = powers(stepped(of, z, h));
        const double dw = 2 * pi * of.split;
        const double g_cos = of.g * std::cos(4 * of.theta_tau);
        const double g_sin = of.g * std::sin(4 * of.theta_tau);
        const double w_cos = dw * std::cos(4 * of.theta_w);
        const double w_sin = dw * std::sin(4 * of.theta_w);
        const std::array told{-2 * e / of.tau - g_cos * r - g_sin * s,
                              -2 * r / of.tau - g_cos * e + w_sin * q + 2 * of.r * s,
                              -2 * s / of.tau - g_sin * e - w_cos * q - 2 * of.r * r,
                              -2 * q / of.tau + w_cos * s - w_sin * r};
        for (std::size_t k = 0; k < told.size(); ++k) {
            VYBEG_CLOSE((after[k] - before[k]) / (2 * h), told[k], 1e-11);
        }
        VYBEG_CLOSE(e * e, r * r + s * s + q * q, 1e-12);
        VYBEG_CLOSE(q, 2 * (z.c.real() * -z.d.imag() - z.d.real() * -z.c.imag()), 1e-15);
        const WaveState wave = to_wave_state({z.c, z.d});
        VYBEG_CLOSE(q, 2 * wave.a_A * wave.a_B, 1e-12);
    }

    void the_linear_start_is_the_resonator_where_there_is_no_noise() {
        const Resonator of;
        const Eigen::VectorXd found = linear_powers(set_of(of, 4, 28, {}, 1));
        const double dw = 2 * pi * of.split;
        const std::array truth{2 / of.tau,
                               of.g * std::cos(4 * of.theta_tau),
                               of.g * std::sin(4 * of.theta_tau),
                               dw * std::sin(4 * of.theta_w),
                               dw * std::cos(4 * of.theta_w),
                               2 * of.r};
        for (std::size_t k = 0; k < truth.size(); ++k) {
            VYBEG_CLOSE(found[static_cast<Eigen::Index>(k)], truth[k], 1e-8);
        }
    }

    // Four logs of 28 s at 10 Hz, noise 1e-5.
    void four_logs_tell_the_resonator_to_the_digits_told() {
        const Resonator of;
        const ResonatorEstimate found = resonator_of(set_of(of, 4, 28, {.power = 1e-5}, 1));
        VYBEG_CLOSE(found.tau_s.value, 400, 0.005);
        VYBEG_CLOSE(found.split_hz.value, 2e-3, 2e-7);
        VYBEG_CLOSE(found.theta_w_rad.value, 0.3, 2e-5);
        VYBEG_CLOSE(found.damping_anisotropy_per_s.value, 3e-4, 4e-7);
        VYBEG_CLOSE(found.theta_tau_rad.value, 0.7, 3e-4);
        VYBEG_CLOSE(found.angle_rate_rad_s.value, -0.5e-3, 1e-7);
        const auto pulls = pulls_of(found, of);
        QCOMPARE(pulls.size(), std::size_t{6});
        for (const auto& [name, pull] : pulls) {
            VYBEG_LESS(std::abs(pull), 4.5, name.c_str());
        }
    }

    void what_needs_the_frequency_is_absent_with_its_reason() {
        const Result<PowerFit> found =
            fit_powers(set_of({}, 4, 28, {.power = 1e-5}, 2), known_channels(), {});
        QVERIFY(found);
        for (const Estimate* each :
             {&found->fit.resonator.f_mean_hz, &found->fit.resonator.q,
              &found->fit.resonator.delay_s, &found->fit.runs[1].f_offset_hz,
              &found->fit.runs[1].drift_hz_per_s, &found->fit.modes.at(0).f_hz}) {
            QCOMPARE(each->reason.code, ReasonCode::phase_lost);
            QVERIFY(std::isnan(each->value));
        }
        QVERIFY(found->fit.modes.at(0).tau_s.given());
        VYBEG_CLOSE(found->fit.runs[1].a_A.value, 1, 1e-4);
        VYBEG_CLOSE(found->fit.chi2_per_dof, 1, 0.2);
    }

    void one_still_wave_tells_no_split() {
        const ResonatorEstimate found =
            resonator_of(set_of({.split = 1e-4, .r = 0}, 1, 28, {.power = 1e-4}, 3));
        QVERIFY(!found.split_hz.given());
        QVERIFY(!found.angle_rate_rad_s.given());
    }

    // E^2 = R^2 + S^2 + Q^2 holds for any two channels, whatever they are.
    void powers_of_one_motion_agree_at_any_noise() {
        for (unsigned seed = 1; seed <= 20; ++seed) {
            for (const Noise noise : {Noise{.power = 1e-5}, Noise{.power = 0.1},
                                      Noise{.phasor = 1e-3}, Noise{.power = 1e-3, .phasor = 0.1}}) {
                for (const PowerRun& run : set_of({.tau = 20}, 2, 60, noise, seed)) {
                    QCOMPARE(power_mismatch(run).of_all, 0.0);
                    VYBEG_LESS(std::abs(power_mismatch(run).worst), 0.05);
                }
            }
        }
    }

    void a_column_of_another_unit_or_with_an_offset_does_not() {
        const PowerRun good = log_of_noise(1e-5);
        PowerRun milli = good;
        PowerRun half = good;
        PowerRun offset = good;
        PowerRun amplitude = good;
        for (std::size_t k = 0; k < good.e.size(); ++k) {
            milli.e[k] *= 1000;
            half.r[k] /= 2;
            offset.q[k] += 0.02;
            amplitude.e[k] = std::sqrt(amplitude.e[k]);
        }
        VYBEG_CLOSE(power_mismatch(milli).of_all, -1, 1e-5);
        VYBEG_LESS(power_mismatch(half).of_all, -0.5);
        VYBEG_LESS(power_mismatch(amplitude).of_all, -0.1);
        // (Q + 0.02)^2 - Q^2, the more of it the smaller the wave.
        const PowerMismatch found = power_mismatch(offset);
        VYBEG_LESS(std::abs(found.of_all), 0.01);
        VYBEG_MORE(std::abs(found.worst), 1e-3);
        VYBEG_MORE(found.at_s, 25.0);
    }

    void a_log_of_another_gyro_is_seen() {
        std::vector<PowerRun> set = set_of({}, 4, 28, {.power = 1e-5}, 4);
        std::mt19937_64 random(5);
        Resonator other;
        other.split = 3e-3;
        other.tau = 300;
        set[2] = log_of(other, 0.1 + pi / 4, 28, {.power = 1e-5}, random);
        const Result<PowerFit> found = fit_powers(set, known_channels(), {});
        QVERIFY(found);
        QCOMPARE(found->fit.resonator.split_hz.reason.code, ReasonCode::set_refused);
    }

    void tracks_and_phasors_of_the_same_decays_agree() {
        FreeDecay decay{.split_hz = 2e-3,
                        .theta_w = 0.3,
                        .tau_s = 400,
                        .damping_anisotropy_per_s = 3e-4,
                        .theta_tau = 0.7,
                        .omega_rad_s = 2e-3,
                        .noise = 1e-3};
        std::vector<PhasorRun> phasors;
        std::vector<PowerRun> tracks;
        for (int k = 0; k < 4; ++k) {
            decay.two_theta_A = 0.2 + k * pi / 4;
            phasors.push_back(simulated_phasors(decay, 3333, 100 + static_cast<unsigned>(k)));
            std::array<std::vector<double>, 3> waves;
            for (std::size_t row = 0; row < phasors.back().c.size(); ++row) {
                const WaveState wave =
                    to_wave_state({phasors.back().c[row], phasors.back().d[row]});
                waves[0].push_back(wave.a_A);
                waves[1].push_back(wave.a_B);
                waves[2].push_back(wave.two_theta_A / 2);
            }
            tracks.push_back(powers_of_waves(phasors.back().time_s, waves[0], waves[1], waves[2]));
        }
        for (const double kappa : {0.0, 0.01}) {
            FitOptions options;
            options.tolerance[kappa_error] = kappa;
            const Result<ResonatorFit> samples = fit_resonator(phasors, options, {});
            QVERIFY(samples);
            const ResonatorEstimate found = resonator_of(tracks, options);
            int compared = 0;
            for (const ResonatorParameter& parameter : resonator_parameters) {
                const Estimate& expected = samples->resonator.*parameter.member;
                const Estimate& estimate = found.*parameter.member;
                if (!expected.given() || estimate.reason.code == ReasonCode::phase_lost) {
                    continue;
                }
                QVERIFY2(estimate.given(), parameter.name);
                VYBEG_LESS(std::abs(estimate.value - expected.value), expected.sd, parameter.name);
                // The phase tells nothing of it that the powers do not.
                VYBEG_CLOSE_RATIO(estimate.sd, expected.sd, 0.3, parameter.name);
                ++compared;
            }
            VYBEG_AT_LEAST(compared, 6);
        }
    }
};

VYBEG_TEST(TestPowerFit)

}  // namespace test_power_fit

#include "test_power_fit.moc"
