// identify of logs of a lock-in and a phasemeter, as a process. The lock-in is the test's own.
#include "tests/app/cli_run.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <complex>
#include <cstring>
#include <numbers>
#include <vector>

namespace test_cli_phasors {

using namespace vybeg::test;

namespace {

using Complex = std::complex<double>;

constexpr double pi = std::numbers::pi;
constexpr double rate_hz = 33333;
constexpr double f_ref_hz = 5300.1;
constexpr double seconds = 20;
constexpr int runs = 3;

QJsonObject json_of(const Outcome& run) {
    return QJsonDocument::fromJson(run.out).object();
}

// Two channels of 64 bit floats, behind a header that ends with a line.
std::vector<double> samples_of(const QString& npy, int channel) {
    QFile file(npy);
    if (!file.open(QIODevice::ReadOnly)) {
        qFatal("no samples");
    }
    const QByteArray bytes = file.readAll();
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

std::vector<Complex> demodulated(const std::vector<double>& x, const LockIn& lock_in) {
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
QByteArray log_of(const QString& npy, const LockIn& lock_in, Frame frame, double y_sign,
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

}  // namespace

class TestCliPhasors : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        for (int k = 0; k < runs; ++k) {
            const QString name = QString::number(k) + ".npy";
            const Outcome made = run_cli({"simulate",
                                          "-o",
                                          name,
                                          "--seconds",
                                          QString::number(seconds),
                                          "--split",
                                          "0.05",
                                          "--theta-w",
                                          "0.2",
                                          "--tau",
                                          "60",
                                          "--damping-anisotropy",
                                          "1e-3",
                                          "--theta-tau",
                                          "-0.3",
                                          "--noise",
                                          "0.001",
                                          "--seed",
                                          QString::number(k + 10),
                                          "--two-theta-A",
                                          QString::number(0.2 + k * pi / 4)},
                                         folder_.path());
            QCOMPARE(made.status, 0);
        }
    }

    void samples_and_their_lock_in_tell_one_resonator_data() {
        QTest::addColumn<int>("order");
        QTest::addColumn<double>("bandwidth");
        QTest::addColumn<int>("samples");
        QTest::addColumn<int>("frame");
        QTest::addColumn<double>("y_sign");
        QTest::addColumn<bool>("rms");
        const struct {
            double bandwidth;
            int samples;
        } filters[]{{8, 600}, {30, 150}, {120, 40}};
        // Below order 3 the wave at twice the carrier comes through.
        for (int order = 3; order <= 8; ++order) {
            for (int filter = 0; filter < 3; ++filter) {
                const int frame = (order + filter) % 4;
                const bool other = (order + frame) % 2 == 1;
                QTest::addRow("order %d, %g Hz, frame %d", order, filters[filter].bandwidth, frame)
                    << order << filters[filter].bandwidth << filters[filter].samples << frame
                    << (other ? -1.0 : 1.0) << (filter == 1);
            }
        }
    }
    void samples_and_their_lock_in_tell_one_resonator() {
        QFETCH(int, order);
        QFETCH(double, bandwidth);
        QFETCH(int, samples);
        QFETCH(int, frame);
        QFETCH(double, y_sign);
        QFETCH(bool, rms);
        const auto kind = static_cast<Frame>(frame);
        QStringList arguments{"identify",
                              "-o",
                              "-",
                              "--phasors",
                              kind == Frame::fixed ? "fixed"
                              : kind == Frame::pll ? "pll"
                                                   : "common",
                              "--y-sign",
                              y_sign > 0 ? "+" : "-",
                              "--amplitude",
                              rms ? "rms" : "peak",
                              "--lock-in",
                              QString("%1,%2Hz").arg(order).arg(bandwidth)};
        if (kind != Frame::common_frequency) {
            arguments << "--f-ref" << QString::number(f_ref_hz);
        }
        for (int k = 0; k < runs; ++k) {
            QFile file(folder_.filePath(QString("log%1.csv").arg(k)));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(log_of(folder_.filePath(QString::number(k) + ".npy"),
                              {order, bandwidth, samples}, kind, y_sign,
                              rms ? std::numbers::sqrt2 : 1));
            arguments << QFileInfo(file).fileName();
        }
        const Outcome identified = run_cli(arguments, folder_.path());
        VYBEG_EQUAL(identified.status, 0, identified.err.constData());
        const QJsonObject found = json_of(identified)["resonator"].toObject();
        const QJsonObject expected = resonator_of_samples({order, bandwidth, samples});
        for (const QString name :
             {"split_hz", "theta_w_rad", "tau_s", "angle_rate_rad_s", "damping_anisotropy_per_s"}) {
            const QJsonObject there = expected[name].toObject();
            const QJsonObject here = found[name].toObject();
            const double sd = there["sd"].toDouble();
            VYBEG_LESS(std::abs(here["value"].toDouble() - there["value"].toDouble()) / sd, 0.4,
                       qPrintable(name));
            VYBEG_LESS(std::abs(here["sd"].toDouble() / sd - 1), 0.08, qPrintable(name));
        }
        const double amplitude = json_of(identified)["runs"]
                                     .toArray()[0]
                                     .toObject()["a_A"]
                                     .toObject()["value"]
                                     .toDouble();
        VYBEG_LESS(std::abs(amplitude - 1), 0.01);
    }

    // LabOne: a file of each demodulator, times in ticks, whose clock stands in a file beside.
    void ticks_of_labone_are_seconds() {
        const double clockbase = 6e7;
        const LockIn lock_in{4, 30, 150};
        const QByteArray both = log_of(folder_.filePath("0.npy"), lock_in, Frame::fixed, 1, 1);
        QByteArray of_c = "chunk;timestamp;x;y;freq;phase;dio;trigger;auxin0;auxin1\n";
        QByteArray of_d = of_c;
        const auto add = [&](QByteArray& to, const QByteArray& t, const QByteArray& x,
                             const QByteArray& y) {
            // Counted from the start of the device.
            to += "0;" + QByteArray::number(7e14 + std::round(t.toDouble() * clockbase), 'f', 0) +
                  ';' + x + ';' + y + ";5300.1;0;0;0;0;0\n";
        };
        for (const QByteArray& line : both.split('\n').mid(1)) {
            const QList<QByteArray> f = line.split(',');
            if (f.size() >= 5) {
                add(of_c, f[0], f[1], f[2]);
                add(of_d, f[0], f[3], f[4]);
            }
        }
        write("plain.csv", both);
        write("dev1_demods_0_sample_00000.csv", of_c);
        write("dev1_demods_1_sample_00000.csv", of_d);
        const QStringList choice{"--phasors",   "fixed", "--y-sign", "+",
                                 "--amplitude", "peak",  "-o",       "-"};
        const QStringList demods{"identify", "dev1_demods_0_sample_00000.csv", "--channel-d",
                                 "dev1_demods_1_sample_00000.csv"};
        const Outcome refused = run_cli(demods + choice, folder_.path());
        QCOMPARE(refused.status, 3);
        QVERIFY2(refused.err.contains("--rate"), refused.err.constData());
        const auto wave = [&](const QStringList& arguments) {
            const Outcome read = run_cli(arguments, folder_.path());
            if (read.status != 0) {
                qWarning("%s", read.err.constData());
            }
            return json_of(read)["runs"].toArray()[0].toObject()["wave"].toObject();
        };
        const QJsonObject told =
            wave(QStringList{"identify", "plain.csv", "--f-ref", "5300.1"} + choice);
        write("dev1_demods_0_sample_header_00000.csv", "chunk;clockbase;name\n0;60000000;demod\n");
        write("dev1_demods_1_sample_header_00000.csv", "chunk;clockbase;name\n0;60000000;demod\n");
        QStringList other = demods + choice;
        for (const QJsonObject& found : {wave(other), wave(other << "--rate"
                                                                 << "222.22")}) {
            for (const QString name : {"f_hz", "tau_s"}) {
                const QJsonObject expected = told[name].toObject();
                VYBEG_LESS(std::abs(found[name].toObject()["value"].toDouble() -
                                    expected["value"].toDouble()),
                           expected["sd"].toDouble() * 0.1);
            }
        }
    }

    void simulate_writes_the_log_of_a_lock_in() {
        const QStringList decay{"simulate", "-o",      "lock.wav", "--seconds", "10",
                                "--tau",    "40",      "--f0",     "5300.1",    "--noise",
                                "1e-3",     "--split", "0.05"};
        const Outcome made =
            run_cli(decay + QStringList{"--lock-in", "4,30Hz,200"}, folder_.path());
        VYBEG_EQUAL(made.status, 0, made.err.constData());
        const auto tau = [&](const QStringList& arguments) {
            const QJsonObject json = json_of(run_cli(arguments, folder_.path()));
            return json["runs"].toArray()[0].toObject()["wave"].toObject()["tau_s"].toObject();
        };
        const QJsonObject of_samples = tau({"identify", "lock.wav", "-o", "-", "--from", "0.1"});
        const QJsonObject of_log =
            tau({"identify", "lock.phasors.csv", "-o", "-", "--phasors", "fixed", "--y-sign", "+",
                 "--amplitude", "peak", "--lock-in", "4,30"});
        const double sd = of_samples["sd"].toDouble();
        VYBEG_LESS(std::abs(of_log["value"].toDouble() - of_samples["value"].toDouble()), 0.5 * sd);
        VYBEG_LESS(std::abs(of_log["sd"].toDouble() / sd - 1), 0.1);
        for (const QString text : {"4,30", "9,30,200", "4,0,200"}) {
            QCOMPARE(run_cli(decay + QStringList{"--lock-in", text}, folder_.path()).status, 2);
        }
        const Outcome nameless =
            run_cli({"simulate", "-o", "-", "--lock-in", "4,30,200"}, folder_.path());
        QCOMPARE(nameless.status, 2);
    }

    // A gain and an angle of the electrodes that are told count as for samples; what is of samples
    // is named.
    void calibration_of_a_log() {
        QStringList identify{"identify", "-o",        "-",        "--phasors", "fixed",
                             "--f-ref",  "5300.1",    "--y-sign", "+",         "--amplitude",
                             "peak",     "--lock-in", "4,30Hz"};
        for (int k = 0; k < runs; ++k) {
            const QString name = QString("fixed%1.csv").arg(k);
            write(name, log_of(folder_.filePath(QString::number(k) + ".npy"), {4, 30, 150},
                               Frame::fixed, 1, 1));
            identify << name;
        }
        // Empty where the command fails.
        const auto resonator = [&](const QStringList& more) {
            return json_of(run_cli(identify + more, folder_.path()))["resonator"].toObject();
        };
        const auto value = [](const QJsonObject& of, const QString& name) {
            return of[name].toObject()["value"].toDouble();
        };
        const QJsonObject as_it_is = resonator({});
        const QJsonObject turned = resonator({"--angle-zero", "10"});
        const double sd = as_it_is["theta_w_rad"].toObject()["sd"].toDouble();
        VYBEG_CLOSE(value(as_it_is, "theta_w_rad") - value(turned, "theta_w_rad"), pi / 18, 2 * sd);
        const QJsonObject told = resonator({"--kappa", "0.8", "--tolerance", "kappa=0.5"});
        VYBEG_CLOSE(value(told, "theta_w_rad"), value(as_it_is, "theta_w_rad"), 2 * sd);
        VYBEG_CLOSE(value(told, "kappa"), 1, 0.002);
        const Outcome idle = run_cli(identify + QStringList{"--window", "600"}, folder_.path());
        QVERIFY2(idle.err.contains("--window has no effect: a log holds no samples"),
                 idle.err.constData());
    }

    void analyze_writes_the_track_of_a_log() {
        write("track_of.csv", log_of(folder_.filePath("0.npy"), {4, 30, 150}, Frame::fixed, 1, 1));
        const QStringList analyze{"analyze",     "track_of.csv", "-o",     "-",        "--phasors",
                                  "fixed",       "--f-ref",      "5300.1", "--y-sign", "+",
                                  "--amplitude", "peak"};
        const Outcome run = run_cli(analyze, folder_.path());
        VYBEG_EQUAL(run.status, 0, run.err.constData());
        QVERIFY(run.out.contains("# phasors: fixed\n"));
        QVERIFY(run.out.contains("# y_sign: +\n"));
        QVERIFY(!run.out.contains("# algorithm"));
        // 20 s in windows of 15 ms or more.
        VYBEG_WITHIN(run.out.count('\n'), 1500, 100);
        QCOMPARE(run_cli(analyze + QStringList{"--offset", "auto"}, folder_.path())
                     .err.count("--offset has no effect"),
                 1);
        const Outcome untold =
            run_cli({"analyze", "track_of.csv", "-o", "-", "--phasors", "fixed"}, folder_.path());
        QCOMPARE(untold.status, 2);
        QVERIFY(untold.out.isEmpty());
    }

    // A moved part of a log, whose first seconds are those of a hand.
    void part_of_a_log() {
        QByteArray log = log_of(folder_.filePath("0.npy"), {4, 30, 150}, Frame::fixed, 1, 1);
        QList<QByteArray> lines = log.split('\n');
        for (qsizetype k = 1; k < 400; ++k) {
            lines[k] = lines[k].left(lines[k].indexOf(',')) + ",9,9,9,9";
        }
        write("hand.csv", lines.join('\n'));
        const QStringList choice{"identify", "hand.csv", "-o",       "-", "--phasors",   "fixed",
                                 "--f-ref",  "5300.1",   "--y-sign", "+", "--amplitude", "peak"};
        const Outcome read = run_cli(choice + QStringList{"--from", "2"}, folder_.path());
        VYBEG_EQUAL(read.status, 0, read.err.constData());
        const QJsonObject wave = json_of(read)["runs"].toArray()[0].toObject()["wave"].toObject();
        VYBEG_LESS(std::abs(wave["tau_s"].toObject()["value"].toDouble() - 60), 2.0);
        const Outcome none = run_cli(choice + QStringList{"--from", "200"}, folder_.path());
        QCOMPARE(none.status, 4);
        QVERIFY2(none.err.contains("200"), none.err.constData());
    }

    void the_phase_of_a_moving_oscillator_is_not_guessed() {
        QByteArray log =
            log_of(folder_.filePath("0.npy"), {4, 30, 150}, Frame::common_frequency, 1, 1);
        QList<QByteArray> lines = log.split('\n');
        lines.remove(1000, 30);
        write("gap.csv", lines.join('\n'));
        const Outcome refused = run_cli(
            {"identify", "gap.csv", "--phasors", "common", "--y-sign", "+", "--amplitude", "peak"},
            folder_.path());
        QCOMPARE(refused.status, 2);
        QVERIFY2(refused.err.contains("--from or --to"), refused.err.constData());
    }

    void what_no_data_show_is_asked_for_data() {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QString>("asked");
        const QStringList whole{"--phasors", "fixed", "--f-ref",     "5300.1",
                                "--y-sign",  "+",     "--amplitude", "peak"};
        QTest::newRow("sign") << QStringList{"--phasors", "fixed", "--f-ref", "5300.1"}
                              << "--y-sign + or -";
        QTest::newRow("peak") << whole.mid(0, 6) << "--amplitude peak or rms";
        QTest::newRow("reference")
            << QStringList{"--phasors", "fixed"} + whole.mid(4) << "give --f-ref";
        QTest::newRow("oscillator")
            << QStringList{"--phasors", "common"} + whole.mid(4) << "frequency or phase";
        QTest::newRow("phases") << QStringList{"--phasors", "pll"} + whole.mid(2) << "Pc";
        QTest::newRow("frame") << QStringList{"--phasors", "moving"} << "fixed, common or pll";
        QTest::newRow("order") << whole + QStringList{"--lock-in", "9,20"} << "from 1 to 8";
        QTest::newRow("alone") << QStringList{"--y-sign", "+"} << "--phasors";
    }
    void what_no_data_show_is_asked_for() {
        QFETCH(QStringList, options);
        QFETCH(QString, asked);
        QFile file(folder_.filePath("asked.csv"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(log_of(folder_.filePath("0.npy"), {4, 30, 150}, Frame::fixed, 1, 1));
        file.close();
        const Outcome refused =
            run_cli(QStringList{"identify", "asked.csv"} + options, folder_.path());
        QVERIFY2(refused.status == 2 || refused.status == 3, refused.err.constData());
        QVERIFY2(refused.err.contains(asked.toUtf8()), refused.err.constData());
    }

    // 0.15 phasors a second of a split of 0.05 Hz.
    void phasors_that_fold_are_refused() {
        QFile file(folder_.filePath("slow.csv"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("t,Xc,Yc,Xd,Yd\n");
        for (int k = 0; k < 400; ++k) {
            const double t = 6.7 * k;
            const Complex p = std::polar(std::exp(-t / 4000), 2 * pi * 0.025 * t + 0.3);
            const Complex q = std::polar(0.6 * std::exp(-t / 4000), -2 * pi * 0.025 * t);
            const Complex c = std::cos(0.3) * p - std::sin(0.3) * q;
            const Complex d = std::sin(0.3) * p + std::cos(0.3) * q;
            for (const double value : {t, c.real(), c.imag(), d.real()}) {
                file.write(QByteArray::number(value + 1e-5 * std::sin(1e4 * t), 'g', 15) + ',');
            }
            file.write(QByteArray::number(d.imag(), 'g', 15) + '\n');
        }
        file.close();
        const Outcome refused = run_cli({"identify", "slow.csv", "--phasors", "fixed", "--f-ref",
                                         "5300", "--y-sign", "+", "--amplitude", "peak"},
                                        folder_.path());
        QCOMPARE(refused.status, 4);
        QVERIFY2(refused.err.contains("less than four times the split"), refused.err.constData());
    }

    // A real Moku Pro phasemeter, 37.25 Hz.
    void the_phase_of_a_phasemeter_is_no_time() {
        const QString data = qEnvironmentVariable("VYBEG_REAL_DATA");
        const QString zip = data + "/phasemeter.csv.zip";
        if (data.isEmpty() || !QFile::exists(zip)) {
            qWarning("VYBEG_REAL_DATA is not set: NO REAL PHASEMETER IS TESTED.");
            QSKIP("no real data");
        }
        QProcess unzip;
        unzip.start("python3", {"-m", "zipfile", "-e", zip, folder_.path()});
        QVERIFY(unzip.waitForFinished());
        const QString csv = "MokuPhasemeterData_MokuProTest.csv";
        for (const char* command : {"info", "identify"}) {
            const Outcome refused = run_cli({command, csv}, folder_.path());
            QCOMPARE(refused.status, 3);
            QVERIFY2(refused.err.contains("it holds phasors"), refused.err.constData());
        }
        const Outcome read = run_cli({"identify", zip, "-o", "-", "--phasors", "pll", "--y-sign",
                                      "+", "--amplitude", "peak"},
                                     folder_.path());
        VYBEG_EQUAL(read.status, 0, read.err.constData());
        const QJsonObject run = json_of(read)["runs"].toArray()[0].toObject();
        const double f_hz = run["wave"].toObject()["f_hz"].toObject()["value"].toDouble();
        VYBEG_LESS(std::abs(f_hz - 250000.0176), 1e-3);
        const QJsonObject input = json_of(read)["inputs"].toArray()[0].toObject();
        VYBEG_LESS(std::abs(input["rate_hz"].toDouble() - 37.2529), 1e-3);
    }

private:
    void write(const QString& name, const QByteArray& text) const {
        QFile file(folder_.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) {
            qFatal("no file");
        }
    }

    // Of the samples that the phasors of a log show.
    QJsonObject resonator_of_samples(const LockIn& lock_in) const {
        const double delay_s = lock_in.order * lock_in.tau_s();
        const double from_s =
            static_cast<double>(lock_in.settling()) * lock_in.samples / rate_hz - delay_s;
        QStringList arguments{"identify",
                              "--rate",
                              "33333",
                              "-o",
                              "-",
                              "--from",
                              QString::number(from_s),
                              "--to",
                              QString::number(seconds - delay_s)};
        for (int k = 0; k < runs; ++k) {
            arguments << QString::number(k) + ".npy";
        }
        return json_of(run_cli(arguments, folder_.path()))["resonator"].toObject();
    }

    QTemporaryDir folder_;
};

VYBEG_TEST(TestCliPhasors)

}  // namespace test_cli_phasors

#include "test_cli_phasors.moc"
