#include "core/analysis/setting_table.h"
#include "core/base/number_text.h"
#include "core/output/track_file.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <random>

namespace test_track_csv {

using namespace vybeg;

namespace {

const QByteArray names =
    "t_s,a_A,a_B,two_theta_A_rad,alpha_rad,f_Hz,delta_phi_CD_rad,rms,sd_a_A,sd_a_B,"
    "sd_two_theta_A_rad,sd_alpha_rad,sd_f_Hz,flag";

QList<QByteArray> written(const Track& track, const std::vector<std::string>& header) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("track.csv");
    auto file = OutputFile::create(path.toStdString(), {});
    if (!file || !write_track(*file, TrackFormat::csv, track, header, {}) || !file->commit()) {
        return {};
    }
    QFile read(path);
    return read.open(QIODevice::ReadOnly) ? read.readAll().split('\n') : QList<QByteArray>{};
}

class Empty : public SampleSource {
public:
    std::int64_t frames() const override { return 0; }
    Status read(std::int64_t, std::span<double>, std::span<double>) const override { return {}; }
};

}  // namespace

class TestTrackCsv : public QObject {
    Q_OBJECT

private slots:
    void a_row_holds_the_columns_of_the_interface_in_their_order() {
        Track track(1);
        track.time_s()[0] = 0.5;
        double number = 1;
        for (const SlowVariable variable :
             {SlowVariable::a_A, SlowVariable::a_B, SlowVariable::two_theta_A, SlowVariable::alpha,
              SlowVariable::f, SlowVariable::delta_phi_CD, SlowVariable::rms}) {
            track.values(variable)[0] = number++;
        }
        for (const SlowVariable variable :
             {SlowVariable::a_A, SlowVariable::a_B, SlowVariable::two_theta_A, SlowVariable::alpha,
              SlowVariable::f}) {
            track.sds(variable)[0] = number++;
        }
        track.flags()[0] = Flag::gap | Flag::not_converged;
        QCOMPARE(written(track, {"first", "a line\nbroken"}),
                 (QList<QByteArray>{"# first", "# a line broken", names,
                                    "0.5,1,2,3,4,5,6,7,8,9,10,11,12,gap;not-converged", ""}));
    }

    void a_missing_value_is_nan_and_no_flag_is_empty() {
        Track track(1);
        track.time_s()[0] = 0;
        track.values(SlowVariable::a_A)[0] = -std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(
            written(track, {}),
            (QList<QByteArray>{names, "0,nan,nan,nan,nan,nan,nan,nan,nan,nan,nan,nan,nan,", ""}));
    }

    void every_number_reads_back_as_the_same_double() {
        std::mt19937_64 engine(7);
        Track track(20000);  // more rows than one block
        const auto any = [&engine] {
            double number = std::nan("");
            while (!std::isfinite(number)) {
                const std::uint64_t bits = engine();
                std::memcpy(&number, &bits, sizeof number);
            }
            return number;
        };
        for (std::size_t row = 0; row < track.rows(); ++row) {
            track.time_s()[row] = any();
            track.values(SlowVariable::f)[row] = any();
            track.sds(SlowVariable::f)[row] = any();
        }
        const QList<QByteArray> lines = written(track, {});
        QCOMPARE(lines.size(), 20002);
        for (std::size_t row = 0; row < track.rows(); ++row) {
            const QList<QByteArray> fields = lines[static_cast<qsizetype>(row) + 1].split(',');
            QCOMPARE(fields.size(), 14);
            QCOMPARE(parse_number(fields[0].toStdString()), track.time_s()[row]);
            QCOMPARE(parse_number(fields[5].toStdString()), track.values(SlowVariable::f)[row]);
            QCOMPARE(parse_number(fields[12].toStdString()), track.sds(SlowVariable::f)[row]);
        }
    }

    void rows_written_before_their_header_make_the_same_file() {
        Track whole;
        std::mt19937_64 engine(3);
        std::uniform_real_distribution<double> any(-1, 1);
        const QTemporaryDir folder;
        const QString path = folder.filePath("track.csv");
        const QString before = QDir::currentPath();
        QVERIFY(QDir::setCurrent(folder.path()));
        auto file = OutputFile::create("track.csv", {});  // a name without a folder
        QVERIFY(file);
        TrackSpool spool(*file, {});
        for (int piece = 0; piece < 30; ++piece) {  // 9 MB: more than the spool keeps in memory
            Track rows(3000);
            std::ranges::generate(rows.time_s(), [&] { return any(engine); });
            for (const SlowVariable variable : all_slow_variables) {
                std::ranges::generate(rows.values(variable), [&] { return any(engine); });
            }
            for (std::size_t row = 0; row < rows.rows(); row += 7) {
                rows.flags()[row] = Flag::no_quadrature | Flag::at_bound;
            }
            QVERIFY(spool.append(rows));
            whole.append(rows);
        }
        // Besides the file's own temporary, nothing with a name.
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 1);
        const std::vector<std::string> header{"known", "at the end"};
        // Every row of the middle third and, twice over, some in the last piece.
        const std::vector<FlaggedRows> flagged{
            {30000, 30000, Flag::clipped}, {88000, 1500, Flag::gap}, {89000, 5000, Flag::clipped}};
        set_flags(whole.flags(), 0, flagged);
        spool.set_flagged(flagged);
        QVERIFY(write_track(*file, TrackFormat::csv, spool, header, {}));
        QVERIFY(file->commit());
        QVERIFY(QDir::setCurrent(before));
        QFile read(path);
        QVERIFY(read.open(QIODevice::ReadOnly));
        QVERIFY(read.readAll() == written(whole, header).join('\n'));
    }

    void the_header_names_program_input_settings_carrier_and_warnings() {
        Recording recording;
        recording.path = "/some/where/demo.wav";
        recording.rate_hz = 33333;
        recording.rate_from = RateOrigin::option;
        recording.source = std::make_shared<Empty>();
        Analysis analysis;
        analysis.settings.f0_hz = 5300.25;
        analysis.settings.window = 63;
        analysis.settings.hop = 10;
        analysis.settings.algorithm = Algorithm::phase_shift;
        analysis.settings.filter = Band{4000, 6000.5};
        analysis.settings.initial = StartValues{{1, -0.5, 0.25, 3}, 5300};
        analysis.settings.start = StartRule::previous;
        analysis.settings.calibration.offset_d = -0.125;
        analysis.residual = 0.5;
        analysis.diagnostics = {{DiagnosticKind::filter_transients, {"0.25"}}};
        const std::vector<std::string> expected{
            "vybeg-cli 1.2.3",
            "input: demo.wav",
            "sha256: abc",
            "rate: 33333 (option)",
            "channels: 1,2",
            "algorithm: phase-shift",
            "window: 63",
            "periods: none",
            "snap: no",
            "hop: 10",
            "f0: 5300.25",
            "initial: 1,-0.5,0.25,3,5300",
            "start: previous",
            "from: none",
            "to: none",
            "band: none",
            "filter: 4000,6000.5",
            "kappa: 1",
            "offset: 0,-0.125",
            "delay: 0",
            "angle-zero: 0",
            "repair-lost: no",
            "f0_Hz: 5300.25",
            "residual: 0.5",
            "note: The band-pass takes 0.25 s at each end for its transient; those windows are "
            "flagged."};
        QCOMPARE(track_header("vybeg-cli 1.2.3", recording, "abc", analysis), expected);
    }

    void settings_that_are_not_numbers_have_their_own_words() {
        Settings settings;
        settings.calibration.offset_auto = true;
        settings.snap = true;
        settings.periods = 10.5;
        const auto list = settings_list(settings);
        const auto value = [&list](const std::string& name) {
            const auto found = std::ranges::find(list, name, &NamedValue::first);
            return found == list.end() ? "(not there)" : found->second;
        };
        QCOMPARE(value("offset"), std::string("auto"));
        QCOMPARE(value("snap"), std::string("yes"));
        QCOMPARE(value("periods"), std::string("10.5"));
        QCOMPARE(value("hop"), std::string("window"));
        QCOMPARE(value("f0"), std::string("none"));
        QCOMPARE(value("threads"), std::string("(not there)"));
    }

    void the_article_s_155554_rows_take_little_longer_than_their_digits() {
        Track track(155554);
        std::mt19937_64 engine(1);
        std::uniform_real_distribution<double> any(-1, 1);
        for (const SlowVariable variable : all_slow_variables) {
            std::ranges::generate(track.values(variable), [&] { return any(engine); });
            std::ranges::generate(track.sds(variable), [&] { return any(engine); });
        }
        // Processor time, so that a busy machine does not count.
        const auto least_of_three = [](const auto& use) {
            std::clock_t least = std::numeric_limits<std::clock_t>::max();
            for (int i = 0; i < 3; ++i) {
                const std::clock_t begun = std::clock();
                use();
                least = std::min(least, std::clock() - begun);
            }
            return static_cast<double>(least) / CLOCKS_PER_SEC;
        };
        const double whole = least_of_three([&] {
            auto file = OutputFile::create("/dev/null", {});
            QVERIFY(file && write_track(*file, TrackFormat::csv, track, {}, {}) && file->commit());
        });
        std::size_t digits = 0;
        const double peer = least_of_three([&] {
            std::array<char, 32> text{};
            for (const SlowVariable variable : all_slow_variables) {
                for (const auto& values : {track.values(variable), track.sds(variable)}) {
                    for (const double value : values) {
                        const auto end = std::to_chars(text.begin(), text.end(), value,
                                                       std::chars_format::general, 12);
                        digits += static_cast<std::size_t>(end.ptr - text.data());
                    }
                }
            }
        });
        VYBEG_MORE(digits, 0);
        VYBEG_LESS(whole, 3 * peer);
        qInfo("%.3f s, digits alone %.3f s", whole, peer);
    }
};

VYBEG_TEST(TestTrackCsv, threads)

}  // namespace test_track_csv

#include "test_track_csv.moc"
