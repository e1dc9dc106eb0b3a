// A column of times or of row numbers is refused as a channel, whatever the file.
#include "tests/core/recording/recording_files.h"
#include "tests/test_registry.h"

namespace test_signal_channels {

using namespace vybeg;
using namespace vybeg::test;

namespace {

constexpr double rate_hz = 33333;

// First a column that is no signal, then C and D.
std::string table(int rows, double start, double step) {
    const Samples samples = wave(static_cast<std::size_t>(rows));
    std::string bytes;
    for (int i = 0; i < rows; ++i) {
        const auto k = static_cast<std::size_t>(i);
        for (const double value : {start + step * i, samples.c[k], samples.d[k]}) {
            bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
        }
    }
    return bytes;
}

Result<Recording> opened_raw(const std::string& bytes, int c, int d) {
    const Folder folder;
    OpenOptions options{.rate_hz = rate_hz, .raw = RawLayout{}};
    options.raw->type = RawType::f64;
    options.raw->channels = 3;
    options.channel_c = c;
    options.channel_d = d;
    return open(folder.write("run.bin", bytes), options);
}

}  // namespace

class TestSignalChannels : public QObject {
    Q_OBJECT

private slots:
    void times_and_row_numbers_are_no_signal_data() {
        QTest::addColumn<double>("start");
        QTest::addColumn<double>("step");
        QTest::newRow("seconds") << 0.0 << 1 / rate_hz;
        QTest::newRow("from somewhere") << 1234.5 << 1 / rate_hz;
        QTest::newRow("milliseconds") << 0.0 << 1e3 / rate_hz;
        QTest::newRow("rows") << 1.0 << 1.0;
    }
    void times_and_row_numbers_are_no_signal() {
        QFETCH(double, start);
        QFETCH(double, step);
        const std::string bytes = table(2000, start, step);
        for (const auto& [c, d] : {std::pair(1, 2), std::pair(3, 1)}) {
            const auto refused = opened_raw(bytes, c, d);
            QVERIFY(!refused);
            QCOMPARE(refused.error().code, ErrorCode::channel_is_time);
            QCOMPARE(refused.error().args, std::vector<MessageArg>{"1"});
        }
        QVERIFY(opened_raw(bytes, 2, 3));
    }

    void what_rises_otherwise_may_be_a_signal() {
        QVERIFY(opened_raw(table(2000, 1, 0), 1, 2));      // a constant
        QVERIFY(opened_raw(table(2000, 1, -1e-4), 1, 2));  // falls
        QVERIFY(opened_raw(table(999, 0, 1), 1, 2));       // too short to know
    }
};

VYBEG_TEST(TestSignalChannels)

}  // namespace test_signal_channels

#include "test_signal_channels.moc"
