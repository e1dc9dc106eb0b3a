#include "ui/plots/panel_frame.h"

#include <algorithm>

namespace vybeg::ui {

void addFrame(QCPAxisRect& panel, const QSharedPointer<PanelTicker>& x,
              const QSharedPointer<PanelTicker>& y) {
    panel.setLayer(QStringLiteral("background"));  // below the grid
    for (const auto type : {QCPAxis::atLeft, QCPAxis::atBottom, QCPAxis::atRight, QCPAxis::atTop}) {
        QCPAxis* side = panel.addAxis(type);
        side->setLayer(QStringLiteral("axes"));
        side->grid()->setLayer(QStringLiteral("grid"));
        side->setSubTicks(false);
        side->setTickLengthIn(0);
        const bool scale = type == QCPAxis::atLeft || type == QCPAxis::atBottom;
        side->grid()->setVisible(scale);
        side->setTicks(scale);
        side->setTickLabels(scale);
    }
    panel.axis(QCPAxis::atBottom)->setTicker(x);
    panel.axis(QCPAxis::atLeft)->setTicker(y);
    panel.axis(QCPAxis::atBottom)->setTickLength(0, 4);
    panel.axis(QCPAxis::atLeft)->setTickLength(0, 4);
}

void setFrameLook(QCPAxisRect& panel, const Theme& theme, const QFont& tick_font) {
    panel.setBackground(QBrush(theme.panelBackground));
    for (QCPAxis* side : panel.axes()) {
        side->setBasePen(QPen(theme.axis, 1));
        side->setTickPen(QPen(theme.axis, 1));
        side->setTickLabelColor(theme.text);
        side->setTickLabelFont(tick_font);
        side->grid()->setPen(QPen(theme.grid, 1));
        side->grid()->setZeroLinePen(QPen(theme.zeroLine, 1));
    }
}

QFont tickFont(const QFont& font) {
    QFont smaller = font;
    smaller.setPixelSize(std::max(9, font.pixelSize() - 1));
    return smaller;
}

}  // namespace vybeg::ui
