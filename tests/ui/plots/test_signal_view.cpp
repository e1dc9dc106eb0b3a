#include "core/recording/envelope/envelope.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "ui/plots/signal_view.h"

#include <QSignalSpy>
#include <QWheelEvent>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <limits>

namespace test_signal_view {

using namespace vybeg;
using namespace vybeg::ui;

namespace {

constexpr double rate = 1000;
constexpr std::int64_t length = 10000;  // 10 s

// C swings by 1, D by 0.1; the samples from 6 s to 6.5 s are missing.
class Swing : public SampleSource {
public:
    std::int64_t frames() const override { return length; }
    Status read(std::int64_t first, std::span<double> c, std::span<double> d) const override {
        for (std::size_t i = 0; i < c.size(); ++i) {
            const auto frame = first + static_cast<std::int64_t>(i);
            const bool missing = 6000 <= frame && frame < 6500;
            c[i] = missing ? std::numeric_limits<double>::quiet_NaN() : (frame % 2 ? 1 : -1);
            d[i] = 0.1 * c[i];
        }
        return {};
    }
};

struct Bench {
    SignalView view;
    QSignalSpy visible{&view, &SignalView::visibleRangeEdited};
    QSignalSpy analysed{&view, &SignalView::analysedRangeEdited};

    Bench() {
        view.resize(1016, 69);
        view.setMargins(8, 8);
        view.setPalette(lightTheme().palette);
        const auto envelope = build_envelope(Swing(), {});
        view.setEnvelope(*envelope, rate);
        view.setVisibleRange({2, 6});
        view.setAnalysedRange({1, 9});
        view.show();
        QCoreApplication::processEvents();
    }

    // 100 pixels are a second, from the left margin on.
    QPoint signalAt(double time_s) const { return {8 + qRound(100 * time_s), 30}; }
    QPoint barAt(double time_s) const { return {8 + qRound(100 * time_s), 64}; }

    void drag(const QPoint& from, const QPoint& to) {
        QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, from);
        QMouseEvent event(QEvent::MouseMove, to, view.mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                          Qt::NoModifier);
        QCoreApplication::sendEvent(&view, &event);
        QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, to);
    }

    bool shows(double from, double to) const {
        // One and a half pixels.
        return std::abs(view.visibleRange().lower - from) < 0.015 &&
               std::abs(view.visibleRange().upper - to) < 0.015;
    }
    bool analyses(double from, double to) const {
        return std::abs(view.analysedRange().lower - from) < 0.015 &&
               std::abs(view.analysedRange().upper - to) < 0.015;
    }
};

// How many pixels of a row of the picture have about this colour.
int pixelsLike(const QImage& image, int y, const QColor& color) {
    int count = 0;
    for (int x = 0; x < image.width(); ++x) {
        const QColor c = image.pixelColor(x, y);
        count += std::abs(c.red() - color.red()) + std::abs(c.green() - color.green()) +
                     std::abs(c.blue() - color.blue()) <
                 30;
    }
    return count;
}

}  // namespace

class TestSignalView : public QObject {
    Q_OBJECT

private slots:
    void faults_are_marked_where_they_lie() {
        Bench bench;
        const QImage before = bench.view.grab().toImage();
        auto faults = std::make_shared<SampleFaults>();
        faults->clipped = {{1000, 500}, {1500, 3}};  // 1 s to 1.5 s
        faults->steps = {{8000, 1.0, 1}};
        bench.view.setFaults(faults);
        const QImage after = bench.view.grab().toImage();
        const QRgb warning = lightTheme().warning.rgb();
        const auto marked = [&](double time_s, int y) {
            return after.pixel(bench.signalAt(time_s).x(), y) == warning;
        };
        QVERIFY(marked(1.01, 5) && marked(1.25, 5) && marked(1.49, 5));
        QVERIFY(!marked(0.98, 5) && !marked(1.55, 5) && !marked(1.25, 20));
        QVERIFY(marked(8, 5));
        QVERIFY(!marked(7.9, 5) && !marked(8.1, 5));
        bench.view.setFaults({});
        QCOMPARE(bench.view.grab().toImage(), before);
    }
    void each_edge_can_be_dragged() {
        Bench bench;
        bench.drag(bench.signalAt(2), bench.signalAt(3));
        QVERIFY(bench.shows(3, 6));
        bench.drag(bench.signalAt(6), bench.signalAt(8));
        QVERIFY(bench.shows(3, 8));
        bench.drag(bench.barAt(1), bench.barAt(0.5));
        QVERIFY(bench.analyses(0.5, 9));
        bench.drag(bench.barAt(9), bench.barAt(7));
        QVERIFY(bench.analyses(0.5, 7));
        QVERIFY(bench.shows(3, 8));
        VYBEG_AT_LEAST(bench.visible.count(), 2);
        VYBEG_AT_LEAST(bench.analysed.count(), 2);
    }

    void the_inside_shifts_the_range_to_the_ends_and_no_farther() {
        Bench bench;
        bench.drag(bench.signalAt(4), bench.signalAt(5));
        QVERIFY(bench.shows(3, 7));
        bench.drag(bench.signalAt(5), bench.signalAt(9.9));
        QVERIFY(bench.shows(6, 10));
        bench.drag(bench.barAt(5), bench.barAt(1));
        QVERIFY(bench.analyses(0, 8));
    }

    void an_edge_does_not_pass_the_other() {
        Bench bench;
        bench.drag(bench.signalAt(2), bench.signalAt(9));
        VYBEG_LESS(bench.view.visibleRange().lower, bench.view.visibleRange().upper);
        VYBEG_LESS(bench.view.visibleRange().upper, 6.001);
    }

    void a_click_outside_centres_the_range_there() {
        Bench bench;
        QTest::mouseClick(&bench.view, Qt::LeftButton, Qt::NoModifier, bench.signalAt(7.5));
        QVERIFY(bench.shows(5.5, 9.5));
    }

    void a_double_click_shows_all() {
        Bench bench;
        QTest::mouseDClick(&bench.view, Qt::LeftButton, Qt::NoModifier, bench.signalAt(4));
        QVERIFY(bench.shows(0, 10));
        QTest::mouseDClick(&bench.view, Qt::LeftButton, Qt::NoModifier, bench.barAt(4));
        QVERIFY(bench.analyses(0, 10));
    }

    void the_wheel_zooms_about_the_mouse() {
        Bench bench;
        const QPoint mouse = bench.signalAt(3);
        QWheelEvent event(mouse, bench.view.mapToGlobal(mouse), {}, {0, 120}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&bench.view, &event);
        QVERIFY(bench.shows(3 - 0.8, 3 + 0.8 * 3));
    }

    void keys_move_both_ranges() {
        Bench bench;
        QTest::keyClick(&bench.view, Qt::Key_Right);
        QVERIFY(bench.shows(2.4, 6.4));
        QTest::keyClick(&bench.view, Qt::Key_Plus);
        QVERIFY(bench.shows(2.8, 6));
        QTest::keyClick(&bench.view, Qt::Key_Home);
        QVERIFY(bench.shows(0, 10));
        QTest::keyClick(&bench.view, Qt::Key_Left, Qt::ShiftModifier);
        QVERIFY(bench.analyses(0.2, 8.2));
    }

    void setters_emit_nothing() {
        Bench bench;
        bench.view.setVisibleRange({1, 2});
        bench.view.setAnalysedRange({1, 2});
        QCOMPARE(bench.visible.count() + bench.analysed.count(), 0);
    }

    void both_channels_and_missing_samples_are_seen() {
        Bench bench;
        bench.view.setVisibleRange({0, 10});
        // In device-independent pixels, whatever the scale.
        const QImage image = bench.view.grab().toImage().scaled(bench.view.size());
        // 950 of 1000 columns hold samples; names and handles cover some.
        VYBEG_MORE(pixelsLike(image, 12, lightTheme().signalC), 850);
        VYBEG_MORE(pixelsLike(image, 46, lightTheme().signalD), 850);
        // D swings a tenth as far: nothing of it where C's crests are.
        QCOMPARE(pixelsLike(image, 37, lightTheme().signalD), 0);
        const int marked = pixelsLike(image, 58, lightTheme().warning);
        VYBEG_AT_LEAST(marked, 45);
        VYBEG_AT_MOST(marked, 60);
    }

    void what_has_been_read_is_seen_and_the_rest_is_not() {
        Bench bench;
        bench.view.setVisibleRange({0, 10});
        // Two blocks of 5 s, of which the first has been read.
        const auto two_blocks = 2 * EnvelopeBlock::frames;
        std::vector<double> c(EnvelopeBlock::frames);
        std::vector<double> d(EnvelopeBlock::frames);
        for (std::size_t i = 0; i < c.size(); ++i) {
            c[i] = i % 2 ? 1 : -1;
            d[i] = 0.1 * c[i];
        }
        const auto block = std::make_shared<const EnvelopeBlock>(c, d);
        bench.view.setEnvelope(
            std::make_shared<Envelope>(two_blocks, std::vector{block, decltype(block){}}, nullptr),
            static_cast<double>(two_blocks) / 10);
        const QImage image = bench.view.grab().toImage().scaled(bench.view.size());
        const int seen = pixelsLike(image, 12, lightTheme().signalC);
        VYBEG_MORE(seen, 450);
        VYBEG_AT_MOST(seen, 501);
        // The axis is that of the whole, and can be used at once.
        bench.drag(bench.signalAt(10), bench.signalAt(8));
        QVERIFY(bench.shows(0, 8));
    }

    void what_has_only_been_looked_at_is_paler() {
        Bench bench;
        bench.view.setVisibleRange({0, 10});
        EnvelopeBucket look{{-1, 1}, {-0.1f, 0.1f}};
        bench.view.setEnvelope(sampled_envelope(length, {look, look}), rate);
        const QImage image = bench.view.grab().toImage().scaled(bench.view.size());
        QCOMPARE(pixelsLike(image, 12, lightTheme().signalC), 0);
        const QColor strong = lightTheme().signalC;
        const QColor ground = lightTheme().plotBackground;
        const auto mixed = [](int a, int b) { return qRound(0.45 * a + 0.55 * b); };
        const QColor pale(mixed(strong.red(), ground.red()), mixed(strong.green(), ground.green()),
                          mixed(strong.blue(), ground.blue()));
        VYBEG_MORE(pixelsLike(image, 12, pale), 850);
    }

    void nothing_can_be_dragged_while_reading() {
        Bench bench;
        bench.view.setReading(10);
        bench.drag(bench.signalAt(2), bench.signalAt(3));
        QTest::keyClick(&bench.view, Qt::Key_Right);
        QCOMPARE(bench.visible.count(), 0);
        QCOMPARE(pixelsLike(bench.view.grab().toImage(), 12, lightTheme().signalC), 0);
    }
};

VYBEG_TEST(TestSignalView)

}  // namespace test_signal_view

#include "test_signal_view.moc"
