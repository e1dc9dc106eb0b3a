// A recording with a file for each channel through the commands: the same numbers as from one file.
#include "tests/app/cli_run.h"
#include "tests/closeness.h"
#include "tests/data/trade_files.h"
#include "tests/test_registry.h"

#include <QJsonArray>
#include <QtTest>

namespace test_cli_channel_files {

using namespace vybeg::test;

class TestCliChannelFiles : public QObject, private CliFolder {
    Q_OBJECT

private:
    // What an identification says of the modes.
    static QJsonValue modes(const QByteArray& json) { return object(json)["modes"]; }

    static void same_modes(const QByteArray& one, const QByteArray& other) {
        QCOMPARE(modes(one).toArray().size(), 2);
        for (int k = 0; k < 2; ++k) {
            const auto f_hz = [k](const QByteArray& json) {
                return modes(json)[k]["f_hz"]["value"].toDouble();
            };
            // The samples are rounded to 32 bits.
            VYBEG_CLOSE(f_hz(one), f_hz(other), 1e-5);
        }
    }

private slots:
    void initTestCase() {
        QCOMPARE(
            run("simulate -o run.csv --seconds 6 --split 0.3 --theta-w 0.3 --noise 1e-4 --seed 5")
                .status,
            0);
        std::vector<double> c;
        std::vector<double> d;
        for (const QByteArray& line : file("run.csv").split('\n')) {
            const QList<QByteArray> fields = line.split(',');
            if (fields.size() == 3 && fields[0] != "t_s" && !line.startsWith('#')) {
                c.push_back(fields[1].toDouble());
                d.push_back(fields[2].toDouble());
            }
        }
        VYBEG_MORE(c.size(), 100000);
        QVERIFY(put(path("sig0001.ana"), QByteArray::fromStdString(zetlab_ana(c, 1e-6))));
        QVERIFY(put(path("sig0002.ana"), QByteArray::fromStdString(zetlab_ana(d, 1e-6))));
        for (const char* name : {"sig0001.anp", "sig0002.anp"}) {
            QVERIFY(put(path(name), QByteArray::fromStdString(zetlab_anp(33333, 1e-6, name, "V"))));
        }
        QCOMPARE(run("identify run.csv -o whole.json --threads 1").status, 0);
    }

    void two_files_give_the_split_of_one() {
        const Outcome outcome =
            run("identify sig0001.ana --channel-d sig0002.ana -o pair.json --threads 1");
        QCOMPARE(outcome.status, 0);
        same_modes(file("whole.json"), file("pair.json"));
    }

    void a_list_names_the_other_file_from_its_own_folder() {
        QVERIFY(QDir(folder_.path()).mkpath("lists"));
        QVERIFY(put(path("lists/list.csv"), "file,channel-d\n../sig0001.ana,../sig0002.ana\n"));
        const Outcome outcome = run("identify --list lists/list.csv -o list.json --threads 1");
        QCOMPARE(outcome.status, 0);
        same_modes(file("pair.json"), file("list.json"));
        // The hash is that of both.
        const auto sha256 = [](const QByteArray& json) {
            return object(json)["inputs"][0]["sha256"].toString();
        };
        QCOMPARE(sha256(file("list.json")), sha256(file("pair.json")));
        QCOMPARE(
            object(run("info --json sig0001.ana --channel-d sig0002.ana").out)["sha256"].toString(),
            sha256(file("pair.json")));
    }

    void one_file_alone_names_the_other() {
        const Outcome outcome = run("info sig0001.ana");
        QCOMPARE(outcome.status, 3);
        QVERIFY2(outcome.err.contains("--channel-d sig0002.ana."), outcome.err);
    }

    void a_part_belongs_to_one_recording_once() {
        const Outcome several = run("identify sig0001.ana run.csv --channel-d sig0002.ana");
        QCOMPARE(several.status, 2);
        QVERIFY2(several.err.contains("it would belong to several recordings"), several.err);
        QCOMPARE(run("identify run.csv whole.csv --join more.csv").status, 2);
        const Outcome same = run("info sig0001.ana --channel-d ./sig0001.ana");
        QCOMPARE(same.status, 2);
        QVERIFY2(same.err.contains("it is the channel that is read as C"), same.err);
        QCOMPARE(run("info run.csv --channel-d run.csv").status, 0);  // another column of it
        const Outcome twice = run("info run.csv --join ./run.csv");
        QCOMPARE(twice.status, 2);
        QVERIFY2(twice.err.contains("it is a piece already"), twice.err);
    }

    void values_take_units() {
        const QString analyze = "analyze run.csv -o - --quiet --window 600 ";
        const auto rows = [](const QByteArray& track) {
            return track.mid(track.indexOf("\nt_s,"));
        };
        const Outcome plain = run(analyze + "--from 1 --to 1.25 --delay 2.5e-6 --f0 5300");
        const Outcome units = run(analyze + "--from 1000ms --to 1.25s --delay 2.5us --f0 5.3kHz");
        QCOMPARE(plain.status, 0);
        QCOMPARE(units.status, 0);
        QCOMPARE(rows(units.out), rows(plain.out));
        for (const char* micro : {"2.5µs", "2.5μs"}) {
            const Outcome other =
                run(analyze + "--from 1 --to 1.25 --f0 5300 --delay " + QString::fromUtf8(micro));
            QCOMPARE(other.status, 0);
            QCOMPARE(rows(other.out), rows(plain.out));
        }
        const Outcome wrong = run(analyze + "--from 1kHz");
        QCOMPARE(wrong.status, 2);
        QVERIFY2(wrong.err.contains("in s or with its unit"), wrong.err);
    }
};

VYBEG_TEST(TestCliChannelFiles)

}  // namespace test_cli_channel_files

#include "test_cli_channel_files.moc"
