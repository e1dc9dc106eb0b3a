#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/synthetic_analysis.h"
#include "ui/plots/plot_stack.h"

#include <QApplication>
#include <QClipboard>
#include <QPainter>
#include <QSvgRenderer>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtTest>

#include <algorithm>
#include <array>
#include <csignal>
#include <sys/resource.h>

namespace test_plot_export {

using namespace vybeg;
using namespace vybeg::ui;

namespace {

PlotContent twoRuns() {
    PlotContent content;
    content.analyses = {syntheticAnalysis(0, {.window = 6}), syntheticAnalysis(1, {.window = 60})};
    content.zoom.time = *coveredTime(content.analyses);
    content.theme = darkTheme();
    return content;
}

std::vector<FigureColumn> twoColumns() {
    const PlotContent content = twoRuns();
    return {{QStringLiteral("n = 6"), content.analyses[0]},
            {QStringLiteral("n = 60"), content.analyses[1]}};
}

QByteArray bytesOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

// Share of pixels that are not white.
double ink(const QImage& image) {
    qint64 dark = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            dark += image.pixel(x, y) != qRgb(255, 255, 255);
        }
    }
    return double(dark) / image.width() / image.height();
}

Status drawnFigure(const Figure& figure, const QString& path) {
    return writeDrawing(figure.draw, {figure.size}, path);
}

// All texts of an SVG, one after the other.
QString textsOf(const QByteArray& svg) {
    QString all;
    QXmlStreamReader xml(svg);
    while (!xml.atEnd()) {
        if (xml.readNext() == QXmlStreamReader::Characters && !xml.isWhitespace()) {
            all += xml.text().toString() + ' ';
        }
    }
    return xml.hasError() ? QString() : all;
}

PlotContent onePlot(PlotContent content, SlowVariable variable) {
    content.variables = {variable};
    return content;
}

}  // namespace

class TestPlotExport : public QObject {
    Q_OBJECT

private:
    QTemporaryDir dir_;

    // Columns of pixels with a colour, of those between the first and the last.
    static double shareOf(const QImage& image, const QColor& color) {
        int first = -1;
        int last = -1;
        int columns = 0;
        // Inside the frame: letters beside it are dark, too.
        for (int x = image.width() / 12; x < image.width() * 24 / 25; ++x) {
            bool found = false;
            for (int y = image.height() / 4; y < image.height() && !found;
                 ++y) {                                // below the legend
                const QRgb pixel = image.pixel(x, y);  // where pieces meet a little paler
                found = std::abs(qRed(pixel) - color.red()) < 80 &&
                        std::abs(qGreen(pixel) - color.green()) < 80 &&
                        std::abs(qBlue(pixel) - color.blue()) < 80;
            }
            if (found) {
                first = first < 0 ? x : first;
                last = x;
                ++columns;
            }
        }
        return columns < 2 ? 0 : static_cast<double>(columns) / (last - first + 1);
    }

private slots:
    // Of whatever number: a dash would chop a dense curve into bursts, a modulation that is not
    // there.
    void data_are_drawn_without_gaps() {
        for (const int index : {0, 7, 14, 21, 28}) {
            PlotContent content = onePlot(twoRuns(), SlowVariable::a_A);
            content.units.sigma_bands = false;
            content.analyses = {syntheticAnalysis(index, {.window = 60, .noise = 1e-9})};
            content.zoom.time = *coveredTime(content.analyses);
            const ShownAnalysis& shown = content.analyses.front();
            const QImage image =
                toImage(plotsFigure(content).draw, {{800, 300}, 4 * pixels_per_inch});
            VYBEG_AT_LEAST(shareOf(image, readable(shown.color, lightTheme(), shown.shade)), 0.99);
        }
    }

    // Four curves within each other's noise: the mean of each is seen all along.
    void noisy_curves_over_each_other_stay_apart() {
        PlotContent content = onePlot(twoRuns(), SlowVariable::a_B);
        content.units.sigma_bands = false;
        content.analyses.clear();
        for (int k = 0; k < 4; ++k) {
            ShownAnalysis shown =
                syntheticAnalysis(k, {.window = 6, .noise = 0.02, .seed = 1U + unsigned(k)});
            auto shifted = std::make_shared<Analysis>(*shown.analysis);
            for (double& value : shifted->track.values(SlowVariable::a_B)) {
                value += 0.01 * k;  // of noise with a deviation of 0.0115
            }
            shown.analysis = shifted;
            content.analyses.push_back(shown);
        }
        content.zoom.time = *coveredTime(content.analyses);
        const QImage image = toImage(plotsFigure(content).draw, {{800, 400}, 4 * pixels_per_inch});
        for (const ShownAnalysis& shown : content.analyses) {
            VYBEG_AT_LEAST(shareOf(image, readable(shown.color, lightTheme(), shown.shade)), 0.8,
                           qPrintable(shown.recording));
        }
    }

    // At any number of windows a pixel: an amplitude in counts scatters by more than an angle can.
    void noise_looks_the_same_in_volts_and_in_counts() {
        for (const int window : {12, 60, 150, 300, 600, 1500}) {
            std::array<int, 2> coloured{};
            for (const double counts : {1.0, 1e4}) {
                PlotContent content = onePlot(twoRuns(), SlowVariable::a_A);
                content.units.sigma_bands = false;
                ShownAnalysis shown = syntheticAnalysis(0, {.window = window, .noise = 0.3});
                auto scaled = std::make_shared<Analysis>(*shown.analysis);
                for (double& value : scaled->track.values(SlowVariable::a_A)) {
                    value *= counts;
                }
                shown.analysis = scaled;
                content.analyses = {shown};
                content.zoom.time = *coveredTime(content.analyses);
                const QImage image =
                    toImage(plotsFigure(content).draw, {{800, 300}, pixels_per_inch});
                for (int y = 0; y < image.height(); ++y) {
                    for (int x = 0; x < image.width(); ++x) {
                        const QColor color = image.pixelColor(x, y);
                        coloured[counts > 1] += color.blue() > color.red() + 20 ? 1 : 0;
                    }
                }
            }
            VYBEG_CLOSE_RATIO(coloured[1], coloured[0], 0.02, qPrintable(QString::number(window)));
        }
    }

    void where_curves_leave_the_frame_stand_pointers_of_each_and_no_bar() {
        PlotContent content = onePlot(twoRuns(), SlowVariable::a_A);
        content.units.sigma_bands = false;
        // Amplitudes about one lie above the first, below the second.
        for (const AxisRange& values : {AxisRange{0, 0.1}, AxisRange{10, 11}}) {
            content.zoom.fixed[SlowVariable::a_A] = values;
            const QImage image = toImage(plotsFigure(content).draw, {{800, 300}, pixels_per_inch});
            for (const ShownAnalysis& shown : content.analyses) {
                const QColor color = readable(shown.color, lightTheme());
                int pixels = 0;
                int longest = 0;
                for (int y = 0; y < image.height(); ++y) {
                    int length = 0;
                    for (int x = 0; x < image.width(); ++x) {
                        length = image.pixelColor(x, y) == color ? length + 1 : 0;
                        pixels += length > 0;
                        longest = std::max(longest, length);
                    }
                }
                VYBEG_MORE(pixels, 200, "the curve is seen to go on");
                VYBEG_LESS(longest, 40);  // the legend's line
            }
        }
    }

    void a_png_has_twice_the_size_and_a_white_ground() {
        const QString path = dir_.filePath(QStringLiteral("plots.png"));
        QVERIFY(writeDrawing(plotsFigure(twoRuns()).draw, {{800, 600}}, path));
        const QImage image(path);
        QCOMPARE(image.size(), QSize(1600, 1200));
        QCOMPARE(image.pixel(2, 1190), qRgb(255, 255, 255));
        VYBEG_MORE(ink(image), 0.03);
        VYBEG_LESS(ink(image), 0.6);
    }

    void an_svg_parses_and_names_runs_and_units() {
        const QString path = dir_.filePath(QStringLiteral("plots.svg"));
        QVERIFY(writeDrawing(plotsFigure(twoRuns()).draw, {{800, 600}}, path));
        const QByteArray svg = bytesOf(path);
        QVERIFY(QSvgRenderer().load(svg));
        const QString texts = textsOf(svg);
        QVERIFY(texts.contains(QStringLiteral("n = 60")));
        QVERIFY(texts.contains(QStringLiteral("Hz")));
        // 155 000 windows twice in five plots: what is drawn is what can be seen.
        VYBEG_LESS(svg.size(), 4'000'000);
    }

    void a_pdf_is_one_page_of_vectors() {
        const QString path = dir_.filePath(QStringLiteral("plots.pdf"));
        QVERIFY(writeDrawing(plotsFigure(twoRuns()).draw, {{800, 600}}, path));
        const QByteArray pdf = bytesOf(path);
        QVERIFY(pdf.startsWith("%PDF-1."));
        QVERIFY(pdf.trimmed().endsWith("%%EOF"));
        QVERIFY(pdf.contains("/Count 1"));
        QVERIFY(!pdf.contains("/Subtype /Image"));
        // 800 by 600 pixels of 1/96 inch, in points.
        QVERIFY(pdf.contains("/MediaBox [0 0 600"));
        VYBEG_LESS(pdf.size(), 2'000'000);
    }

    void one_plot_alone_holds_one_variable() {
        const QString path = dir_.filePath(QStringLiteral("one.svg"));
        QVERIFY(writeDrawing(plotsFigure(onePlot(twoRuns(), SlowVariable::two_theta_A)).draw,
                             {{800, 300}}, path));
        const QString texts = textsOf(bytesOf(path));
        QVERIFY(texts.contains(QStringLiteral("2θ")));
        QVERIFY(!texts.contains(QStringLiteral("ω")));
    }

    void an_unknown_ending_is_refused() {
        const Status status = writeDrawing(plotsFigure(twoRuns()).draw, {{800, 600}},
                                           dir_.filePath(QStringLiteral("plots.bmp")));
        QVERIFY(!status);
        QVERIFY(status.error().code == ErrorCode::output_format_unknown);
        QCOMPARE(status.error().args, (std::vector<MessageArg>{".bmp", ".png, .svg, .pdf"}));
    }

    void a_failure_leaves_the_old_file() {
        const Status status =
            writeDrawing(plotsFigure(twoRuns()).draw, {{800, 600}},
                         dir_.filePath(QStringLiteral("no/such/place/plots.pdf")));
        QVERIFY(!status);
        QVERIFY(status.error().code == ErrorCode::output_failed);
        QVERIFY(!english(status.error().args.at(0)).empty());
        const QString folder = dir_.filePath(QStringLiteral("taken.svg"));
        QVERIFY(QDir().mkpath(folder + QStringLiteral("/inside")));
        QVERIFY(!writeDrawing(plotsFigure(twoRuns()).draw, {{800, 600}}, folder));
        QVERIFY(QFileInfo::exists(folder + QStringLiteral("/inside")));
    }

    void the_clipboard_gets_the_image() {
        copyDrawing(plotsFigure(twoRuns()).draw, {{400, 300}});
        QCOMPARE(QApplication::clipboard()->image().size(), QSize(800, 600));
    }

    void a_picture_draws_into_any_page() {
        const QPicture picture = toPicture(plotsFigure(twoRuns()).draw, {400, 300});
        QImage page(1200, 900, QImage::Format_RGB32);
        page.fill(Qt::white);
        QPainter painter(&page);
        painter.scale(3, 3);
        painter.drawPicture(0, 0, picture);
        painter.end();
        // The lower right quarter holds curves too: the picture fills the page.
        VYBEG_MORE(ink(page.copy(600, 450, 600, 450)), 0.02);
    }

    void the_articles_figure_has_eight_lettered_panels() {
        const QString path = dir_.filePath(QStringLiteral("figure.svg"));
        QVERIFY(drawnFigure(articleFigure(twoColumns()), path));
        const QString texts = textsOf(bytesOf(path));
        for (const char* part : {"n = 6 ", "n = 60 ", "rad", "Hz", "t, s"}) {
            QVERIFY2(texts.contains(QString::fromUtf8(part)), part);
        }
        for (const char letter : {'a', 'b', 'c', 'd', 'e', 'f', 'g', 'h'}) {
            QVERIFY2(texts.contains(QStringLiteral(" %1 ").arg(QChar(letter))), &letter);
        }
        QVERIFY(!texts.contains(QStringLiteral(" i ")));
    }

    // Columns of several recordings have their names, by what differs, as they are.
    void columns_of_recordings_are_named() {
        std::vector<FigureColumn> columns = twoColumns();
        const QString path = dir_.filePath(QStringLiteral("named.svg"));
        QVERIFY(drawnFigure(articleFigure(columns), path));
        QVERIFY(!textsOf(bytesOf(path)).contains(QStringLiteral("gyro_A_long_way_north")));
        columns[0].shown.recording = QStringLiteral("gyro_A_long_way_north.wav");
        columns[1].shown.recording = QStringLiteral("gyro_A_long_way_south.wav");
        QVERIFY(drawnFigure(articleFigure(columns), path));
        const QString texts = textsOf(bytesOf(path));
        QVERIFY2(texts.contains(QStringLiteral("north")) && texts.contains(QStringLiteral("south")),
                 qPrintable(texts));
    }

    void a_figure_is_written_in_every_format() {
        const QString base = dir_.filePath(QStringLiteral("figure"));
        const Figure figure = articleFigure(twoColumns());
        QVERIFY(drawnFigure(figure, base + QStringLiteral(".png")));
        QCOMPARE(QImage(base + QStringLiteral(".png")).size(), 2 * figure.size);
        QVERIFY(drawnFigure(figure, base + QStringLiteral(".pdf")));
        QVERIFY(bytesOf(base + QStringLiteral(".pdf")).startsWith("%PDF-1."));
        QVERIFY(!drawnFigure(figure, base + QStringLiteral(".gif")));
    }

    void columns_share_their_value_axes() {
        // With the scatter of n = 6 on both, n = 60 is a narrow trace in its panel; alone it fills
        // it. Ink of the last column.
        const auto blue = [&](const std::vector<FigureColumn>& columns) {
            DisplayUnits units;
            units.sigma_bands = false;
            const QString path = dir_.filePath(QStringLiteral("axes.png"));
            if (!drawnFigure(articleFigure(columns, {SlowVariable::f}, units), path)) {
                return -1.;
            }
            const QImage image(path);
            const int width = image.width() / static_cast<int>(columns.size());
            return ink(image.copy(image.width() - width, 0, width, image.height()));
        };
        const double common = blue(twoColumns());
        const double own = blue({twoColumns().back()});
        VYBEG_MORE(common, 0);
        VYBEG_MORE(own, 2 * common);
    }

    void a_disk_that_fills_leaves_the_old_file_data() {
        QTest::addColumn<QString>("ending");
        for (const char* ending : {"png", "svg", "pdf"}) {
            QTest::newRow(ending) << ending;
        }
    }

    void a_disk_that_fills_leaves_the_old_file() {
        QFETCH(QString, ending);
        const QString path = dir_.filePath(QStringLiteral("full.") + ending);
        QVERIFY(writeDrawing(plotsFigure(twoRuns()).draw, {{800, 600}}, path));
        const qint64 plots_size = QFileInfo(path).size();
        QVERIFY(drawnFigure(articleFigure(twoColumns()), path));
        const qint64 whole = std::min(plots_size, QFileInfo(path).size());
        constexpr int sizes = 15;
        VYBEG_MORE(whole, sizes);
        // SIGXFSZ is ignored, as in both programs: write() fails where a file reaches the limit.
        std::signal(SIGXFSZ, SIG_IGN);
        rlimit before{};
        QCOMPARE(getrlimit(RLIMIT_FSIZE, &before), 0);
        for (int k = 0; k < sizes; ++k) {
            QFile old(path);
            QVERIFY(old.open(QIODevice::WriteOnly) && old.write("old") == 3);
            old.close();
            const rlimit now{static_cast<rlim_t>(whole * k / sizes), before.rlim_max};
            QCOMPARE(setrlimit(RLIMIT_FSIZE, &now), 0);
            const Status plots = writeDrawing(plotsFigure(twoRuns()).draw, {{800, 600}}, path);
            const Status figure = drawnFigure(articleFigure(twoColumns()), path);
            QCOMPARE(setrlimit(RLIMIT_FSIZE, &before), 0);
            const QByteArray about = QByteArray::number(qulonglong(now.rlim_cur));
            QVERIFY2(!plots && plots.error().code == ErrorCode::output_failed, about);
            QVERIFY2(!figure && figure.error().code == ErrorCode::output_failed, about);
            QVERIFY2(bytesOf(path) == "old", about);
            const QStringList left =
                QDir(dir_.path())
                    .entryList({QStringLiteral("*.part"), QStringLiteral("full.*.*")},
                               QDir::AllEntries | QDir::Hidden);
            QVERIFY2(left.isEmpty(), about + left.join(' ').toUtf8());
        }
        QVERIFY(QFile::remove(path));
    }

    void a_figure_without_columns_is_an_empty_page() {
        const QString path = dir_.filePath(QStringLiteral("empty.png"));
        QVERIFY(drawnFigure(articleFigure({}), path));
        QCOMPARE(ink(QImage(path)), 0.);
    }
};

VYBEG_TEST(TestPlotExport)

}  // namespace test_plot_export

#include "test_plot_export.moc"
