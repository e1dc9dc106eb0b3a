#include "core/recording/conditioning/conditioned_source.h"
#include "tests/closeness.h"
#include "tests/core/recording/source_reading.h"
#include "tests/test_registry.h"

#include <QTest>

#include <array>
#include <numbers>
#include <thread>

namespace test_filtered_source {

using namespace vybeg;
using namespace vybeg::test;

namespace {

constexpr double rate = 33333;

Samples sinusoid(double f_hz, double rate_hz, std::int64_t frames) {
    Samples samples;
    for (std::int64_t i = 0; i < frames; ++i) {
        const double angle =
            2 * std::numbers::pi * std::fmod(f_hz / rate_hz * static_cast<double>(i), 1.0);
        samples.c.push_back(std::cos(angle));
        samples.d.push_back(std::sin(angle));
    }
    return samples;
}

// C: the channel's own samples with the given ones missing.
Samples with_missing(Samples samples, std::initializer_list<std::int64_t> in_c, double value) {
    for (const std::int64_t i : in_c) {
        samples.c[i] = value;
    }
    return samples;
}

}  // namespace

class TestFilteredSource : public QObject {
    Q_OBJECT

    static void add_bands() {
        QTest::addColumn<double>("low");
        QTest::addColumn<double>("high");
        QTest::addColumn<double>("rate_hz");
        QTest::newRow("around the carrier") << 5200.0 << 5400.0 << rate;
        QTest::newRow("wide") << 4000.0 << 7000.0 << rate;
        QTest::newRow("nearly everything") << 50.0 << 16600.0 << rate;
        QTest::newRow("bell") << 1000.0 << 1040.0 << 48000.0;
        QTest::newRow("low edge limits the transition") << 20.0 << 200.0 << 1000.0;
        QTest::newRow("high edge limits the transition") << 300.0 << 490.0 << 1000.0;
        QTest::newRow("slow camera") << 2.0 << 3.0 << 12.5;
    }

    // Long enough for three blocks at least, or twice the reach of long filters.
    static std::int64_t frames_for(double low, double high, double rate_hz) {
        return 20000 + 12 * band_pass_reach(low, high, rate_hz);
    }

    static double transition(double low, double high, double rate_hz) {
        return std::min({(high - low) / 2, low, rate_hz / 2 - high});
    }

private slots:
    void a_sinusoid_in_the_band_comes_out_as_it_went_in_data() { add_bands(); }

    // Bounds the gain's ripple and the phase (C and D are a quarter turn apart) by 1e-4 at once.
    void a_sinusoid_in_the_band_comes_out_as_it_went_in() {
        QFETCH(double, low);
        QFETCH(double, high);
        QFETCH(double, rate_hz);
        const std::int64_t frames = frames_for(low, high, rate_hz);
        for (int step = 0; step <= 16; ++step) {
            const double f = low + (high - low) * step / 16;
            const Samples in = sinusoid(f, rate_hz, frames);
            const auto source = band_passed(source_of(in), low, high, rate_hz);
            QVERIFY(bool(source));
            const Samples out = read_all(**source);
            VYBEG_CLOSE(largest_difference(out.c, in.c), 0, 1e-4, qPrintable(QString::number(f)));
            VYBEG_CLOSE(largest_difference(out.d, in.d), 0, 1e-4, qPrintable(QString::number(f)));
        }
    }

    void a_sinusoid_outside_of_the_transitions_is_80_db_down_data() { add_bands(); }

    void a_sinusoid_outside_of_the_transitions_is_80_db_down() {
        QFETCH(double, low);
        QFETCH(double, high);
        QFETCH(double, rate_hz);
        const double width = transition(low, high, rate_hz);
        const std::int64_t frames = frames_for(low, high, rate_hz);
        for (int step = 0; step <= 8; ++step) {
            for (const double f : {(low - width) * step / 8,
                                   rate_hz / 2 - (rate_hz / 2 - high - width) * step / 8}) {
                const auto source =
                    band_passed(source_of(sinusoid(f, rate_hz, frames)), low, high, rate_hz);
                QVERIFY(bool(source));
                const Samples out = read_all(**source);
                const std::vector<double> silence(out.c.size());
                VYBEG_CLOSE(largest_difference(out.c, silence), 0, 1e-4,
                            qPrintable(QString::number(f)));
                VYBEG_CLOSE(largest_difference(out.d, silence), 0, 1e-4,
                            qPrintable(QString::number(f)));
            }
        }
    }

    void exactly_the_reach_is_missing_at_each_end_data() { add_bands(); }

    void exactly_the_reach_is_missing_at_each_end() {
        QFETCH(double, low);
        QFETCH(double, high);
        QFETCH(double, rate_hz);
        const std::int64_t reach = band_pass_reach(low, high, rate_hz);
        for (const std::int64_t frames :
             {2 * reach + 1, 2 * reach + 2, frames_for(low, high, rate_hz)}) {
            const auto source = band_passed(source_of(noise(frames, 2)), low, high, rate_hz);
            QVERIFY(bool(source));
            const Samples out = read_all(**source);
            const QString expected =
                QString("0-%1 %2-%3").arg(reach).arg(frames - reach).arg(frames);
            QCOMPARE(missing_ranges(out.c), expected);
            QCOMPARE(missing_ranges(out.d), expected);
        }
    }

    void a_frame_has_the_same_bits_however_reads_are_cut() {
        const std::int64_t frames = 100000;
        const auto make = [&] {
            return *band_passed(
                source_of(with_missing(noise(frames, 4), {100, 31000, 31001, 60000}, no_value)),
                5200, 5400, rate);
        };
        QVERIFY(same_however_cut(*make(), 20000));
        // A fresh source, whose first block is another one, has them too.
        const Samples all = read_all(*make());
        const Samples late = read(*make(), 70001, 13);
        QVERIFY(same_bits(late.c, std::span(all.c).subspan(70001, 13)));
        QVERIFY(same_bits(late.d, std::span(all.d).subspan(70001, 13)));
    }

    void several_threads_read_the_same_bits() {
        const std::int64_t frames = 100000;
        const auto samples = noise(frames, 5);
        const Samples all = read_all(**band_passed(source_of(samples), 5200, 5400, rate));
        const auto shared = *band_passed(source_of(samples), 5200, 5400, rate);
        std::array<int, 4> differences{};
        std::vector<std::jthread> threads;
        for (std::size_t thread = 0; thread < differences.size(); ++thread) {
            threads.emplace_back([&, thread] {
                std::mt19937_64 random(thread);
                for (int i = 0; i < 100; ++i) {
                    const std::int64_t first = static_cast<std::int64_t>(random() % 90000);
                    const Samples part = read(*shared, first, 10000);
                    const auto at = static_cast<std::size_t>(first);
                    differences[thread] += !same_bits(part.c, std::span(all.c).subspan(at, 10000)) +
                                           !same_bits(part.d, std::span(all.d).subspan(at, 10000));
                }
            });
        }
        threads.clear();
        QCOMPARE(differences, (std::array<int, 4>{}));
    }

    void a_missing_sample_takes_its_channel_within_reach_and_nothing_else_data() {
        QTest::addColumn<double>("value");
        QTest::newRow("NaN") << no_value;
        QTest::newRow("infinite") << std::numeric_limits<double>::infinity();
        QTest::newRow("minus infinite") << -std::numeric_limits<double>::infinity();
    }

    void a_missing_sample_takes_its_channel_within_reach_and_nothing_else() {
        QFETCH(double, value);
        const std::int64_t frames = 40000;
        const std::int64_t reach = band_pass_reach(5200, 5400, rate);
        const Samples clean = noise(frames, 6);
        const Samples filtered = read_all(**band_passed(source_of(clean), 5200, 5400, rate));
        const auto expected = [&](std::int64_t first, std::int64_t last) {
            return QString("0-%1 %2-%3 %4-%5")
                .arg(reach)
                .arg(first - reach)
                .arg(last + reach + 1)
                .arg(frames - reach)
                .arg(frames);
        };
        // Every position on the grid of blocks, whatever its step is.
        for (std::int64_t at = 5000; at < 30000; at += 617) {
            const Samples holed = with_missing(clean, {at, at + 10}, value);
            const Samples out = read_all(**band_passed(source_of(holed), 5200, 5400, rate));
            QCOMPARE(missing_ranges(out.c), expected(at, at + 10));
            QCOMPARE(missing_ranges(out.d), missing_ranges(filtered.d));
            // What is left is what was there before, to rounding in the transform.
            VYBEG_CLOSE(largest_difference(out.c, filtered.c), 0, 1e-13);
            VYBEG_CLOSE(largest_difference(out.d, filtered.d), 0, 1e-13);
        }
    }

    void two_missing_samples_further_apart_than_the_reach_leave_frames_between_them() {
        const std::int64_t reach = band_pass_reach(4000, 7000, rate);
        const std::int64_t first = 3000;
        const std::int64_t second = first + 2 * reach + 2;
        const Samples holed = with_missing(noise(10000, 8), {first, second}, no_value);
        const Samples out = read_all(**band_passed(source_of(holed), 4000, 7000, rate));
        QCOMPARE(missing_ranges(out.c), QString("0-%1 %2-%3 %4-%5 %6-10000")
                                            .arg(reach)
                                            .arg(first - reach)
                                            .arg(first + reach + 1)
                                            .arg(second - reach)
                                            .arg(second + reach + 1)
                                            .arg(10000 - reach));
    }

    void an_impossible_band_is_refused_data() {
        QTest::addColumn<double>("low");
        QTest::addColumn<double>("high");
        QTest::newRow("zero") << 0.0 << 100.0;
        QTest::newRow("negative") << -5.0 << 100.0;
        QTest::newRow("empty") << 100.0 << 100.0;
        QTest::newRow("falling") << 200.0 << 100.0;
        QTest::newRow("half the rate") << 100.0 << 500.0;
        QTest::newRow("above half the rate") << 600.0 << 700.0;
        QTest::newRow("no number") << no_value << 100.0;
        QTest::newRow("no number above") << 100.0 << no_value;
    }

    void an_impossible_band_is_refused() {
        QFETCH(double, low);
        QFETCH(double, high);
        const auto result = band_passed(source_of(noise(10000, 1)), low, high, 1000);
        QVERIFY(!result);
        QCOMPARE(result.error().code, ErrorCode::band_invalid);
        QCOMPARE(result.error().args.size(), 3U);
        QCOMPARE(result.error().args[2], "500");
    }

    void a_filter_that_leaves_no_frame_is_refused() {
        const std::int64_t reach = band_pass_reach(5200, 5400, rate);
        const auto result = band_passed(source_of(noise(2 * reach, 1)), 5200, 5400, rate);
        QVERIFY(!result);
        const Error expected{.code = ErrorCode::filter_too_long,
                             .where = "",
                             .args = {std::to_string(reach), std::to_string(2 * reach)}};
        QCOMPARE(result.error(), expected);
        // Nor does a band that asks for an endless one take memory first.
        const auto endless = band_passed(source_of(noise(1000, 1)), 1e-300, 100, 1000);
        QVERIFY(!endless);
        QCOMPARE(endless.error().code, ErrorCode::filter_too_long);
    }

    void errors_of_the_source_are_passed_on() {
        const auto source = band_passed(std::make_shared<FailingSource>(100000), 5200, 5400, rate);
        QVERIFY(bool(source));
        std::vector<double> c(100);
        std::vector<double> d(100);
        const Status status = (*source)->read(50000, c, d);
        QVERIFY(!status);
        QCOMPARE(status.error(), FailingSource::error());
    }
};

VYBEG_TEST(TestFilteredSource, threads)

}  // namespace test_filtered_source

#include "test_filtered_source.moc"
