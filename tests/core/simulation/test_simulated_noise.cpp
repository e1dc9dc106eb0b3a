// What the simulator adds to the motion: noise, gain ratio, offsets, quantiser.
//
// Statistical model: n independent Gaussian numbers of variance s^2 have a mean of sd s/sqrt(n), a
// mean square of sd s^2 sqrt(2/n), and a correlation of sd 1/sqrt(n) with any other such row.
#include "core/simulation/free_decay.h"
#include "core/simulation/simulate.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace test_simulated_noise {

using namespace vybeg;

namespace {

FreeDecay short_decay() {
    FreeDecay decay{.seconds = 6};
    return decay;
}

std::vector<double> difference(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> result(a.size());
    std::ranges::transform(a, b, result.begin(), std::minus{});
    return result;
}

double mean_product(std::span<const double> a, std::span<const double> b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0) / static_cast<double>(a.size());
}

}  // namespace

class TestSimulatedNoise : public QObject {
    Q_OBJECT

private slots:
    void noise_is_white_gaussian_and_independent_in_the_channels() {
        FreeDecay decay = short_decay();
        const auto clean = simulate(decay, {});
        const double sigma = 0.02;
        decay.noise = sigma;
        decay.seed = 20200320;
        const auto noisy = simulate(decay, {});
        QVERIFY(clean && noisy);
        const std::vector<double> c = difference(noisy->c, clean->c);
        const std::vector<double> d = difference(noisy->d, clean->d);
        const auto n = static_cast<double>(c.size());
        const double variance = sigma * sigma;
        for (const auto& channel : {c, d}) {
            const double mean = std::accumulate(channel.begin(), channel.end(), 0.0) / n;
            VYBEG_CLOSE(mean, 0, 4 * sigma / std::sqrt(n));
            VYBEG_CLOSE(mean_product(channel, channel), variance, 4 * variance * std::sqrt(2 / n));
            // White: no correlation with the neighbours.
            const std::span all(channel);
            for (const std::size_t lag : {1U, 2U, 6U}) {
                VYBEG_CLOSE(mean_product(all.first(all.size() - lag), all.subspan(lag)), 0,
                            4 * variance / std::sqrt(n));
            }
            // Gaussian: 31.731 % lie outside one sigma, 4.550 % outside two, 0.26998 % outside 3.
            for (const auto& [bound, share] :
                 {std::pair{1.0, 0.317310508}, std::pair{2.0, 0.0455002639},
                  std::pair{3.0, 0.00269979606}}) {
                const auto outside = std::ranges::count_if(
                    channel, [&](double x) { return std::abs(x) > bound * sigma; });
                VYBEG_CLOSE(static_cast<double>(outside), n * share,
                            4 * std::sqrt(n * share * (1 - share)));
            }
        }
        VYBEG_CLOSE(mean_product(c, d), 0, 4 * variance / std::sqrt(n));
    }

    void a_seed_gives_the_same_samples_on_every_machine() {
        FreeDecay decay = demo_decay();
        decay.seconds = 0.1;
        const auto samples = simulate(decay, {});
        QVERIFY(samples);
        QCOMPARE(samples->c.size(), std::size_t{3333});
        // Written down once; the last digits belong to the machine's sin and log.
        VYBEG_CLOSE(samples->c[0], 0.87988377632450288, 1e-14);
        VYBEG_CLOSE(samples->d[0], 0.27180530353381038, 1e-14);
        VYBEG_CLOSE(samples->c[1000], 0.88319061868251414, 1e-12);
        VYBEG_CLOSE(samples->d[3332], -0.039627375572655742, 1e-12);
    }

    void the_same_seed_repeats_itself_and_another_does_not() {
        FreeDecay decay = short_decay();
        decay.noise = 1e-3;
        const auto first = simulate(decay, {});
        const auto again = simulate(decay, {});
        decay.seed = 2;
        const auto other = simulate(decay, {});
        QVERIFY(first && again && other);
        QVERIFY(first->c == again->c && first->d == again->d);
        const std::vector<double> gap = difference(first->c, other->c);
        // Two independent noises differ by sqrt(2) sigma.
        const auto n = static_cast<double>(gap.size());
        VYBEG_CLOSE(mean_product(gap, gap), 2e-6, 4 * 2e-6 * std::sqrt(2 / n));
    }

    void gain_ratio_and_offsets_act_before_the_noise() {
        FreeDecay decay = short_decay();
        decay.noise = 1e-3;
        const auto plain = simulate(decay, {});
        decay.kappa = 1.25;
        decay.offset_c = 0.5;
        decay.offset_d = -0.75;
        const auto changed = simulate(decay, {});
        decay.noise = 0;
        const auto silent = simulate(decay, {});
        QVERIFY(plain && changed && silent);
        decay = short_decay();
        const auto motion = simulate(decay, {});
        QVERIFY(motion);
        for (std::size_t k = 0; k < plain->c.size(); ++k) {
            VYBEG_CLOSE(silent->c[k], motion->c[k] + 0.5, 1e-15);
            VYBEG_CLOSE(silent->d[k], motion->d[k] / 1.25 - 0.75, 1e-15);
            // The noise is the receiver's: neither kappa nor offset touch it.
            VYBEG_CLOSE(changed->d[k] - silent->d[k], plain->d[k] - motion->d[k], 1e-15);
        }
    }

    void the_quantiser_rounds_to_its_steps_data() {
        QTest::addColumn<int>("bits");
        for (const int bits : {2, 8, 12, 16, 24, 32}) {
            QTest::addRow("%d bits", bits) << bits;
        }
    }

    void the_quantiser_rounds_to_its_steps() {
        QFETCH(int, bits);
        FreeDecay decay = short_decay();
        decay.seconds = 1;
        decay.noise = 1e-3;
        const auto smooth = simulate(decay, {});
        decay.bits = bits;
        const auto rounded = simulate(decay, {});
        QVERIFY(smooth && rounded);
        double peak = 0;
        for (std::size_t k = 0; k < smooth->c.size(); ++k) {
            peak = std::max({peak, std::abs(smooth->c[k]), std::abs(smooth->d[k])});
        }
        QCOMPARE(rounded->full_scale, 1.25 * peak);
        const double step = rounded->full_scale / std::ldexp(1.0, bits - 1);
        for (std::size_t k = 0; k < smooth->c.size(); ++k) {
            const double code = rounded->c[k] / step;
            VYBEG_CLOSE(code, std::round(code), 1e-6);
            if (!(smooth->c[k] > rounded->full_scale - step)) {
                VYBEG_WITHIN(rounded->c[k], smooth->c[k], step * (0.5 + 1e-6));
            }
        }
    }

    void the_quantiser_clips_at_full_scale() {
        FreeDecay decay = short_decay();
        decay.two_theta_A = 0;
        decay.bits = 8;
        decay.full_scale = 0.5;
        const auto samples = simulate(decay, {});
        QVERIFY(samples);
        const auto [low, high] = std::ranges::minmax(samples->c);
        QCOMPARE(low, -0.5);
        QCOMPARE(high, 0.5 * 127 / 128);
        const auto railed = std::ranges::count_if(
            samples->c, [](double x) { return x == -0.5 || x == 0.5 * 127 / 128; });
        // |cos| > 0.5 two thirds of the time, and -+ half a step.
        const double share = static_cast<double>(railed) / static_cast<double>(samples->c.size());
        VYBEG_CLOSE(share, 2.0 / 3, 0.01);
    }

    void zeros_have_no_full_scale() {
        FreeDecay decay = short_decay();
        decay.a_A = 0;
        decay.bits = 16;
        const auto samples = simulate(decay, {});
        QVERIFY(!samples);
        QCOMPARE(samples.error().code, ErrorCode::simulation_impossible);
    }
};

VYBEG_TEST(TestSimulatedNoise)

}  // namespace test_simulated_noise

#include "test_simulated_noise.moc"
