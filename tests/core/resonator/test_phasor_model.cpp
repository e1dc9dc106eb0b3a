#include "core/resonator/model_fit.h"
#include "tests/core/resonator/simulated_phasors.h"

#include <QtTest>

#include <random>

using namespace vybeg;

namespace {

ScaledRun some_run() {
    FreeDecay decay;
    decay.seconds = 5;
    decay.rate_hz = 1000;
    decay.f0_hz = 200;
    decay.noise = 0.01;
    decay.tau_s = 4;
    decay.split_hz = 0.2;
    decay.omega_rad_s = 0.3;
    return scaled_run(test::simulated_phasors(decay, 100, 1), 2);
}

Own some_own() {
    Own own;
    own << 0.03, 0.004, 0.2, -0.3, 0.4, 0.1;
    return own;
}

Shared some_shared() {
    Shared shared = to_shared({0.1, -0.2, 0.03, 0.02, 0.3, 0.01, 0.25});
    shared[kappa_index] = 1.02;
    shared[power_index] = 0.05;
    return shared;
}

Eigen::VectorXd residuals_of(const ScaledRun& run, const Shared& shared, const Own& own) {
    Eigen::VectorXd r(static_cast<Eigen::Index>(4 * run.size()));
    residuals(run, shared, own, r.data(), nullptr, nullptr);
    return r;
}

}  // namespace

class TestPhasorModel : public QObject {
    Q_OBJECT

private slots:
    void theJacobianIsThatOfCentralDifferences();
    void theTruthLeavesTheNoise();
    void whatASpaceHoldsFixedStaysFixed();
    void theCovarianceOfALineOfParametersIsTheInverse();
};

void TestPhasorModel::theJacobianIsThatOfCentralDifferences() {
    const ScaledRun run = some_run();
    const Shared shared = some_shared();
    const Own own = some_own();
    const auto rows = static_cast<Eigen::Index>(4 * run.size());
    RowMajor by_shared(rows, shared_count);
    RowMajor by_own(rows, own_count);
    Eigen::VectorXd r(rows);
    residuals(run, shared, own, r.data(), by_shared.data(), by_own.data());
    QVERIFY((r - residuals_of(run, shared, own)).norm() < 1e-12 * r.norm());
    constexpr double step = 1e-5;
    for (int k = 0; k < shared_count; ++k) {
        const Shared by = Shared::Unit(k) * step;
        const Eigen::VectorXd difference =
            (residuals_of(run, shared + by, own) - residuals_of(run, shared - by, own)) /
            (2 * step);
        QVERIFY2((difference - by_shared.col(k)).norm() < 1e-7 * difference.norm(),
                 qPrintable(QString::number(k)));
    }
    for (int k = 0; k < own_count; ++k) {
        const Own by = Own::Unit(k) * step;
        const Eigen::VectorXd difference =
            (residuals_of(run, shared, own + by) - residuals_of(run, shared, own - by)) /
            (2 * step);
        QVERIFY2((difference - by_own.col(k)).norm() < 1e-7 * difference.norm(),
                 qPrintable(QString::number(k)));
    }
}

void TestPhasorModel::theTruthLeavesTheNoise() {
    FreeDecay decay;
    decay.seconds = 20;
    decay.rate_hz = 1000;
    decay.f0_hz = 200;
    decay.noise = 1e-3;
    decay.tau_s = 4;
    decay.split_hz = 1.2;
    decay.theta_w = 0.1;
    decay.omega_rad_s = 0.3;
    decay.kappa = 1.1;
    const PhasorRun run = test::simulated_phasors(decay, 10, 1);
    const std::vector runs{scaled_run(run, 1)};
    Shared shared = to_shared({.split_cos_hz = 1.2 * std::cos(0.4),
                               .split_sin_hz = 1.2 * std::sin(0.4),
                               .rotation_per_s = 2 * 0.277 * 0.3,
                               .decay_per_s = 0.25});
    shared[kappa_index] = 1.1;
    const Eigen::Vector2cd y =
        SlowDynamics(rates_of(shared)).window_mean(run.window_s, 0) * SlowMotion(decay).at_frame(0);
    Own own = Own::Zero();
    own.segment<4>(start_index) << y[0].real(), y[0].imag(), y[1].real(), y[1].imag();
    const double residuals = 4.0 * static_cast<double>(runs[0].size());
    const double chi2 = chi_square(runs, {shared, {own}});
    QVERIFY2(std::abs(chi2 / residuals - 1) < 4 * std::sqrt(2 / residuals),
             qPrintable(QString::number(chi2 / residuals)));
}

void TestPhasorModel::whatASpaceHoldsFixedStaysFixed() {
    const std::vector runs{some_run()};
    const FitState start{some_shared(), {some_own()}};
    const Result<ModelFit> fit = fit_model(runs, space_of({4, 6}, false), start, {});
    QVERIFY(bool(fit));
    QVERIFY(fit->converged);
    for (int k = 0; k < shared_count; ++k) {
        QCOMPARE(fit->state.shared[k] == start.shared[k], k != 4 && k != 6);
    }
    QCOMPARE(fit->state.runs[0][drift_index], start.runs[0][drift_index]);
    QVERIFY(fit->chi2 < chi_square(runs, start));
    const Eigen::MatrixXd spread = covariance(runs, space_of({4, 6}, false), fit->state);
    QCOMPARE(spread(0, 0), 0.0);
    QVERIFY(spread(4, 4) > 0);
}

void TestPhasorModel::theCovarianceOfALineOfParametersIsTheInverse() {
    const std::vector runs{some_run()};
    const FitState state{some_shared(), {some_own()}};
    const ModelSpace space = space_of({0, 1, 2, 3, 4, 6}, true);
    const Eigen::MatrixXd spread = covariance(runs, space, state);
    // C H C = C on the space, in units of what each coordinate knows alone.
    const Eigen::MatrixXd information = normal_equations(runs, state).information;
    const Eigen::MatrixXd again = spread * information * spread;
    QVERIFY((again - spread).norm() < 1e-6 * spread.norm());
}

QTEST_GUILESS_MAIN(TestPhasorModel)
#include "test_phasor_model.moc"
