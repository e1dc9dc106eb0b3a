// The track of a log: phasors with noise, and powers without a phase, of a wave that is known at
// each instant.
#include "core/analysis/analyse_logs.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>

namespace test_analyse_log {

using namespace vybeg;
using namespace vybeg::test;

namespace {

using Complex = std::complex<double>;

constexpr double pi = std::numbers::pi;
constexpr double f_ref_hz = 5300;
constexpr double step_s = 0.005;  // three rows to a window of 15 ms

// Slow variables that change slowly and evenly.
struct Wave {
    double a_B = 0.2;  // of a_A
    double two_theta = 0.3;
    double turn_rad_s = 0.05;
    double offset_hz = 0.02;

    double a_A_at(double t) const { return std::exp(-t / 40); }
    double two_theta_at(double t) const { return two_theta + turn_rad_s * t; }
    double alpha_at(double t) const { return 0.4 - 2 * pi * offset_hz * t; }  // of f_ref
    // The mean rate of phase has a part by the turn of a wave with quadrature.
    double f_at() const {
        return f_ref_hz + offset_hz + 2 * a_B / (1 + a_B * a_B) * turn_rad_s / (2 * pi);
    }
    std::array<Complex, 2> phasors_at(double t) const {
        const Complex turn = std::polar(a_A_at(t), -alpha_at(t));
        const double c = std::cos(two_theta_at(t));
        const double s = std::sin(two_theta_at(t));
        return {turn * Complex(c, a_B * s), turn * Complex(s, -a_B * c)};
    }
};

QByteArray numbers(std::initializer_list<double> row) {
    QByteArray text;
    for (const double value : row) {
        text += QByteArray::number(value, 'g', 17) + ',';
    }
    text.back() = '\n';
    return text;
}

struct Pull {
    double sum = 0;
    double squares = 0;
    int count = 0;

    void take(double difference, double sd) {
        sum += difference / sd;
        squares += difference * difference / (sd * sd);
        ++count;
    }
    double mean() const { return sum / std::sqrt(count); }
    double rms() const { return std::sqrt(squares / count); }
};

LogChoice phasors_at_reference() {
    LogChoice choice;
    choice.phasors = {PhasorFrame::fixed, f_ref_hz, 1, 1, {}};
    return choice;
}

}  // namespace

class TestAnalyseLog : public QObject {
    Q_OBJECT

private slots:
    void phasors_give_the_wave_within_their_noise_data() {
        QTest::addColumn<double>("two_theta");
        QTest::addColumn<double>("a_B");
        for (const double two_theta : {-1.2, -0.4, 0.3, 1.3}) {
            for (const double a_B : {-0.3, 0.0, 0.4}) {
                QTest::addRow("%g, %g", two_theta, a_B) << two_theta << a_B;
            }
        }
    }
    void phasors_give_the_wave_within_their_noise() {
        QFETCH(double, two_theta);
        QFETCH(double, a_B);
        const Wave wave{a_B, two_theta};
        std::mt19937_64 random(7);
        std::normal_distribution<double> noise(0, 1e-3);
        const QString path = folder_.filePath("log.csv");
        {
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write("t_s,Xc,Yc,Xd,Yd\n");
            for (int k = 0; k < 6000; ++k) {
                const double t = 2 + step_s * k;
                const auto [c, d] = wave.phasors_at(t);
                file.write(numbers({t, c.real() + noise(random), c.imag() + noise(random),
                                    d.real() + noise(random), d.imag() + noise(random)}));
            }
        }
        const Result<Analysis> found =
            analyse_log(path.toStdString(), {}, phasors_at_reference(), {}, {});
        QVERIFY(found);
        const Track& track = found->track;
        QCOMPARE(track.rows(), 2000U);
        std::array<Pull, 5> pulls;
        for (std::size_t k = 0; k < track.rows(); ++k) {
            const double t = track.time_s()[k];
            const double alpha =
                wave.alpha_at(t) - 2 * pi * std::fmod(f_ref_hz * t, 1.0);  // of the carrier
            const double two_theta_at = wave.two_theta_at(t);
            const auto take = [&](std::size_t of, SlowVariable variable, double truth,
                                  double turn) {
                const double difference = track.values(variable)[k] - truth;
                pulls[of].take(turn > 0 ? std::remainder(difference, turn) : difference,
                               track.sds(variable)[k]);
            };
            take(0, SlowVariable::a_A, wave.a_A_at(t), 0);
            take(1, SlowVariable::a_B, a_B * wave.a_A_at(t), 0);
            take(2, SlowVariable::two_theta_A, two_theta_at, pi);
            take(3, SlowVariable::f, wave.f_at(), 0);
            take(4, SlowVariable::alpha, alpha, pi);  // together with 2 theta_A
        }
        for (const Pull& pull : pulls) {
            VYBEG_LESS(std::abs(pull.mean()), 4.0);
            VYBEG_CLOSE(pull.rms(), 1, 0.08);
        }
        VYBEG_CLOSE(found->means.noise, 1e-3, 3e-5);
        VYBEG_LESS(std::abs(found->means.mean_f_hz - wave.f_at()), 4 * found->means.sd_mean_f_hz);
    }

    // A gain, a delay and a turned electrode that the settings tell are taken out of both kinds.
    void the_calibration_is_applied() {
        const Wave wave{0.2, 0.5};
        Settings settings;
        settings.calibration.kappa = 1.25;
        settings.calibration.delay_d_s = 3e-6;
        settings.calibration.angle_zero_deg = 20;
        settings.f0_hz = f_ref_hz;
        const Complex of_d = std::polar(1 / 1.25, -2 * pi * f_ref_hz * 3e-6);
        const double zero = 20 * pi / 90;  // of 2 theta
        QByteArray phasors = "t_s,Xc,Yc,Xd,Yd\n";
        QByteArray powers = "t_s,E,R,S,Q\n";
        for (int k = 0; k < 600; ++k) {
            const double t = step_s * k;
            const auto [c, unturned] = Wave{wave.a_B, wave.two_theta + zero}.phasors_at(t);
            const Complex d = of_d * unturned;
            phasors += numbers({t, c.real(), c.imag(), d.real(), d.imag()});
            const Complex both = 2.0 * c * std::conj(d);
            powers += numbers({t, std::norm(c) + std::norm(d), std::norm(c) - std::norm(d),
                               both.real(), both.imag()});
        }
        LogChoice of_powers;
        of_powers.names = "E,R,S,Q";
        for (const auto& [text, choice] :
             {std::pair{phasors, phasors_at_reference()}, std::pair{powers, of_powers}}) {
            const QString path = folder_.filePath("calibrated.csv");
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(text);
            file.close();
            const Result<Analysis> found =
                analyse_log(path.toStdString(), {}, choice, settings, {});
            QVERIFY(found);
            const Track& track = found->track;
            for (std::size_t k = 0; k < track.rows(); ++k) {
                const double t = track.time_s()[k];
                VYBEG_CLOSE(track.values(SlowVariable::a_A)[k], wave.a_A_at(t), 1e-4);
                VYBEG_CLOSE(track.values(SlowVariable::a_B)[k], 0.2 * wave.a_A_at(t), 1e-4);
                VYBEG_CLOSE(track.values(SlowVariable::two_theta_A)[k], wave.two_theta_at(t), 1e-4);
                QCOMPARE(std::isnan(track.values(SlowVariable::f)[k]), choice.without_phase());
            }
        }
        settings.f0_hz.reset();
        const Result<Analysis> refused = analyse_log(
            folder_.filePath("calibrated.csv").toStdString(), {}, of_powers, settings, {});
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::setting_invalid);
    }

    void a_circular_wave_has_no_angle() {
        const QString path = folder_.filePath("circle.csv");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("t_s,Xc,Yc,Xd,Yd\n");
        for (int k = 0; k < 600; ++k) {
            const auto [c, d] = Wave{1.0}.phasors_at(step_s * k);
            file.write(numbers({step_s * k, c.real(), c.imag(), d.real(), d.imag()}));
        }
        file.close();
        const Result<Analysis> found =
            analyse_log(path.toStdString(), {}, phasors_at_reference(), {}, {});
        QVERIFY(found);
        QVERIFY(has(found->track.flags()[100], Flag::circular));
        QVERIFY(std::isnan(found->track.values(SlowVariable::two_theta_A)[100]));
        VYBEG_CLOSE(found->track.values(SlowVariable::a_A)[100],
                    Wave{}.a_A_at(found->track.time_s()[100]), 1e-3);
    }

private:
    QTemporaryDir folder_;
};

VYBEG_TEST(TestAnalyseLog)

}  // namespace test_analyse_log

#include "test_analyse_log.moc"
