// What the digits of a time column leave open.
#include "core/recording/times/local_cubic.h"
#include "tests/closeness.h"
#include "tests/core/recording/times/timed_signal.h"
#include "tests/test_registry.h"

#include <random>

namespace test_time_digits {

using namespace vybeg;
using namespace vybeg::test;

class TestTimeDigits : public QObject {
    Q_OBJECT

private slots:
    void rounded_times_are_even_and_give_the_rate_as_well_as_their_digits_allow_data();
    void rounded_times_are_even_and_give_the_rate_as_well_as_their_digits_allow();
    void times_of_few_digits_give_the_rate_within_two_of_its_deviations_data();
    void times_of_few_digits_give_the_rate_within_two_of_its_deviations();
    void times_of_floats_are_even_whatever_their_digits_data();
    void times_of_floats_are_even_whatever_their_digits();
    void lost_samples_are_found_where_the_digits_become_coarser();
    void equal_times_are_an_error_where_their_digits_do_not_explain_them();
};

void TestTimeDigits::rounded_times_are_even_and_give_the_rate_as_well_as_their_digits_allow_data() {
    QTest::addColumn<QByteArray>("format");
    QTest::addColumn<double>("start");
    QTest::addColumn<double>("last_digit");  // seconds
    QTest::newRow("5 decimals: a third of a sample") << QByteArray("%.5f") << 0.0 << 1e-5;
    QTest::newRow("6 decimals") << QByteArray("%.6f") << 0.0 << 1e-6;
    QTest::newRow("9 decimals") << QByteArray("%.9f") << 0.0 << 1e-9;
    QTest::newRow("9 decimals, an hour later") << QByteArray("%.9f") << 3600.0 << 1e-9;
    QTest::newRow("7 digits") << QByteArray("%.7g") << 0.0 << 1e-7;
    QTest::newRow("exponents of 7 digits") << QByteArray("%.6e") << 0.0 << 1e-7;
    QTest::newRow("17 digits") << QByteArray("%.17g") << 0.0 << 2e-16;
}

void TestTimeDigits::rounded_times_are_even_and_give_the_rate_as_well_as_their_digits_allow() {
    QFETCH(QByteArray, format);
    QFETCH(double, start);
    QFETCH(double, last_digit);
    const Folder folder;
    const std::vector<double> times = even_times(20000, start);
    const Recording recording = opened(folder.write("run", text_of(times, format)));
    QCOMPARE(recording.rate_from, RateOrigin::time_column);
    QCOMPARE(recording.frames(), 20000);
    QVERIFY(recording.diagnostics.empty());
    // One digit over the whole length is the worst that rounding can do to a straight line.
    const double allowed = last_digit / (times.back() - times.front()) + 1e-14 * (1 + start);
    VYBEG_CLOSE_RATIO(recording.rate_hz, rate, allowed);
    QCOMPARE(read_all(recording).c, sampled(signal_c, times));
}

void TestTimeDigits::times_of_few_digits_give_the_rate_within_two_of_its_deviations_data() {
    QTest::addColumn<QByteArray>("format");
    QTest::addColumn<double>("rate_hz");
    QTest::addColumn<double>("seconds");
    QTest::addColumn<double>("coarsest");  // last digit of the last time, s
    const auto add = [](const char* format, double rate_hz, double seconds, double coarsest) {
        QTest::addRow("%s at %g Hz for %g s", format, rate_hz, seconds)
            << QByteArray(format) << rate_hz << seconds << coarsest;
    };
    for (const double rate_hz : {33333.0, 44100.0, 48000.0, 51234.5}) {
        add("%.5f", rate_hz, 1.3, 1e-5);
        add("%.7g", rate_hz, 1.3, 1e-6);
        add("%.6g", rate_hz, 1.3, 1e-5);
        add("%.5g", rate_hz, 1.3, 1e-4);  // some times are equal
        add("%.5e", rate_hz, 1.3, 1e-5);
    }
    add("%.7g", 33333, 11, 1e-5);
    add("%.6g", 33333, 11, 1e-4);
    add("%.4f", 33333, 1.3, 1e-4);
}

void TestTimeDigits::times_of_few_digits_give_the_rate_within_two_of_its_deviations() {
    QFETCH(QByteArray, format);
    QFETCH(double, rate_hz);
    QFETCH(double, seconds);
    QFETCH(double, coarsest);
    const Folder folder;
    std::vector<double> times;
    const auto frames = static_cast<std::int64_t>(seconds * rate_hz);
    for (std::int64_t i = 0; i < frames; ++i) {
        times.push_back(static_cast<double>(i) / rate_hz);
    }
    const Recording recording = opened(folder.write("run", text_of(times, format)));
    QCOMPARE(recording.frames(), frames);
    QVERIFY(recording.diagnostics.empty());
    const double error = recording.rate_hz / rate_hz - 1;
    const double sd = recording.rate_relative_sd;
    // Where rounding meets halves of the last digit (48000 Hz), the times tell the rate exactly.
    VYBEG_WITHIN(error, 0, 2.001 * sd + 1e-15);
    // No more than a slope that lies anywhere within a digit at either end.
    VYBEG_LESS(sd, 0.82 * coarsest / seconds);
}

// Exports in single precision round twice: to a float, then to the digits of the text.
void TestTimeDigits::times_of_floats_are_even_whatever_their_digits_data() {
    QTest::addColumn<QByteArray>("format");
    QTest::addColumn<double>("rate_hz");
    QTest::addColumn<double>("start");
    QTest::addColumn<double>("seconds");
    for (const char* const format : {"%.7g", "%.8g", "%.9g", "%.17g", "%.8f", "%.6e"}) {
        QTest::addRow("%s", format) << QByteArray(format) << 33333.0 << 0.0 << 14.1;
        QTest::addRow("%s from 3 s on", format) << QByteArray(format) << 44100.0 << 3.0 << 1.5;
        QTest::addRow("%s at 5 kHz", format) << QByteArray(format) << 5000.0 << 0.0 << 60.0;
    }
}

void TestTimeDigits::times_of_floats_are_even_whatever_their_digits() {
    QFETCH(QByteArray, format);
    QFETCH(double, rate_hz);
    QFETCH(double, start);
    QFETCH(double, seconds);
    const Folder folder;
    std::vector<double> times;
    const auto frames = static_cast<std::int64_t>(seconds * rate_hz);
    for (std::int64_t i = 0; i < frames; ++i) {
        times.push_back(static_cast<float>(start + static_cast<double>(i) / rate_hz));
    }
    const Recording recording = opened(folder.write("run", text_of(times, format)));
    QCOMPARE(recording.frames(), frames);
    QVERIFY(recording.diagnostics.empty());
    VYBEG_WITHIN(recording.rate_hz / rate_hz - 1, 0, 4 * recording.rate_relative_sd + 1e-14);
}

void TestTimeDigits::lost_samples_are_found_where_the_digits_become_coarser() {
    std::vector<double> times = even_times(50000);
    for (const std::ptrdiff_t lost : {45000, 33340, 3340}) {
        times.erase(times.begin() + lost, times.begin() + lost + 4);
    }
    const Folder folder;
    const Recording recording = opened(folder.write("run", text_of(times, "%.7g")));
    QCOMPARE(recording.frames(), 50000);
    QCOMPARE(recording.diagnostics.size(), 3u);
    for (const auto& [index, frame] : {std::pair{0, 3340}, {1, 33340}, {2, 45000}}) {
        const Diagnostic& gap = recording.diagnostics[static_cast<std::size_t>(index)];
        QCOMPARE(gap.kind, DiagnosticKind::time_gap);
        QCOMPARE(gap.first_frame, frame);
        QCOMPARE(gap.count, 4);
    }
    VYBEG_WITHIN(recording.rate_hz / rate, 1, 2.001 * recording.rate_relative_sd);
}

void TestTimeDigits::equal_times_are_an_error_where_their_digits_do_not_explain_them() {
    std::vector<double> times = even_times(1000);
    times[500] = times[499];
    const Folder folder;
    const auto wrong = open(folder.write("run", text_of(times, "%.9f")));
    QVERIFY(!wrong);
    QCOMPARE(wrong.error().code, ErrorCode::text_time_backwards);
    QCOMPARE(wrong.error().args.at(0), std::string("502"));
}

VYBEG_TEST(TestTimeDigits)

}  // namespace test_time_digits

#include "test_time_digits.moc"
