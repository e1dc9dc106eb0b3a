// Recordings as they come from L-Card's LGraph2 and from ZETLAB.
#include "tests/closeness.h"
#include "tests/core/recording/recording_files.h"
#include "tests/data/trade_files.h"
#include "tests/test_registry.h"

#include <array>

namespace test_trade_formats {

using namespace vybeg;
using namespace vybeg::test;

namespace {

constexpr double rate = 33333;
constexpr double digits = 1e-8;       // of the text
constexpr double float_digit = 1e-7;  // of samples below 1

// Two files of ZETLAB, their headers where they are wanted.
struct Zetlab {
    Folder folder;
    Samples samples = wave(400);
    std::filesystem::path c = folder.write("sig0001.ana", zetlab_ana(samples.c, 1.5e-6));
    std::filesystem::path d = folder.write("sig0002.ana", zetlab_ana(samples.d, 2e-6));

    void describe_by_anp(double rate_of_d = rate) const {
        folder.write("sig0001.anp", zetlab_anp(rate, 1.5e-6, "Пьезо C"));
        folder.write("sig0002.anp", zetlab_anp(rate_of_d, 2e-6, "Пьезо D"));
    }
};

}  // namespace

class TestTradeFormats : public QObject {
    Q_OBJECT

private slots:
    void lgraph_gives_channels_rate_and_samples_data() {
        QTest::addColumn<QString>("unit");
        QTest::addColumn<double>("step");
        QTest::addColumn<bool>("cyrillic");
        QTest::newRow("seconds") << "секунды" << 1 / rate << false;
        QTest::newRow("seconds, Windows-1251") << "секунды" << 1 / rate << true;
        QTest::newRow("milliseconds") << "миллисекунды" << 1e3 / rate << false;
        QTest::newRow("milliseconds, Windows-1251") << "миллисекунды" << 1e3 / rate << true;
        QTest::newRow("ms") << "мс" << 1e3 / rate << true;
        QTest::newRow("without times") << "" << 0.0 << false;
        QTest::newRow("without times, Windows-1251") << "" << 0.0 << true;
    }
    void lgraph_gives_channels_rate_and_samples() {
        QFETCH(QString, unit);
        QFETCH(double, step);
        QFETCH(bool, cyrillic);
        const Folder folder;
        const Samples samples = wave(300);
        for (const bool older : {false, true}) {
            for (const bool named : {false, true}) {
                LGraphText layout{.time_unit = unit, .time_step = step, .older = older};
                if (named) {
                    layout.names = {"Пьезо_C", "Пьезо_D"};
                }
                const QString text = lgraph_text(layout, {samples.c, samples.d});
                const auto path =
                    folder.write("run.txt", cyrillic ? windows_1251(text) : text.toStdString());
                const Recording recording = opened(path);
                VYBEG_CLOSE(recording.rate_hz, rate, 1e-3);
                QCOMPARE(recording.channels.size(), 2u);
                QCOMPARE(recording.channels[0], (Channel{named ? "Пьезо_C" : "Ch 1", "Volts"}));
                QCOMPARE(recording.channels[1].name, named ? "Пьезо_D" : "Ch 2");
                const Samples read = read_all(recording);
                VYBEG_AT_MOST(worst_difference(read.c, samples.c), digits);
                VYBEG_AT_MOST(worst_difference(read.d, samples.d), digits);
            }
        }
    }

    void lgraph_with_a_rate_that_contradicts_its_times_is_refused_with_both() {
        const Folder folder;
        const Samples samples = wave(300);
        LGraphText layout{.time_unit = "секунды", .time_step = 1 / rate};
        layout.rate_khz = 100;
        const auto path =
            folder.write("run.txt", lgraph_text(layout, {samples.c, samples.d}).toStdString());
        const auto refused = open(path);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::rates_differ);
        QCOMPARE(refused.error().args, (std::vector<MessageArg>{"100000", "33333"}));
        // The option says which holds.
        for (const double holds : {100e3, rate}) {
            const OpenOptions options{.rate_hz = holds};
            const Recording recording = opened(path, options);
            VYBEG_CLOSE(recording.rate_hz, holds, 1e-3);
            QCOMPARE(recording.rate_from, RateOrigin::option);
        }
    }

    void lgraph_that_left_samples_out_tells_no_rate_without_times() {
        const Folder folder;
        const Samples samples = wave(300);
        LGraphText layout;
        layout.decimation = 10;
        const auto refused = open(
            folder.write("run.txt", lgraph_text(layout, {samples.c, samples.d}).toStdString()));
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::rate_unknown);
    }

    void zetlab_gives_both_channels_in_volts_by_either_header() {
        for (const bool xml : {false, true}) {
            const Zetlab zetlab;
            if (xml) {
                zetlab.folder.write("sig0001.xml", zetlab_xml(rate, 1.5e-6, "Пьезо &quot;C&quot;"));
                zetlab.folder.write("sig0002.xml", zetlab_xml(rate, 2e-6, "Пьезо D"));
            } else {
                zetlab.describe_by_anp();
            }
            const Recording recording = opened(zetlab.c, d_in(zetlab.d));
            QCOMPARE(recording.rate_hz, rate);
            QCOMPARE(recording.channels,
                     (std::vector<Channel>{{xml ? "Пьезо \"C\"" : "Пьезо C", xml ? "V" : "mV"},
                                           {"Пьезо D", xml ? "V" : "mV"}}));
            Samples read = read_all(recording);
            const double unit = xml ? 1 : 1e-3;
            for (std::vector<double>* channel : {&read.c, &read.d}) {
                for (double& sample : *channel) {
                    sample *= unit;
                }
            }
            VYBEG_AT_MOST(worst_difference(read.c, zetlab.samples.c), float_digit);
            VYBEG_AT_MOST(worst_difference(read.d, zetlab.samples.d), float_digit);
        }
    }

    void one_file_of_zetlab_names_its_partner() {
        const Zetlab zetlab;
        zetlab.describe_by_anp();
        const auto refused = open(zetlab.c);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::too_few_channels);
        QVERIFY(english(refused.error()).ends_with("--channel-d sig0002.ana."));
    }

    void zetlab_of_unlike_lengths_is_told() {
        const Zetlab zetlab;
        zetlab.describe_by_anp();
        const Samples longer = wave(420);
        zetlab.folder.write("sig0002.ana", zetlab_ana(longer.d, 2e-6));
        const Recording recording = opened(zetlab.c, d_in(zetlab.d));
        QCOMPARE(recording.frames(), 400);
        const Diagnostic* unequal = find(recording, DiagnosticKind::channels_unequal);
        QVERIFY(unequal);
        QCOMPARE(unequal->args, (std::vector<MessageArg>{"Пьезо C", "400", "Пьезо D", "420"}));
    }

    void zetlab_of_unlike_rates_is_refused_with_both() {
        const Zetlab zetlab;
        zetlab.describe_by_anp(25000);
        const auto refused = open(zetlab.c, d_in(zetlab.d));
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::parts_differ);
        const std::string text = english(refused.error());
        QVERIFY2(text.find("33333 Hz") != std::string::npos &&
                     text.find("25000 Hz") != std::string::npos,
                 text.c_str());
    }

    void zetlab_without_header_or_partner_says_what_to_do() {
        const Zetlab zetlab;
        QCOMPARE(open(zetlab.c, d_in(zetlab.d)).error().code, ErrorCode::header_missing);
        zetlab.describe_by_anp();
        QCOMPARE(open(zetlab.c, d_in(zetlab.folder.file("sig0003.ana"))).error().code,
                 ErrorCode::file_missing);
        // Without its header it is still raw samples.
        OpenOptions raw = d_in(zetlab.d);
        raw.raw = RawLayout{.type = RawType::f32, .channels = 1};
        raw.rate_hz = rate;
        QCOMPARE(opened(zetlab.c, raw).frames(), 400);
    }
};

VYBEG_TEST(TestTradeFormats)

}  // namespace test_trade_formats

#include "test_trade_formats.moc"
