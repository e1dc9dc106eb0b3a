#include "ui/plots/plot_strip.h"

#include "ui/words/rich_text.h"
#include "ui/words/short_names.h"

#include <QStringList>

#include <algorithm>

namespace vybeg::ui {
namespace {

constexpr double legend_sample_length = 24;
constexpr double legend_sample_gap = 6;
constexpr double entry_gap = 18;
constexpr double least_name = 48;

double widthOf(const StripEntry& entry, const QFont& font) {
    const double text = entry.literal ? QFontMetricsF(font).horizontalAdvance(entry.text)
                                      : indexTextWidth(entry.text, font);
    return text + (entry.line ? legend_sample_length + legend_sample_gap : 0);
}

// Of all of them in a row.
double widthOf(const std::vector<StripEntry>& entries, const QFont& font) {
    double total = -entry_gap;
    for (const StripEntry& entry : entries) {
        total += widthOf(entry, font) + entry_gap;
    }
    return total;
}

// Literal texts by what differs between them, so that it stays legible longest.
std::vector<StripEntry> withDistinctNames(std::vector<StripEntry> entries, bool beginning) {
    QStringList names;
    for (const StripEntry& entry : entries) {
        if (entry.literal) {
            names << entry.text;
        }
    }
    names = distinctNames(names, beginning);
    for (StripEntry& entry : entries) {
        if (entry.literal) {
            entry.text = names.takeFirst();
        }
    }
    return entries;
}

// Draws a sample of a curve as a legend shows it.
void drawSample(QCPPainter& painter, QPointF from, const StripEntry& entry) {
    painter.setAntialiasing(true);
    if (!entry.points.isNone()) {
        entry.points.applyTo(&painter, QPen(entry.color));
        entry.points.drawShape(&painter, from + QPointF(legend_sample_length / 2, 0));
        return;
    }
    painter.setPen(QPen(entry.color, 2, entry.dash, Qt::FlatCap));
    painter.drawLine(QLineF(from, from + QPointF(legend_sample_length, 0)));
}

}  // namespace

PlotStrip::PlotStrip(QCustomPlot* plot, int height) : QCPLayoutElement(plot), full_height_(height) {
    setHeight(height);
}

void PlotStrip::setHeight(int height) {
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

std::vector<std::vector<StripEntry>> PlotStrip::rows(const std::vector<StripEntry>& entries,
                                                     const QFont& font, double available) {
    std::vector<std::vector<StripEntry>> rows;
    double taken = available;
    for (const StripEntry& entry : entries) {
        const double wanted = entry_gap + widthOf(entry, font);
        if (rows.empty() || taken + wanted > available) {
            rows.emplace_back();
            taken = -entry_gap;
        }
        rows.back().push_back(entry);
        taken += wanted;
    }
    return rows;
}

void PlotStrip::shorten(double available) {
    if (widthOf(entries_, font_) <= available) {
        shown_ = entries_;
        return;
    }
    shown_ = withDistinctNames(entries_, false);
    if (widthOf(shown_, font_) <= available) {
        return;
    }
    const QFontMetricsF metrics(font_);
    const std::vector<StripEntry> distinct = withDistinctNames(entries_, true);
    const auto limited = [&metrics](StripEntry entry, double most) {
        if (entry.literal) {
            entry.text = metrics.elidedText(entry.text, Qt::ElideMiddle, most);
        }
        return entry;
    };
    // All names get the same limit of length until they fit.
    for (double most = available; most > least_name; most *= 0.9) {
        shown_.clear();
        for (const StripEntry& entry : distinct) {
            shown_.push_back(limited(entry, most));
        }
        if (widthOf(shown_, font_) <= available) {
            return;
        }
    }
    // Too many for distinct names: as many as fit.
    shown_.clear();
    double total = metrics.horizontalAdvance(QStringLiteral("…"));
    for (const StripEntry& entry : distinct) {
        StripEntry shorter = limited(entry, least_name);
        total += widthOf(shorter, font_) + entry_gap;
        if (total > available) {
            shown_.push_back({QStringLiteral("…"), true});
            return;
        }
        shown_.push_back(std::move(shorter));
    }
}

void PlotStrip::draw(QCPPainter* painter) {
    const QRect area = rect().adjusted(left_, above_, -right_, 0);
    shorten(area.width());
    double x = area.left();
    if (alignment_ != Qt::AlignLeft) {
        x += (alignment_ == Qt::AlignRight ? 1 : 0.5) *
             std::max(0., area.width() - widthOf(shown_, font_));
    }
    const QFontMetricsF metrics(font_);
    const double base = area.top() + 0.5 * (area.height() + metrics.ascent() - metrics.descent());
    for (const StripEntry& entry : shown_) {
        if (entry.line) {
            drawSample(*painter, {x, base - 0.33 * metrics.ascent()}, entry);
            x += legend_sample_length + legend_sample_gap;
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

#include "moc_plot_strip.cpp"
