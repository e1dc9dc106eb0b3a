#include "core/windows/carrier_search.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <numbers>
#include <random>
#include <vector>

namespace test_carrier {

using namespace vybeg;

namespace {

struct Pair {
    std::vector<double> c;
    std::vector<double> d;
};

// Two sinusoids of one frequency with amplitudes a_c and a_d in white noise.
Pair tones(std::size_t count, double f, double rate, double a_c, double a_d, double noise) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> gauss(0, 1);
    Pair pair;
    for (std::size_t j = 0; j < count; ++j) {
        const double phase = 2 * std::numbers::pi * f / rate * static_cast<double>(j);
        pair.c.push_back(a_c * std::cos(phase + 0.4) + noise * gauss(random));
        pair.d.push_back(a_d * std::sin(phase) + noise * gauss(random));
    }
    return pair;
}

}  // namespace

class TestCarrier : public QObject {
    Q_OBJECT

private slots:
    void isFoundToAHundredthOfABin() {
        for (const std::size_t count : {1000UL, 33333UL, 200000UL}) {
            const double bin = 33333.0 / static_cast<double>(count);
            for (double f = 4000; f < 9000; f += 371.123) {
                const Pair pair = tones(count, f, 33333, 1, 0.7, 1e-3);
                const Result<double> found = find_carrier(pair.c, pair.d, 33333, 1000, 16666);
                QVERIFY(found);
                VYBEG_CLOSE(*found, f, 0.01 * bin,
                            qPrintable(QString("%1 bins").arg((*found - f) / bin)));
            }
        }
    }

    void isFoundInEitherChannelAlone() {
        for (const bool first : {true, false}) {
            const Pair pair = tones(20000, 5300.3, 33333, first ? 1 : 0, first ? 0 : 1, 0.01);
            const Result<double> found = find_carrier(pair.c, pair.d, 33333, 100, 16666);
            QVERIFY(found);
            VYBEG_CLOSE(*found, 5300.3, 0.05);
        }
    }

    void ofSeveralTonesTheBandDecides() {
        Pair pair = tones(50000, 5300, 33333, 1, 1, 0.01);
        const Pair hum = tones(50000, 3000, 33333, 3, 3, 0);
        for (std::size_t j = 0; j < pair.c.size(); ++j) {
            pair.c[j] += hum.c[j];
            pair.d[j] += hum.d[j];
        }
        VYBEG_CLOSE(*find_carrier(pair.c, pair.d, 33333, 10, 16666), 3000, 0.1);
        VYBEG_CLOSE(*find_carrier(pair.c, pair.d, 33333, 5000, 6000), 5300, 0.1);
    }

    void offsetsAndMissingSamplesDoNotMislead() {
        Pair pair = tones(50000, 5300, 33333, 1, 1, 0.01);
        for (std::size_t j = 0; j < pair.c.size(); ++j) {
            pair.c[j] += 100;
            pair.d[j] -= 30;
            if (j % 1000 < 20) {
                pair.c[j] = std::nan("");
            }
        }
        const Result<double> found = find_carrier(pair.c, pair.d, 33333, 10, 16666);
        QVERIFY(found);
        VYBEG_CLOSE(*found, 5300, 0.1);
    }

    void noiseAloneHasNone() {
        for (const std::size_t count : {300UL, 5000UL, 200000UL}) {
            const Pair pair = tones(count, 5300, 33333, 0, 0, 1);
            const Result<double> found = find_carrier(pair.c, pair.d, 33333, 10, 16666);
            QVERIFY(!found);
            QVERIFY(found.error().code == ErrorCode::carrier_not_found);
        }
        const std::vector<double> silence(1000, 0.25);
        QVERIFY(find_carrier(silence, silence, 33333, 10, 16666).error().code ==
                ErrorCode::channels_constant);
        const std::vector<double> nothing(1000, std::nan(""));
        QVERIFY(find_carrier(nothing, nothing, 33333, 10, 16666).error().code ==
                ErrorCode::no_valid_samples);
    }

    void fewSamplesAreEnough() {
        // Ten periods: within a tenth of a main lobe, so that the search in the windows starts
        // inside it.
        const Pair pair = tones(63, 5300, 33333, 1, 0.5, 0);
        const Result<double> found = find_carrier(pair.c, pair.d, 33333, 1500, 16666);
        QVERIFY(found);
        VYBEG_CLOSE(*found, 5300, 0.1 * 33333 / 63);
    }

    void impossibleBandsAreNamed() {
        const Pair pair = tones(1000, 5300, 33333, 1, 1, 0);
        QVERIFY(find_carrier(pair.c, pair.d, 33333, 6000, 5000).error().code ==
                ErrorCode::band_invalid);
        QVERIFY(find_carrier(pair.c, pair.d, 33333, 17000, 20000).error().code ==
                ErrorCode::band_invalid);
    }

    // Half a minute: the zoom alone answers, whatever the offset, with samples missing, drifting,
    // and beside weaker lines far and near.
    void aLongSegmentIsSearchedCoarseToFine() {
        constexpr double rate = 33333;
        for (const std::size_t count : {200000UL, 933324UL}) {
            const double bin = rate / static_cast<double>(count);
            for (const double f : {1301.7, 5300.0026, 5413.1, 12345.678, 15500.3}) {
                Pair pair = tones(count, f, rate, 1, 0.7, 1e-2);
                const Pair near = tones(count, f + 5 * bin, rate, 0.3, 0.3, 0);
                const Pair far = tones(count, 2222.2, rate, 0.1, 0.1, 0);
                for (std::size_t j = 0; j < count; ++j) {
                    pair.c[j] += near.c[j] + far.c[j] + 0.3;
                    pair.d[j] += near.d[j] + far.d[j] - 3;
                    if (j % 100000 < 20) {
                        pair.d[j] = std::nan("");
                    }
                }
                const auto found = zoom_carrier(pair.c, pair.d, rate, 4 * bin, rate / 2, {});
                const QString which = QString("%1 of %2").arg(f).arg(count);
                QVERIFY2(found, qPrintable(which));
                VYBEG_CLOSE(*found, f, 0.01 * bin, qPrintable(which));
            }
        }
    }

    void whereTheZoomIsNotCertainItSaysNothing() {
        constexpr std::size_t count = 300000;
        constexpr double rate = 33333;
        const auto zoomed = [](const Pair& pair) {
            return zoom_carrier(pair.c, pair.d, rate, 1, rate / 2, {});
        };
        // Noise alone, silence, and a carrier at the edge.
        QVERIFY(!zoomed(tones(count, 5300, rate, 0, 0, 1)));
        QVERIFY(!zoomed({std::vector<double>(count, 0.25), std::vector<double>(count, 0)}));
        QVERIFY(!zoomed(tones(count, 20, rate, 1, 1, 0.01)));
        // A line that is there between the short segments of the coarse look alone, and longer than
        // they are: the carrier that they see is not the largest peak.
        Pair pair = tones(count, 5300, rate, 0.1, 0.1, 0.001);
        const Pair burst = tones(count, 9000, rate, 3, 3, 0);
        for (std::size_t j = 150000; j < 168000; ++j) {
            pair.c[j] += burst.c[j];
            pair.d[j] += burst.d[j];
        }
        QVERIFY(!zoomed(pair));
        const Result<double> found = find_carrier(pair.c, pair.d, rate, 1, rate / 2);
        QVERIFY(found);
        VYBEG_CLOSE(*found, 9000, 1);
    }
};

VYBEG_TEST(TestCarrier)

}  // namespace test_carrier

#include "test_carrier.moc"
