// Frames that phasors are not in, shown by the phasors themselves: many seeds, noise from 20 to 100
// dB, rows with the correlation of a filter.
#include "core/analysis/phasor_findings.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

namespace test_phasor_findings {

using namespace vybeg;
using namespace vybeg::test;

namespace {

using Complex = std::complex<double>;

constexpr double pi = std::numbers::pi;
constexpr double step_s = 0.01;

struct Log {
    std::vector<Complex> c;
    std::vector<Complex> d;
};

// A wave that decays and grows a quadrature at `offset_hz` from the reference, with noise through a
// filter of one stage.
Log log_of(unsigned seed, double offset_hz, double snr_db, double split_hz) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(0, 1);
    const double tau_s = 5 * std::pow(100, any(random));
    const double theta = pi * any(random);
    const double start = 2 * pi * any(random);
    const double sd = std::pow(10, -snr_db / 20);
    const double keep = 0.9 * any(random);
    std::normal_distribution<double> noise(0, sd);
    Complex of_c;
    Complex of_d;
    Log log;
    for (int k = 0; k < 3000; ++k) {
        const double t = step_s * k;
        of_c = keep * of_c + Complex(noise(random), noise(random));
        of_d = keep * of_d + Complex(noise(random), noise(random));
        const Complex wave = std::polar(std::exp(-t / tau_s), 2 * pi * offset_hz * t + start);
        const Complex p = wave * std::polar(std::cos(theta), pi * split_hz * t);
        const Complex q = wave * std::polar(std::sin(theta), -pi * split_hz * t);
        log.c.push_back((p + q) / std::numbers::sqrt2 + of_c);
        log.d.push_back((p - q) / std::numbers::sqrt2 + of_d);
    }
    return log;
}

// The loop of C, of second order and 3 Hz, turns both channels.
void lock(Log& log) {
    double held = std::arg(log.c.front());
    double step = 0;
    for (std::size_t k = 0; k < log.c.size(); ++k) {
        held += step;
        const double off = std::arg(log.c[k] * std::polar(1.0, -held));
        held += 0.3 * off;
        step += 0.02 * off;
        log.c[k] *= std::polar(1.0, -held);
        log.d[k] *= std::polar(1.0, -held);
    }
}

std::size_t count_of(DiagnosticKind kind, const Log& log) {
    std::size_t count = 0;
    for (const Diagnostic& found : phasor_findings(step_s, log.c, log.d)) {
        count += found.kind == kind ? 1U : 0U;
    }
    return count;
}

}  // namespace

class TestPhasorFindings : public QObject {
    Q_OBJECT

private slots:
    void signal_to_noise_data() {
        QTest::addColumn<double>("snr_db");
        for (const double snr_db : {20, 40, 60, 80, 100}) {
            QTest::addRow("%g dB", snr_db) << snr_db;
        }
    }

    void a_reference_that_follows_c_is_told_data() { signal_to_noise_data(); }
    void a_reference_that_follows_c_is_told() {
        QFETCH(double, snr_db);
        std::size_t told = 0;
        constexpr unsigned logs = 40;
        for (unsigned seed = 0; seed < logs; ++seed) {
            Log log = log_of(seed, 0.02, snr_db, seed % 2 == 0 ? 0 : 1e-3);
            lock(log);
            told += count_of(DiagnosticKind::phasors_locked, log);
        }
        VYBEG_AT_LEAST(told, logs - 2U);
    }

    // Also one that is the wave's frequency to all digits.
    void a_reference_of_its_own_says_nothing_data() { signal_to_noise_data(); }
    void a_reference_of_its_own_says_nothing() {
        QFETCH(double, snr_db);
        std::size_t told = 0;
        for (unsigned seed = 0; seed < 200; ++seed) {
            const double offset_hz = seed % 4 == 0 ? 0 : std::pow(10.0, -5 + seed / 40.0);
            const Log log = log_of(seed, offset_hz, snr_db, seed % 3 == 0 ? 0 : 1e-3);
            told += count_of(DiagnosticKind::phasors_locked, log);
        }
        VYBEG_EQUAL(told, 0U);
    }

    void unlike_signs_of_y_are_told() {
        for (const double offset_hz : {-10.0, -1.0, 0.3, 5.0}) {
            Log log = log_of(1, offset_hz, 40, 1e-3);
            VYBEG_EQUAL(count_of(DiagnosticKind::phasors_mirrored, log), 0U);
            for (Complex& z : log.d) {
                z = std::conj(z);
            }
            VYBEG_EQUAL(count_of(DiagnosticKind::phasors_mirrored, log), 1U);
        }
    }

    void few_rows_say_nothing() {
        const Log log = log_of(1, 0, 40, 0);
        const std::span<const Complex> c = log.c;
        VYBEG_EQUAL(phasor_findings(step_s, c.first(30), c.first(30)).size(), 0U);
    }
};

VYBEG_TEST(TestPhasorFindings)

}  // namespace test_phasor_findings

#include "test_phasor_findings.moc"
