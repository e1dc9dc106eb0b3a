// A wave as figures for drawing, against (6) and its amplitudes.
#include "core/track/wave_pattern.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace test_wave_pattern {

using namespace vybeg;

class TestWavePattern : public QObject {
    Q_OBJECT

    // Angles through all quadrants and onto the axes, both signs of a_B.
    static std::vector<WaveState> waves() {
        std::vector<WaveState> all;
        for (int k = -8; k <= 8; ++k) {
            for (const double a_B : {-0.3, 0., 1e-3, 0.7}) {
                all.push_back({1.5, a_B, k * std::numbers::pi / 8});
            }
        }
        return all;
    }

private slots:
    void the_pattern_has_four_antinodes_of_a_A_and_a_B_between_them() {
        for (const WaveState& wave : waves()) {
            const ClosedCurve curve = polar_pattern(wave, 1440);
            QCOMPARE(curve.x.size(), std::size_t(1441));
            VYBEG_CLOSE(std::ranges::max(curve.y), wave.a_A, 1e-4);
            VYBEG_CLOSE(std::ranges::min(curve.y), std::abs(wave.a_B), 1e-2);
            for (std::size_t k = 0; k < curve.x.size(); ++k) {
                // The larger semi-axis of the motion of this place of the rim over a period.
                double largest = 0;
                for (int step = 0; step < 400; ++step) {
                    const double tau = 2 * std::numbers::pi * step / 400;
                    const double c = wave.a_A * std::cos(tau) * std::cos(wave.two_theta_A) -
                                     wave.a_B * std::sin(tau) * std::sin(wave.two_theta_A);
                    const double d = wave.a_A * std::cos(tau) * std::sin(wave.two_theta_A) +
                                     wave.a_B * std::sin(tau) * std::cos(wave.two_theta_A);
                    largest = std::max(largest, std::abs(c * std::cos(2 * curve.x[k]) +
                                                         d * std::sin(2 * curve.x[k])));
                }
                VYBEG_CLOSE(curve.y[k], largest, 1e-3);
                k += 36;
            }
        }
    }

    void the_ellipse_has_the_semi_axes_direction_and_sense_of_the_wave() {
        for (const WaveState& wave : waves()) {
            const ClosedCurve curve = channel_ellipse(wave, 720);
            VYBEG_CLOSE(curve.x.back(), curve.x.front(), 1e-12);
            // At the start it stands at a_A in the direction 2theta_A.
            VYBEG_CLOSE(curve.x[0], wave.a_A * std::cos(wave.two_theta_A), 1e-12);
            VYBEG_CLOSE(curve.y[0], wave.a_A * std::sin(wave.two_theta_A), 1e-12);
            double area = 0;  // signed, anticlockwise positive
            double longest = 0;
            for (std::size_t k = 1; k < curve.x.size(); ++k) {
                area += (curve.x[k - 1] * curve.y[k] - curve.x[k] * curve.y[k - 1]) / 2;
                longest = std::max(longest, std::hypot(curve.x[k], curve.y[k]));
            }
            VYBEG_CLOSE(longest, wave.a_A, 1e-12);
            VYBEG_CLOSE(area, std::numbers::pi * wave.a_A * wave.a_B, 1e-4);
        }
    }
};

VYBEG_TEST(TestWavePattern)

}  // namespace test_wave_pattern

#include "test_wave_pattern.moc"
