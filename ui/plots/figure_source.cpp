#include "ui/plots/figure_source.h"

#include <qcustomplot.h>

#include <algorithm>

namespace vybeg::ui {

Figure stacked(const std::vector<Figure>& figures, const QString& name) {
    Figure all{{}, {}, name};
    for (const Figure& figure : figures) {
        all.size.setWidth(std::max(all.size.width(), figure.size.width()));
        all.size.rheight() += figure.size.height();
    }
    const int proposed = std::max(1, all.size.height());
    all.draw = [figures, proposed](QCPPainter& painter, QSize size) {
        int top = 0;
        for (const Figure& figure : figures) {
            const int height = size.height() * figure.size.height() / proposed;
            painter.save();
            painter.translate(0, top);
            figure.draw(painter, {size.width(), height});
            painter.restore();
            top += height;
        }
    };
    return all;
}

FigureSource sourceOf(const std::vector<std::pair<QString, Figure>>& figures, const QString& name,
                      const QString& title) {
    FigureSource source;
    std::vector<Figure> drawings;
    for (const auto& [plot, figure] : figures) {
        source.plots << plot;
        drawings.push_back(figure);
    }
    source.title = title;
    source.figure = [drawings, name](const std::vector<int>& places) {
        return stacked(atPlaces(drawings, places), name);
    };
    return source;
}

}  // namespace vybeg::ui
