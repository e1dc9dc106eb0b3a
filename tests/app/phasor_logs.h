#pragma once

#include "tests/app/cli_run.h"

#include <QByteArray>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QtTest>

#include <cmath>
#include <complex>
#include <cstddef>
#include <cstring>
#include <numbers>
#include <vector>

// Logs of a lock-in of the test's own, from the samples of simulated recordings.
namespace vybeg::test {

using Complex = std::complex<double>;

inline constexpr double pi = std::numbers::pi;
inline constexpr double rate_hz = 33333;
inline constexpr double f_ref_hz = 5300.1;
inline constexpr double seconds = 20;
inline constexpr int runs = 3;

// Two channels of 64 bit floats, behind a header that ends with a line.
inline std::vector<double> samples_of(const QString& npy, int channel) {
    const QByteArray bytes = content(npy);
    const qsizetype begin = bytes.indexOf('\n') + 1;
    std::vector<double> all(static_cast<std::size_t>((bytes.size() - begin) / 8));
    std::memcpy(all.data(), bytes.constData() + begin, all.size() * 8);
    std::vector<double> one;
    for (std::size_t k = static_cast<std::size_t>(channel); k < all.size(); k += 2) {
        one.push_back(all[k]);
    }
    return one;
}

struct LockIn {
    int order;
    double bandwidth_hz;
    int samples;  // of the recording, for one of the log

    double tau_s() const {
        return std::sqrt(std::pow(2.0, 1.0 / order) - 1) / (2 * pi * bandwidth_hz);
    }
    // Until the filter has settled to 1e-6.
    std::size_t settling() const {
        return static_cast<std::size_t>((14 + 2.5 * order) * tau_s() * rate_hz / samples) + 1;
    }
};

inline std::vector<Complex> demodulated(const std::vector<double>& x, const LockIn& lock_in) {
    std::vector<Complex> stages(static_cast<std::size_t>(lock_in.order));
    const double keep = std::exp(-1 / (rate_hz * lock_in.tau_s()));
    std::vector<Complex> log;
    for (std::size_t k = 0; k < x.size(); ++k) {
        const double turns = std::fmod(f_ref_hz / rate_hz * static_cast<double>(k), 1.0);
        Complex z = 2 * x[k] * std::polar(1.0, -2 * pi * turns);
        for (Complex& stage : stages) {
            stage = keep * stage + (1 - keep) * z;
            z = stage;
        }
        if (k % static_cast<std::size_t>(lock_in.samples) == 0) {
            log.push_back(z);
        }
    }
    return log;
}

enum class Frame { fixed, common_frequency, common_phase, pll };

// The log of a recording in a frame, whose oscillators move by hertz.
inline QByteArray log_of(const QString& npy, const LockIn& lock_in, Frame frame, double y_sign,
                         double unit) {
    const std::vector<Complex> c = demodulated(samples_of(npy, 0), lock_in);
    const std::vector<Complex> d = demodulated(samples_of(npy, 1), lock_in);
    const double step_s = lock_in.samples / rate_hz;
    QByteArray text = "t,Xc,Yc,Xd,Yd";
    text += frame == Frame::common_frequency ? ",F (Hz)\n"
            : frame == Frame::common_phase   ? ",P (rad)\n"
            : frame == Frame::pll            ? ",Pc (cyc),Pd (cyc)\n"
                                             : "\n";
    for (std::size_t k = lock_in.settling(); k < c.size(); ++k) {
        const double t = static_cast<double>(k) * step_s;
        // Its frequency is f_ref + 0.3 sin(0.5 t) Hz.
        const double turns = 0.3 * (1 - std::cos(0.5 * t)) / (0.5 * 2 * pi) * 2 * pi;
        const double turns_of_d = 0.11 * t + 0.2;
        const bool moves = frame != Frame::fixed;
        const Complex of_c = c[k] * std::polar(1 / unit, moves ? -2 * pi * turns : 0);
        const Complex of_d = d[k] * std::polar(1 / unit, frame == Frame::pll ? -2 * pi * turns_of_d
                                                         : moves             ? -2 * pi * turns
                                                                             : 0);
        std::vector<double> row{t, of_c.real(), y_sign * of_c.imag(), of_d.real(),
                                y_sign * of_d.imag()};
        if (frame == Frame::common_frequency) {
            row.push_back(f_ref_hz + 0.3 * std::sin(0.5 * t));
        } else if (frame == Frame::common_phase) {
            row.push_back(2 * pi * turns);
        } else if (frame == Frame::pll) {
            row.push_back(turns);
            row.push_back(turns_of_d);
        }
        for (const double value : row) {
            text += QByteArray::number(value, 'g', 15) + ',';
        }
        text.back() = '\n';
    }
    return text;
}

// A folder with the recordings 0.npy, 1.npy, ... of one resonator, and logs of them.
class PhasorLogTest : public QObject, protected CliFolder {
protected:
    void simulate_runs() const {
        for (int k = 0; k < runs; ++k) {
            const QString name = QString::number(k) + ".npy";
            QCOMPARE(
                run("simulate --split 0.05 --theta-w 0.2 --tau 60 --damping-anisotropy 1e-3 "
                    "--theta-tau -0.3 --noise 0.001",
                    {"-o", name, "--seconds", QString::number(seconds), "--seed",
                     QString::number(k + 10), "--two-theta-A", QString::number(0.2 + k * pi / 4)})
                    .status,
                0);
        }
    }

    void write(const QString& name, const QByteArray& text) const {
        if (!put(path(name), text)) {
            qFatal("no file");
        }
    }

    QByteArray log_of_run(int k, const LockIn& lock_in, Frame frame, double y_sign = 1,
                          double unit = 1) const {
        return log_of(path(QString::number(k) + ".npy"), lock_in, frame, y_sign, unit);
    }

    // With Y as the carrier turns and peak values.
    Outcome identify_fixed(const QStringList& files, const QStringList& more) const {
        return run("identify -o - --phasors fixed --f-ref 5300.1 --y-sign + --amplitude peak",
                   more + files);
    }
};

}  // namespace vybeg::test
