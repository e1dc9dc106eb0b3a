#include "core/resonator/runs/run_track.h"
#include "tests/closeness.h"
#include "tests/core/resonator/simulated_phasors.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <cmath>
#include <numbers>
#include <utility>

namespace test_run_track {

using namespace vybeg;
using namespace vybeg::test;

class TestRunTrack : public QObject {
    Q_OBJECT

private slots:
    void its_points_lie_on_the_motion_within_their_deviations() {
        FreeDecay decay{.f0_hz = 5300, .a_B = 0.2, .tau_s = 100};
        decay.omega_rad_s = 0.4;  // 2 theta_A turns through 355 degrees
        decay.noise = 1e-3;
        const RunTrack track = run_track(simulated_phasors(decay, 500, 1), 200);
        QCOMPARE(track.time_s.size(), std::size_t{200});
        double squares = 0;
        for (std::size_t k = 0; k < 200; ++k) {
            const double t = track.time_s[k];
            const double fall = std::exp(-t / decay.tau_s);
            const double angle = decay.two_theta_A - 2 * decay.bryan * decay.omega_rad_s * t;
            VYBEG_CLOSE(track.a_A[k], fall, 5 * track.sd_a[k]);
            VYBEG_CLOSE(track.a_B[k], 0.2 * fall, 5 * track.sd_a[k]);
            VYBEG_CLOSE(track.two_theta_A[k], angle, 5 * track.sd_two_theta_A[k]);
            squares += std::pow((track.two_theta_A[k] - angle) / track.sd_two_theta_A[k], 2) / 200;
        }
        VYBEG_CLOSE(squares, 1, 0.45);
    }

    void its_frequency_is_that_of_the_phase() {
        const FreeDecay decay{.noise = 1e-3};
        PhasorRun run = simulated_phasors(decay, 500, 2);
        run.f_ref_hz += 0.02;  // the same signals seen from another reference
        for (std::size_t k = 0; k < run.time_s.size(); ++k) {
            const auto turn = std::polar(1.0, -2 * std::numbers::pi * 0.02 * run.time_s[k]);
            run.c[k] *= turn;
            run.d[k] *= turn;
        }
        const RunTrack track = run_track(run, 100);
        double squares = 0;
        for (std::size_t k = 0; k < 100; ++k) {
            squares += std::pow((track.f_hz[k] - decay.f0_hz) / track.sd_f_hz[k], 2) / 100;
        }
        VYBEG_CLOSE(squares, 1, 0.6);
    }

    void few_windows_are_points_of_their_own() {
        const FreeDecay decay{.seconds = 0.05};
        const RunTrack track = run_track(simulated_phasors(decay, 500, 3), 200);
        QCOMPARE(track.time_s.size(), std::size_t{3});
        QVERIFY(std::isnan(track.f_hz[0]));
        QCOMPARE(run_track({}, 200), RunTrack{});
    }
};

VYBEG_TEST(TestRunTrack)

}  // namespace test_run_track

#include "test_run_track.moc"
