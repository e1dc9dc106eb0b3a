#include "core/recording/conditioning/conditioned_source.h"
#include "tests/closeness.h"
#include "tests/core/recording/source_reading.h"
#include "tests/test_registry.h"

#include <QTest>

#include <numbers>

namespace test_calibrated_source {

using namespace vybeg;
using namespace vybeg::test;

namespace {

constexpr double rate = 33333;
constexpr double carrier = 5300;

double c_at(double t) {
    return 1.3 * std::cos(2 * std::numbers::pi * carrier * t - 0.4);
}

double d_at(double t) {
    return 0.8 * std::cos(2 * std::numbers::pi * carrier * t + 1.1);
}

// What pick-offs with these faults record: S_C = C + offset_c, S_D(t) = D(t - delay)/kappa +
// offset_d.
Samples recorded(const Calibration& faults, std::int64_t frames) {
    Samples samples;
    for (std::int64_t i = 0; i < frames; ++i) {
        const double t = static_cast<double>(i) / rate;
        samples.c.push_back(c_at(t) + faults.offset_c);
        samples.d.push_back(d_at(t - faults.delay_d_s) / faults.kappa + faults.offset_d);
    }
    return samples;
}

Samples ideal(std::int64_t frames) {
    return recorded({}, frames);
}

}  // namespace

class TestCalibratedSource : public QObject {
    Q_OBJECT

private slots:
    void nothing_to_do_gives_the_source_itself() {
        const auto source = source_of(ideal(100));
        QCOMPARE(calibrated(source, {}, rate), source);
        // The angle of the electrode and the wish for offsets are no matter of the samples.
        QCOMPARE(calibrated(source, {.offset_auto = true, .angle_zero_deg = 12}, rate), source);
        QVERIFY(calibrated(source, {.kappa = 1.01}, rate) != source);
        QVERIFY(calibrated(source, {.offset_c = 1e-9}, rate) != source);
        QVERIFY(calibrated(source, {.offset_d = 1e-9}, rate) != source);
        QVERIFY(calibrated(source, {.delay_d_s = 1e-9}, rate) != source);
    }

    void every_fault_is_taken_out_data() {
        QTest::addColumn<double>("kappa");
        QTest::addColumn<double>("offset_c");
        QTest::addColumn<double>("offset_d");
        QTest::addColumn<double>("delay_samples");
        QTest::addColumn<double>("tolerance");  // recording units; the amplitudes are about 1
        QTest::addColumn<QString>("missing");   // of 70100 frames
        // Rounding alone, with sines of arguments up to 7e4 (1e-11); 1e-6 for interpolation.
        QTest::newRow("gain") << 1.07 << 0.0 << 0.0 << 0.0 << 1e-10 << "";
        QTest::newRow("offsets") << 1.0 << 0.3 << -2.0 << 0.0 << 1e-10 << "";
        QTest::newRow("gain and offsets") << 0.9 << 0.3 << -2.0 << 0.0 << 1e-10 << "";
        QTest::newRow("whole delay") << 1.0 << 0.0 << 0.0 << 3.0 << 1e-10 << "70097-70100";
        QTest::newRow("whole advance") << 1.0 << 0.0 << 0.0 << -3.0 << 1e-10 << "0-3";
        QTest::newRow("half a sample") << 1.0 << 0.0 << 0.0 << 0.5 << 1e-6 << "0-20 70079-70100";
        QTest::newRow("all together")
            << 1.07 << 0.3 << -2.0 << 1.572 << 1.1e-6 << "0-19 70078-70100";
        QTest::newRow("negative") << 0.93 << 0.3 << -2.0 << -1.572 << 1e-6 << "0-22 70081-70100";
        QTest::newRow("longer than the filter")
            << 1.0 << 0.1 << 0.2 << 1000.37 << 1e-6 << "69079-70100";
        QTest::newRow("nearly the whole recording")
            << 1.0 << 0.1 << 0.2 << 70000.3 << 1e-6 << "79-70100";
    }

    void every_fault_is_taken_out() {
        QFETCH(double, kappa);
        QFETCH(double, offset_c);
        QFETCH(double, offset_d);
        QFETCH(double, delay_samples);
        QFETCH(double, tolerance);
        QFETCH(QString, missing);
        const Calibration calibration{.kappa = kappa,
                                      .offset_c = offset_c,
                                      .offset_d = offset_d,
                                      .delay_d_s = delay_samples / rate};
        const std::int64_t frames = 70100;  // more than a block of 65536
        const auto source = calibrated(source_of(recorded(calibration, frames)), calibration, rate);
        QCOMPARE(source->frames(), frames);
        const Samples samples = read_all(*source);
        const Samples truth = ideal(frames);
        VYBEG_CLOSE(largest_difference(samples.c, truth.c), 0, 1e-10);
        VYBEG_CLOSE(largest_difference(samples.d, truth.d), 0, tolerance);
        QCOMPARE(missing_ranges(samples.d), missing);
        QCOMPARE(missing_ranges(samples.c), missing);
    }

    void a_frame_has_the_same_bits_however_reads_are_cut() {
        for (const double delay : {1.572, -40.2, 5.0}) {
            const Calibration calibration{
                .kappa = 1.1, .offset_c = 0.1, .offset_d = 0.2, .delay_d_s = delay / rate};
            const auto source = calibrated(source_of(noise(70000, 1)), calibration, rate);
            QVERIFY(same_however_cut(*source, 3000));
        }
    }

    void a_missing_sample_spreads_over_the_reach_of_the_delay_in_d_alone() {
        Samples samples = ideal(2000);
        samples.d[1000] = no_value;
        samples.c[500] = no_value;
        const auto whole = calibrated(source_of(samples), {.delay_d_s = 4 / rate}, rate);
        QCOMPARE(missing_ranges(read_all(*whole).d), "996-997 1996-2000");
        QCOMPARE(missing_ranges(read_all(*whole).c), "500-501 1996-2000");
        const auto part = calibrated(source_of(samples), {.delay_d_s = 1.572 / rate}, rate);
        QCOMPARE(missing_ranges(read_all(*part).d), "0-19 978-1020 1978-2000");
        QCOMPARE(missing_ranges(read_all(*part).c), "0-19 500-501 1978-2000");
    }

    void a_delay_beyond_the_recording_leaves_nothing() {
        for (const double delay_s : {1.0, -1.0, 1e300, -1e300}) {
            const auto source = calibrated(source_of(ideal(200)), {.delay_d_s = delay_s}, rate);
            const Samples samples = read_all(*source);
            QCOMPARE(missing_ranges(samples.c), "0-200");
            QCOMPARE(missing_ranges(samples.d), "0-200");
        }
    }

    void errors_of_the_source_are_passed_on() {
        const auto failing = std::make_shared<FailingSource>(1000);
        std::vector<double> c(100);
        std::vector<double> d(100);
        for (const Calibration& calibration :
             {Calibration{.kappa = 2}, Calibration{.delay_d_s = 1e-5}}) {
            const Status status = calibrated(failing, calibration, rate)->read(500, c, d);
            QVERIFY(!status);
            QCOMPARE(status.error(), FailingSource::error());
        }
    }
};

VYBEG_TEST(TestCalibratedSource, threads)

}  // namespace test_calibrated_source

#include "test_calibrated_source.moc"
