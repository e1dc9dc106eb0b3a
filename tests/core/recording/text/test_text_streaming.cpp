// Text files of many blocks: read piece by piece they are what they are as a whole.
#include "core/base/number_text.h"
#include "core/recording/times/time_grid.h"
#include "tests/closeness.h"
#include "tests/core/recording/recording_files.h"
#include "tests/data/trade_files.h"
#include "tests/test_registry.h"

#include <atomic>
#include <random>
#include <thread>

namespace test_text_streaming {

using namespace vybeg;
using namespace vybeg::test;

namespace {

constexpr std::size_t row_count = 20000;  // some 900 kB: seven blocks

// How a file writes its rows.
struct Dialect {
    std::string line_end = "\n";
    std::string separator = ",";
    bool decimal_comma = false;
    bool quoted = false;
    bool utf16 = false;
};

std::string number(double value, const Dialect& dialect) {
    std::string text = std::isnan(value) ? "" : round_trip_text(value);
    if (dialect.decimal_comma) {
        std::replace(text.begin(), text.end(), '.', ',');
    }
    return dialect.quoted ? "\"" + text + "\"" : text;
}

// The samples with the times of their frames at 33333 Hz; `skipped` frames have no row.
std::string text_of(const Samples& samples, const Dialect& dialect, std::size_t skip_from = 0,
                    std::size_t skip_to = 0) {
    std::string text = "t" + dialect.separator + "C" + dialect.separator + "D" + dialect.line_end;
    for (std::size_t i = 0; i < samples.c.size(); ++i) {
        if (i >= skip_from && i < skip_to) {
            continue;
        }
        text += number(static_cast<double>(i) / 33333, dialect) + dialect.separator +
                number(samples.c[i], dialect) + dialect.separator + number(samples.d[i], dialect) +
                dialect.line_end;
    }
    return dialect.utf16 ? utf16(text, true) : text;
}

Samples some_samples() {
    Samples samples = wave(row_count);
    std::mt19937_64 random(5);
    for (int i = 0; i < 200; ++i) {  // the way of the odd row, too
        samples.c[random() % row_count] = no_value;
        samples.d[random() % row_count] = no_value;
    }
    return samples;
}

TimedSamples timed(const std::vector<double>& times) {
    return {times, times, times, {}};
}

// The judgement of a UniformTimeDetector that was put together from pieces of random length.
std::optional<EvenTimes> judged(const std::vector<double>& times, std::mt19937_64& random) {
    const double step = typical_step(times, {});
    UniformTimeDetector whole(step);
    for (std::size_t i = 0; i < times.size();) {
        UniformTimeDetector piece(step);
        for (std::size_t left = 1 + random() % 500; left > 0 && i < times.size(); --left) {
            piece.add(times[i++]);
        }
        whole.append(piece);
    }
    return whole.judge({});
}

}  // namespace

class TestTextStreaming : public QObject {
    Q_OBJECT

private slots:
    void every_row_is_read_once_wherever_blocks_are_cut_data() {
        QTest::addColumn<Dialect>("dialect");
        QTest::newRow("LF") << Dialect{};
        QTest::newRow("CRLF") << Dialect{.line_end = "\r\n"};
        QTest::newRow("CR") << Dialect{.line_end = "\r"};
        QTest::newRow("semicolon, decimal comma")
            << Dialect{.separator = ";", .decimal_comma = true};
        QTest::newRow("tab, quoted") << Dialect{.separator = "\t", .quoted = true};
        QTest::newRow("UTF-16, CRLF") << Dialect{.line_end = "\r\n", .utf16 = true};
    }

    void every_row_is_read_once_wherever_blocks_are_cut() {
        QFETCH(Dialect, dialect);
        const Folder folder;
        const Samples samples = some_samples();
        const Recording recording = opened(folder.write("run", text_of(samples, dialect)));
        QCOMPARE(recording.frames(), static_cast<std::int64_t>(row_count));
        VYBEG_CLOSE_RATIO(recording.rate_hz, 33333, 1e-12);
        const Samples read = read_all(recording);
        QCOMPARE(worst_difference(read, samples), 0.0);
        QVERIFY(same_however_cut(*recording.source, 5000));
    }

    void a_gap_of_the_times_is_missing_frames_wherever_it_is_read() {
        const Folder folder;
        Samples samples = wave(row_count);
        const Recording recording = opened(folder.write("run", text_of(samples, {}, 12000, 12345)));
        std::fill(samples.c.begin() + 12000, samples.c.begin() + 12345, no_value);
        QCOMPARE(recording.frames(), static_cast<std::int64_t>(row_count));
        QCOMPARE(worst_difference(read_all(recording).c, samples.c), 0.0);
        QVERIFY(same_however_cut(*recording.source, 5000));
        const Diagnostic* const gap = find(recording, DiagnosticKind::time_gap);
        QVERIFY(gap);
        QCOMPARE(gap->first_frame, 12000);
        QCOMPARE(gap->count, 345);
    }

    void threads_that_read_at_once_do_not_disturb_each_other() {
        const Folder folder;
        const Recording recording = opened(folder.write("run", text_of(some_samples(), {})));
        const Samples all = read_all(recording);
        std::atomic<int> wrong = 0;
        std::vector<std::thread> threads;
        for (unsigned seed = 0; seed < 4; ++seed) {
            threads.emplace_back([&, seed] {
                std::mt19937 random(seed);
                for (int i = 0; i < 50; ++i) {
                    const auto first = static_cast<std::int64_t>(random() % (row_count - 3000));
                    const Samples part = read(*recording.source, first, 3000);
                    const auto at = static_cast<std::size_t>(first);
                    wrong += same_bits(part.c, std::span(all.c).subspan(at, 3000)) ? 0 : 1;
                }
            });
        }
        for (std::thread& thread : threads) {
            thread.join();
        }
        QCOMPARE(wrong.load(), 0);
    }

    void the_first_fault_of_the_file_is_the_error_data() {
        QTest::addColumn<int>("wrong_row");
        QTest::addColumn<int>("backwards_row");
        QTest::newRow("in one block, wrong first") << 9000 << 9010;
        QTest::newRow("in one block, backwards first") << 9010 << 9000;
        QTest::newRow("blocks apart, wrong first") << 3000 << 19000;
        QTest::newRow("blocks apart, backwards first") << 19000 << 3000;
    }

    void the_first_fault_of_the_file_is_the_error() {
        QFETCH(int, wrong_row);
        QFETCH(int, backwards_row);
        const Folder folder;
        std::string text = "t,C,D\n";
        for (int i = 0; i < static_cast<int>(row_count); ++i) {
            text += (i == backwards_row ? "0.00001" : round_trip_text(i / 33333.0)) + ",0.125," +
                    (i == wrong_row ? "x" : "0.25") + ",\n";
        }
        const auto recording = open(folder.write("run", text));
        QVERIFY(!recording);
        const bool wrong_first = wrong_row < backwards_row;
        QCOMPARE(recording.error().code,
                 wrong_first ? ErrorCode::text_not_a_number : ErrorCode::text_time_backwards);
        QCOMPARE(recording.error().args.at(0),
                 std::to_string(std::min(wrong_row, backwards_row) + 2));
    }

    void a_file_that_changes_under_the_reader_is_an_error() {
        const Folder folder;
        const auto path = folder.write("run", text_of(wave(row_count), {}));
        const Recording recording = opened(path);
        std::fstream(path, std::ios::in | std::ios::out).seekp(500000).write("\n\n\n\n", 4);
        std::vector<double> c(row_count);
        std::vector<double> d(row_count);
        const Status changed = recording.source->read(0, c, d);
        QVERIFY(!changed);
        QCOMPARE(changed.error().code, ErrorCode::file_read_failed);
        std::filesystem::resize_file(path, 1000);
        QCOMPARE(recording.source->read(0, c, d).error().code, ErrorCode::file_read_failed);
    }

    void a_line_of_times_finds_the_grid_that_all_times_together_give_data() {
        QTest::addColumn<double>("jitter");  // samples
        QTest::addColumn<bool>("even");
        QTest::newRow("none") << 0.0 << true;
        QTest::newRow("less than a thousandth") << 0.0009 << true;
        QTest::newRow("more than a thousandth") << 0.0012 << false;
    }

    void a_line_of_times_finds_the_grid_that_all_times_together_give() {
        QFETCH(double, jitter);
        QFETCH(bool, even);
        std::mt19937_64 random(21);
        for (int trial = 0; trial < 20; ++trial) {
            std::vector<double> times;
            std::int64_t frame = 0;
            for (int i = 0; i < 5000; ++i) {
                times.push_back(-0.03 + static_cast<double>(frame) / 33333);
                frame += random() % 1000 == 0 ? 2 + random() % 3000 : 1;
            }
            // One time alone, so that the line of least squares stays where it is.
            times[1000 + random() % 3000] += (random() % 2 == 0 ? jitter : -jitter) / 33333;
            const auto found = judged(times, random);
            QCOMPARE(found.has_value(), even);
            const auto grid = to_uniform_grid(timed(times), "times");
            QVERIFY(grid);
            QCOMPARE(!grid->diagnostics.empty() &&
                         grid->diagnostics[0].kind == DiagnosticKind::time_uneven,
                     !even);
            if (!even) {
                continue;
            }
            VYBEG_CLOSE_RATIO(found->rate_hz, grid->rate_hz, 1e-12);
            QCOMPARE(found->frames(), static_cast<std::int64_t>(grid->c.size()));
            for (const RowSegment& segment : found->segments) {
                const auto row = static_cast<std::size_t>(segment.first_row);
                const auto frame_of_row = static_cast<std::size_t>(segment.first_frame);
                QCOMPARE(grid->c[frame_of_row], times[row]);
                QVERIFY(frame_of_row == 0 || std::isnan(grid->c[frame_of_row - 1]));
            }
        }
    }
};

VYBEG_TEST(TestTextStreaming, threads)

}  // namespace test_text_streaming

#include "test_text_streaming.moc"
