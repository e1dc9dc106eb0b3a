// The filter of a lock-in, and the wave at twice the carrier that one of few stages lets through.
#include "core/analysis/frame_check.h"
#include "core/numerics/lock_in.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <vector>

namespace test_lock_in {

using namespace vybeg;
using Complex = std::complex<double>;

namespace {

constexpr double pi = std::numbers::pi;

// The rows of a lock-in of order 1 at 120 Hz: a beat of 0.05 Hz in noise, without and with an
// image.
struct Rows {
    std::vector<double> time_s;
    std::array<std::vector<Complex>, 2> pure;
    std::array<std::vector<Complex>, 2> seen;
};

constexpr double f_ref_hz = 5300.1;
constexpr double noise = 1e-4;

Rows rows_with(Complex image, double step_s) {
    Rows rows;
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    for (int k = 0; k < 12000; ++k) {
        const double t = 3.1 + k * step_s;
        rows.time_s.push_back(t);
        const Complex p = std::polar(std::exp(-t / 60), 2 * pi * 0.225 * t + 0.3);
        const Complex q = std::polar(0.6 * std::exp(-t / 60), 2 * pi * 0.175 * t - 1);
        const Complex turn = std::polar(1.0, -2 * pi * std::fmod(2 * f_ref_hz * t, 1.0));
        for (const std::size_t channel : {0, 1}) {
            const Complex wave = channel == 0 ? 0.9 * p - 0.4 * q : 0.4 * p + 0.9 * q;
            const Complex z = wave + noise * Complex(normal(random), normal(random));
            rows.pure[channel].push_back(z);
            rows.seen[channel].push_back(z + image * std::conj(wave) * turn);
        }
    }
    return rows;
}

double rms_off(const Rows& rows) {
    double sum = 0;
    for (const std::size_t channel : {0, 1}) {
        for (std::size_t k = 0; k < rows.time_s.size(); ++k) {
            sum += std::norm(rows.seen[channel][k] - rows.pure[channel][k]);
        }
    }
    return std::sqrt(sum / static_cast<double>(2 * rows.time_s.size()));
}

}  // namespace

class TestLockIn : public QObject {
    Q_OBJECT

private slots:
    // The factors of LabOne's manual.
    void time_constants_are_those_of_the_manual() {
        constexpr std::array factors{1.,      .643594, .509825, .434979,
                                     .385614, .349946, .322629, .300845};
        for (int order = 1; order <= 8; ++order) {
            const LockIn filter{order, 25};
            VYBEG_CLOSE(filter.tau_s() * 2 * pi * 25, factors.at(std::size_t(order - 1)), 1e-6);
            VYBEG_CLOSE(std::norm(filter.response(25)), 0.5, 1e-12);
        }
    }

    // Two modes 0.05 Hz apart, half a hertz beside the reference of a narrow filter.
    void modes_come_out_as_they_went_in() {
        const LockIn filter{4, 1};
        constexpr double offset_hz = 0.5;
        constexpr double step_s = 0.02;
        std::vector<double> time_s;
        std::vector<Complex> pure;
        std::vector<Complex> seen;
        for (int k = 0; k < 1000; ++k) {
            const double t = k * step_s + (k > 500 ? 0.5 : 0);
            Complex in = 0;
            Complex out = 0;
            for (const double side : {-1.0, 1.0}) {
                const Complex motion(-1 / 60., side * pi * 0.05);
                const Complex s = motion + Complex(0, 2 * pi * offset_hz);
                const Complex response =
                    std::exp(s * filter.delay_s()) / std::pow(1.0 + s * filter.tau_s(), 4);
                const Complex mode = std::polar(1.0, side) * std::exp(motion * t);
                in += mode;
                out += response * mode;
            }
            time_s.push_back(t);
            pure.push_back(in);
            seen.push_back(out);
        }
        std::vector<Complex> found = seen;
        filter.take_out(offset_hz, step_s, time_s, found);
        double before = 0;
        double after = 0;
        for (std::size_t k = 1; k + 1 < found.size(); ++k) {
            before = std::max(before, std::abs(seen[k] / filter.response(offset_hz) - pure[k]));
            after = std::max(after, std::abs(found[k] - pure[k]));
        }
        VYBEG_MORE(before, 5e-3);
        VYBEG_LESS(after, 1e-3);
    }

    // The integral of |H|^2 cos(2 pi f t) over that of |H|^2.
    void the_noise_is_as_alike_as_the_response_makes_it() {
        for (const int order : {1, 2, 5, 8}) {
            const LockIn filter{order, 25};
            for (const double t_s : {0.001, 0.01, 0.03}) {
                double whole = 0;
                double turned = 0;
                constexpr double step_hz = 0.25;
                for (double f_hz = step_hz / 2; f_hz < 20000; f_hz += step_hz) {
                    const double power = std::norm(filter.response(f_hz));
                    whole += power;
                    turned += power * std::cos(2 * pi * f_hz * t_s);
                }
                VYBEG_CLOSE(filter.correlation(t_s), turned / whole, 1e-3);
            }
        }
    }

    void an_image_is_taken_out() {
        const Complex image = std::polar(0.011, 0.7);
        Rows rows = rows_with(image, 40 / 33333.0);
        VYBEG_MORE(rms_off(rows), 50 * noise);
        remove_image(f_ref_hz, rows.time_s, rows.seen[0], rows.seen[1]);
        VYBEG_LESS(rms_off(rows), 0.1 * noise);
    }

    // A clock of the rows that is not that of the carrier tells nothing; nor does noise.
    void what_is_no_image_stays() {
        Rows pure = rows_with(0, 40 / 33333.0);
        remove_image(f_ref_hz, pure.time_s, pure.seen[0], pure.seen[1]);
        QVERIFY(pure.seen == pure.pure);
        Rows rows = rows_with(0.011, 40 / 33333.0);
        const auto before = rows.seen;
        remove_image(f_ref_hz + 17, rows.time_s, rows.seen[0], rows.seen[1]);
        QVERIFY(rows.seen == before);
    }

    // Twice the carrier is a multiple of the rows' rate: it is no other than the motion.
    void an_image_that_folds_onto_the_motion_stays() {
        Rows rows = rows_with(0.011, 12 / (2 * f_ref_hz));
        const auto before = rows.seen;
        remove_image(f_ref_hz, rows.time_s, rows.seen[0], rows.seen[1]);
        QVERIFY(rows.seen == before);
    }
};

VYBEG_TEST(TestLockIn)

}  // namespace test_lock_in

#include "test_lock_in.moc"
