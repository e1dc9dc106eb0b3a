#include "ui/plots/plot_export.h"

#include "ui/plots/figure.h"
#include "ui/plots/plot_file.h"
#include "ui/plots/plot_stack.h"

#include <QClipboard>
#include <QGuiApplication>

namespace vybeg::ui {
namespace {

// Lays out the plots of `content` on paper and calls draw(plot).
template <class Draw>
void onPaper(const PlotContent& content, QSize size, const Draw& draw) {
    PlotContent paper = content;
    paper.theme = lightTheme();
    QCustomPlot plot;
    preparePlot(plot, paper.theme);
    PlotStack stack(plot, 0, PlotStack::Head::run_names);
    // Twice, because the room for the names is known after the first layout.
    stack.setContent(paper);
    stack.prepare(size);
    stack.setZoom(paper.zoom);
    draw(plot);
}

}  // namespace

QSize paperSize(const PlotContent& content) {
    FigureOptions options;
    options.variables = content.variables;
    constexpr int width = 900;
    return {width, figureSize(1, options).height()};
}

QImage plotImage(const PlotContent& content, QSize size, double scale) {
    QImage image;
    onPaper(content, size, [&](QCustomPlot& plot) { image = toImage(plot, size, scale); });
    return image;
}

QPicture plotPicture(const PlotContent& content, QSize size) {
    QPicture picture;
    onPaper(content, size, [&](QCustomPlot& plot) { picture = toPicture(plot, size); });
    return picture;
}

Status exportPlots(const PlotContent& content, QSize size, const QString& path) {
    Status status;
    onPaper(content, size, [&](QCustomPlot& plot) { status = writePlot(plot, size, path); });
    return status;
}

PlotContent onePlot(PlotContent content, SlowVariable variable) {
    content.variables = {variable};
    return content;
}

void copyPlots(const PlotContent& content, QSize size) {
    QGuiApplication::clipboard()->setImage(plotImage(content, size));
}

}  // namespace vybeg::ui
