#include "core/resonator/results/resonator_parameters.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

namespace test_parameter_limit {

using namespace vybeg;

namespace {

Estimate estimate(double value, double sd, double u = std::nan("")) {
    Estimate made;
    made.value = value;
    made.sd = sd;
    made.u = u;
    return made;
}

}  // namespace

class TestParameterLimit : public QObject {
    Q_OBJECT

private slots:
    void the_whole_interval_decides() {
        const ParameterLimit most{"split_hz", std::nullopt, 10.0};
        QCOMPARE(conformity(estimate(7.9, 1), most), Conformity::within);
        QCOMPARE(conformity(estimate(8, 1), most), Conformity::within);  // ends included
        QCOMPARE(conformity(estimate(8.1, 1), most), Conformity::unknown);
        QCOMPARE(conformity(estimate(11.9, 1), most), Conformity::unknown);
        QCOMPARE(conformity(estimate(12.1, 1), most), Conformity::outside);
        const ParameterLimit least{"q", 10.0, std::nullopt};
        QCOMPARE(conformity(estimate(12, 1), least), Conformity::within);
        QCOMPARE(conformity(estimate(10, 1), least), Conformity::unknown);
        QCOMPARE(conformity(estimate(7.9, 1), least), Conformity::outside);
        const ParameterLimit both{"delay_s", -1.0, 1.0};
        QCOMPARE(conformity(estimate(0, 0.4), both), Conformity::within);
        QCOMPARE(conformity(estimate(0, 0.6), both), Conformity::unknown);
        QCOMPARE(conformity(estimate(-3, 0.6), both), Conformity::outside);
    }

    void tolerances_of_the_channels_count() {
        const ParameterLimit most{"split_hz", std::nullopt, 10.0};
        QCOMPARE(conformity(estimate(7, 0.1, 1.4), most), Conformity::within);
        QCOMPARE(conformity(estimate(7, 0.1, 1.6), most), Conformity::unknown);
    }

    void no_value_or_no_uncertainty_is_unknown() {
        const ParameterLimit most{"split_hz", std::nullopt, 10.0};
        QCOMPARE(conformity(Estimate(), most), Conformity::unknown);
        QCOMPARE(conformity(estimate(1, std::nan("")), most), Conformity::unknown);
        Estimate refused = estimate(1, 0.1);
        refused.reason.code = ReasonCode::within_noise;
        QCOMPARE(conformity(refused, most), Conformity::unknown);
    }

    void a_difference_within_its_noise_has_a_greatest_value() {
        const Estimate refused{.reason = {ReasonCode::within_noise, {number_arg(1.31e-5, 3)}}};
        const auto judged = [&](std::optional<double> lower, std::optional<double> upper) {
            return conformity(refused, {"split_hz", lower, upper});
        };
        QCOMPARE(judged({}, 0.01), Conformity::within);
        QCOMPARE(judged(0.0, 0.01), Conformity::within);
        QCOMPARE(judged({}, 1e-5), Conformity::unknown);
        QCOMPARE(judged(1e-6, 0.01), Conformity::unknown);
        QCOMPARE(judged(1e-3, 0.01), Conformity::outside);
    }

    // A parameter at its limit is called within, or outside, in one of 44 measurements (2.3 %).
    void a_parameter_at_its_limit_is_seldom_decided() {
        std::mt19937_64 random(1);
        std::normal_distribution<double> noise;
        const ParameterLimit most{"split_hz", std::nullopt, 10.0};
        int within = 0;
        int outside = 0;
        constexpr int measurements = 20000;
        for (int k = 0; k < measurements; ++k) {
            const Conformity found = conformity(estimate(10 + noise(random), 1), most);
            within += found == Conformity::within ? 1 : 0;
            outside += found == Conformity::outside ? 1 : 0;
        }
        const double expected = measurements * 0.02275;
        VYBEG_CLOSE(within, expected, 4 * std::sqrt(expected));
        VYBEG_CLOSE(outside, expected, 4 * std::sqrt(expected));
    }

    void axes_have_no_limits() {
        const auto limited = limited_parameters();
        QCOMPARE(limited.size(), resonator_parameters.size() - 2);
        QVERIFY(std::ranges::none_of(limited, [](const auto& each) {
            return std::string(each.name) == "theta_w_rad" ||
                   std::string(each.name) == "theta_tau_rad";
        }));
    }
};

VYBEG_TEST(TestParameterLimit)

}  // namespace test_parameter_limit

#include "test_parameter_limit.moc"
