// Pan and zoom of a long recording on the page of the signals: a step costs what it costs on a
// recording of half a minute, the peer in the same run.
//
// 10^7 samples; for more, give their number in the environment variable VYBEG_SIGNAL_SAMPLES.
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "tests/ui/heartbeat.h"
#include "ui/plots/track_view.h"
#include "ui/signals/signals_page.h"

#include <QTest>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

namespace test_long_signals {

using namespace vybeg;
using namespace vybeg::ui;

namespace {

constexpr int rate = 33333;
constexpr qint64 usual_samples = 1'000'000;
constexpr qint64 long_samples = 10'000'000;

// What goes over the samples in the window's thread costs ten times as much on the long recording.
constexpr double largest_ratio = 2;
constexpr double clock_ms = 2;  // of a timer and of a step that takes nothing

}  // namespace

class TestLongSignals : public QObject, private WindowTest {
    Q_OBJECT

    Heartbeat heart_;
    std::map<QString, double> costs_ms_;  // medians by step, of the recording looked at

    SignalsView& view() { return childOf<SignalsPage>(*window_).view(); }
    TrackView& tracks() { return childOf<TrackView>(*window_); }

    // 16 bit; one second over and over, in which the carrier of 5300 Hz has whole periods.
    QString written(qint64 samples) {
        std::mt19937 random(1);
        std::normal_distribution<double> noise(0, 20);
        std::vector<qint16> second;
        for (int k = 0; k < rate; ++k) {
            const double turn = 2 * std::numbers::pi * 5300 * k / rate;
            second.push_back(static_cast<qint16>(20000 * std::cos(turn) + noise(random)));
            second.push_back(
                static_cast<qint16>(9000 * std::cos(turn) + 2000 * std::sin(turn) + noise(random)));
        }
        const QByteArray bytes(reinterpret_cast<const char*>(second.data()),
                               static_cast<qsizetype>(second.size() * sizeof(qint16)));
        QFile file(home_.path("long.raw"));
        if (!file.open(QIODevice::WriteOnly)) {
            qFatal("the test's file cannot be written");
        }
        for (qint64 at = 0; at < samples; at += rate) {
            file.write(bytes);
        }
        return file.fileName();
    }

    // One step and its drawing, ms, less the time in which others ran.
    template <class Act>
    double duration(Act act) {
        QElapsedTimer clock;
        clock.start();
        const double delay = Heartbeat::readDelay();
        act();
        QCoreApplication::processEvents();
        return 1e-6 * static_cast<double>(clock.nsecsElapsed()) - (Heartbeat::readDelay() - delay);
    }

    template <class Act>
    void measure(const char* what, int steps, Act act) {
        std::vector<double> costs;
        heart_.reset();
        for (int k = 0; k < steps; ++k) {
            costs.push_back(duration([&] { act(k); }));
            QTest::qWait(10);  // as between two events of a mouse
        }
        std::ranges::sort(costs);
        const double median = costs[costs.size() / 2];
        qInfo("%s: median %.1f ms, largest %.1f ms; %s", what, median, costs.back(),
              qPrintable(heart_.text()));
        costs_ms_[what] = median;
    }

    void panAndZoom(qint64 samples) {
        costs_ms_.clear();
        const OpenOptions options{.rate_hz = rate, .raw = RawLayout{}};
        window_ = shownWindow();
        document().open({written(samples)}, options);
        QVERIFY(QTest::qWaitFor(
            [&] { return !document().busy() && !document().analyses().empty(); }, 600000));
        QVERIFY(QTest::qWaitFor([&] { return document().currentRecording()->envelope->whole(); },
                                600000));
        QTest::keyClick(window_.get(), Qt::Key_2, Qt::ControlModifier);
        QTRY_VERIFY(view().isVisible());
        deliverPosted();

        const auto wheel = [&](int notches) {
            const QPointF middle(view().width() / 2.0, view().height() / 2.0);
            QWheelEvent event(middle, view().mapToGlobal(middle), {}, QPoint(0, 120 * notches),
                              Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(&view(), &event);
        };
        const auto pan = [&](int k) { tracks().zoom().panTime(k % 20 < 10 ? 0.03 : -0.03); };
        const double seconds = static_cast<double>(samples) / rate;
        tracks().setTimeRange({0.1 * seconds, 0.9 * seconds});
        measure("pan of nearly all", 60, pan);
        tracks().setTimeRange({2, 22});
        measure("zoom to periods", 70, [&](int) { wheel(1); });
        QVERIFY(view().picture().samples);
        measure("pan of periods", 60, pan);
        for (const double in_pixel : {0.3, 2., 3.9}) {
            const double from = tracks().timeRange().lower;
            tracks().setTimeRange({from, from + in_pixel * view().timeWidth() / rate});
            QVERIFY(view().picture().samples);
            measure(qPrintable(QStringLiteral("pan of samples, %1 in a pixel").arg(in_pixel)), 60,
                    pan);
        }
        measure("zoom out", 20, [&](int) { wheel(-1); });
        window_.reset();
    }

private slots:
    void pan_and_zoom_cost_the_same_on_a_long_recording() {
        bool given = false;
        const qint64 samples = qEnvironmentVariableIntValue("VYBEG_SIGNAL_SAMPLES", &given);
        panAndZoom(usual_samples);
        const auto usual_ms = costs_ms_;
        panAndZoom(given ? samples : long_samples);
        QCOMPARE(costs_ms_.size(), std::size_t(7));
        for (const auto& [what, cost_ms] : costs_ms_) {
            VYBEG_AT_MOST(cost_ms, largest_ratio * usual_ms.at(what) + clock_ms, qPrintable(what));
        }
    }
};

VYBEG_TEST(TestLongSignals, long, alone)

}  // namespace test_long_signals

#include "test_long_signals.moc"
