// Standard uncertainties of the resonator's fit against the Cramer-Rao bound at the truth, with the
// same priors (FIT section 7): the information of window phasors by central differences of the
// simulator's motion, which shares no formula with the fit.
//
// Statistical model: u depends on the data only through the point at which the fit linearises, so
// that u over the bound scatters by a few per cent about 1; its median over two hundred sets lies
// within 5 % of it for every quantity.
#include "tests/closeness.h"
#include "tests/statistical/each_seed.h"
#include "tests/statistical/random_sets.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <Eigen/Cholesky>

#include <algorithm>
#include <map>
#include <mutex>
#include <string>

namespace test_resonator_bound {

using namespace vybeg;
using namespace vybeg::test;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

namespace {

// The resonator's parameters, then each run's start, frequency and drift.
enum Shared : int { decay_at, split_c, split_s, g_c, g_s, rate_at, kappa_at, shared_parameters };
enum Own : int { a_A_at, a_B_at, two_theta_at, alpha_at, f_at, drift_at, own_parameters };

struct Truth {
    const RandomSet* set = nullptr;
    std::size_t run = 0;
    std::int64_t window = 0;
    VectorXd shared = VectorXd(int{shared_parameters});
    VectorXd own = VectorXd(int{own_parameters});
};

Truth truth_of(const RandomSet& set, std::size_t run) {
    const FreeDecay& decay = set.each[run];
    const double w = 4 * decay.theta_w;
    const double t = 4 * decay.theta_tau;
    const double g = decay.damping_anisotropy_per_s;
    Truth truth{&set, run};
    truth.window = std::llround(set.runs[run].window_s * decay.rate_hz);
    truth.shared << 1 / decay.tau_s, decay.split_hz * std::cos(w), decay.split_hz * std::sin(w),
        g * std::cos(t), g * std::sin(t), -decay.bryan * decay.omega_rad_s, decay.kappa;
    truth.own << decay.a_A, decay.a_B, decay.two_theta_A, decay.alpha, set.f_offset_hz[run], 0;
    return truth;
}

// Real and imaginary parts of the windows' phasors without noise, over their deviation.
VectorXd phasors(const Truth& at) {
    FreeDecay decay = at.set->resonator;
    decay.noise = 0;
    decay.tau_s = 1 / at.shared[decay_at];
    decay.split_hz = std::hypot(at.shared[split_c], at.shared[split_s]);
    decay.theta_w = std::atan2(at.shared[split_s], at.shared[split_c]) / 4;
    decay.damping_anisotropy_per_s = std::hypot(at.shared[g_c], at.shared[g_s]);
    decay.theta_tau = std::atan2(at.shared[g_s], at.shared[g_c]) / 4;
    decay.omega_rad_s = -at.shared[rate_at] / decay.bryan;
    decay.kappa = at.shared[kappa_at];
    decay.a_A = at.own[a_A_at];
    decay.a_B = at.own[a_B_at];
    decay.two_theta_A = at.own[two_theta_at];
    decay.alpha = at.own[alpha_at];
    PhasorRun run = simulated_phasors(decay, at.window, 1, at.own[f_at]);
    shift(run, 0, at.own[drift_at]);
    const double sd = at.set->runs[at.run].sd.front();
    VectorXd numbers(4 * std::ssize(run.c));
    for (std::size_t k = 0; k < run.c.size(); ++k) {
        numbers.segment<4>(4 * static_cast<Index>(k)) << run.c[k].real() / sd, run.c[k].imag() / sd,
            run.d[k].real() / sd, run.d[k].imag() / sd;
    }
    return numbers;
}

// Columns: the shared parameters, the own ones.
MatrixXd derivatives(const Truth& truth) {
    const double seconds = truth.set->resonator.seconds;
    VectorXd shared_step = VectorXd::Constant(int{shared_parameters}, 1e-5 / seconds);
    shared_step[kappa_at] = 1e-6;
    VectorXd own_step = VectorXd::Constant(int{own_parameters}, 1e-6);
    own_step[f_at] = 1e-6 / seconds;
    own_step[drift_at] = 1e-6 / (seconds * seconds);
    std::vector<VectorXd> columns;
    const auto add = [&](VectorXd Truth::*part, Index k, double step) {
        Truth up = truth;
        Truth down = truth;
        (up.*part)[k] += step;
        (down.*part)[k] -= step;
        columns.push_back((phasors(up) - phasors(down)) / (2 * step));
    };
    for (Index k = 0; k < shared_parameters; ++k) {
        add(&Truth::shared, k, shared_step[k]);
    }
    for (Index k = 0; k < own_parameters; ++k) {
        add(&Truth::own, k, own_step[k]);
    }
    MatrixXd by(columns[0].size(), std::ssize(columns));
    for (std::size_t k = 0; k < columns.size(); ++k) {
        by.col(static_cast<Index>(k)) = columns[k];
    }
    return by;
}

// Bounds of the deviations of the reported quantities.
std::map<std::string, double> bounds(const RandomSet& set) {
    const FreeDecay& gyro = set.resonator;
    const auto runs = std::ssize(set.runs);
    const Index size = shared_parameters + runs * own_parameters;
    MatrixXd precision = MatrixXd::Zero(size, size);
    VectorXd f_mean = VectorXd::Zero(size);
    const auto prior = [&](Index k, double sd) { precision(k, k) += 1 / (sd * sd); };
    prior(split_c, 3);
    prior(split_s, 3);
    prior(g_c, 1 / gyro.tau_s);
    prior(g_s, 1 / gyro.tau_s);
    prior(rate_at, 1.5);
    prior(kappa_at, 0.01);
    for (Index run = 0; run < runs; ++run) {
        const auto k = static_cast<std::size_t>(run);
        const MatrixXd by = derivatives(truth_of(set, k));
        const MatrixXd square = by.transpose() * by;
        const Index first = shared_parameters + run * own_parameters;
        constexpr Index s = shared_parameters;
        constexpr Index o = own_parameters;
        precision.topLeftCorner(s, s) += square.topLeftCorner(s, s);
        precision.block(first, 0, o, s) += square.bottomLeftCorner(o, s);
        precision.block(0, first, s, o) += square.topRightCorner(s, o);
        precision.block(first, first, o, o) += square.bottomRightCorner(o, o);
        const PhasorRun& measured = set.runs[k];
        prior(first + drift_at, 0.1 / (measured.time_s.back() + measured.window_s / 2));
        // The run's frequency is that at its mean instant by power.
        double power = 0;
        double moment = 0;
        for (std::size_t j = 0; j < measured.c.size(); ++j) {
            const double here = std::norm(measured.c[j]) + std::norm(measured.d[j]);
            power += here;
            moment += here * measured.time_s[j];
        }
        f_mean[first + f_at] = 1 / static_cast<double>(runs);
        f_mean[first + drift_at] = moment / power / static_cast<double>(runs);
    }
    const VectorXd unit = precision.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::LLT<MatrixXd> factor(unit.asDiagonal() * precision * unit.asDiagonal());
    const auto bound = [&](const VectorXd& gradient) {
        const VectorXd scaled = unit.cwiseProduct(gradient);
        return std::sqrt(scaled.dot(factor.solve(scaled)));
    };
    const auto vector = [&](Index c, double angle, bool along) {
        VectorXd gradient = VectorXd::Zero(size);
        gradient[c] = along ? std::cos(angle) : -std::sin(angle);
        gradient[c + 1] = along ? std::sin(angle) : std::cos(angle);
        return gradient;
    };
    const auto one = [&](Index k) { return VectorXd(VectorXd::Unit(size, k)); };
    const double w = 4 * gyro.theta_w;
    const double t = 4 * gyro.theta_tau;
    return {{"f_mean", bound(f_mean)},
            {"split", bound(vector(split_c, w, true))},
            {"theta_w", bound(vector(split_c, w, false)) / (4 * gyro.split_hz)},
            {"decay", bound(one(decay_at))},
            {"g", bound(vector(g_c, t, true))},
            {"theta_tau", bound(vector(g_c, t, false)) / (4 * gyro.damping_anisotropy_per_s)},
            {"rate", bound(one(rate_at))},
            {"kappa", bound(one(kappa_at))}};
}

}  // namespace

class TestResonatorBound : public QObject {
    Q_OBJECT

private slots:
    void uncertainties_are_those_of_the_bound() {
        constexpr int sets = 200;
        std::map<std::string, std::vector<double>> ratios;
        std::mutex mutex;
        for_each_seed(sets, [&](int seed) {
            const RandomSet set = random_set(static_cast<std::uint64_t>(seed) + 1);
            const Result<ResonatorFit> fit = fit_resonator(set.runs, {}, {});
            if (!fit || fit->model != ResonatorModel::structured || !fit->noise.white()) {
                return;
            }
            const std::map<std::string, double> bound = bounds(set);
            const ResonatorEstimate& found = fit->resonator;
            const double tau = found.tau_s.value;
            const std::map<std::string, std::pair<const Estimate*, double>> estimates{
                {"f_mean", {&found.f_mean_hz, 1}},
                {"split", {&found.split_hz, 1}},
                {"theta_w", {&found.theta_w_rad, 1}},
                {"decay", {&found.tau_s, 1 / (tau * tau)}},
                {"g", {&found.damping_anisotropy_per_s, 1}},
                {"theta_tau", {&found.theta_tau_rad, 1}},
                {"rate", {&found.angle_rate_rad_s, 1}},
                {"kappa", {&found.kappa, 1}}};
            const std::lock_guard lock(mutex);
            for (const auto& [name, estimate] : estimates) {
                if (estimate.first->given()) {
                    ratios[name].push_back(estimate.first->uncertainty() * estimate.second /
                                           bound.at(name));
                }
            }
        });
        QCOMPARE(ratios.size(), std::size_t{8});
        for (auto& [name, all] : ratios) {
            std::ranges::sort(all);
            const auto quantile = [&all](double share) {
                return all[static_cast<std::size_t>(share * static_cast<double>(all.size() - 1))];
            };
            const QString text = QString("%1: %2 sets, u over the bound %3, 5..95 %: %4..%5")
                                     .arg(name.c_str())
                                     .arg(all.size())
                                     .arg(quantile(0.5))
                                     .arg(quantile(0.05))
                                     .arg(quantile(0.95));
            qInfo("%s", qPrintable(text));
            VYBEG_MORE(all.size(), sets / 3, qPrintable(text));
            VYBEG_CLOSE(quantile(0.5), 1, 0.05, qPrintable(text));
        }
    }
};

VYBEG_TEST(TestResonatorBound, first)

}  // namespace test_resonator_bound

#include "test_resonator_bound.moc"
