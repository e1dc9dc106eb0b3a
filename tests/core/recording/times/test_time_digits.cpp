// What the digits of a time column leave open.
#include "core/recording/times/time_grid.h"
#include "tests/closeness.h"
#include "tests/core/recording/times/timed_signal.h"
#include "tests/test_registry.h"

#include <random>

namespace test_time_digits {

using namespace vybeg;
using namespace vybeg::test;

// What a time is stored as before it is written.
static double stored(double time_s, bool single) {
    return single ? static_cast<double>(static_cast<float>(time_s)) : time_s;
}

static std::string rows_at(const std::vector<double>& times, const char* format) {
    std::string text = "t,C,D\n";
    for (const double time : times) {
        char row[80];
        text.append(row, static_cast<std::size_t>(std::snprintf(row, sizeof row, format, time)));
        text += text.size() % 2 == 0 ? ",1,2\n" : ",2,1\n";
    }
    return text;
}

class TestTimeDigits : public QObject {
    Q_OBJECT

private slots:
    void times_that_stand_still_for_most_rows_have_a_step() {
        // Whole milliseconds at 33.333 kHz: the median step is 0.
        std::vector<double> times;
        for (int i = 0; i < 5000; ++i) {
            times.push_back(std::floor(i / 33.333) / 1000);
        }
        const TimeResolution whole{.absolute_s = 1e-3};
        VYBEG_CLOSE_RATIO(typical_step(times, whole), 1 / 33333.0, 1e-3);
        const auto even =
            UniformTimeDetector(times, typical_step(times, whole), whole).judge(whole);
        QVERIFY(even && even->segments.size() == 1);
        VYBEG_CLOSE_RATIO(even->rate_hz, 33333, 1e-2);
        // Nor is it looked for in times that no step leads to.
        for (const double end : {1e300, 1.7e308}) {
            times.back() = end;
            QVERIFY(!to_uniform_grid({times, times, times, whole}, "times"));
        }
    }

    void rounded_times_are_even_and_give_the_rate_as_well_as_their_digits_allow_data() {
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

    void rounded_times_are_even_and_give_the_rate_as_well_as_their_digits_allow() {
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

    void times_of_few_digits_give_the_rate_within_two_of_its_deviations_data() {
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

    void times_of_few_digits_give_the_rate_within_two_of_its_deviations() {
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
        // Where rounding meets halves of the last digit (48000 Hz), the times tell the rate
        // exactly.
        VYBEG_WITHIN(error, 0, 2.001 * sd + 1e-15);
        // No more than a slope that lies anywhere within a digit at either end.
        VYBEG_LESS(sd, 0.82 * coarsest / seconds);
    }

    void rounded_times_are_even_at_any_rate_length_start_and_number_of_digits_data() {
        QTest::addColumn<QByteArray>("format");
        QTest::addColumn<bool>("single");
        QTest::addColumn<double>("rate_hz");
        QTest::addColumn<double>("seconds");
        QTest::addColumn<double>("start_s");
        // Sanitizers look at the reading, whose paths a few of the rows take.
#ifdef __SANITIZE_ADDRESS__
        constexpr int every = 7;
#else
        constexpr int every = 1;
#endif
        int rows = 0;
        for (const char* format :
             {"%.5g", "%.6g", "%.7g", "%.8g", "%.9g", "%.6f", "%.6e", "%.17g"}) {
            for (const bool single : {false, true}) {
                for (const auto& [rate_hz, seconds] :
                     {std::pair(1e3, 1.0), {1e3, 20.0}, {33e3, 0.5}, {33333.3, 1.0}, {2e5, 0.2}}) {
                    for (const double start_s : {0.0, 9.7, 123.0}) {
                        if (++rows % every != 0) {
                            continue;
                        }
                        QTest::addRow("%s%s, %g Hz, %g s from %g s", format,
                                      single ? " single" : "", rate_hz, seconds, start_s)
                            << QByteArray(format) << single << rate_hz << seconds << start_s;
                    }
                }
            }
        }
        for (const char* format : {"%.7g", "%.9g"}) {
            QTest::addRow("%s single, 1 kHz, 10 min", format)
                << QByteArray(format) << true << 1e3 << 600.0 << 0.0;
            QTest::addRow("%s single, 33 kHz, 14 s", format)
                << QByteArray(format) << true << 33e3 << 14.0 << 0.0;
        }
    }

    void rounded_times_are_even_at_any_rate_length_start_and_number_of_digits() {
        QFETCH(QByteArray, format);
        QFETCH(bool, single);
        QFETCH(double, rate_hz);
        QFETCH(double, seconds);
        QFETCH(double, start_s);
        std::vector<double> times;
        for (int i = 0; i < static_cast<int>(seconds * rate_hz); ++i) {
            times.push_back(stored(start_s + i / rate_hz, single));
        }
        const Folder folder;
        const Recording recording = opened(folder.write("run", rows_at(times, format)));
        QCOMPARE(recording.frames(), std::ssize(times));
        QVERIFY(!find(recording, DiagnosticKind::time_uneven));
        QVERIFY(!find(recording, DiagnosticKind::time_gap));
        const double sd = recording.rate_relative_sd;
        VYBEG_WITHIN(recording.rate_hz / rate_hz, 1, 2.001 * sd + 1e-12);
    }

    void jitter_beyond_the_rounding_is_reported_data() {
        QTest::addColumn<QByteArray>("format");
        QTest::addColumn<bool>("single");
        QTest::addColumn<double>("late_s");  // of one time near 5 s
        QTest::newRow("6 decimals") << QByteArray("%.6f") << false << 2e-6;
        QTest::newRow("7 digits of 32 bits") << QByteArray("%.7g") << true << 3e-6;
        QTest::newRow("9 digits of 32 bits") << QByteArray("%.9g") << true << 1.2e-6;
        QTest::newRow("17 digits of 32 bits") << QByteArray("%.17g") << true << 1.2e-6;
        QTest::newRow("17 digits") << QByteArray("%.17g") << false << 5e-8;
    }

    void jitter_beyond_the_rounding_is_reported() {
        QFETCH(QByteArray, format);
        QFETCH(bool, single);
        QFETCH(double, late_s);
        std::vector<double> times;
        for (int i = 0; i < 200000; ++i) {
            times.push_back(stored(i / rate + (i == 166665 ? late_s : 0), single));
        }
        const Folder folder;
        const Recording recording = opened(folder.write("run", rows_at(times, format)));
        QVERIFY(find(recording, DiagnosticKind::time_uneven));
    }

    void lost_samples_are_found_where_the_digits_become_coarser() {
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

    void lost_samples_are_found_in_times_that_were_32_bit_floats() {
        std::vector<double> times;
        for (int i = 0; i < 400000; ++i) {
            if (i < 300000 || i >= 300004) {
                times.push_back(stored(i / rate, true));
            }
        }
        const Folder folder;
        const Recording recording = opened(folder.write("run", rows_at(times, "%.9g")));
        QCOMPARE(recording.frames(), 400000);
        QCOMPARE(recording.diagnostics.size(), 1u);
        QCOMPARE(recording.diagnostics[0].kind, DiagnosticKind::time_gap);
        QCOMPARE(recording.diagnostics[0].first_frame, 300000);
        QCOMPARE(recording.diagnostics[0].count, 4);
    }

    void equal_times_are_an_error_where_their_digits_do_not_explain_them() {
        std::vector<double> times = even_times(1000);
        times[500] = times[499];
        const Folder folder;
        const auto wrong = open(folder.write("run", text_of(times, "%.9f")));
        QVERIFY(!wrong);
        QCOMPARE(wrong.error().code, ErrorCode::text_time_backwards);
        QCOMPARE(wrong.error().args.at(0), std::string("502"));
    }
};

VYBEG_TEST(TestTimeDigits, first)

}  // namespace test_time_digits

#include "test_time_digits.moc"
