#include "ui/plot_strip.h"

#include "ui/crisp_graph.h"
#include "ui/index_text.h"

namespace vybeg::ui {
namespace {

constexpr double sample_length = 24;
constexpr double sample_gap = 6;
constexpr double entry_gap = 18;

}  // namespace

void drawSample(QCPPainter& painter, QPointF from, double length, const QColor& color,
                Qt::PenStyle dash) {
    QPen pen(color, 2, Qt::SolidLine, Qt::FlatCap);
    if (const QVector<double> pattern = dashPattern(dash); !pattern.isEmpty()) {
        // Half the curve's own lengths, so that a whole period fits; in units of the pen's width.
        QVector<double> shorter;
        for (const double part : pattern) {
            shorter.append(0.5 * part / pen.widthF());
        }
        pen.setDashPattern(shorter);
    }
    painter.setAntialiasing(true);
    painter.setPen(pen);
    painter.drawLine(QLineF(from, from + QPointF(length, 0)));
}

PlotStrip::PlotStrip(QCustomPlot* plot, int height) : QCPLayoutElement(plot) {
    setMinimumSize(10, height);
    setMaximumSize(QWIDGETSIZE_MAX, height);
}

void PlotStrip::setEntries(std::vector<StripEntry> entries, Qt::Alignment alignment) {
    entries_ = std::move(entries);
    alignment_ = alignment;
}

void PlotStrip::setLook(const QFont& font, const QColor& text) {
    font_ = font;
    text_ = text;
}

void PlotStrip::setInset(int left, int right, int above) {
    left_ = left;
    right_ = right;
    above_ = above;
}

double PlotStrip::width(const StripEntry& entry) const {
    const double text = entry.literal ? QFontMetricsF(font_).horizontalAdvance(entry.text)
                                      : indexTextWidth(entry.text, font_);
    return text + (entry.line ? sample_length + sample_gap : 0);
}

void PlotStrip::draw(QCPPainter* painter) {
    const QRect area = rect().adjusted(left_, above_, -right_, 0);
    double total = -entry_gap;
    for (const StripEntry& entry : entries_) {
        total += width(entry) + entry_gap;
    }
    double x = area.left();
    if (total < area.width() && alignment_ == Qt::AlignHCenter) {
        x += 0.5 * (area.width() - total);
    } else if (total < area.width() && alignment_ == Qt::AlignRight) {
        x += area.width() - total;
    }
    const QFontMetricsF metrics(font_);
    const double base = area.top() + 0.5 * (area.height() + metrics.ascent() - metrics.descent());
    const double ellipsis = metrics.horizontalAdvance(QStringLiteral("…"));
    for (const StripEntry& entry : entries_) {
        const bool last = &entry == &entries_.back();
        if (x + width(entry) + (last ? 0 : entry_gap + ellipsis) > area.right() + 1 &&
            entries_.size() > 1) {
            painter->setPen(text_);
            painter->setFont(font_);
            painter->drawText(QPointF(x, base), QStringLiteral("…"));
            return;
        }
        if (entry.line) {
            drawSample(*painter, {x, base - 0.33 * metrics.ascent()}, sample_length, entry.color,
                       entry.dash);
            x += sample_length + sample_gap;
        }
        painter->setPen(text_);
        if (entry.literal) {
            painter->setFont(font_);
            painter->drawText(QPointF(x, base), entry.text);
            x += metrics.horizontalAdvance(entry.text) + entry_gap;
        } else {
            x += drawIndexText(*painter, {x, base}, entry.text, font_) + entry_gap;
        }
    }
}

}  // namespace vybeg::ui
