#include "core/resonator/results/resonator_fit.h"
#include "core/resonator/runs/run_track.h"
#include "tests/closeness.h"
#include "tests/core/resonator/simulated_phasors.h"
#include "tests/needed.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <cmath>

namespace test_channel_balance {

using namespace vybeg;
using namespace vybeg::test;

namespace {

FreeDecay turning() {
    FreeDecay decay{.tau_s = 100};
    decay.omega_rad_s = 0.3;  // 2 theta_A turns through 266 degrees
    decay.noise = 1e-3;
    return decay;
}

double mean_square(const ChannelBalance& balance) {
    double sum = 0;
    for (std::size_t k = 0; k < balance.sd.size(); ++k) {
        sum += std::pow(balance.orthogonality[k] / balance.sd[k], 2);
    }
    return sum / static_cast<double>(balance.sd.size());
}

ChannelBalance balance_of(const PhasorRun& run) {
    FitOptions options{.model = FitOptions::Model::structured};
    options.tolerance[kappa_error] = 0;
    return channel_balance(run, needed(fit_resonator({&run, 1}, options, {})).motion, 0, 100);
}

}  // namespace

class TestChannelBalance : public QObject {
    Q_OBJECT

private slots:
    void balanced_channels_meet_the_condition() {
        const ChannelBalance balance = balance_of(simulated_phasors(turning(), 500, 1));
        QCOMPARE(balance.time_s.size(), std::size_t{100});
        // The mean of a hundred squares has a deviation of 0.14.
        const double square = mean_square(balance);
        VYBEG_CLOSE(square, 1, 0.6);
    }

    void a_gain_that_changes_on_the_way_breaks_it() {
        // A constant one would not: to the fit it is the gain ratio, or a damping anisotropy. A
        // step would not either: the fit finds it.
        PhasorRun run = simulated_phasors(turning(), 500, 2);
        for (std::size_t k = 0; k < run.d.size(); ++k) {
            run.d[k] *= 1 + 0.01 * std::sin(20 * static_cast<double>(k) /
                                            static_cast<double>(run.d.size()));
        }
        const double square = mean_square(balance_of(run));
        VYBEG_MORE(square, 100);
    }
};

VYBEG_TEST(TestChannelBalance)

}  // namespace test_channel_balance

#include "test_channel_balance.moc"
