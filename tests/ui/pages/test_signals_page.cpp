// The page of the signals as a person uses it: keys, mouse, zoom shared with the tracks.
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "ui/panels/ledger.h"
#include "ui/plots/signal_view.h"
#include "ui/plots/track_view.h"
#include "ui/signals/signals_page.h"

#include <QFileInfo>
#include <QLabel>
#include <QTabBar>
#include <QTest>
#include <QWheelEvent>
#include <qcustomplot.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace test_signals_page {

using namespace vybeg;
using namespace vybeg::ui;

class TestSignalsPage : public QObject, private WindowTest {
    Q_OBJECT

    SignalsPage& page() { return the<SignalsPage>(); }
    SignalsView& view() { return page().view(); }
    TrackView& tracks() { return the<TrackView>(); }
    QString state() { return the<QLabel>("signalsState").text(); }

    void open(const QString& path) {
        document().open({path});
        QVERIFY(idle(1));
        QVERIFY(QTest::qWaitFor([&] {
            const RecordingEntry* entry = document().currentRecording();
            return entry->envelope && entry->envelope->whole();
        }));
    }

    void goToSignals() {
        QTest::keyClick(window_.get(), Qt::Key_2, Qt::ControlModifier);
        QVERIFY(page().isVisible());
    }

    void goToTracks() {
        QTest::keyClick(window_.get(), Qt::Key_1, Qt::ControlModifier);
        QVERIFY(tracks().isVisible());
    }

    void wheelAt(double time_s, int notches) {
        const QPointF at(view().positionOf(time_s), view().height() / 2.0);
        QWheelEvent event(at, view().mapToGlobal(at), {}, QPoint(0, 120 * notches), Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&view(), &event);
    }

    // Three periods of 1000 Hz.
    void zoomToThreePeriods(double about_s) {
        for (int k = 0; k < 60 && tracks().timeRange().span() > 3.2e-3; ++k) {
            wheelAt(about_s, 1);
        }
        QVERIFY(tracks().timeRange().contains(about_s));
        VYBEG_CLOSE(tracks().timeRange().span(), 3e-3, 0.5e-3);
        QVERIFY(QTest::qWaitFor([&] { return samplesShown(); }, 20000));
    }

    // All visible samples are there, with the wave of a run if it has one.
    bool samplesShown() {
        const SignalPicture& picture = view().picture();
        return picture.samples && picture.whole &&
               (picture.wave.c.empty() ||
                std::isfinite(view().content().excerpt->fit_c[picture.from]));
    }

    void moveMouseTo(double time_s) {
        QTest::mouseMove(&view(), QPoint(static_cast<int>(std::lround(view().positionOf(time_s))),
                                         view().height() / 2));
        QVERIFY(QTest::qWaitFor([&] { return tracks().tracker().has_value(); }));
    }

private slots:
    void init() { window_ = shownWindow(); }
    void cleanup() { window_.reset(); }

    // Whatever a plot holds, the note in its corner covers none of it.
    void notes_stand_above_what_is_drawn() {
        open(home_.recording("notes.wav"));
        goToSignals();
        QCustomPlot plot;
        preparePlot(plot, lightTheme());
        SignalStack stack(plot, {SignalPart::c, SignalPart::d, SignalPart::residual},
                          PlotHead::margin);
        for (const int height : {300, 500, 1000}) {
            stack.setContent(view().content(), {900, height});
            for (std::size_t k = 0; k < stack.parts().size(); ++k) {
                const TimePanel* panel = stack.frames()[k];
                const AxisRange drawn =
                    valuesOf(stack.content(), stack.picture(), stack.parts()[k]);
                const double top = drawn.upper - 0.06 / 1.12 * drawn.span();
                const double above = (panel->values().upper - top) / panel->values().span();
                VYBEG_AT_LEAST(above * panel->expectedSize().height(),
                               QFontMetricsF(panel->font()).height());
            }
        }
    }

    void an_hour_is_an_envelope_and_three_periods_are_samples() {
        open(home_.recording("demo.wav"));
        goToSignals();
        QCOMPARE(the<QTabBar>("pages").currentIndex(), 1);
        QVERIFY(!tracks().isVisible());
        // 16000 samples over less than 1400 pixels.
        const SignalPicture& all = view().picture();
        QVERIFY(!all.samples);
        VYBEG_MORE(all.columns.size(), 200);
        QVERIFY(!all.rms.empty());
        // Amplitudes of C and D of a_A = 1, a_B = 0.1, 2theta_A = 0.4.
        const std::size_t middle = all.wave.c.size() / 2;
        VYBEG_CLOSE(all.wave.c[middle], std::hypot(std::cos(0.4), 0.1 * std::sin(0.4)), 0.2);
        VYBEG_CLOSE(all.wave.c[middle] / all.wave.d[middle],
                    std::hypot(std::cos(0.4), 0.1 * std::sin(0.4)) /
                        std::hypot(std::sin(0.4), 0.1 * std::cos(0.4)),
                    0.01);
        // Of eight samples to a period the largest misses the crest by pi / 8 at most.
        const double largest = static_cast<double>(all.columns[all.columns.size() / 2].c.max);
        VYBEG_LESS(largest, 1.01 * all.wave.c[middle]);
        VYBEG_MORE(largest, 0.99 * std::cos(std::numbers::pi / 8) * all.wave.c[middle]);

        zoomToThreePeriods(1.0);
        const SignalPicture& near = view().picture();
        QVERIFY(near.columns.empty());
        const SignalExcerpt& excerpt = *view().content().excerpt;
        VYBEG_AT_LEAST(near.to - near.from, 22);
        VYBEG_AT_MOST(near.to - near.from, 30);
        double sum = 0;
        for (std::size_t k = near.from; k < near.to; ++k) {
            sum += std::pow(excerpt.residual_c(k), 2) + std::pow(excerpt.residual_d(k), 2);
            VYBEG_CLOSE(excerpt.residual_c(k), 0, 5e-3);
            VYBEG_CLOSE(excerpt.residual_d(k), 0, 5e-3);
        }
        const auto count = 2 * static_cast<double>(near.to - near.from);
        VYBEG_CLOSE_RATIO(std::sqrt(sum / count), 1e-3, 5 / std::sqrt(2 * count));
        // The wave is drawn at hundreds of points, smooth, and passes through each sample.
        QVERIFY(near.smooth);
        VYBEG_MORE(near.wave.c.size(), 200);
        for (std::size_t k = near.from + 2; k + 2 < near.to; ++k) {
            const auto at = std::ranges::lower_bound(near.wave.time_s, excerpt.time_s(k));
            const auto after = static_cast<std::size_t>(at - near.wave.time_s.begin());
            const double part = (excerpt.time_s(k) - near.wave.time_s[after - 1]) /
                                (near.wave.time_s[after] - near.wave.time_s[after - 1]);
            const double wave = std::lerp(near.wave.c[after - 1], near.wave.c[after], part);
            VYBEG_CLOSE(wave, excerpt.c[k], 6e-3);
        }
    }

    void zoom_and_cursors_are_shared_with_the_tracks() {
        open(home_.recording("demo.wav"));
        tracks().setTimeRange({0.5, 1.5});
        goToSignals();
        QVERIFY(view().content().time == (AxisRange{0.5, 1.5}));
        wheelAt(1.2, 3);
        const AxisRange zoomed = tracks().timeRange();
        VYBEG_CLOSE(zoomed.span(), 0.512, 1e-9);
        QVERIFY(view().content().time == zoomed);
        // Dragged by a tenth of the width to the left: later times.
        const int y = view().height() / 2;
        const int x = view().width() / 2;
        const int by = view().timeWidth() / 10;
        QTest::mousePress(&view(), Qt::LeftButton, {}, QPoint(x, y));
        QTest::mouseMove(&view(), QPoint(x - by, y));
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, QPoint(x - by, y));
        VYBEG_CLOSE(tracks().timeRange().lower, zoomed.lower + 0.0512, 2e-3);
        view().setFocus();
        QTest::keyClick(&view(), Qt::Key_R);
        QVERIFY(tracks().timeRange() == zoomed);
        moveMouseTo(1.15);
        QTest::keyClick(&view(), Qt::Key_1);
        moveMouseTo(1.25);
        QTest::keyClick(&view(), Qt::Key_2);
        VYBEG_CLOSE(tracks().cursor(Cursor::a).value(), 1.15, 1e-3);
        VYBEG_CLOSE(tracks().cursor(Cursor::b).value(), 1.25, 1e-3);
        goToTracks();
        QVERIFY(tracks().timeRange() == zoomed);
        tracks().zoom().back();
        goToSignals();
        QVERIFY(view().content().time == (AxisRange{0.5, 1.5}));
        QTest::keyClick(&view(), Qt::Key_0);
        QVERIFY(!tracks().cursor(Cursor::a) && !tracks().cursor(Cursor::b));
        QTest::mouseDClick(&view(), Qt::LeftButton, {}, QPoint(x, y));
        QVERIFY(tracks().timeRange() == tracks().fullTimeRange());
    }

    void the_keys_of_the_page_work_when_it_is_shown() {
        open(home_.recording("demo.wav"));
        tracks().setFocus();
        goToSignals();
        QVERIFY(view().hasFocus());
        const double before = tracks().timeRange().span();
        QTest::keyClick(&view(), Qt::Key_Plus);
        VYBEG_CLOSE_RATIO(tracks().timeRange().span(), 0.8 * before, 1e-9);
        QTest::keyClick(&view(), Qt::Key_Home);
        QCOMPARE(tracks().timeRange().span(), before);
    }

    // Samples stay while those beside them are read.
    // The window came to its size while the tracks were hidden.
    void the_overview_stands_over_the_signals() {
        open(home_.recording("over.wav"));
        goToSignals();
        for (const QSize size : {QSize(1100, 760), QSize(1640, 1000)}) {
            window_->resize(size);
            const auto span = [this](const QWidget& widget, const QRect& area) {
                return std::pair(widget.mapTo(window_.get(), area.topLeft()).x(),
                                 widget.mapTo(window_.get(), area.bottomRight()).x());
            };
            const auto& overview = childOf<SignalView>(*window_);
            const auto& plot = childOf<QCustomPlot>(view());
            QTRY_COMPARE(span(overview, overview.plotArea()),
                         span(plot, plot.axisRects().front()->rect()));
        }
    }

    void panning_reads_what_comes_next() {
        open(home_.recording("demo.wav"));
        goToSignals();
        zoomToThreePeriods(0.5);
        for (int k = 0; k < 40; ++k) {
            QTest::keyClick(&view(), Qt::Key_Right);
            QVERIFY(view().content().excerpt);
            QVERIFY(QTest::qWaitFor([&] { return samplesShown(); }, 20000));
        }
        VYBEG_CLOSE(tracks().timeRange().lower, 0.5 + 40 * 0.1 * 3e-3, 3e-3);
        const SignalExcerpt& excerpt = *view().content().excerpt;
        VYBEG_CLOSE(excerpt.residual_c(view().picture().from), 0, 5e-3);
    }

    void without_a_run_samples_are_as_recorded() {
        open(home_.recording("demo.wav"));
        goToSignals();
        QVERIFY2(!state().contains("F5"), qPrintable(state()));
        document().removeAnalysis(document().analyses().front().shown.id);
        QVERIFY2(state().contains("F5"), qPrintable(state()));
        QVERIFY(!view().content().analysis);
        // The zoom goes on in the time of the recording.
        VYBEG_MORE(tracks().timeRange().span(), 1.9);
        zoomToThreePeriods(1.5);
        QVERIFY(view().picture().wave.c.empty());
        QVERIFY(std::isnan(view().content().excerpt->fit_c[0]));
        QCOMPARE(page().figures().plots.size(), 2);
        // A run that comes keeps the place.
        const AxisRange shown = tracks().timeRange();
        document().analyse();
        QVERIFY(QTest::qWaitFor([&] { return !view().picture().wave.c.empty(); }, 20000));
        QVERIFY(tracks().timeRange() == shown);
        QVERIFY(QTest::qWaitFor([&] { return samplesShown(); }, 20000));
    }

    void the_wave_can_be_hidden() {
        open(home_.recording("demo.wav"));
        goToSignals();
        zoomToThreePeriods(1);
        QVERIFY(!view().picture().wave.c.empty());
        const QImage with = view().grab().toImage();
        window_->action(Command::fitted_wave)->trigger();
        QVERIFY(view().picture().wave.c.empty());
        QVERIFY(std::isfinite(view().content().excerpt->residual_c(view().picture().from)));
        QVERIFY(QTest::qWaitFor([&] { return view().grab().toImage() != with; }));
    }

    void the_wave_follows_the_chosen_run() {
        open(home_.recording("demo.wav"));
        Settings settings = document().settings();
        settings.window = 200;
        document().setSettings(settings);
        document().analyse();
        QVERIFY(QTest::qWaitFor([&] { return document().analyses().size() == 2; }, 20000));
        goToSignals();
        for (const AnalysisEntry& entry : document().analyses()) {
            the<Ledger>().setCurrentAnalysis(entry.shown.id);
            QVERIFY(view().content().analysis == entry.shown.analysis);
        }
        // The row of an analysis is that of its recording, too: its wave is fitted to its samples.
        const auto first = document().currentRecording()->id;
        document().open({home_.recording("other.wav", 1)});
        QVERIFY(idle(3));
        the<Ledger>().setCurrentAnalysis(document().analyses().front().shown.id);
        QCOMPARE(document().currentRecording()->id, first);
        QVERIFY2(state().isEmpty(), qPrintable(state()));  // the chosen row says it
        QVERIFY(view().content().analysis == document().analyses().front().shown.analysis);
    }

    void it_speaks_both_languages() {
        open(home_.recording("demo.wav"));
        goToSignals();
        window_->setLanguage("ru");
        QTRY_COMPARE(the<QTabBar>("pages").tabText(1), QStringLiteral("Сигналы"));
        QVERIFY(view().accessibleName() != QStringLiteral("Signals over time"));
    }

    void it_exports_what_it_shows() {
        open(home_.recording("demo.wav"));
        goToSignals();
        zoomToThreePeriods(1);
        QVERIFY(window_->action(Command::export_plots)->isEnabled());
        const FigureSource source = page().figures();
        QCOMPARE(source.plots.size(), 3);
        std::vector<int> all(3);
        std::iota(all.begin(), all.end(), 0);
        const Figure figure = source.figure(all);
        const Figure residual = source.figure({2});
        VYBEG_LESS(residual.size.height(), figure.size.height());
        const QImage image = toImage(figure.draw, {figure.size});
        const QRgb ink = lightTheme().signalC.rgb();
        int inked = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                inked += image.pixel(x, y) == ink ? 1 : 0;
            }
        }
        VYBEG_MORE(inked, 200);
        const QString path = home_.path("signals.pdf");
        QVERIFY(writeDrawing(figure.draw, {figure.size}, path));
        VYBEG_MORE(QFileInfo(path).size(), 5000);
    }
};

VYBEG_TEST(TestSignalsPage, threads)

}  // namespace test_signals_page

#include "test_signals_page.moc"
