#include "core/analysis/analyse.h"
#include "core/analysis/analysis.h"
#include "core/analysis/settings.h"
#include "core/track/track.h"
#include "tests/closeness.h"
#include "tests/statistical/simulated_recording.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace test_analyse {

using namespace vybeg;

namespace {

FreeDecay short_decay() {
    FreeDecay decay{.seconds = 1, .a_B = 0.2, .noise = 0.001};
    return decay;
}

// Two tracks have the same bits in every column.
bool identical(const Track& a, const Track& b) {
    const auto same = [](std::span<const double> x, std::span<const double> y) {
        return std::equal(x.begin(), x.end(), y.begin(), y.end(), [](double p, double q) {
            return std::bit_cast<std::uint64_t>(p) == std::bit_cast<std::uint64_t>(q);
        });
    };
    bool equal = same(a.time_s(), b.time_s()) && std::ranges::equal(a.flags(), b.flags());
    for (const SlowVariable variable : all_slow_variables) {
        equal = equal && same(a.values(variable), b.values(variable)) &&
                same(a.sds(variable), b.sds(variable));
    }
    return equal;
}

ErrorCode code_of(const Recording& recording, const Settings& settings) {
    const Result<Analysis> analysis = analyse(recording, settings, {});
    return analysis ? ErrorCode::setting_invalid : analysis.error().code;
}

}  // namespace

class TestAnalyse : public QObject {
    Q_OBJECT

private slots:
    void fillsInWhatWasLeftOpen() {
        const Recording recording = test::simulated_recording(short_decay());
        Settings settings;
        settings.periods = 10;
        settings.snap = true;
        const Result<Analysis> analysis = analyse(recording, settings, {});
        QVERIFY(analysis);
        VYBEG_CLOSE(analysis->f0_hz(), 5300, 0.1);
        QCOMPARE(analysis->settings.window, 66);  // ten periods are 62.9; 66 are 20.99 half-periods
        QCOMPARE(analysis->settings.hop, 66);
        VYBEG_LESS(analysis->residual, 0.001);
        QCOMPARE(analysis->track.rows(), std::size_t{33333 / 66});
    }

    // Windows about a carrier that was told see another line as noise, and a wave that is none.
    void aLineBeyondTheGivenCarrierIsNamed() {
        const Recording recording = test::simulated_recording(short_decay());
        for (const double f0 : {4000.0, 4300.0, 4900.0, 5299.0, 5310.0, 5600.0, 6300.0, 6500.0}) {
            Settings settings;
            settings.f0_hz = f0;
            const Result<Analysis> analysis = analyse(recording, settings, {});
            QVERIFY(analysis);
            const auto named = std::ranges::find(
                analysis->diagnostics, DiagnosticKind::carrier_out_of_reach, &Diagnostic::kind);
            const bool far = std::abs(f0 - 5300) > 33333.0 / 60;
            VYBEG_EQUAL(named != analysis->diagnostics.end(), far, qPrintable(QString::number(f0)));
            if (far) {
                VYBEG_CLOSE(std::stod(english(named->args[0])), 5300, 1);
            }
        }
        // Noise has no other line.
        FreeDecay noise = short_decay();
        noise.noise = 30;
        Settings settings;
        settings.f0_hz = 5300;
        const Result<Analysis> analysis = analyse(test::simulated_recording(noise), settings, {});
        QVERIFY(analysis);
        QVERIFY(std::ranges::find(analysis->diagnostics, DiagnosticKind::carrier_out_of_reach,
                                  &Diagnostic::kind) == analysis->diagnostics.end());
    }

    void resultIsTheSameForAnyNumberOfThreads() {
        FreeDecay decay = demo_decay();
        decay.seconds = 10;  // more than one chunk
        const Recording recording = test::simulated_recording(decay);
        for (const Algorithm algorithm :
             {Algorithm::in_phase, Algorithm::phase_shift, Algorithm::moving_axes,
              Algorithm::demodulation, Algorithm::conjugate_gradient,
              Algorithm::maximum_likelihood}) {
            Settings settings;
            settings.algorithm = algorithm;
            settings.window = 22;
            settings.threads = 1;
            const Result<Analysis> one = analyse(recording, settings, {});
            settings.threads = 2;
            const Result<Analysis> two = analyse(recording, settings, {});
            settings.threads = 5;
            const Result<Analysis> five = analyse(recording, settings, {});
            QVERIFY(one && two && five);
            QVERIFY2(identical(one->track, two->track), algorithm_name(algorithm).data());
            QVERIFY2(identical(one->track, five->track), algorithm_name(algorithm).data());
        }
    }

    void slidingWindowsAgreeWithDiscreteOnes() {
        FreeDecay decay = short_decay();
        decay.seconds = 0.2;
        const Recording recording = test::simulated_recording(decay);
        Settings settings;
        settings.window = 60;
        const Result<Analysis> discrete = analyse(recording, settings, {});
        settings.hop = 1;
        const Result<Analysis> sliding = analyse(recording, settings, {});
        QVERIFY(discrete && sliding);
        QCOMPARE(sliding->track.rows(), static_cast<std::size_t>(recording.frames() - 59));
        for (std::size_t k = 0; k < discrete->track.rows(); ++k) {
            QCOMPARE(sliding->track.time_s()[60 * k], discrete->track.time_s()[k]);
            QCOMPARE(sliding->track.values(SlowVariable::a_A)[60 * k],
                     discrete->track.values(SlowVariable::a_A)[k]);
            QCOMPARE(sliding->track.values(SlowVariable::f)[60 * k],
                     discrete->track.values(SlowVariable::f)[k]);
        }
    }

    void rangeIsKept() {
        const Recording recording = test::simulated_recording(short_decay());
        Settings settings;
        settings.from_s = 0.25;
        settings.to_s = 0.5;
        const Result<Analysis> analysis = analyse(recording, settings, {});
        QVERIFY(analysis);
        VYBEG_AT_LEAST(analysis->track.time_s().front(), 0.25);
        VYBEG_AT_MOST(analysis->track.time_s().back(), 0.5);
        QCOMPARE(analysis->plan.first, 8334);  // the first frame not before 0.25 s
        QCOMPARE(analysis->track.rows(), std::size_t{(16667 - 8334) / 60});
    }

    void calibrationTakesOutWhatTheChannelsAdd() {
        FreeDecay decay = short_decay();
        decay.kappa = 1.03;
        decay.offset_c = 0.5;
        decay.offset_d = -0.2;
        const Recording recording = test::simulated_recording(decay);
        const auto error_of = [&](const Settings& settings) {
            const Result<Analysis> analysis = analyse(recording, settings, {});
            const auto angle = analysis->track.values(SlowVariable::two_theta_A);
            double sum = 0;
            for (const double value : angle) {
                sum += value - decay.two_theta_A;
            }
            return std::abs(sum / static_cast<double>(angle.size()));
        };
        Settings settings;
        // sd of 2theta_A in a window is 2e-4 and of the mean of 555 windows 1e-5.
        VYBEG_MORE(error_of(settings), 3e-3);
        settings.calibration.kappa = 1.03;
        settings.calibration.offset_c = 0.5;
        settings.calibration.offset_d = -0.2;
        VYBEG_CLOSE(error_of(settings), 0, 5e-5);
        settings.calibration.offset_c = settings.calibration.offset_d = 0;
        settings.calibration.offset_auto = true;
        VYBEG_CLOSE(error_of(settings), 0, 5e-5);
        const Result<Analysis> analysis = analyse(recording, settings, {});
        VYBEG_CLOSE(analysis->settings.calibration.offset_c, 0.5, 1e-4);
        VYBEG_CLOSE(analysis->settings.calibration.offset_d, -0.2, 1e-4);
    }

    void electrodeAngleIsSubtracted() {
        const Recording recording = test::simulated_recording(short_decay());
        Settings settings;
        const double before =
            analyse(recording, settings, {})->track.values(SlowVariable::two_theta_A)[0];
        settings.calibration.angle_zero_deg = 5;
        const double after =
            analyse(recording, settings, {})->track.values(SlowVariable::two_theta_A)[0];
        VYBEG_CLOSE(before - after, 10 * std::numbers::pi / 180, 1e-12);
    }

    void filterFlagsItsTransients() {
        const Recording recording = test::simulated_recording(short_decay());
        Settings settings;
        settings.filter = Band{5000, 5600};
        const Result<Analysis> analysis = analyse(recording, settings, {});
        QVERIFY(analysis);
        const auto flags = analysis->track.flags();
        QVERIFY(has(flags.front(), Flag::filter_transient));
        QVERIFY(has(flags.back(), Flag::filter_transient));
        const auto clean = std::count(flags.begin(), flags.end(), Flags{0});
        VYBEG_MORE(clean, 450);
        VYBEG_LESS(clean, 555);
        VYBEG_CLOSE(analysis->track.values(SlowVariable::a_A)[250], 1, 1e-3);
        QVERIFY(std::ranges::any_of(analysis->diagnostics, [](const Diagnostic& d) {
            return d.kind == DiagnosticKind::filter_transients;
        }));
    }

    void windowsOverMissingSamplesAreFlaggedAndEmpty() {
        Recording recording = test::simulated_recording(short_decay());
        std::vector<double> c(static_cast<std::size_t>(recording.frames()));
        std::vector<double> d(c.size());
        QVERIFY(recording.source->read(0, c, d));
        c[605] = std::nan("");
        d[1205] = std::numeric_limits<double>::infinity();
        recording.source = memory_source(c, d);
        for (const Algorithm algorithm :
             {Algorithm::in_phase, Algorithm::conjugate_gradient, Algorithm::maximum_likelihood}) {
            Settings settings;
            settings.algorithm = algorithm;
            const Result<Analysis> analysis = analyse(recording, settings, {});
            QVERIFY(analysis);
            for (std::size_t k = 0; k < analysis->track.rows(); ++k) {
                const bool gap = k == 10 || k == 20;
                QCOMPARE(has(analysis->track.flags()[k], Flag::gap), gap);
                QCOMPARE(std::isnan(analysis->track.values(SlowVariable::a_A)[k]), gap);
                QCOMPARE(std::isnan(analysis->track.values(SlowVariable::rms)[k]), gap);
            }
        }
    }

    void uncertaintyOfTheRateIsInThatOfTheFrequency() {
        Recording recording = test::simulated_recording(short_decay());
        Settings settings;
        settings.periods = 100;
        const Result<Analysis> exact = analyse(recording, settings, {});
        for (const double relative : {1e-7, 1e-5, 1e-3}) {
            recording.rate_relative_sd = relative;
            const Result<Analysis> open = analyse(recording, settings, {});
            QVERIFY(exact && open);
            for (std::size_t row = 0; row < open->track.rows(); row += 7) {
                const double f = exact->track.values(SlowVariable::f)[row];
                const double expected =
                    std::hypot(exact->track.sds(SlowVariable::f)[row], relative * f);
                const double sd = open->track.sds(SlowVariable::f)[row];
                VYBEG_CLOSE_RATIO(sd, expected, 1e-12);
                QCOMPARE(open->track.values(SlowVariable::f)[row], f);
                QCOMPARE(open->track.sds(SlowVariable::a_A)[row],
                         exact->track.sds(SlowVariable::a_A)[row]);
            }
        }
    }

    void impossibleAnalysesAreNamed() {
        const Recording recording = test::simulated_recording(short_decay());
        Settings settings;
        settings.window = 40000;
        QVERIFY(code_of(recording, settings) == ErrorCode::window_too_long);
        settings = {};
        settings.f0_hz = 17000;
        QVERIFY(code_of(recording, settings) == ErrorCode::carrier_above_half_rate);
        settings = {};
        settings.f0_hz = 1000;
        settings.window = 10;
        QVERIFY(code_of(recording, settings) == ErrorCode::window_too_short);
        for (const Algorithm algorithm :
             {Algorithm::in_phase, Algorithm::phase_shift, Algorithm::moving_axes,
              Algorithm::demodulation, Algorithm::conjugate_gradient,
              Algorithm::maximum_likelihood}) {
            settings = {};
            settings.algorithm = algorithm;
            settings.f0_hz = 0.4914 * 33333;
            settings.window = 7;
            QVERIFY(code_of(recording, settings) == ErrorCode::window_too_short);
        }
        settings = {};
        settings.from_s = 2;
        QVERIFY(code_of(recording, settings) == ErrorCode::range_empty);
        settings = {};
        settings.band = Band{17000, 18000};
        QVERIFY(code_of(recording, settings) == ErrorCode::band_invalid);
        settings = {};
        settings.filter = Band{5299.99, 5300.01};
        QVERIFY(code_of(recording, settings) == ErrorCode::filter_too_long);
        settings = {};
        settings.hop = -1;
        QVERIFY(code_of(recording, settings) == ErrorCode::setting_invalid);
    }

    void cancellingInterrupts() {
        const Recording recording = test::simulated_recording(short_decay());
        std::stop_source stop;
        stop.request_stop();
        const Result<Analysis> analysis = analyse(recording, {}, JobControl(stop.get_token()));
        QVERIFY(!analysis);
        QVERIFY(analysis.error().code == ErrorCode::interrupted);
    }

    void progressRisesToOne() {
        FreeDecay decay = short_decay();
        decay.seconds = 20;
        const Recording recording = test::simulated_recording(decay);
        std::vector<double> told;
        const JobControl job({}, [&told](double fraction) { told.push_back(fraction); });
        QVERIFY(analyse(recording, {}, job));
        VYBEG_MORE(told.size(), 1);
        QVERIFY(std::ranges::is_sorted(told));
        QCOMPARE(told.back(), 1.0);
    }
};

VYBEG_TEST(TestAnalyse, threads)

}  // namespace test_analyse

#include "test_analyse.moc"
