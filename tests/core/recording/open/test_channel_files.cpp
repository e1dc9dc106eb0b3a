// Recordings of several files: one for each channel, pieces one after the other; and channels with
// times of their own.
#include "core/recording/bytes/sha256.h"
#include "core/recording/samples/reader_rules.h"
#include "core/recording/samples/recording.h"
#include "tests/closeness.h"
#include "tests/core/recording/recording_files.h"
#include "tests/test_registry.h"

#include <functional>
#include <numbers>

namespace test_channel_files {

using namespace vybeg;
using namespace vybeg::test;

namespace {

constexpr double rate = 20000;
constexpr double f0 = 5300;

double signal_c(double t_s) {
    return 0.9 * std::cos(2 * std::numbers::pi * f0 * t_s);
}
double signal_d(double t_s) {
    return 0.4 * std::cos(2 * std::numbers::pi * f0 * t_s - 1.1);
}

// Rows of a time and one or two waves of it.
std::string table(const std::string& names, int rows, double from_s,
                  const std::vector<std::function<double(double)>>& waves,
                  double step_s = 1 / rate) {
    std::string text = names + "\n";
    for (int i = 0; i < rows; ++i) {
        const double t_s = from_s + step_s * i;
        text += QString::number(t_s, 'f', 9).toStdString();
        for (const auto& signal : waves) {
            text += "," + QString::number(signal(t_s), 'f', 9).toStdString();
        }
        text += "\n";
    }
    return text;
}

OpenOptions joined_with(std::initializer_list<std::filesystem::path> paths) {
    OpenOptions options;
    for (const auto& path : paths) {
        options.join.push_back(path.string());
    }
    return options;
}

// C and D at the times of C, but for the frames at both ends that no interpolation reaches.
void check_signals(const Recording& recording, double first_s, std::int64_t reach) {
    const Samples samples = read_all(recording);
    std::int64_t present = 0;
    for (std::size_t i = 0; i < samples.c.size(); ++i) {
        const double t_s = first_s + static_cast<double>(i) / rate;
        if (!std::isnan(samples.d[i])) {
            ++present;
            VYBEG_CLOSE(samples.c[i], signal_c(t_s), 1e-6, "C");
            VYBEG_CLOSE(samples.d[i], signal_d(t_s), 1e-6, "D");
        }
    }
    VYBEG_AT_LEAST(present, recording.frames() - reach);
}

QString sentence(const Result<Recording>& refused) {
    return refused ? QString() : QString::fromStdString(english(refused.error()));
}

}  // namespace

class TestChannelFiles : public QObject {
    Q_OBJECT

private slots:
    void a_file_for_each_channel_is_one_recording() {
        const Folder folder;
        const auto c = folder.write("run_C.csv", table("t,U [V]", 600, 0, {signal_c}));
        const auto d = folder.write(
            "run_D.csv", table("t,U [mV]", 600, 0, {[](double t) { return 1e3 * signal_d(t); }}));
        const Recording recording = opened(c, d_in(d));
        VYBEG_CLOSE_RATIO(recording.rate_hz, rate, 1e-6);
        QCOMPARE(recording.channels, (std::vector<Channel>{{"run_C", "V"}, {"run_D", "mV"}}));
        check_signals(recording, 0, 0);
        QVERIFY(find(recording, DiagnosticKind::unit_converted));
        QCOMPARE(recording.read_with, "--channel-d " + d.string());
    }

    void its_hash_is_that_of_both_files_one_after_the_other() {
        const Folder folder;
        const auto c = folder.write("c.csv", table("t,C", 50, 0, {signal_c}));
        const auto d = folder.write("d.csv", table("t,D", 50, 0, {signal_d}));
        const Recording recording = opened(c, d_in(d));
        QCOMPARE(*recording_sha256(recording, {}), *text_sha256(bytes_of(c) + bytes_of(d)));
        folder.write("d.csv", table("t,D", 60, 0, {signal_d}));
        QCOMPARE(unchanged(recording).error().code, ErrorCode::file_changed);
    }

    void columns_without_times_take_the_rate_of_the_option() {
        const Folder folder;
        const auto lines = [](const std::function<double(double)>& signal) {
            std::string text;
            for (int i = 0; i < 200; ++i) {
                text += QString::number(signal(i / rate), 'f', 9).toStdString() + "\n";
            }
            return text;
        };
        const auto c = folder.write("1.txt", lines(signal_c));
        OpenOptions options = d_in(folder.write("2.txt", lines(signal_d)));
        QCOMPARE(open(c, options).error().code, ErrorCode::rate_unknown);
        options.rate_hz = rate;
        check_signals(opened(c, options), 0, 0);
    }

    void a_file_without_a_rate_takes_that_of_the_other_channel() {
        const Folder folder;
        std::string lines;
        for (int i = 0; i < 600; ++i) {
            lines += QString::number(signal_d(i / rate), 'f', 9).toStdString() + "\n";
        }
        const auto timed = folder.write("c.csv", table("t,C", 600, 0, {signal_c}));
        const auto untimed = folder.write("d.txt", lines);
        const Recording recording = opened(timed, d_in(untimed));
        QCOMPARE(recording.rate_from, RateOrigin::time_column);
        check_signals(recording, 0, 0);
        const Recording exchanged = opened(untimed, d_in(timed));
        QCOMPARE(exchanged.rate_from, RateOrigin::time_column);
        QCOMPARE(exchanged.rate_hz, recording.rate_hz);
        VYBEG_CLOSE(read_all(exchanged).c[1], signal_d(1 / rate), 1e-6);
    }

    void of_files_with_several_channels_the_option_chooses() {
        const Folder folder;
        const auto c = folder.write("c.csv", table("t,Aux,C", 60, 0, {signal_d, signal_c}));
        const auto d = folder.write("d.csv", table("t,D,Aux", 60, 0, {signal_d, signal_c}));
        OpenOptions options = d_in(d);
        options.channel_c = 2;
        options.channel_d = 1;
        check_signals(opened(c, options), 0, 0);
    }

    void times_of_d_that_begin_later_are_told_and_interpolated() {
        const Folder folder;
        const auto c = folder.write("c.csv", table("t,C", 3000, 0, {signal_c}));
        constexpr double late_s = 25.4137e-3;
        const auto d = folder.write("d.csv", table("t,D", 3000, late_s, {signal_d}));
        const Recording recording = opened(c, d_in(d));
        const Diagnostic* delayed = find(recording, DiagnosticKind::channel_delayed);
        QVERIFY(delayed);
        QCOMPARE(delayed->args, (std::vector<MessageArg>{"0.0254137", "508.274"}));
        check_signals(recording, 0, 700);
    }

    void columns_with_a_time_each_are_brought_to_the_times_of_c() {
        const Folder folder;
        std::string text = "t [s],C,t [s],D\n";
        constexpr double late_s = 0.35 / rate;
        for (int i = 0; i < 2000; ++i) {
            const double t_s = i / rate;
            text += QString("%1,%2,%3,%4\n")
                        .arg(t_s, 0, 'f', 9)
                        .arg(signal_c(t_s), 0, 'f', 9)
                        .arg(t_s + late_s, 0, 'f', 9)
                        .arg(signal_d(t_s + late_s), 0, 'f', 9)
                        .toStdString();
        }
        const Recording recording = opened(folder.write("run.csv", text));
        QVERIFY(find(recording, DiagnosticKind::channel_delayed));
        QCOMPARE(recording.channels.size(), 2u);
        check_signals(recording, 0, 200);
    }

    // Two recorders whose clocks were set by a third: their times tell how the rates differ.
    void rates_that_differ_by_their_own_times_are_brought_together() {
        const Folder folder;
        for (const double ppm : {100.0, -37.0, 2.0}) {
            const auto c = folder.write("c.csv", table("t,C", 40000, 0.5, {signal_c}));
            const auto d = folder.write(
                "d.csv", table("t,D", 40000, 0.5003, {signal_d}, (1 - 1e-6 * ppm) / rate));
            OpenOptions options;
            options.channel_d_file = d.string();
            const Recording recording = opened(c, options);
            const Diagnostic* told = find(recording, DiagnosticKind::channel_clocks_apart);
            QVERIFY(told);
            VYBEG_CLOSE(std::stod(english(told->args[0])), ppm, 0.1);
            const Samples samples = read_all(recording);
            std::int64_t present = 0;
            for (std::size_t i = 0; i < samples.c.size(); ++i) {
                const double t_s = 0.5 + static_cast<double>(i) / rate;
                if (!std::isnan(samples.d[i])) {
                    ++present;
                    VYBEG_CLOSE(samples.d[i], signal_d(t_s), 2e-4, "D");
                }
            }
            VYBEG_AT_LEAST(present, 39900);
            // A part has the same bits as the whole.
            std::vector<double> part_c(1000);
            std::vector<double> part_d(1000);
            QVERIFY(recording.source->read(20003, part_c, part_d));
            QVERIFY(std::ranges::equal(part_d, std::span(samples.d).subspan(20003, 1000)));
        }
    }

    void files_that_do_not_belong_together_are_refused_with_both_values() {
        const Folder folder;
        const auto c = folder.write("c.csv", table("t,C", 600, 0, {signal_c}));
        const auto other = folder.write("d.csv", table("t,D", 600, 0, {signal_d}, 1 / 10000.0));
        const QString rates = sentence(open(c, d_in(other)));
        QVERIFY2(rates.contains("20000 Hz") && rates.contains("10000 Hz"), qPrintable(rates));
        const auto later = folder.write("later.csv", table("t,D", 600, 3600, {signal_d}));
        const QString times = sentence(open(c, d_in(later)));
        QVERIFY2(times.contains("3600 s"), qPrintable(times));
    }

    void the_partner_is_found_by_its_name_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("partner");
        const auto row = [](const char* name, const char* partner) {
            QTest::newRow(name) << QString(name) << QString(partner);
        };
        row("sig0009.ana", "sig0010.ana");
        row("run 5 ch1.csv", "run 5 ch2.csv");
        row("run_C.wav", "run_D.wav");
        row("runX.txt", "runY.txt");
        row("c-2024-05-01.txt", "d-2024-05-01.txt");
        row("cos.bin", "sin.bin");
        row("dev1_demods_0_sample_00000.csv", "dev1_demods_1_sample_00000.csv");
        row("magic.wav", "");
    }
    void the_partner_is_found_by_its_name() {
        QFETCH(QString, name);
        QFETCH(QString, partner);
        const Folder folder;
        const auto path = folder.write(name.toStdString(), "1");
        QVERIFY(!partner_of(path));
        if (!partner.isEmpty()) {
            QCOMPARE(partner_of(path), std::optional(folder.write(partner.toStdString(), "1")));
        }
    }

    void a_file_with_one_channel_says_how_to_name_the_other() {
        const Folder folder;
        const auto c = folder.write("ch1.csv", table("t,C", 60, 0, {signal_c}));
        QVERIFY(sentence(open(c)).endsWith("--channel-d FILE."));
        folder.write("ch2.csv", "1");
        QVERIFY(sentence(open(c)).endsWith("--channel-d ch2.csv."));
        const OpenOptions raw{.rate_hz = rate, .raw = RawLayout{.channels = 1}};
        QCOMPARE(open(c, raw).error().code, ErrorCode::too_few_channels);
    }

    void pieces_are_one_recording_with_what_is_missing_between_them() {
        const Folder folder;
        const std::vector<std::function<double(double)>> both{signal_c, signal_d};
        const auto first = folder.write("1.csv", table("t,C,D", 500, 0, both));
        const auto second = folder.write("2.csv", table("t,C,D", 500, 500 / rate, both));
        const auto third = folder.write("3.csv", table("t,C,D", 500, 1040 / rate, both));
        const Recording recording = opened(first, joined_with({second, third}));
        QCOMPARE(recording.frames(), 1540);
        const Diagnostic* gap = find(recording, DiagnosticKind::time_gap);
        QVERIFY(gap);
        QCOMPARE(gap->first_frame, 1000);
        QCOMPARE(gap->count, 40);
        QVERIFY(!find(recording, DiagnosticKind::pieces_untimed));
        const Samples samples = read_all(recording);
        QCOMPARE(std::ranges::count_if(samples.c, [](double x) { return std::isnan(x); }), 40);
        check_signals(recording, 0, 40);
        // Any range of frames has the same samples.
        const Samples across = read(*recording.source, 490, 600);
        QCOMPARE(across.c[9], samples.c[499]);
        QCOMPARE(across.c[599], samples.c[1089]);
        QCOMPARE(*recording_sha256(recording, {}),
                 *text_sha256(bytes_of(first) + bytes_of(second) + bytes_of(third)));
    }

    // Times of day begin anew.
    void pieces_on_either_side_of_midnight_follow_each_other() {
        const Folder folder;
        const std::vector<std::function<double(double)>> both{signal_c, signal_d};
        const auto before = folder.write("1.csv", table("t,C,D", 500, 86400 - 300 / rate, both));
        const auto after = folder.write("2.csv", table("t,C,D", 500, 230 / rate, both));
        const Recording recording = opened(before, joined_with({after}));
        QCOMPARE(recording.frames(), 1030);
        QCOMPARE(find(recording, DiagnosticKind::time_gap)->count, 30);
    }

    void channels_on_either_side_of_midnight_are_one_recording() {
        const Folder folder;
        const auto c = folder.write("c.csv", table("t,C", 500, 86400 - 0.01, {signal_c}));
        const auto d = folder.write("d.csv", table("t,D", 500, 0.0, {signal_d}));
        OpenOptions options;
        options.channel_d_file = d.string();
        const Recording recording = opened(c, options);
        QCOMPARE(recording.frames(), 500);
        QVERIFY(find(recording, DiagnosticKind::channel_delayed));
    }

    void pieces_untimed_follow_each_other_and_it_is_told() {
        const Folder folder;
        OpenOptions raw{.rate_hz = rate, .raw = RawLayout{}};
        raw.join = {folder.write("2.raw", std::string(400, '\2')).string()};
        const Recording recording = opened(folder.write("1.raw", std::string(400, '\1')), raw);
        QCOMPARE(recording.frames(), 200);
        QVERIFY(find(recording, DiagnosticKind::pieces_untimed));
    }

    void pieces_that_overlap_or_differ_are_refused() {
        const Folder folder;
        const std::vector<std::function<double(double)>> both{signal_c, signal_d};
        const auto first = folder.write("1.csv", table("t,C,D", 500, 0, both));
        const auto inside = folder.write("2.csv", table("t,C,D", 500, 300 / rate, both));
        QCOMPARE(open(first, joined_with({inside})).error().code, ErrorCode::parts_differ);
        const auto slow = folder.write("3.csv", table("t,C,D", 500, 1, both, 1e-3));
        QVERIFY(sentence(open(first, joined_with({slow}))).contains("1000 Hz"));
        const auto wide =
            folder.write("4.csv", table("t,C,D,E", 500, 1, {signal_c, signal_d, signal_c}));
        QCOMPARE(open(first, joined_with({wide})).error().code, ErrorCode::parts_differ);
        const auto turned = folder.write("6.csv", table("t,D,C", 500, 500 / rate, both));
        QVERIFY(sentence(open(first, joined_with({turned}))).contains("C, D and D, C"));
        const auto far = folder.write("5.csv", table("t,C,D", 500, 1e6, both));
        QCOMPARE(open(first, joined_with({far})).error().code, ErrorCode::format_limit);
    }
};

VYBEG_TEST(TestChannelFiles)

}  // namespace test_channel_files

#include "test_channel_files.moc"
