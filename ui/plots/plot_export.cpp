#include "ui/plots/plot_export.h"

#include "ui/plots/figure.h"
#include "ui/plots/plot_stack.h"

namespace vybeg::ui {

Drawing plotsDrawing(const PlotContent& content) {
    PlotContent paper = content;
    paper.theme = lightTheme();
    return [paper](QCPPainter& painter, QSize size) {
        QCustomPlot plot;
        preparePlot(plot, paper.theme);
        PlotStack stack(plot, 0, PlotHead::line);
        // Twice, because the room for the names is known after the first layout.
        stack.setContent(paper);
        stack.prepare(size);
        stack.setZoom(paper.zoom);
        plot.toPainter(&painter, size.width(), size.height());
    };
}

QSize paperSize(const PlotContent& content) {
    FigureOptions options;
    options.variables = content.variables;
    constexpr int width = 900;
    return {width, figureSize(1, options).height()};
}

}  // namespace vybeg::ui
