#include "core/recording/checks/fault_checks.h"
#include "core/recording/checks/recording_check.h"
#include "tests/closeness.h"
#include "tests/core/recording/checks/line_signal.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <algorithm>
#include <numbers>
#include <random>

namespace test_sample_faults {

using namespace vybeg;
using namespace vybeg::test;

namespace {

// 28 s of a decaying wave whose angle turns, at 40 dB.
Signal decay(std::uint64_t seed, double f, double seconds = 28) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> gauss(0, 0.01);
    std::uniform_real_distribution<double> any(0, 6);
    const double phase = any(random);
    const double angle = any(random);
    Signal signal;
    const auto frames = static_cast<std::size_t>(seconds * 33333);
    signal.c.reserve(frames);
    signal.d.reserve(frames);
    for (std::size_t j = 0; j < frames; ++j) {
        const double t = static_cast<double>(j) / 33333;
        const double wave = std::exp(-t / 30) * std::cos(2 * std::numbers::pi * f * t + phase);
        const double quadrature =
            0.2 * std::sin(0.3 * t) * std::sin(2 * std::numbers::pi * f * t + phase);
        const double turned = angle + 0.05 * t;
        signal.c.push_back(wave * std::cos(turned) - quadrature * std::sin(turned) + gauss(random));
        signal.d.push_back(wave * std::sin(turned) + quadrature * std::cos(turned) + gauss(random));
    }
    return signal;
}

}  // namespace

class TestSampleFaults : public QObject {
    Q_OBJECT

private slots:
    void twentyLostSamplesAreFoundInTheirPlaces() {
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            for (const double f : {4321.987, 5300.0, 7071.07}) {
                Signal signal = decay(seed, f);
                std::mt19937_64 random(100 + seed);
                std::vector<std::int64_t> lost;
                std::uniform_int_distribution<std::int64_t> place(1000, 900000);
                while (lost.size() < 20) {
                    lost.push_back(place(random));
                }
                // From the last to the first, so that the places before stay; then each moves by
                // those before it.
                std::ranges::sort(lost, std::greater{});
                for (const std::int64_t frame : lost) {
                    signal.c.erase(signal.c.begin() + frame);
                    signal.d.erase(signal.d.begin() + frame);
                }
                std::ranges::reverse(lost);
                const std::vector<PhaseStep> steps = steps_of(signal, f + 0.02, 33333);
                int found = 0;
                for (std::size_t k = 0; k < lost.size(); ++k) {
                    const std::int64_t frame = lost[k] - static_cast<std::int64_t>(k);
                    // To the frame, but for those so close together that they show as one step.
                    found += std::ranges::any_of(steps, [frame](const PhaseStep& s) {
                        return std::abs(s.frame - frame) <= (s.lost == 1 ? 1 : 60) && s.lost >= 1;
                    });
                }
                QString where = QString("seed %1, %2 Hz: found %3 of").arg(seed).arg(f).arg(found);
                for (std::size_t k = 0; k < lost.size(); ++k) {
                    where += QString(" %1").arg(lost[k] - static_cast<std::int64_t>(k));
                }
                where += ":";
                for (const PhaseStep& s : steps) {
                    where += QString(" %1 (%2, %3)").arg(s.frame).arg(s.lost).arg(s.phase_rad);
                }
                VYBEG_AT_LEAST(found, 19, qPrintable(where));
                int total = 0;
                for (const PhaseStep& s : steps) {
                    total += s.lost;
                }
                VYBEG_AT_LEAST(total, 19, qPrintable(where));
                VYBEG_AT_MOST(total, 20, qPrintable(where));
            }
        }
    }

    void aHundredCleanRecordingsHaveNone() {
        for (std::uint64_t seed = 1; seed <= 100; ++seed) {
            const double f = 4000 + 50.123 * static_cast<double>(seed);
            const std::vector<PhaseStep> steps =
                steps_of(decay(seed, f, seed <= 10 ? 28 : 5), f - 0.03, 33333);
            QVERIFY2(steps.empty(), qPrintable(QString("seed %1").arg(seed)));
        }
    }

    void missingSegmentsAreNoSteps() {
        Signal signal = decay(3, 5300, 5);
        for (std::size_t j = 50000; j < 50007; ++j) {
            signal.c[j] = std::nan("");
        }
        QVERIFY(steps_of(signal, 5300, 33333).empty());
    }

    void clippedSamplesAreCounted_data() {
        QTest::addColumn<int>("bits");
        QTest::addColumn<double>("level");
        QTest::newRow("float, 0.97 of the amplitude") << 0 << 0.97;
        QTest::newRow("float, 0.95") << 0 << 0.95;
        QTest::newRow("16 bits, 0.98") << 16 << 0.98;
        QTest::newRow("12 bits, 0.9") << 12 << 0.9;
    }

    void clippedSamplesAreCounted() {
        QFETCH(int, bits);
        QFETCH(double, level);
        Signal signal = decay(7, 5300, 10);
        const double top = level * *std::ranges::max_element(signal.c);
        const double unit = bits > 0 ? top / std::exp2(bits - 1) : 0;
        std::vector<std::int64_t> clipped;
        for (std::size_t j = 0; j < signal.c.size(); ++j) {
            double& x = signal.c[j];
            x = unit > 0 ? unit * std::round(x / unit) : x;
            if (x >= top) {
                x = top;
                clipped.push_back(static_cast<std::int64_t>(j));
            }
        }
        ClippingCheck check;
        check.add(0, std::span(signal.c).first(5000));
        check.add(5000, std::span(signal.c).subspan(5000));
        const std::vector<ClippingCheck::Rail> rails = check.rails();
        QCOMPARE(rails.size(), std::size_t{1});
        QCOMPARE(rails[0].level, top);
        QCOMPARE(rails[0].count, static_cast<std::int64_t>(clipped.size()));
        std::vector<std::int64_t> places;
        for (const FrameRange& range : rails[0].places) {
            for (std::int64_t k = 0; k < range.count; ++k) {
                places.push_back(range.first + k);
            }
        }
        QVERIFY(places == clipped);
    }

    void shortFillsAreToldAndWavesOfAnyResolutionAreNot() {
        for (const int bits : {0, 8, 12, 16}) {
            for (const double noise : {0.0, 1e-3, 0.03}) {
                for (const double f : {5300.0, 1000.123, 33333 / 4.0, 15000.0}) {
                    std::mt19937_64 random(11);
                    std::normal_distribution<double> gauss(0, noise);
                    std::uniform_int_distribution<int> any(0, 99);
                    const double unit = bits > 0 ? std::exp2(1 - bits) : 0;
                    const auto written = [unit](double x) {
                        return unit > 0 ? unit * std::round(x / unit) : x;
                    };
                    for (const int fill : {0, 1, 2}) {  // none, zeros, the last one
                        Signal signal;
                        for (int j = 0; j < 100000; ++j) {
                            const double wave =
                                std::exp(-j / 1e5) * std::cos(2 * std::numbers::pi * f / 33333 * j);
                            signal.c.push_back(written(0.02 + 0.8 * wave + gauss(random)));
                            signal.d.push_back(written(0.3 * wave + gauss(random)));
                            if (fill > 0 && j > 0 && any(random) == 0) {
                                signal.c.back() = fill == 1 ? 0 : signal.c[signal.c.size() - 2];
                                signal.d.back() = fill == 1 ? 0 : signal.d[signal.d.size() - 2];
                            }
                        }
                        FaultCheck check(f, 33333);
                        check.add(0, signal.c, signal.d);
                        const SampleFaults faults = check.finish();
                        const auto told = std::ranges::count(
                            faults.findings, DiagnosticKind::samples_filled, &Diagnostic::kind);
                        QVERIFY2(told == (fill > 0 ? 1 : 0),
                                 qPrintable(QString("%1 bits, noise %2, %3 Hz, fill %4")
                                                .arg(bits)
                                                .arg(noise)
                                                .arg(f)
                                                .arg(fill)));
                    }
                }
            }
        }
    }

    void unclippedSignalsHaveNoRail() {
        for (const int bits : {0, 10, 12, 16, 20}) {
            for (const double noise : {0.0, 1e-4, 1e-2}) {
                // The last has 355 frames in 113 half-periods, less a 30,000th of a period.
                for (const double f : {5300.0, 5000.123, 33333 / (2 * std::numbers::pi)}) {
                    std::mt19937_64 random(11);
                    std::normal_distribution<double> gauss(0, 1);
                    std::vector<double> x;
                    const double unit = bits > 0 ? std::exp2(1 - bits) : 0;
                    for (int j = 0; j < 200000; ++j) {
                        const double value = 0.8 * std::cos(2 * std::numbers::pi * f / 33333 * j) +
                                             noise * gauss(random);
                        x.push_back(unit > 0 ? unit * std::round(value / unit) : value);
                    }
                    ClippingCheck check;
                    check.add(0, x);
                    QVERIFY2(check.rails().empty(),
                             qPrintable(
                                 QString("%1 bits, noise %2, %3 Hz").arg(bits).arg(noise).arg(f)));
                }
            }
        }
        ClippingCheck still;
        still.add(0, std::vector<double>(1000, 0.5));
        QVERIFY(still.rails().empty());
    }

    void placesStayFewHoweverMuchIsClipped() {
        // A rail every 7 frames, with a clean segment in the middle that is far longer than what is
        // drawn together.
        ClippingCheck check;
        std::vector<double> part(70000);
        std::int64_t first = 0;
        const auto add = [&](int portions, double top) {
            for (int k = 0; k < portions; ++k) {
                for (std::size_t j = 0; j < part.size(); ++j) {
                    part[j] = j % 7 == 0 ? top : 0.1 * static_cast<double>(j % 5);
                }
                check.add(first, part);
                first += static_cast<std::int64_t>(part.size());
            }
        };
        add(100, 1.0);
        const std::int64_t clean = first;
        add(2, 0.5);
        const std::int64_t clipped_again = first;
        add(100, 1.0);
        const std::vector<ClippingCheck::Rail> rails = check.rails();
        QCOMPARE(rails.size(), std::size_t{1});
        QCOMPARE(rails[0].count, std::int64_t{2 * 100 * 10000});
        VYBEG_AT_MOST(rails[0].places.size(), ClippingCheck::most_places);
        std::int64_t covered = 0;
        for (const FrameRange& range : rails[0].places) {
            QVERIFY(range.first + range.count <= clean || range.first >= clipped_again);
            covered += range.count;
        }
        VYBEG_AT_LEAST(covered, rails[0].count);
    }
};

VYBEG_TEST(TestSampleFaults)

}  // namespace test_sample_faults

#include "test_sample_faults.moc"
