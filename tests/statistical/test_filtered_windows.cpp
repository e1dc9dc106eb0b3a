#include "core/analysis/analyse.h"
#include "core/analysis/analysis.h"
#include "core/analysis/settings.h"
#include "core/estimators/wave/estimator.h"
#include "core/simulation/simulate.h"
#include "tests/closeness.h"
#include "tests/statistical/simulated_recording.h"
#include "tests/statistical/track_errors.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <algorithm>

namespace test_filtered_windows {

using namespace vybeg;
using namespace vybeg::test;

// A still wave in white noise behind a band-pass, against the simulator's truth, from samples.
// Where the band is B wide, about 2 B T values of a recording of T seconds are independent: 2000
// for 50 Hz and 20 s, and a deviation over them is known to 1.6 %.
class TestFilteredWindows : public QObject {
    Q_OBJECT

private slots:
    void deviations_are_right_within_a_tenth_data() {
        QTest::addColumn<double>("low");
        QTest::addColumn<double>("high");
        QTest::addColumn<int>("n");
        struct Edges {
            double low, high;
        };
        for (const Edges band : {Edges{5275, 5325}, Edges{5200, 5400}, Edges{5290, 5420},
                                 Edges{5050, 5550}, Edges{4300, 6300}}) {
            for (const int n : {20, 60, 63, 300, 2000}) {
                QTest::addRow("%g to %g Hz, %d", band.low, band.high, n)
                    << band.low << band.high << n;
            }
        }
    }
    void deviations_are_right_within_a_tenth() {
        QFETCH(double, low);
        QFETCH(double, high);
        QFETCH(int, n);
        std::array<double, 5> squares{};
        std::array<double, 5> variances{};
        std::array<double, 5> sums{};
        double count = 0;
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const FreeDecay wave{.seconds = 20,
                                 .a_B = seed == 2 ? -0.3 : 0.2,
                                 .two_theta_A = 0.3 + 2 * static_cast<double>(seed),
                                 .noise = seed == 3 ? 1e-2 : 1e-3,
                                 .seed = seed + static_cast<std::uint64_t>(n)};
            Settings settings;
            settings.window = n;
            settings.f0_hz = wave.f0_hz;
            settings.filter = Band{low, high};
            const Result<Analysis> analysis = analyse(simulated_recording(wave), settings, {});
            QVERIFY(analysis);
            const Result<Track> truth = true_track(wave, n);
            QVERIFY(truth);
            const Track& track = analysis->track;
            for (std::size_t k = 0; k < track.rows(); ++k) {
                if (track.flags()[k] != 0) {
                    continue;
                }
                count += 1;
                for (std::size_t v = 0; v < variables_with_sd.size(); ++v) {
                    const double error = error_of(track, *truth, variables_with_sd[v], k, k);
                    const double sd = track.sds(variables_with_sd[v])[k];
                    squares[v] += error * error / (wave.noise * wave.noise);
                    variances[v] += sd * sd / (wave.noise * wave.noise);
                    sums[v] += error / wave.noise;
                }
            }
        }
        VYBEG_MORE(count, 0.9 * 60 * 33333 / n);
        QString found;
        for (std::size_t v = 0; v < variables_with_sd.size(); ++v) {
            found += QString("%1: error/sd %2, mean/sd %3  ")
                         .arg(info(variables_with_sd[v]).column)
                         .arg(std::sqrt(squares[v] / variances[v]))
                         .arg(sums[v] / count / std::sqrt(variances[v] / count));
        }
        qInfo("%s", qPrintable(found));
        const double independent = std::min(count, 2 * (high - low) * 60);
        for (std::size_t v = 0; v < variables_with_sd.size(); ++v) {
            VYBEG_CLOSE(std::sqrt(squares[v] / variances[v]), 1, 0.1, qPrintable(found));
            VYBEG_CLOSE(sums[v] / count, 0, 5 * std::sqrt(variances[v] / count / independent),
                        qPrintable(found));
        }
    }

    // 28 s at 80 dB know the amplitude to 1e-7: a thousandth of the passband's ripple.
    void the_band_pass_keeps_the_amplitude_of_the_carrier() {
        for (const Band band : {Band{5200, 5400}, Band{5275, 5325}, Band{5000, 5600}}) {
            for (const double f0 : {5297.3, 5300.0, 5311.7}) {
                const FreeDecay wave{.seconds = 5, .f0_hz = f0, .noise = 1e-4};
                Settings settings;
                settings.window = 630;
                settings.filter = band;
                const Result<Analysis> analysis = analyse(simulated_recording(wave), settings, {});
                QVERIFY(analysis);
                double sum = 0;
                double variance = 0;
                double count = 0;
                for (std::size_t k = 0; k < analysis->track.rows(); ++k) {
                    if (analysis->track.flags()[k] == 0) {
                        sum += analysis->track.values(SlowVariable::a_A)[k] - 1;
                        const double sd = analysis->track.sds(SlowVariable::a_A)[k];
                        variance += sd * sd;
                        count += 1;
                    }
                }
                // Windows of 19 ms behind 50 Hz are all but independent.
                const double pull = sum / std::sqrt(variance);
                VYBEG_MORE(count, 100);
                VYBEG_CLOSE(pull, 0, 5);
            }
        }
    }

    void transients_and_delays_have_reasons_of_their_own() {
        const FreeDecay wave{.seconds = 2, .a_B = 0.2, .noise = 1e-3};
        const Recording recording = simulated_recording(wave);
        const auto flags_of = [&recording](const Settings& settings) {
            const Result<Analysis> analysis = analyse(recording, settings, {});
            return analysis ? std::vector<Flags>(analysis->track.flags().begin(),
                                                 analysis->track.flags().end())
                            : std::vector<Flags>();
        };
        const auto without_gap = [](const std::vector<Flags>& flags) {
            return !flags.empty() &&
                   std::ranges::none_of(flags, [](Flags f) { return has(f, Flag::gap); });
        };
        Settings settings;
        settings.window = 63;
        settings.filter = Band{5200, 5400};
        std::vector<Flags> flags = flags_of(settings);
        QVERIFY(without_gap(flags));
        QVERIFY(has(flags.front(), Flag::filter_transient));
        QVERIFY(has(flags.back(), Flag::filter_transient));
        settings.filter.reset();
        settings.algorithm = Algorithm::phase_shift;
        flags = flags_of(settings);
        QVERIFY(without_gap(flags));
        QVERIFY(has(flags.front(), Flag::delay_reach) && has(flags.back(), Flag::delay_reach));
        settings.filter = Band{5200, 5400};
        settings.hop = 5;  // some windows lie beside the transient, within the delay's reach of it
        flags = flags_of(settings);
        QVERIFY(without_gap(flags));
        QVERIFY(std::ranges::any_of(flags, [](Flags f) { return has(f, Flag::delay_reach); }));
        QVERIFY(has(flags.front(), Flag::filter_transient));
        QCOMPARE(QString::fromStdString(flags_text(flags.front())), QString("filter-transient"));
    }
};

VYBEG_TEST(TestFilteredWindows)

}  // namespace test_filtered_windows

#include "test_filtered_windows.moc"
