// Logs of a lock-in and a phasemeter as laboratories have them, as a process.
#include "tests/app/phasor_logs.h"
#include "tests/closeness.h"
#include "tests/core/recording/python_script.h"
#include "tests/test_registry.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonObject>
#include <QProcess>
#include <QtTest>

#include <cmath>
#include <random>

namespace test_cli_phasor_files {

using namespace vybeg::test;

class TestCliPhasorFiles : public PhasorLogTest {
    Q_OBJECT

private slots:
    void initTestCase() { simulate_runs(); }

    // LabOne: a file of each demodulator, times in ticks, whose clock stands in a file beside.
    void ticks_of_labone_are_seconds() {
        const double clockbase = 6e7;
        const LockIn lock_in{4, 30, 150};
        const QByteArray both = log_of_run(0, lock_in, Frame::fixed);
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
        const QStringList choice = words("--phasors fixed --y-sign + --amplitude peak -o -");
        const QStringList demods = words(
            "identify dev1_demods_0_sample_00000.csv --channel-d dev1_demods_1_sample_00000.csv");
        const Outcome refused = run(demods + choice);
        QCOMPARE(refused.status, 3);
        QVERIFY2(refused.err.contains("--rate"), refused.err);
        const Outcome as_samples = run(words("info dev1_demods_0_sample_00000.csv"));
        QCOMPARE(as_samples.status, 3);
        QVERIFY2(as_samples.err.contains("it holds phasors"), as_samples.err);
        const auto wave = [&](const QStringList& arguments) {
            const Outcome read = run(arguments);
            if (read.status != 0) {
                qWarning("%s", read.err.constData());
            }
            return json_of(read)["runs"][0]["wave"].toObject();
        };
        const QJsonObject told = wave(words("identify plain.csv --f-ref 5300.1") + choice);
        write("dev1_demods_0_sample_header_00000.csv", "chunk;clockbase;name\n0;60000000;demod\n");
        write("dev1_demods_1_sample_header_00000.csv", "chunk;clockbase;name\n0;60000000;demod\n");
        QStringList other = demods + choice;
        for (const QJsonObject& found : {wave(other), wave(other << "--rate"
                                                                 << "222.22")}) {
            for (const QString name : {"f_hz", "tau_s"}) {
                const QJsonObject expected = told[name].toObject();
                VYBEG_LESS(std::abs(found[name]["value"].toDouble() - expected["value"].toDouble()),
                           expected["sd"].toDouble() * 0.1);
            }
        }
        const Outcome another = run(demods + choice + words("--rate 100"));
        QCOMPARE(another.status, 2);
        QVERIFY2(another.err.contains("rows a second"), another.err);
    }

    // LabOne's long form: a line for each field, with its values side by side.
    void fields_of_labone_stand_in_lines() {
        const QByteArray both = log_of_run(0, {4, 30, 150}, Frame::fixed);
        write("lines.csv", both);
        for (const int channel : {0, 1}) {
            QByteArray x = "0;700000000000;100000;x";
            QByteArray y = "0;700000000000;100000;y";
            QByteArray ticks = "0;700000000000;100000;timestamp";
            for (const QByteArray& line : both.split('\n').mid(1)) {
                const QList<QByteArray> f = line.split(',');
                if (f.size() >= 5) {
                    x += ';' + f[1 + 2 * channel];
                    y += ';' + f[2 + 2 * channel];
                    ticks +=
                        ';' + QByteArray::number(7e11 + std::round(f[0].toDouble() * 6e7), 'f', 0);
                }
            }
            write(QString("dev1_demods_%1_long.csv").arg(channel),
                  "chunk;timestamp;size;fieldname;v0\n" + x + '\n' + y + '\n' + ticks + '\n');
        }
        const Outcome as_samples = run(words("info dev1_demods_0_long.csv"));
        QCOMPARE(as_samples.status, 3);
        QVERIFY2(as_samples.err.contains("it holds phasors"), as_samples.err);
        const QStringList choice =
            words("identify -o - --phasors fixed --f-ref 5300.1 --y-sign + --amplitude peak");
        const auto tau = [&](const QStringList& files) {
            const Outcome read = run(choice + files);
            if (read.status != 0) {
                qWarning("%s", read.err.constData());
            }
            return json_of(read)["runs"][0]["wave"]["tau_s"].toObject();
        };
        const QJsonObject told = tau({"lines.csv"});
        const QJsonObject found = tau({"dev1_demods_0_long.csv", "--channel-d",
                                       "dev1_demods_1_long.csv", "--rate", "222.22"});
        VYBEG_CLOSE(found["value"].toDouble(), told["value"].toDouble(),
                    0.1 * told["sd"].toDouble());
    }

    // The rest of the longer one was left out without a word.
    void a_channel_that_ends_earlier_is_told() {
        QByteArray c = "t,X,Y\n";
        for (int k = 0; k < 400; ++k) {
            const double t = 0.01 * k;
            const double a = std::exp(-t / 40);
            c += QByteArray::number(t, 'f', 2) + ',' +
                 QByteArray::number(a * std::cos(0.3 * t), 'g', 9) + ',' +
                 QByteArray::number(0.1 * a, 'g', 9) + '\n';
        }
        write("long_C.csv", c);
        write("long_D.csv", c.left(c.size() / 2).append('\n'));
        const Outcome read =
            run("identify long_C.csv --channel-d long_D.csv --phasors fixed --f-ref 5300 --y-sign "
                "+ --amplitude peak --verbose");
        QVERIFY2(read.err.contains("differ in length: long_C.csv has 400 samples, long_D.csv has "),
                 read.err);
    }

    // Seconds since 1970, and a reference in kilohertz.
    void a_clock_may_count_from_an_epoch() {
        const QByteArray from_zero = log_of_run(0, {4, 30, 150}, Frame::fixed);
        write("zero.csv", from_zero);
        const QJsonObject usual = json_of(identify_fixed({"zero.csv"}, {"--lock-in", "4,30Hz"}));
        QByteArray log = "t (s),Xc,Yc,Xd,Yd,F (kHz)\n";
        for (const QByteArray& line : from_zero.split('\n').mid(1)) {
            const qsizetype comma = line.indexOf(',');
            if (comma > 0) {
                log += QByteArray::number(1.7e9 + line.left(comma).toDouble(), 'f', 6) +
                       line.mid(comma) + ",5.3001\n";
            }
        }
        write("epoch.csv", log);
        const Outcome found = run(
            "identify -o - epoch.csv --phasors fixed --y-sign + --amplitude peak --lock-in 4,30");
        const QJsonObject wave = json_of(found)["runs"][0].toObject()["wave"].toObject();
        const QJsonObject as_usual = usual["runs"][0].toObject()["wave"].toObject();
        for (const char* name : {"f_hz", "tau_s"}) {
            const double value = as_usual[name].toObject()["value"].toDouble();
            VYBEG_WITHIN(wave[name].toObject()["value"].toDouble(), value, 1e-6 * value);
        }
        QCOMPARE(
            run("identify epoch.csv --join zero.csv --phasors fixed --y-sign + --amplitude peak")
                .status,
            2);
    }

    void the_phase_of_a_moving_oscillator_is_not_guessed() {
        QByteArray log = log_of_run(0, {4, 30, 150}, Frame::common_frequency);
        QList<QByteArray> lines = log.split('\n');
        lines.remove(1000, 30);
        write("gap.csv", lines.join('\n'));
        const Outcome refused =
            run("identify gap.csv --phasors common --y-sign + --amplitude peak");
        QCOMPARE(refused.status, 2);
        QVERIFY2(refused.err.contains("--from or --to"), refused.err);
    }

    // A beat of 0.8 Hz behind a filter of 0.5 Hz, whose delay is longer than a second.
    void a_fast_beat_behind_a_slow_filter() {
        QStringList samples;
        QStringList logs;
        const LockIn slow{4, 0.5, 600};
        for (int k = 0; k < runs; ++k) {
            const QString name = QString("beat%1").arg(k);
            QCOMPARE(run({"simulate", "-o", name + ".npy", "--seconds", "40", "--split", "0.8",
                          "--theta-w", "0.2", "--tau", "60", "--noise", "0.001", "--f0", "5300.1",
                          "--seed", QString::number(k + 30), "--two-theta-A",
                          QString::number(0.2 + k * pi / 4)})
                         .status,
                     0);
            write(name + ".csv", log_of(path(name + ".npy"), slow, Frame::fixed, 1, 1));
            samples << name + ".npy";
            logs << name + ".csv";
        }
        const QJsonObject found = json_of(identify_fixed(logs, {"--lock-in", "4,0.5Hz"}));
        const QJsonObject split = found["resonator"]["split_hz"].toObject();
        const double sd = split["sd"].toDouble();
        VYBEG_WITHIN(split["value"].toDouble(), 0.8, 3 * sd);
        // What the noise of the samples gives, and the filter leaves.
        VYBEG_LESS(sd, 2e-4);
        const QJsonObject axis = found["resonator"]["theta_w_rad"].toObject();
        VYBEG_WITHIN(axis["value"].toDouble(), 0.2, 3 * axis["sd"].toDouble());
    }

    // Rows that are missing, twice there, or in other units change the noise of no other row.
    void missing_rows_and_unlike_units() {
        const QByteArray log = log_of_run(0, {4, 30, 150}, Frame::fixed);
        write("all.csv", log);
        QList<QByteArray> lines = log.split('\n');
        QList<QByteArray> some;
        QList<QByteArray> milli{"t,Xc (V),Yc (V),Xd (mV),Yd (mV)"};
        for (qsizetype k = 1; k + 1 < lines.size(); ++k) {
            if (k % 40 != 7) {
                some << lines[k];
            }
            if (k % 300 == 0) {
                some << lines[k];
            }
            QList<QByteArray> fields = lines[k].split(',');
            for (const int d : {3, 4}) {
                fields[d] = QByteArray::number(1000 * fields[d].toDouble(), 'g', 15);
            }
            milli << fields.join(',');
        }
        write("some.csv", lines[0] + '\n' + some.join('\n') + '\n');
        write("milli.csv", milli.join('\n') + '\n');
        const auto wave = [this](const QString& file) {
            const Outcome read = identify_fixed({file}, {"--lock-in", "4,30Hz"});
            if (read.status != 0) {
                qFatal("%s", read.err.constData());
            }
            return json_of(read)["runs"][0].toObject();
        };
        const QJsonObject all = wave("all.csv");
        const double tau = all["wave"]["tau_s"]["value"].toDouble();
        const double sd = all["wave"]["tau_s"]["sd"].toDouble();
        for (const QString file : {"some.csv", "milli.csv"}) {
            const QJsonObject found = wave(file);
            VYBEG_WITHIN(found["noise_sd"].toDouble() / all["noise_sd"].toDouble(), 1, 0.1);
            const QJsonObject its = found["wave"]["tau_s"].toObject();
            VYBEG_WITHIN(its["value"].toDouble(), tau, sd);
            VYBEG_WITHIN(its["sd"].toDouble() / sd, 1, 0.1);
        }
    }

    // A phase column counts from a reference that the frequency beside it tells.
    void the_reference_stands_behind_phase_and_frequency() {
        const QByteArray log = log_of_run(0, {4, 30, 150}, Frame::common_phase);
        QList<QByteArray> lines = log.split('\n');
        lines[0] += ",F (Hz)";
        for (qsizetype k = 1; k + 1 < lines.size(); ++k) {
            const double t = lines[k].split(',').front().toDouble();
            lines[k] += ',' + QByteArray::number(f_ref_hz + 0.3 * std::sin(0.5 * t), 'g', 12);
        }
        write("both.csv", lines.join('\n'));
        const Outcome outcome =
            run("identify both.csv -o - --phasors common --y-sign + --amplitude peak");
        VYBEG_EQUAL(outcome.status, 0, outcome.err);
        const QJsonObject f = json_of(outcome)["runs"][0]["wave"].toObject();
        VYBEG_WITHIN(f["f_hz"]["value"].toDouble(), 5300, 0.05);
    }

    // Mixers of unlike sides.
    void a_channel_with_the_other_sign_of_y_is_told() {
        const QByteArray log = log_of_run(0, {4, 30, 150}, Frame::fixed);
        QList<QByteArray> lines = log.split('\n');
        for (qsizetype row = 1; row + 1 < lines.size(); ++row) {
            QList<QByteArray> fields = lines[row].split(',');
            fields[4] = QByteArray::number(-fields[4].toDouble(), 'g', 15);
            lines[row] = fields.join(',');
        }
        write("unlike.csv", lines.join('\n'));
        const Outcome told = identify_fixed({"unlike.csv"}, {"--lock-in", "4,30Hz", "--to", "6"});
        QVERIFY2(told.err.contains("as if Y of one had the other sign"), told.err);
    }

    // An oscillator locked to one channel: what turns of it stands nowhere in the file.
    void a_reference_that_follows_a_channel_is_told_data() {
        QTest::addColumn<bool>("of_d");
        QTest::newRow("C") << false;
        QTest::newRow("D") << true;
    }
    void a_reference_that_follows_a_channel_is_told() {
        QFETCH(bool, of_d);
        const QByteArray log = log_of_run(0, {4, 30, 150}, Frame::fixed);
        QList<QByteArray> lines = log.split('\n');
        Complex loop = 0;
        for (qsizetype row = 1; row + 1 < lines.size(); ++row) {
            QList<QByteArray> fields = lines[row].split(',');
            const Complex c(fields[1].toDouble(), fields[2].toDouble());
            const Complex d(fields[3].toDouble(), fields[4].toDouble());
            // Follows within three rows, and not the noise of each.
            const Complex& followed = of_d ? d : c;
            loop = row == 1 ? followed : loop + (followed - loop) / 3.0;
            const Complex back = std::conj(loop / std::abs(loop));
            const std::vector<double> values{(c * back).real(), (c * back).imag(),
                                             (d * back).real(), (d * back).imag()};
            for (qsizetype k = 0; k < 4; ++k) {
                fields[k + 1] = QByteArray::number(values[static_cast<std::size_t>(k)], 'g', 15);
            }
            lines[row] = fields.join(',');
        }
        write("followed.csv", lines.join('\n'));
        const Outcome told = identify_fixed({"followed.csv"}, {"--lock-in", "4,30Hz"});
        const char* const channel =
            of_d ? "the reference follows channel D" : "the reference follows channel C";
        QVERIFY2(told.err.contains(channel), told.err);
        write("free.csv", log);
        const Outcome free = identify_fixed({"free.csv"}, {"--lock-in", "4,30Hz"});
        QVERIFY2(!free.err.contains("reference follows"), free.err);
    }

    void noise_is_no_wave() {
        QByteArray noise = "t,Xc,Yc,Xd,Yd\n";
        std::mt19937 generator(7);
        std::normal_distribution<double> normal;
        for (int k = 0; k < 6000; ++k) {
            noise += QByteArray::number(0.005 * k, 'g', 9);
            for (int column = 0; column < 4; ++column) {
                noise += ',' + QByteArray::number(normal(generator), 'g', 9);
            }
            noise += '\n';
        }
        write("noise.csv", noise);
        const Outcome refused = identify_fixed({"noise.csv"}, {});
        QCOMPARE(refused.status, 4);
        QVERIFY2(refused.err.contains("noise.csv: no wave stands out of the noise"), refused.err);
        QVERIFY2(refused.err.contains("choose the seconds of the decay"), refused.err);
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
            const Outcome refused = run({command, csv});
            QCOMPARE(refused.status, 3);
            QVERIFY2(refused.err.contains("it holds phasors"), refused.err);
        }
        const Outcome read = run({"identify", zip, "-o", "-", "--phasors", "pll", "--y-sign", "+",
                                  "--amplitude", "peak", "--to", "60"});
        VYBEG_EQUAL(read.status, 0, read.err);
        const QJsonObject run = json_of(read)["runs"][0].toObject();
        const double f_hz = run["wave"]["f_hz"]["value"].toDouble();
        // The mean of the whole log; the frequency wanders by some mHz.
        VYBEG_LESS(std::abs(f_hz - 250000.0176), 3e-3);
        // Means of the file: 0.09134 and 0.09031 V.
        const Outcome track = this->run({"analyze", zip, "-o", "-", "--phasors", "pll", "--y-sign",
                                         "+", "--amplitude", "peak", "--to", "60"});
        VYBEG_EQUAL(track.status, 0, track.err);
        double c = 0;
        double d = 0;
        int rows = 0;
        for (const QByteArray& line : track.out.split('\n')) {
            const QList<QByteArray> f = line.split(',');
            if (line.startsWith('#') || f.size() < 4 || std::isnan(f[3].toDouble())) {
                continue;
            }
            const double a = f[1].toDouble();
            const double b = f[2].toDouble();
            const double angle = f[3].toDouble();
            if (a > 0) {
                c += std::hypot(a * std::cos(angle), b * std::sin(angle));
                d += std::hypot(a * std::sin(angle), b * std::cos(angle));
                ++rows;
            }
        }
        VYBEG_AT_LEAST(rows, 1000);
        VYBEG_CLOSE(c / rows, 0.09134, 2e-5);
        VYBEG_CLOSE(d / rows, 0.09031, 2e-5);
        const QJsonObject input = json_of(read)["inputs"][0].toObject();
        VYBEG_LESS(std::abs(input["rate_hz"].toDouble() - 37.2529), 1e-3);
    }

    // Moku's converter names the columns in MAT, and in NPY none: as it writes them.
    void arrays_of_moku() {
        const LockIn lock_in{4, 30, 150};
        write("moku.csv", log_of_run(0, lock_in, Frame::pll));
        run_python(folder_.path().toStdString(), QStringLiteral(R"(
import scipy.io
log = np.loadtxt('moku.csv', delimiter=',', skiprows=1)
t, xc, yc, xd, yd, pc, pd = log.T
f = np.full(len(t), 5300.1)
data = np.column_stack([t, f, f, pc, xc, yc, f, f, pd, xd, yd])
names = ['Time (s)']
for k in (1, 2):
    names += [f'Input {k} {what}' for what in
              ('Set Frequency (Hz)', 'Frequency (Hz)', 'Phase (cyc)', 'I (V)', 'Q (V)')]
scipy.io.savemat('MokuPhasemeterData.mat', {'moku': {
    'comment': '% Moku:Pro Phasemeter\r\n% ' + ', '.join(names) + '\r\n', 'data': data,
    'legend': np.array(names, dtype=object), 'version': '3.3', 'timestamp': '2026-01-01'}})
header = str({'descr': '<f8', 'fortran_order': False, 'shape': data.shape})
with open('MokuPhasemeterData.npy', 'wb') as out:
    out.write(b'\x93NUMPY\x01\x00' + (86).to_bytes(2, 'little') + header.encode().ljust(85) +
              b'\n' + data.tobytes())
np.save('plain.npy', data)
)"));
        const QStringList choice =
            words("identify -o - --phasors pll --y-sign + --amplitude peak --f-ref 5300.1");
        const auto wave = [&](const QStringList& more) {
            const Outcome read = run(choice + more);
            if (read.status != 0) {
                qWarning("%s", read.err.constData());
            }
            return json_of(read)["runs"][0]["wave"].toObject();
        };
        const QJsonObject told = wave({"moku.csv"});
        for (const QString ending : {"mat", "npy"}) {
            const QString file = "MokuPhasemeterData." + ending;
            const QJsonObject found = wave({file});
            for (const QString name : {"f_hz", "tau_s"}) {
                const double sd = told[name]["sd"].toDouble();
                VYBEG_CLOSE(found[name]["value"].toDouble(), told[name]["value"].toDouble(),
                            0.01 * sd);
            }
            // As recordings they are none.
            const Outcome refused = run({"info", file});
            QCOMPARE(refused.status, 3);
            QVERIFY2(refused.err.contains("it holds phasors"), refused.err);
        }
        // An array of another program has no names: they are told by numbers.
        const Outcome untold = run(choice + QStringList{"plain.npy"});
        QCOMPARE(untold.status, 3);
        QVERIFY2(untold.err.contains("there is no column"), untold.err);
        const QJsonObject found =
            wave(words("plain.npy --columns t=1,Xc=5,Yc=6,Pc=4,Xd=10,Yd=11,Pd=9 --angle-unit cyc"));
        VYBEG_CLOSE(found["tau_s"]["value"].toDouble(), told["tau_s"]["value"].toDouble(),
                    0.01 * told["tau_s"]["sd"].toDouble());
    }

    // /000/dev3000/demods/0/sample/x of HDF5, dev3000.demods(1).sample.x of MAT.
    void variables_of_labone() {
        const LockIn lock_in{4, 30, 150};
        write("plain.csv", log_of_run(0, lock_in, Frame::fixed));
        run_python(folder_.path().toStdString(), QStringLiteral(R"(
import h5py, scipy.io
log = np.loadtxt('plain.csv', delimiter=',', skiprows=1)
ticks = (7e14 + np.round(6e7 * log[:, 0])).astype(np.uint64)
demods = np.zeros((1, 2), dtype=[('sample', object)])
with h5py.File('labone.h5', 'w') as f:
    for d in range(2):
        g = f.create_group(f'000/dev3000/demods/{d}/sample')
        values = {'timestamp': ticks, 'x': log[:, 1 + 2 * d], 'y': log[:, 2 + 2 * d],
                  'frequency': np.full(len(log), 5300.1)}
        for name, value in values.items():
            g[name] = value
        demods[0, d]['sample'] = values
scipy.io.savemat('labone.mat', {'dev3000': {'demods': demods}})
)"));
        const auto wave = [&](const QStringList& arguments) {
            const Outcome read =
                run("identify -o - --phasors fixed --f-ref 5300.1 --y-sign + --amplitude peak",
                    arguments);
            if (read.status != 0) {
                qWarning("%s", read.err.constData());
            }
            return json_of(read)["runs"][0]["wave"].toObject();
        };
        const QJsonObject told = wave({"plain.csv"});
        for (const QString file : {"labone.h5", "labone.mat"}) {
            const QJsonObject found = wave({file, "--rate", "222.22"});
            for (const QString name : {"f_hz", "tau_s"}) {
                const QJsonObject expected = told[name].toObject();
                VYBEG_LESS(std::abs(found[name]["value"].toDouble() - expected["value"].toDouble()),
                           expected["sd"].toDouble() * 0.1);
            }
        }
        const Outcome refused = identify_fixed({"labone.h5"}, {});
        QCOMPARE(refused.status, 3);
        QVERIFY2(refused.err.contains("--rate"), refused.err);
    }
};

VYBEG_TEST(TestCliPhasorFiles)

}  // namespace test_cli_phasor_files

#include "test_cli_phasor_files.moc"
