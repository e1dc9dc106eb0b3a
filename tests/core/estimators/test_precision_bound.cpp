#include "core/estimators/wave/wave_formulas.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <Eigen/Dense>

#include <numbers>

namespace test_precision_bound {

using namespace vybeg;

namespace {

// The bound by brute force: derivatives of the samples of (6) by central differences, Fisher
// matrix, inverse.
std::array<double, 5> brute_force(const WaveState& state, double w, std::int64_t n) {
    const auto samples = [&](const std::array<double, 5>& p) {
        Eigen::VectorXd s(2 * n);
        for (std::int64_t j = 0; j < n; ++j) {
            const double tau =
                p[4] * (static_cast<double>(j) - 0.5 * static_cast<double>(n - 1)) - p[3];
            const double a = p[0] * std::cos(tau);
            const double b = p[1] * std::sin(tau);
            s[j] = a * std::cos(p[2]) - b * std::sin(p[2]);
            s[n + j] = a * std::sin(p[2]) + b * std::cos(p[2]);
        }
        return s;
    };
    const std::array<double, 5> at{state.a_A, state.a_B, state.two_theta_A, state.alpha, w};
    Eigen::MatrixXd jacobian(2 * n, 5);
    for (std::size_t k = 0; k < 5; ++k) {
        const double step = k == 4 ? 1e-4 / static_cast<double>(n) : 1e-4;
        auto up = at;
        auto down = at;
        up[k] += step;
        down[k] -= step;
        jacobian.col(static_cast<int>(k)) = (samples(up) - samples(down)) / (2 * step);
    }
    const Eigen::MatrixXd covariance = (jacobian.transpose() * jacobian).inverse();
    std::array<double, 5> sd{};
    for (std::size_t k = 0; k < 5; ++k) {
        sd[k] = std::sqrt(covariance(static_cast<int>(k), static_cast<int>(k)));
    }
    return sd;
}

}  // namespace

class TestPrecisionBound : public QObject {
    Q_OBJECT

private slots:
    void equalsTheInverseFisherMatrix() {
        for (const std::int64_t n : {5, 6, 22, 61}) {
            for (const double w : {0.7, 0.999, 1.9}) {
                if (static_cast<double>(n) * w < 2 * std::numbers::pi) {
                    continue;  // below one period nothing can be identified
                }
                for (const WaveState& state :
                     {WaveState{1, 0, 0.3, 0.4}, WaveState{2, 0.9, -1.2, 2},
                      WaveState{1, -0.6, 1.5, -3}}) {
                    const WaveErrors bound =
                        precision_bound(to_phasors(state), w / (2 * std::numbers::pi), 1, n, 0.01);
                    const auto expected = brute_force(state, w, n);
                    VYBEG_CLOSE_RATIO(bound.a_A, 0.01 * expected[0], 1e-6);
                    VYBEG_CLOSE_RATIO(bound.a_B, 0.01 * expected[1], 1e-6);
                    VYBEG_CLOSE_RATIO(bound.two_theta_A, 0.01 * expected[2], 1e-6);
                    VYBEG_CLOSE_RATIO(bound.alpha, 0.01 * expected[3], 1e-6);
                    VYBEG_CLOSE_RATIO(bound.f_hz, 0.01 * expected[4] / (2 * std::numbers::pi),
                                      1e-6);
                }
            }
        }
    }

    void isTheClosedFormOfTheMethodWhereTheResidualVanishes() {
        constexpr double rate = 33333;
        for (const std::int64_t n : {60, 600, 100000}) {
            const double f = 2 * std::round(5300 / rate * static_cast<double>(n) / 2) * rate /
                             static_cast<double>(n);
            for (const double a_B : {-0.8, 0.0, 0.5}) {
                const WaveState state{1.5, a_B, 0.8, -2};
                const double sigma = 0.02;
                const auto count = static_cast<double>(n);
                const WaveErrors bound = precision_bound(to_phasors(state), f, rate, n, sigma);
                const double power = 2.25 + a_B * a_B;
                const double amplitude = sigma * std::sqrt(2 / count);
                const double angle = amplitude * std::sqrt(power) / (2.25 - a_B * a_B);
                const double omega =
                    sigma * rate * std::sqrt(24 / (power * count * (count * count - 1)));
                // What the method drops falls with the window like 1/n.
                const double relative = 2 / count;
                VYBEG_CLOSE_RATIO(bound.a_A, amplitude, relative);
                VYBEG_CLOSE_RATIO(bound.a_B, amplitude, relative);
                VYBEG_CLOSE_RATIO(bound.two_theta_A, angle, relative);
                VYBEG_CLOSE_RATIO(bound.alpha, angle, relative);
                VYBEG_CLOSE_RATIO(bound.f_hz * 2 * std::numbers::pi, omega, relative);
            }
        }
    }
};

VYBEG_TEST(TestPrecisionBound)

}  // namespace test_precision_bound

#include "test_precision_bound.moc"
