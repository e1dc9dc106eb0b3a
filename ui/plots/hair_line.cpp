#include "ui/plots/hair_line.h"

#include "ui/plots/panel_ticker.h"
#include "ui/words/number_label.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace vybeg::ui {
namespace {

// The instant with the resolution of a pixel.
QString timeText(const QCPAxisRect& panel, double time_s) {
    const double pixel = panel.axis(QCPAxis::atBottom)->range().size() / std::max(1, panel.width());
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(pixel))), 0, 9);
    return numberLabel(time_s, decimals) + ' ' + QCoreApplication::translate("DisplayUnits", "s");
}

// Clears the labels of ticks that a label over them leaves in part: "2" of "20". Below what the
// layer holds already.
void clearTouched(QCPPainter& painter, const QCPAxis& axis, const QRectF& label,
                  const HairLook& look) {
    const auto ticker = axis.ticker().dynamicCast<PanelTicker>();
    if (!ticker) {
        return;
    }
    const QFontMetricsF metrics(axis.tickLabelFont());
    painter.setCompositionMode(QPainter::CompositionMode_DestinationOver);
    for (std::size_t k = 0; k < ticker->ticks().positions.size(); ++k) {
        const double width =
            metrics.horizontalAdvance(ticker->ticks().labels[static_cast<qsizetype>(k)]) + 2;
        const double left = axis.coordToPixel(ticker->ticks().positions[k]) - 0.5 * width;
        if (left < label.right() && left + width > label.left()) {
            painter.fillRect(QRectF(left, label.top(), width, label.height()), look.label_text);
        }
    }
    painter.setCompositionMode(QPainter::CompositionMode_SourceOver);
}

}  // namespace

void drawHair(QCPPainter& painter, const std::vector<QCPAxisRect*>& panels, double time_s,
              const HairLook& look) {
    if (panels.empty() || !panels.front()->axis(QCPAxis::atBottom)->range().contains(time_s)) {
        return;
    }
    const QRect top = panels.front()->rect();
    const QRect bottom = panels.back()->rect();
    const double x = std::round(panels.front()->axis(QCPAxis::atBottom)->coordToPixel(time_s));
    painter.setAntialiasing(false);
    painter.setPen(QPen(look.color, 1, look.name.isEmpty() ? Qt::DashLine : Qt::SolidLine));
    for (const QCPAxisRect* panel : panels) {
        painter.drawLine(QLineF(x, panel->rect().top(), x, panel->rect().bottom()));
    }
    // Time of the tracker, name of a cursor: instead of tick labels, not over curves.
    const QFontMetricsF metrics(look.font);
    const QString text = look.name.isEmpty() ? timeText(*panels.front(), time_s) : look.name;
    const double width = metrics.horizontalAdvance(text) + 10;
    const double left = std::clamp(x - 0.5 * width, double(top.left()),
                                   std::max(double(top.left()), top.right() - width));
    const double height = metrics.height() + 2;
    const QRectF label(left, bottom.bottom() + 4, width, height);
    clearTouched(painter, *panels.back()->axis(QCPAxis::atBottom), label, look);
    painter.setAntialiasing(true);
    painter.setPen(Qt::NoPen);
    painter.setBrush(look.color);
    painter.drawRoundedRect(label, 3, 3);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(look.label_text);
    painter.setFont(look.font);
    painter.drawText(label, int(Qt::AlignCenter), text);
}

std::optional<std::size_t> hairAt(const QCPAxisRect& panel,
                                  const std::array<std::optional<double>, 2>& times_s, double x) {
    constexpr double reach = 4;  // pixels
    // The second is drawn above the first.
    for (std::size_t k = times_s.size(); k-- > 0;) {
        if (times_s[k] &&
            std::abs(panel.axis(QCPAxis::atBottom)->coordToPixel(*times_s[k]) - x) <= reach) {
            return k;
        }
    }
    return std::nullopt;
}

}  // namespace vybeg::ui
