#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/tools/pictures/layout.h"

#include <QChart>
#include <QChartView>
#include <QPainter>
#include <QScrollArea>
#include <QtTest>
#include <qcustomplot.h>

#include <memory>

namespace test_layout {

using namespace vybeg::test;

namespace {

constexpr double exact = 1e-12;  // of shares

// A window of 400 x 200 with one plot, whose frame is that in the window.
std::unique_ptr<QWidget> window_with_plot(const QRect& frame) {
    auto window = std::make_unique<QWidget>();
    window->resize(400, 200);
    auto* plot = new QCustomPlot(window.get());
    plot->setGeometry(frame.adjusted(-20, -10, 20, 10));
    plot->axisRect()->setAutoMargins(QCP::msNone);
    plot->axisRect()->setMargins({20, 10, 20, 10});
    window->show();
    plot->replot();
    return window;
}

// The window's picture without any ink.
QImage plain_picture(const QWidget& window, int scale = 1) {
    QImage picture(window.size() * scale, QImage::Format_RGB32);
    picture.setDevicePixelRatio(scale);
    picture.fill(Qt::white);
    return picture;
}

}  // namespace

class TestLayout : public QObject {
    Q_OBJECT

private slots:
    void aVisibleFrameIsCountedWithItsShare() {
        const auto window = window_with_plot({100, 50, 200, 100});
        const auto frames = plot_frames(*window);
        QCOMPARE(frames.size(), std::size_t{1});
        QCOMPARE(frames[0].shown, QRect(100, 50, 200, 100));
        const Layout layout = measure_layout(*window, plain_picture(*window));
        QCOMPARE(layout.window, QSize(400, 200));
        QCOMPARE(layout.frames, 1);
        VYBEG_CLOSE(layout.frame_share, 0.25, exact);
    }

    void aFrameThatIsPartlyScrolledAwayIsNotCounted() {
        QScrollArea window;
        window.resize(400, 200);
        window.setFrameShape(QFrame::NoFrame);
        window.setWidget(window_with_plot({100, 150, 200, 100}).release());
        window.widget()->resize(380, 400);
        window.show();
        const auto frames = plot_frames(window);
        QCOMPARE(frames.size(), std::size_t{1});
        QVERIFY(!frames[0].whole);
        VYBEG_LESS(frames[0].shown.bottom(), 200);
        const Layout layout = measure_layout(window, plain_picture(window));
        QCOMPARE(layout.frames, 0);
        VYBEG_CLOSE(layout.frame_share, 0, exact);
    }

    void hiddenPlotsAndAxesAreNotCounted() {
        const auto window = window_with_plot({100, 50, 200, 100});
        auto* plot = window->findChild<QCustomPlot*>();
        plot->layer(QStringLiteral("axes"))->setVisible(false);
        QVERIFY(plot_frames(*window).empty());
        plot->layer(QStringLiteral("axes"))->setVisible(true);
        plot->hide();
        QVERIFY(plot_frames(*window).empty());
    }

    void theFrameOfAChartIsItsPlotArea() {
        QWidget window;
        window.resize(400, 200);
        auto* view = new QChartView(new QChart, &window);
        view->setFrameShape(QFrame::NoFrame);
        view->setGeometry(100, 0, 300, 200);
        view->chart()->setPlotArea({50, 40, 160, 120});
        window.show();
        const auto frames = plot_frames(window);
        QCOMPARE(frames.size(), std::size_t{1});
        QVERIFY(frames[0].whole);
        VYBEG_WITHIN(frames[0].shown.x(), 150, 1);
        VYBEG_WITHIN(frames[0].shown.y(), 40, 1);
        VYBEG_WITHIN(frames[0].shown.width(), 160, 2);
        VYBEG_WITHIN(frames[0].shown.height(), 120, 2);
    }

    void inkIsWhereAPixelDiffersFromItsNeighbours() {
        QWidget window;
        window.resize(400, 200);
        QImage picture = plain_picture(window);
        // The line's column and the one after it have ink, over the whole height.
        QPainter(&picture).fillRect(200, 0, 1, 200, Qt::black);
        const Layout layout = measure_layout(window, picture);
        VYBEG_CLOSE(layout.inkless_share, 1 - 2 / 400., exact);
        VYBEG_CLOSE(layout.blank_share, 1 - (2 + 2 * blank_reach) / 400., exact);
    }

    void framesAreNeverEmpty() {
        const auto window = window_with_plot({100, 50, 200, 100});
        const Layout layout = measure_layout(*window, plain_picture(*window));
        VYBEG_CLOSE(layout.inkless_share, 0.75, exact);
        VYBEG_CLOSE(layout.blank_share, 0.75, exact);
    }

    void theScaleOfTheScreenChangesNoShare() {
        const auto window = window_with_plot({100, 50, 200, 100});
        QImage picture = plain_picture(*window, 2);
        // Two columns of the screen: ink at the first, and after the second.
        QPainter(&picture).fillRect(20, 0, 1, 200, Qt::black);
        const Layout layout = measure_layout(*window, picture);
        VYBEG_CLOSE(layout.frame_share, 0.25, exact);
        VYBEG_CLOSE(layout.inkless_share, 0.75 - 2 / 800., exact);
        VYBEG_CLOSE(layout.blank_share, 0.75 - (3 + 4 * blank_reach) / 800., exact);
    }

    void aRowHasAFieldForEachName() {
        const QString row = layout_row(QStringLiteral("a.png"), {{1280, 720}, 5, 0.5, 0.25, 0.125});
        QCOMPARE(row, "a.png,1280,720,5,0.5000,0.2500,0.1250");
        QCOMPARE(row.count(','), layout_names().count(','));
    }
};

VYBEG_TEST(TestLayout)

}  // namespace test_layout

#include "test_layout.moc"
