// Lines in the spectrum of a residual against those that were simulated.
#include "tests/closeness.h"
#include "tests/core/residuals/simulated_residuals.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <cmath>

namespace test_residual_lines {

using namespace vybeg;
using namespace vybeg::test;

class TestResidualLines : public QObject {
    Q_OBJECT

private slots:
    void a_line_is_found_with_its_frequency_and_amplitude_and_named_data() {
        QTest::addColumn<double>("f_hz");
        QTest::addColumn<double>("tau_s");
        QTest::addColumn<int>("origin");
        QTest::addColumn<int>("order");
        const auto row = [](const char* name, double f_hz, double tau_s, LineOrigin origin,
                            int order) {
            QTest::newRow(name) << f_hz << tau_s << static_cast<int>(origin) << order;
        };
        row("mains", 50.03, 1e300, LineOrigin::mains, 1);
        row("third harmonic of the mains", 149.96, 1e300, LineOrigin::mains, 3);
        row("mains of America", 59.98, 1e300, LineOrigin::mains, 1);
        row("supply of an aircraft", 400.2, 1e300, LineOrigin::mains, 1);
        row("second harmonic", 10600, 1e300, LineOrigin::carrier_harmonic, 2);
        row("third harmonic", 15900, 20, LineOrigin::carrier_harmonic, 3);
        row("folded harmonic", 33333 - 4 * 5300.0, 1e300, LineOrigin::folded_harmonic, 4);
        row("another mode", 7123.4, 10, LineOrigin::other_mode, 0);
        row("a mode near the carrier", 5211.7, 10, LineOrigin::other_mode, 0);
        row("a steady line", 7123.4, 1e300, LineOrigin::unknown, 0);
    }

    void a_line_is_found_with_its_frequency_and_amplitude_and_named() {
        QFETCH(double, f_hz);
        QFETCH(double, tau_s);
        QFETCH(int, origin);
        QFETCH(int, order);
        for (unsigned seed = 1; seed <= 3; ++seed) {
            FreeDecay decay = still_wave(20);
            decay.seed = seed;
            decay.modes_beside = {{f_hz, 3e-4, 2e-4, 0.3, 1.1, tau_s}};
            const Recording recording = simulated_recording(decay);
            // Windows of a second: the line is far outside their lobe.
            const Analysis analysis = analysed(recording, windows_of(33333));
            const Residuals found = residuals(recording, analysis);
            const ResidualLine* line = line_near(found, f_hz);
            QVERIFY2(line, qPrintable(names_of(found)));
            const bool steady = tau_s > 1e3;
            // Noise of 1e-3 at 20 s leaves 2e-6 of an amplitude; 5 sd and 1 % of interpolation.
            if (steady) {
                VYBEG_CLOSE(line->amplitude_c, 3e-4, 5 * line->sd_c + 3e-6);
                VYBEG_CLOSE(line->amplitude_d, 2e-4, 5 * line->sd_d + 2e-6);
                VYBEG_LESS(line->sd_c, 5e-6);
            } else {
                const double x = 2 * decay.seconds / tau_s;
                const double mean = std::sqrt((1 - std::exp(-x)) / x);
                VYBEG_CLOSE_RATIO(line->amplitude_c, 3e-4 * mean, 0.05);
            }
            VYBEG_CLOSE(line->f_hz, f_hz, 0.05 * found.bin_hz + 0.03);
            QCOMPARE(static_cast<int>(line->origin), origin);
            QCOMPARE(line->order, order);
            VYBEG_EQUAL(found.lines.size(), 1, qPrintable(names_of(found)));
        }
    }

    // Hum 30 times the noise, at all places between two bins, with its third harmonic.
    void the_side_lobes_of_a_strong_line_are_none() {
        for (int part = 0; part < 10; ++part) {
            FreeDecay decay = still_wave(20);
            decay.seed = static_cast<std::uint64_t>(part) + 1;
            const double f_hz = 49.9 + 0.02 * part;
            decay.modes_beside = {{f_hz, 3e-2, 2e-2, 0.3, 1.1, 1e300},
                                  {3 * f_hz, 3e-3, 2e-3, 0.2, 0.4, 1e300}};
            const Recording recording = simulated_recording(decay);
            const Residuals found = residuals(recording, analysed(recording, windows_of(33333)));
            VYBEG_EQUAL(found.lines.size(), 2, qPrintable(names_of(found)));
            for (const ResidualLine& line : found.lines) {
                QVERIFY2(line.origin == LineOrigin::mains, qPrintable(names_of(found)));
            }
        }
    }

    // Over 100 seeds: the stated deviation of a line's amplitude within a quarter.
    void the_amplitude_of_a_line_scatters_as_stated() {
        double squares = 0;
        constexpr int trials = 100;
        for (unsigned seed = 1; seed <= trials; ++seed) {
            FreeDecay decay = still_wave(2);
            decay.seed = seed;
            decay.modes_beside = {{7123.4 + 0.37 * seed, 4e-4, 4e-4, 0.3, 1.1, 1e300}};
            const Recording recording = simulated_recording(decay);
            const Residuals found = residuals(recording, analysed(recording, windows_of(16666)));
            const ResidualLine* line = line_near(found, decay.modes_beside.front().f_hz);
            QVERIFY2(line, qPrintable(names_of(found)));
            squares += std::pow((line->amplitude_c - 4e-4) / line->sd_c, 2) / (2.0 * trials);
            squares += std::pow((line->amplitude_d - 4e-4) / line->sd_d, 2) / (2.0 * trials);
        }
        VYBEG_CLOSE_RATIO(std::sqrt(squares), 1, 0.25);
    }

    void white_noise_shows_lines_as_seldom_as_stated() {
        int with_lines = 0;
        constexpr int trials = 200;
        for (unsigned seed = 1; seed <= trials; ++seed) {
            FreeDecay decay = still_wave(seed % 2 == 0 ? 0.25 : 1.5);
            decay.seed = 1000 + seed;
            const Recording recording = simulated_recording(decay);
            const Residuals found =
                residuals(recording, analysed(recording, windows_of(seed % 2 == 0 ? 60 : 1000)));
            with_lines += found.lines.empty() ? 0 : 1;
        }
        VYBEG_AT_MOST(with_lines, 2 + 3 * std::sqrt(2.0));
    }

    void a_decay_inside_long_windows_is_the_wave_itself() {
        FreeDecay decay = still_wave(20);
        decay.tau_s = 5;
        const Recording recording = simulated_recording(decay);
        const Residuals found = residuals(recording, analysed(recording, windows_of(3333)));
        QVERIFY(!found.lines.empty());
        for (const ResidualLine& line : found.lines) {
            QVERIFY2(line.origin == LineOrigin::wave || line.origin == LineOrigin::window_rate,
                     qPrintable(names_of(found)));
            QVERIFY(!line.filter);
        }
    }

    // A line on one side alone is no modulation: modes of a bell lie at such distances by chance.
    void a_modulation_by_the_mains_has_both_its_lines() {
        for (const bool both : {true, false}) {
            FreeDecay decay = still_wave(20);
            decay.modes_beside = {{5400, 3e-4, 2e-4, 0.3, 1.1, 1e300}};
            if (both) {
                decay.modes_beside.push_back({5200, 2e-4, 2e-4, 0.2, 0.1, 1e300});
            }
            const Recording recording = simulated_recording(decay);
            const Residuals found = residuals(recording, analysed(recording, windows_of(33333)));
            const ResidualLine* line = line_near(found, 5400);
            QVERIFY2(line, qPrintable(names_of(found)));
            QCOMPARE(line->origin, both ? LineOrigin::carrier_by_mains : LineOrigin::unknown);
            QCOMPARE(line->order, both ? 2 : 0);
        }
    }

    // Windows of 1.8 ms take up a little of hum, at 555.55 Hz.
    void images_of_a_line_by_the_windows_are_named_after_it() {
        FreeDecay decay = still_wave(30);
        decay.hum = 2 * noise;
        const Recording recording = simulated_recording(decay);
        const Residuals found = residuals(recording, analysed(recording, windows_of(60)));
        const ResidualLine* hum = line_near(found, 50);
        QVERIFY2(hum && hum->origin == LineOrigin::mains, qPrintable(names_of(found)));
        VYBEG_MORE(found.lines.size(), 3, qPrintable(names_of(found)));
        for (const ResidualLine& line : found.lines) {
            if (&line != hum) {
                QVERIFY2(line.origin == LineOrigin::window_image, qPrintable(names_of(found)));
                VYBEG_CLOSE(line.base_hz, 50, 0.1);
            }
        }
    }

    void the_offered_filter_takes_the_line_out() {
        for (const double f : {50.0, 4900.0, 5600.0, 9000.0}) {
            FreeDecay decay = still_wave(10);
            decay.modes_beside = {{f, 1e-3, 1e-3, 0.3, 1.1, 1e300}};
            const Recording recording = simulated_recording(decay);
            Settings settings = windows_of(3333);
            const Residuals before = residuals(recording, analysed(recording, settings));
            const ResidualLine* line = line_near(before, f);
            QVERIFY2(line && line->filter, qPrintable(names_of(before)));
            settings.filter = line->filter;
            const Residuals after = residuals(recording, analysed(recording, settings));
            QVERIFY2(!line_near(after, f), qPrintable(names_of(after)));
            QVERIFY(std::isnan(after.c.noise_sd));
            // 80 dB, with the noise of the passband left.
            const auto bin = static_cast<std::size_t>(std::llround(f / after.bin_hz));
            VYBEG_LESS(after.c.density[bin], 1e-6 * before.c.density[bin]);
            VYBEG_LESS(after.c.moments.sd, before.c.moments.sd);
        }
    }
};

VYBEG_TEST(TestResidualLines, threads)

}  // namespace test_residual_lines

#include "test_residual_lines.moc"
