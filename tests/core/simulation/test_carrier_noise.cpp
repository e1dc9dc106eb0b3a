// Noise about the carrier: its power, its width, its independence.
//
// Statistical model: a mean over N independent numbers has its sd over sqrt(N). For Gaussian
// numbers of variance s^2 the mean square has sd s^2 sqrt(2/N), a mean product s^2/sqrt(N). A
// process with correlation e^{-b lag} has in T about N = b T / 2 independent values of its mean,
// and b T of its mean square.
#include "core/simulation/free_decay.h"
#include "core/simulation/noise.h"
#include "core/simulation/simulate.h"
#include "tests/closeness.h"
#include "tests/largest_of.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <cmath>
#include <numbers>

namespace test_carrier_noise {

using namespace vybeg;
using std::numbers::pi;

namespace {

using Complex = std::complex<double>;

// The phasors of what a decay adds to another, without the carrier: the difference of the signals
// times 2 e^{-iwt}, averaged over whole periods, one value in `stride` samples.
std::vector<Complex> demodulated(const std::vector<double>& a, const std::vector<double>& b,
                                 double f0_hz, double rate_hz, std::size_t stride) {
    std::vector<Complex> found;
    for (std::size_t begin = 0; begin + stride <= a.size(); begin += stride) {
        Complex sum;
        for (std::size_t k = begin; k < begin + stride; ++k) {
            const double turns = std::remainder(f0_hz * static_cast<double>(k), rate_hz) / rate_hz;
            sum += (a[k] - b[k]) * std::polar(2.0, -2 * pi * turns);
        }
        found.push_back(sum / static_cast<double>(stride));
    }
    return found;
}

double mean_square(const std::vector<Complex>& z, std::size_t lag = 0) {
    double sum = 0;
    for (std::size_t k = lag; k < z.size(); ++k) {
        sum += (z[k] * std::conj(z[k - lag])).real();
    }
    return sum / static_cast<double>(z.size() - lag);
}

// Whole periods in 20 samples.
FreeDecay quiet() {
    FreeDecay decay{.seconds = 400, .rate_hz = 2000, .f0_hz = 300, .two_theta_A = 0.9};
    return decay;
}

}  // namespace

class TestCarrierNoise : public QObject {
    Q_OBJECT

private slots:
    void the_processes_are_gaussian_and_have_their_correlation() {
        for (const std::uint64_t seed : {1U, 2U, 3U}) {
            OrnsteinUhlenbeck process(0.5, 100, seed);
            std::vector<Complex> values(400'000);  // 4000 s, b = pi 1/s
            for (Complex& value : values) {
                value = process.next();
            }
            const double independent = 2 * pi * 0.5 * 4000 * 2;  // of both components
            for (const std::size_t lag : {0U, 10U, 30U, 100U}) {
                const double expected =
                    2 * std::exp(-2 * pi * 0.5 * static_cast<double>(lag) / 100);
                VYBEG_CLOSE(mean_square(values, lag), expected,
                            4 * (2 * std::sqrt(2 / independent)));
            }
            // Gaussian: the mean fourth power of a component is 3, of sd sqrt(96 / N).
            double fourth = 0;
            for (const Complex& value : values) {
                fourth += std::pow(value.real(), 4) / static_cast<double>(values.size());
            }
            VYBEG_CLOSE(fourth, 3, 4 * std::sqrt(96 / (independent / 2)));
        }
    }

    void noise_about_the_carrier_has_its_power_and_width_data() {
        QTest::addColumn<double>("width");
        QTest::addColumn<int>("seed");
        for (const double width : {0.2, 1.0, 3.0}) {
            for (const int seed : {1, 2, 3}) {
                QTest::addRow("%g Hz, seed %d", width, seed) << width << seed;
            }
        }
    }

    void noise_about_the_carrier_has_its_power_and_width() {
        QFETCH(double, width);
        QFETCH(int, seed);
        FreeDecay decay = quiet();
        decay.seed = static_cast<std::uint64_t>(seed);
        decay.a_A = 2;
        const auto plain = simulate(decay, {});
        decay.carrier_noise = 1e-3;
        decay.carrier_noise_width_hz = width;
        const auto noisy = simulate(decay, {});
        QVERIFY(plain && noisy);
        const auto c = demodulated(noisy->c, plain->c, 300, 2000, 20);
        const auto d = demodulated(noisy->d, plain->d, 300, 2000, 20);
        const double variance = 2 * 4e-6;  // both components, relative to a_A = 2
        const double independent = 2 * pi * width * decay.seconds * 2;
        const double sd = variance * std::sqrt(2 / independent);
        for (const auto& channel : {c, d}) {
            // Windows of 10 ms average: 1 - b h/3 of the variance is left.
            const double bh = 2 * pi * width * 0.01;
            const double left = 2 * (bh - 1 + std::exp(-bh)) / (bh * bh);
            VYBEG_CLOSE(mean_square(channel), variance * left, 4 * sd);
            // Half a correlation length apart.
            const auto lag = static_cast<std::size_t>(std::round(0.5 / bh));
            const double apart = std::exp(-bh * static_cast<double>(lag)) *
                                 std::pow(std::sinh(bh / 2) / (bh / 2), 2);
            VYBEG_CLOSE(mean_square(channel, lag), variance * apart, 4 * sd);
        }
        double common = 0;
        for (std::size_t k = 0; k < c.size(); ++k) {
            common += (c[k] * std::conj(d[k])).real() / static_cast<double>(c.size());
        }
        VYBEG_CLOSE(common, 0, 4 * sd);
    }

    void modulation_follows_each_channels_own_phasor() {
        FreeDecay decay = quiet();
        decay.tau_s = 300;
        const auto plain = simulate(decay, {});
        decay.modulation_noise = 1e-2;
        decay.carrier_noise_width_hz = 1;
        const auto noisy = simulate(decay, {});
        QVERIFY(plain && noisy);
        const auto c = demodulated(noisy->c, plain->c, 300, 2000, 20);
        const auto d = demodulated(noisy->d, plain->d, 300, 2000, 20);
        // Relative to each channel and to what has not decayed yet the noise is stationary.
        for (const auto& [channel, gain] :
             {std::pair{c, std::cos(0.9)}, std::pair{d, std::sin(0.9)}}) {
            for (const bool second_half : {false, true}) {
                double power = 0;
                const std::size_t half = channel.size() / 2;
                for (std::size_t k = 0; k < half; ++k) {
                    const std::size_t at = k + (second_half ? half : 0);
                    const double left = gain * std::exp(-0.01 * static_cast<double>(at) / 300);
                    power += std::norm(channel[at] / left) / static_cast<double>(half);
                }
                const double independent = 2 * pi * 200 * 2;
                VYBEG_CLOSE(power, 2e-4 * (1 - 2 * pi * 0.01 / 3),
                            4 * 2e-4 * std::sqrt(2 / independent));
            }
        }
    }

    void phase_noise_is_common_to_both_channels() {
        for (const std::uint64_t seed : {1U, 2U}) {
            FreeDecay decay = quiet();
            decay.seconds = 20;
            decay.seed = seed;
            decay.phase_noise_rad = 0.3;
            const auto noisy = simulate(decay, {});
            QVERIFY(bool(noisy));
            double worst = 0;
            double largest = 0;
            for (std::size_t k = 0; k < noisy->c.size(); ++k) {
                worst =
                    test::largest_of({worst, std::abs(noisy->c[k] * std::tan(0.9) - noisy->d[k])});
                largest = test::largest_of({largest, std::abs(noisy->c[k])});
            }
            VYBEG_LESS(worst, 1e-14);
            VYBEG_LESS(largest, std::cos(0.9) * (1 + 1e-12));
        }
    }

    void phase_noise_has_a_density_of_one_over_f_data() {
        QTest::addColumn<double>("f_hz");
        for (const double f : {0.005, 0.02, 0.2, 2.0, 20.0}) {
            QTest::addRow("%g Hz", f) << f;
        }
    }

    // The periodogram at a frequency well inside a record with a Hann taper is exponential about
    // the density: a mean over N of them, from records of their own, has sd 1/sqrt(N) of it.
    void phase_noise_has_a_density_of_one_over_f() {
        QFETCH(double, f_hz);
        // The lowest width is that of a recording of 400 s, the highest draws those of 300 Hz.
        const double rate_hz = std::min(300.0, 200 * f_hz);
        const auto count = static_cast<std::size_t>(10 / f_hz * rate_hz);
        constexpr int records = 1000;
        double mean = 0;
        for (int record = 0; record < records; ++record) {
            FlickerNoise noise(0.01 / 400, rate_hz, 1, static_cast<std::uint64_t>(record + 1));
            Complex sum;
            double weight = 0;
            for (std::size_t k = 0; k < count; ++k) {
                const double share = static_cast<double>(k) / static_cast<double>(count);
                const double taper = 1 - std::cos(2 * pi * share);
                sum += taper * noise.next() *
                       std::polar(1.0, -2 * pi * f_hz * static_cast<double>(k) / rate_hz);
                weight += taper * taper;
            }
            mean += 2 * std::norm(sum) / (weight * rate_hz) / records;
        }
        // The taper's lobe of 2/T, a fifth of f, sees the mean of 1/f over it: 1 % more; at 20 Hz
        // the straight corner of the widest process, half of the draws' rate, leaves 5 % less or
        // more.
        VYBEG_CLOSE(mean * f_hz, 1, 4 / std::sqrt(double(records)) + 0.05);
    }

    void white_noise_stays_as_it_is() {
        FreeDecay decay = quiet();
        decay.seconds = 5;
        const auto silent = simulate(decay, {});
        decay.noise = 1e-3;
        const auto white = simulate(decay, {});
        decay.carrier_noise = 1e-3;
        decay.phase_noise_rad = 1e-3;
        decay.modulation_noise = 1e-3;
        const auto all = simulate(decay, {});
        decay.noise = 0;
        const auto coloured = simulate(decay, {});
        QVERIFY(silent && white && all && coloured);
        for (std::size_t k = 0; k < silent->c.size(); ++k) {
            const double own = white->c[k] - silent->c[k];
            VYBEG_CLOSE(all->c[k] - coloured->c[k], own, 1e-15);
        }
    }

    void a_seed_repeats_itself_and_another_does_not() {
        for (double FreeDecay::*kind : {&FreeDecay::carrier_noise, &FreeDecay::modulation_noise,
                                        &FreeDecay::phase_noise_rad}) {
            FreeDecay decay = quiet();
            decay.seconds = 2;
            decay.*kind = 1e-2;
            const auto first = simulate(decay, {});
            const auto again = simulate(decay, {});
            decay.seed = 2;
            const auto other = simulate(decay, {});
            QVERIFY(first && again && other);
            QVERIFY(first->c == again->c && first->d == again->d);
            QVERIFY(first->c != other->c && first->d != other->d);
        }
    }
};

VYBEG_TEST(TestCarrierNoise)

}  // namespace test_carrier_noise

#include "test_carrier_noise.moc"
