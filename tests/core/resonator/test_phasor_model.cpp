#include "core/resonator/fit/map_fit.h"
#include "core/resonator/fit/posterior.h"
#include "tests/closeness.h"
#include "tests/core/resonator/simulated_phasors.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <array>
#include <cmath>

namespace test_phasor_model {

using namespace vybeg;

namespace {

ScaledRun some_run() {
    const FreeDecay decay{.seconds = 5,
                          .rate_hz = 1000,
                          .f0_hz = 200,
                          .split_hz = 0.2,
                          .tau_s = 4,
                          .omega_rad_s = 0.3,
                          .noise = 0.01};
    PhasorRun run = test::simulated_phasors(decay, 100, 1);
    run.breaks = {{1.1, BreakKind::start}, {1.7}, {2.5, BreakKind::gain}, {3.3}};
    return scaled_run(run, 2);
}

Eigen::VectorXd some_own() {
    Eigen::VectorXd own(own_count + 8);
    own << 0.2, -0.3, 0.4, 0.1, 0.03, 0.004, 0.1, 0.05, -0.2, 0.07, 0.2, 0.1, -0.15, -0.4;
    return own;
}

Eigen::VectorXd some_shared(double cubic) {
    Eigen::VectorXd shared(int{shared_count});
    shared << 0.1, -0.2, 0.03, 0.02, 0.3, 0.01, 0.25, 1.02, 0.01, 0.02, 0.005, 0.03, 0.04, cubic;
    return shared;
}

Eigen::VectorXd residuals_of(const ScaledRun& run, const Eigen::VectorXd& shared,
                             const Eigen::VectorXd& own) {
    return linearised(run, shared, own, run.size()).residual;
}

}  // namespace

class TestPhasorModel : public QObject {
    Q_OBJECT

private slots:
    void the_derivatives_are_those_of_central_differences_data() {
        QTest::addColumn<double>("cubic");
        QTest::addColumn<double>("two_theta_zero");
        QTest::addColumn<double>("drift");
        QTest::newRow("linear") << 0.0 << 0.0 << 0.0;
        QTest::newRow("cubic spring") << 0.3 << 0.0 << 0.0;
        QTest::newRow("turned channels") << 0.0 << 0.7 << 0.0;
        QTest::newRow("drifting") << 0.0 << 0.7 << 0.004;
    }

    void the_derivatives_are_those_of_central_differences() {
        QFETCH(double, cubic);
        QFETCH(double, two_theta_zero);
        QFETCH(double, drift);
        ScaledRun run = some_run();
        run.two_theta_zero = two_theta_zero;
        const Eigen::VectorXd shared = some_shared(cubic);
        Eigen::VectorXd own = some_own();
        own[drift_at] = drift;
        const Linearised at = linearised(run, shared, own, run.size());
        constexpr double step = 1e-5;
        for (Eigen::Index k = 0; k < shared.size() + own.size(); ++k) {
            const bool is_shared = k < shared.size();
            const Eigen::VectorXd by_shared =
                is_shared ? Eigen::VectorXd(Eigen::VectorXd::Unit(shared.size(), k) * step)
                          : Eigen::VectorXd(Eigen::VectorXd::Zero(shared.size()));
            const Eigen::VectorXd by_own =
                is_shared
                    ? Eigen::VectorXd(Eigen::VectorXd::Zero(own.size()))
                    : Eigen::VectorXd(Eigen::VectorXd::Unit(own.size(), k - shared.size()) * step);
            // Residuals are measured less expected.
            const Eigen::VectorXd difference =
                (residuals_of(run, shared - by_shared, own - by_own) -
                 residuals_of(run, shared + by_shared, own + by_own)) /
                (2 * step);
            const double off = (difference - at.by_parameter.col(k)).norm() / difference.norm();
            // The derivatives leave out what a drift changes in the mean over a window.
            const bool with_drift = drift != 0 || k == shared.size() + int{drift_at};
            VYBEG_LESS(off, with_drift ? 1e-3 : 1e-7, qPrintable(QString::number(k)));
        }
    }

    void expected_phasors_and_residuals_are_of_one_model() {
        ScaledRun run = some_run();
        run.two_theta_zero = 0.4;
        for (const double cubic : {0.0, 0.3}) {
            const Eigen::VectorXd shared = some_shared(cubic);
            const double one = residuals_of(run, shared, some_own()).squaredNorm();
            const double other = chi_square(run, shared, some_own(), run.size());
            VYBEG_CLOSE_RATIO(one, other, (cubic == 0 ? 1e-4 : 1e-12));
        }
    }

    void the_truth_leaves_the_noise() {
        const FreeDecay decay{.seconds = 20,
                              .rate_hz = 1000,
                              .f0_hz = 200,
                              .split_hz = 1.2,
                              .theta_w = 0.1,
                              .tau_s = 4,
                              .omega_rad_s = 0.3,
                              .noise = 1e-3,
                              .kappa = 1.1};
        const PhasorRun run = test::simulated_phasors(decay, 10, 1);
        const ScaledRun scaled = scaled_run(run, 1);
        Eigen::VectorXd shared = Eigen::VectorXd::Zero(int{shared_count});
        shared[split_cos_at] = 1.2 * std::cos(0.4);
        shared[split_sin_at] = 1.2 * std::sin(0.4);
        shared[rotation_at] = 2 * 0.277 * 0.3;
        shared[decay_at] = 0.25;
        shared[kappa_at] = 1.1;
        const Eigen::Vector2cd y =
            SlowDynamics(shared).window_mean(run.window_s, 0) * SlowMotion(decay).at_frame(0);
        Eigen::VectorXd own = Eigen::VectorXd::Zero(int{own_count});
        own.head<4>() << y[0].real(), y[0].imag(), y[1].real(), y[1].imag();
        const double residuals = 4.0 * static_cast<double>(scaled.size());
        const double chi2 = chi_square(scaled, shared, own, scaled.size());
        VYBEG_CLOSE_RATIO(chi2, residuals, 4 * std::sqrt(2 / residuals));
    }

    // A window's mean loses more of the mode whose frequency the drift takes away from the carrier.
    // The third order, of a turn of half a radian, leaves 1e-6.
    void means_over_windows_of_a_drifting_motion_are_expected() {
        using std::numbers::pi;
        ScaledRun run = some_run();
        run.breaks.clear();
        for (const double split_hz : {0.02, 0.11, 0.7}) {
            for (const double drift : {-0.003, 0.0003, 0.02}) {
                Eigen::VectorXd shared = some_shared(0);
                shared.segment(kappa_at, cubic_at - kappa_at).setZero();
                shared[kappa_at] = 1;
                shared[split_cos_at] = split_hz * std::cos(0.8);
                shared[split_sin_at] = split_hz * std::sin(0.8);
                Eigen::VectorXd own = some_own().head(int{own_count});
                own[drift_at] = drift;
                const SlowDynamics dynamics(shared);
                const auto mean_at = [&](double t) {
                    constexpr int parts = 2000;
                    Eigen::Vector2cd sum = Eigen::Vector2cd::Zero();
                    for (int k = 0; k < parts; ++k) {
                        const double at = t + ((k + 0.5) / parts - 0.5) * run.window_s;
                        const double u = at - run.reference_s;
                        const double turns = u * (own[frequency_at] + drift * u / 2);
                        sum += std::polar(1.0 / parts, 2 * pi * turns) *
                               (dynamics.propagator(at) * of_real_parts(own.head<4>()));
                    }
                    return sum;
                };
                // The mean at the run's own frequency belongs to the start.
                Eigen::VectorXd averaged = own;
                const Eigen::Vector2cd start =
                    dynamics.window_mean(run.window_s, own[frequency_at]) *
                    of_real_parts(own.head<4>());
                averaged.head<4>() << start[0].real(), start[0].imag(), start[1].real(),
                    start[1].imag();
                const auto expected = expected_phasors(run, shared, averaged, run.size());
                // A phase of its own, the same in all windows: half the drift times w^2/12.
                const auto phase = std::polar(1.0, pi * drift * run.window_s * run.window_s / 12);
                for (std::size_t k = 0; k < run.size(); ++k) {
                    const double off = (phase * expected[k] - mean_at(run.time_s[k])).norm();
                    VYBEG_LESS(off, 1e-6 * start.norm(),
                               qPrintable(QString("split %1, drift %2, window %3")
                                              .arg(split_hz)
                                              .arg(drift)
                                              .arg(k)));
                }
            }
        }
    }

    // From window to window the motion and the carrier are products.
    void each_window_is_that_of_its_instant() {
        ScaledRun run = some_run();
        run.breaks.clear();
        run.step_s = run.window_s = 0.01;
        run.time_s.clear();
        for (int k = 0; k < 400; ++k) {
            run.time_s.push_back(0.01 * (k < 150 ? k : k + 7) + 0.005);
        }
        const Eigen::VectorXd shared = some_shared(0);
        Eigen::VectorXd own = some_own().head(own_count);
        own[frequency_at] = 3;
        own[drift_at] = 0.2;
        const std::vector<Eigen::Vector2cd> all =
            expected_phasors(run, shared, own, run.time_s.size());
        for (std::size_t k = 0; k < all.size(); ++k) {
            ScaledRun one = run;
            one.time_s = {run.time_s[k]};
            const Eigen::Vector2cd alone = expected_phasors(one, shared, own, 1)[0];
            VYBEG_LESS((all[k] - alone).norm() / alone.norm(), 1e-12,
                       qPrintable(QString::number(k)));
        }
    }

    void chi_square_ends_above_its_bound() {
        const ScaledRun run = some_run();
        const Eigen::VectorXd shared = some_shared(0);
        const Eigen::VectorXd own = some_own();
        const double all = chi_square(run, shared, own, run.size());
        QCOMPARE(chi_square(run, shared, own, run.size(), 2 * all), all);
        const double part = chi_square(run, shared, own, run.size(), all / 4);
        QVERIFY(part > all / 4);
        QVERIFY(part < all);
        QCOMPARE(residual_of(run, shared, own, run.size()).squaredNorm(), all);
    }

    void a_prior_of_no_width_holds_its_parameter() {
        const std::vector runs{some_run()};
        const std::array<std::size_t, 1> breaks{8};
        FitProblem problem{runs, ParameterLayout(breaks), {}};
        problem.priors = structured_priors(runs, problem.layout, {});
        Eigen::VectorXd start(problem.layout.size());
        start << some_shared(0), some_own();
        start[kappa_at] = 1;
        start.segment<5>(skew_at).setZero();
        const MapFit fit = minimise(problem, start, 100, {});
        QVERIFY(fit.converged);
        for (Eigen::Index k = 0; k < start.size(); ++k) {
            QCOMPARE(fit.p[k] == start[k], problem.priors.sd[k] == 0);
        }
        VYBEG_LESS(fit.chi2,
                   chi_square(runs[0], start.head(int{shared_count}), some_own(), runs[0].size()));
    }

    void the_three_parts_of_the_covariance_add_up() {
        const std::vector runs{some_run()};
        const std::array<std::size_t, 1> breaks{8};
        FitProblem problem{runs, ParameterLayout(breaks), {}};
        problem.priors = structured_priors(runs, problem.layout, ChannelTolerance{0.01, 0.01});
        Eigen::VectorXd start(problem.layout.size());
        start << some_shared(0), some_own();
        start[kappa_at] = 1;
        start.segment<5>(skew_at).setZero();
        const Posterior at = posterior(problem, minimise(problem, start, 100, {}));
        const Eigen::MatrixXd sum = at.covariance_of(0, at.root.rows());
        const double off = (sum - at.covariance).norm() / at.covariance.norm();
        VYBEG_LESS(off, 1e-8);
    }
};

VYBEG_TEST(TestPhasorModel)

}  // namespace test_phasor_model

#include "test_phasor_model.moc"
