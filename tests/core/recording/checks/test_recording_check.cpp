// What the recording check says of samples whose faults are known, and that it says nothing of
// those without.
#include "core/recording/checks/recording_check.h"
#include "core/recording/conditioning/conditioned_source.h"
#include "core/recording/samples/sample_source.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace test_recording_check {

using namespace vybeg;

namespace {

constexpr double rate = 33333;

struct Wave {
    double f = 5300;
    double tau = 30;
    double noise = 0.003;
    double seconds = 6;
    std::uint64_t seed = 1;
};

struct Signal {
    std::vector<double> c;
    std::vector<double> d;
};

Signal decay(const Wave& wave) {
    std::mt19937_64 random(wave.seed);
    std::normal_distribution<double> gauss(0, wave.noise);
    Signal signal;
    for (int j = 0; j < static_cast<int>(wave.seconds * rate); ++j) {
        const double t = j / rate;
        const double x =
            std::exp(-t / wave.tau) * std::cos(2 * std::numbers::pi * wave.f * t + 0.7);
        signal.c.push_back(0.8 * x + gauss(random));
        signal.d.push_back(0.6 * x + gauss(random));
    }
    return signal;
}

// f(t), t in seconds, is added to both channels.
template <class Function>
void add(Signal& signal, Function f) {
    for (std::size_t j = 0; j < signal.c.size(); ++j) {
        signal.c[j] += f(static_cast<double>(j) / rate);
        signal.d[j] += f(static_cast<double>(j) / rate);
    }
}

std::vector<Diagnostic> findings(Signal signal, std::optional<double> f0) {
    const auto source = memory_source(std::move(signal.c), std::move(signal.d));
    const Result<SampleFaults> faults = check_recording(*source, rate, f0, {});
    return faults ? faults->findings : std::vector<Diagnostic>{{DiagnosticKind::time_gap, {}}};
}

QString text(const std::vector<Diagnostic>& findings) {
    QStringList words;
    for (const Diagnostic& found : findings) {
        QStringList args;
        for (const MessageArg& arg : found.args) {
            args << QString::fromStdString(english(arg));
        }
        words << QString::fromStdString(kind_name(found.kind)) + "(" + args.join(",") + ")";
    }
    return words.join(" ");
}

}  // namespace

class TestRecordingCheck : public QObject {
    Q_OBJECT

private slots:
    void clean_recordings_have_no_findings() {
        for (std::uint64_t seed = 1; seed <= 24; ++seed) {
            const std::array taus{0.5, 3.0, 400.0};
            const std::array noises{1e-6, 1e-3, 3e-2};
            const Wave wave{1000 + 607.3 * static_cast<double>(seed), taus[seed % 3],
                            noises[seed / 3 % 3], 6, seed};
            const auto found = findings(decay(wave), wave.f + 0.02);
            QVERIFY2(found.empty(), qPrintable(QString("seed %1: %2").arg(seed).arg(text(found))));
        }
    }

    void a_beating_pair_is_no_fault() {
        // Two modes of a bell, 5 Hz apart: the phase turns over in the nodes, the power is no
        // exponential.
        for (const double second : {0.5, 0.9, 0.99}) {
            Signal signal = decay({1017.81, 0.9, 1e-4, 4, 3});
            add(signal, [second](double t) {
                return second * 0.7 * std::exp(-t / 0.95) *
                       std::cos(2 * std::numbers::pi * 1023.07 * t);
            });
            QCOMPARE(text(findings(std::move(signal), 1017.8)), QString());
        }
    }

    void offsets_are_told_with_their_share_of_the_amplitude() {
        Signal signal = decay({.tau = 400});
        for (double& x : signal.d) {
            x -= 0.02;
        }
        const auto found = findings(std::move(signal), 5300);
        QCOMPARE(found.size(), std::size_t{1});
        QCOMPARE(found[0].kind, DiagnosticKind::offset);
        QCOMPARE(found[0].args[0], "D");
        // Sum over 200,000 samples: 0.003 / sqrt(200000) = 7e-6, and 1e-6 of an unfinished period.
        VYBEG_CLOSE(std::stod(english(found[0].args[1])), -0.02, 5e-5);
        VYBEG_CLOSE(std::stod(english(found[0].args[2])), 2.0, 0.05);
    }

    void constant_channels_have_no_share_of_an_amplitude() {
        for (const double level : {0.0, 1.0, -0.1}) {
            const std::vector<double> constant(40000, level);
            const std::vector<double> other(40000, 2 * level);
            for (const Diagnostic& found : findings({constant, other}, {})) {
                QVERIFY2(
                    found.kind != DiagnosticKind::offset && found.kind != DiagnosticKind::mains,
                    qPrintable(text({found})));
            }
        }
    }

    void lines_of_the_mains_are_found_and_no_others() {
        for (const double f : {50.0, 100.0, 150.0, 60.0, 120.0, 180.0}) {
            for (const double off : {-0.2, 0.0, 0.15}) {  // the mains wander
                Signal signal = decay({.tau = 400, .noise = 0.01});
                add(signal, [=](double t) {
                    return 0.005 * std::cos(2 * std::numbers::pi * (f + off) * t + 1);
                });
                const auto found = findings(std::move(signal), 5300);
                VYBEG_EQUAL(found.size(), 1,
                            qPrintable(QString("%1 Hz: %2").arg(f + off).arg(text(found))));
                QVERIFY2(found[0].kind == DiagnosticKind::mains &&
                             std::stod(english(found[0].args[0])) == f,
                         qPrintable(QString("%1 Hz: %2").arg(f + off).arg(text(found))));
                // sqrt(2) 0.005 beside an amplitude of 1; a Hann window loses 15 % between bins.
                const double percent = std::stod(english(found[0].args[1]));
                VYBEG_MORE(percent, 0.55, english(found[0].args[1]).c_str());
                VYBEG_LESS(percent, 0.85, english(found[0].args[1]).c_str());
            }
        }
        Signal hum = decay({.tau = 400});
        add(hum, [](double t) { return 0.05 * std::cos(2 * std::numbers::pi * 83 * t); });
        QCOMPARE(text(findings(std::move(hum), 5300)), QString());
    }

    void a_start_that_decays_otherwise_is_told() {
        for (const double seconds : {0.1, 0.3}) {  // decay time of a second mode far away
            Signal signal = decay({.tau = 20});
            add(signal, [seconds](double t) {
                return 0.5 * std::exp(-t / seconds) * std::cos(2 * std::numbers::pi * 9100 * t);
            });
            const auto found = findings(std::move(signal), 5300);
            VYBEG_EQUAL(found.size(), 1, qPrintable(text(found)));
            QVERIFY2(found[0].kind == DiagnosticKind::start_transient, qPrintable(text(found)));
            // Its power, at first half of the wave's, is 2 % of it after 1.6 decay times.
            const double end = std::stod(english(found[0].args[0]));
            VYBEG_MORE(end, 1.2 * seconds, english(found[0].args[0]).c_str());
            VYBEG_LESS(end, 2.2 * seconds + 0.1, english(found[0].args[0]).c_str());
            QCOMPARE(found[0].first_frame, 0);
            VYBEG_CLOSE(static_cast<double>(found[0].count), end * rate, 0.02 * rate);
        }
    }

    // Two modes split by `split` behind channels whose gains differ: the power of both beats
    // slowly.
    void a_beat_without_a_transient_is_none() {
        std::mt19937_64 random(20261123);
        std::uniform_real_distribution<double> part(0, 1);
        int told = 0;
        constexpr int cases = 100;
        for (int k = 0; k < cases; ++k) {
            const double split = std::pow(10, -2 + 2.3 * part(random));
            const double tau = std::pow(10, 0.7 + 2 * part(random));
            const double kappa = 1 + 0.1 * (2 * part(random) - 1);
            const double turn = 2 * std::numbers::pi * part(random);
            const double share = 2 * std::numbers::pi * part(random);
            const double unequal = 0.1 * (part(random) - 0.5);
            std::normal_distribution<double> gauss(0, 0.001);
            Signal signal = decay({.seconds = 4.1});
            for (std::size_t j = 0; j < signal.c.size(); ++j) {
                const double t = static_cast<double>(j) / rate;
                const double phase = 2 * std::numbers::pi * 5300 * t;
                const double beat = std::numbers::pi * split * t;
                const double first =
                    std::cos(share) * std::exp(-t / tau * (1 + unequal)) * std::cos(phase + beat);
                const double second =
                    std::sin(share) * std::exp(-t / tau * (1 - unequal)) * std::cos(phase - beat);
                signal.c[j] = std::cos(turn) * first + std::sin(turn) * second + gauss(random);
                signal.d[j] =
                    kappa * (std::cos(turn) * second - std::sin(turn) * first) + gauss(random);
            }
            const auto found = findings(std::move(signal), 5300);
            told += static_cast<int>(
                std::ranges::count(found, DiagnosticKind::start_transient, &Diagnostic::kind));
        }
        // Without regard to the smooth bend of a beat, one in ten.
        VYBEG_AT_MOST(told, 1, qPrintable(QString("%1 of %2").arg(told).arg(cases)));
    }

    void missing_samples_are_counted() {
        Signal signal = decay({});
        signal.c[1234] = std::nan("");
        signal.c[5000] = INFINITY;
        signal.d[5000] = std::nan("");
        const auto found = findings(std::move(signal), 5300);
        QCOMPARE(text(found), "missing-samples(3)");
        QCOMPARE(found[0].first_frame, 1234);
        QCOMPARE(found[0].count, 2);
    }

    void places_beyond_a_hundred_are_counted() {
        Signal signal = decay({.seconds = 20});
        for (int k = 120; k >= 1; --k) {
            signal.c.erase(signal.c.begin() + k * 5000);
            signal.d.erase(signal.d.begin() + k * 5000);
        }
        const auto found = findings(std::move(signal), 5300);
        QCOMPARE(found.size(), std::size_t{101});
        QCOMPARE(text({found.back()}), "more-samples-lost(20)");
        QCOMPARE(text({found.front()}), "samples-lost(1,0.1500015)");
    }

    void doubled_samples_are_told_from_lost_ones() {
        Signal signal = decay({});
        for (const int frame : {60000, 100000}) {
            signal.c.insert(signal.c.begin() + frame, signal.c[frame]);
            signal.d.insert(signal.d.begin() + frame, signal.d[frame]);
        }
        const auto found = findings(std::move(signal), 5300);
        QCOMPARE(found.size(), std::size_t{2});
        QCOMPARE(found[0].kind, DiagnosticKind::samples_doubled);
        VYBEG_WITHIN(found[0].first_frame, 60000, 1);
        VYBEG_WITHIN(found[1].first_frame, 100001, 1);
    }

    void a_step_that_has_two_explanations_is_told_with_both() {
        Signal signal = decay({.noise = 0.03});
        signal.c.erase(signal.c.begin() + 60000, signal.c.begin() + 60040);
        signal.d.erase(signal.d.begin() + 60000, signal.d.begin() + 60040);
        const auto found = findings(std::move(signal), 5300);
        QCOMPARE(found.size(), std::size_t{1});
        QCOMPARE(found[0].kind, DiagnosticKind::phase_step);
        // 40 samples are seven periods less 4 samples and 0.025 rad, three deviations here.
        VYBEG_CLOSE(std::stod(english(found[0].args[0])), 2.262, 0.05);
        const auto numbers = [&found](std::size_t arg) {
            return QString::fromStdString(english(found[0].args[arg])).split(", ");
        };
        QVERIFY2(numbers(2).first() == "4", qPrintable(text(found)));
        QVERIFY2(numbers(3).contains("40"), qPrintable(text(found)));
        VYBEG_WITHIN(found[0].first_frame, 60000, 1);
    }

    void a_channel_below_one_bit_is_not_clipped() {
        // The wave crosses one threshold of the converter: rarely, half of the time, nearly always.
        for (const double offset : {0.0, 0.35, 0.49, 0.497, 0.503, 0.6}) {
            for (std::uint64_t seed = 1; seed <= 3; ++seed) {
                Signal signal = decay({.tau = 400, .noise = 1e-3, .seed = seed});
                for (double& x : signal.d) {
                    x = std::round(0.016 * x + offset);
                }
                const auto found = findings(std::move(signal), 5300);
                VYBEG_EQUAL(std::ranges::count(found, DiagnosticKind::clipped, &Diagnostic::kind),
                            0, qPrintable(QString("offset %1: ").arg(offset) + text(found)));
                const bool toggles = std::abs(offset - 0.5) < 0.0096;
                const bool at_the_limit = std::abs(std::abs(offset - 0.5) - 0.01) < 0.002;
                QVERIFY2(at_the_limit || std::ranges::count(found, DiagnosticKind::below_one_bit,
                                                            &Diagnostic::kind) == (toggles ? 1 : 0),
                         qPrintable(QString("offset %1: ").arg(offset) + text(found)));
            }
        }
    }

    void channels_without_a_signal_of_their_own_are_named() {
        const Signal signal = decay({});
        QCOMPARE(text(findings({signal.c, signal.c}, 5300)), QString("channels-alike(199998)"));
        Signal one_differs{signal.c, signal.c};
        one_differs.d[100000] += 1e-9;
        QCOMPARE(text(findings(std::move(one_differs), 5300)), QString());
        const std::vector<double> silence(signal.c.size(), 0.0);
        const std::vector<double> level(signal.c.size(), -2.5);
        QCOMPARE(text(findings({silence, silence}, {})),
                 QString("channel-constant(C) channel-constant(D)"));
        QCOMPARE(text(findings({signal.c, silence}, 5300)), QString("channel-constant(D)"));
        QVERIFY(text(findings({level, signal.d}, 5300)).startsWith("channel-constant(C)"));
    }

    void a_repaired_recording_is_the_one_before_the_loss_with_gaps() {
        const Signal whole = decay({.seconds = 5});
        Signal cut = whole;
        const std::vector<std::pair<int, int>> losses{{20000, 1}, {70000, 3}, {70500, 2}};
        for (auto loss = losses.rbegin(); loss != losses.rend(); ++loss) {
            const auto erase = [&](std::vector<double>& x) {
                x.erase(x.begin() + loss->first, x.begin() + loss->first + loss->second);
            };
            erase(cut.c);
            erase(cut.d);
        }
        const auto source = memory_source(cut.c, cut.d);
        const Result<SampleFaults> faults = find_faults(*source, rate, 5300.01, {});
        QVERIFY(faults);
        const auto repaired = with_gaps(source, faults->steps);
        QCOMPARE(repaired->frames(), std::ssize(whole.c));
        // In portions that begin and end anywhere, also inside the gaps.
        std::vector<double> c(whole.c.size());
        std::vector<double> d(whole.c.size());
        for (std::size_t at = 0; at < c.size();) {
            const std::size_t count = std::min<std::size_t>(at % 7 == 3 ? 1 : 1001, c.size() - at);
            QVERIFY(repaired->read(static_cast<std::int64_t>(at), std::span(c).subspan(at, count),
                                   std::span(d).subspan(at, count)));
            at += count;
        }
        int missing = 0;
        for (std::size_t j = 0; j < c.size(); ++j) {
            missing += std::isnan(c[j]) ? 1 : 0;
            // A sample beside a gap that fits before it as well as behind may lie on either side.
            const bool at_gap = std::ranges::any_of(losses, [j](const auto& loss) {
                return std::abs(static_cast<int>(j) - loss.first) <= loss.second + 1;
            });
            if (!at_gap) {
                const std::string frame = "frame " + std::to_string(j);
                VYBEG_EQUAL(c[j], whole.c[j], frame.c_str());
                VYBEG_EQUAL(d[j], whole.d[j], frame.c_str());
            }
        }
        QCOMPARE(missing, 6);
    }

    void a_watched_source_is_looked_through_once() {
        Signal signal = decay({});
        for (const auto frame : {30000U, 90000U}) {
            signal.c[frame] = std::nan("");
        }
        const auto check = std::make_shared<FaultCheck>(5300, rate);
        const auto source = checked_source(memory_source(signal.c, signal.d), check);
        std::vector<double> c(40000);
        std::vector<double> d(40000);
        // Overlapping portions: each frame counts once.
        for (std::int64_t at = 0; at + 40000 <= source->frames(); at += 10000) {
            QVERIFY(source->read(at, c, d));
            QVERIFY(std::equal(d.begin(), d.end(), signal.d.begin() + at));
        }
        QCOMPARE(text(check->finish().findings), "missing-samples(2)");
    }
};

VYBEG_TEST(TestRecordingCheck)

}  // namespace test_recording_check

#include "test_recording_check.moc"
