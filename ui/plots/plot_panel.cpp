#include "ui/plots/plot_panel.h"

#include "ui/plots/decimated_graph.h"
#include "ui/plots/value_range.h"
#include "ui/words/index_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <limits>

namespace vybeg::ui {
namespace {

constexpr double unit_gap = 8;
constexpr double least_mark_spacing = 4;

}  // namespace

PlotPanel::PlotPanel(QCustomPlot* plot, SlowVariable variable, PlotHead head)
    : QCPAxisRect(plot, false),
      variable_(variable),
      head_(head),
      time_ticker_(new PanelTicker(Qt::Horizontal)),
      value_ticker_(new PanelTicker(Qt::Vertical)) {
    addStackedFrame(
        *this, time_ticker_, value_ticker_, head,
        [this](const AxisTicks& ticks) { return marginTexts(ticks); }, font_);
}

void PlotPanel::setContent(const PlotContent& content, const QFont& font) {
    units_ = content.units;
    theme_ = content.theme;
    marks_s_ = content.marks_s;
    font_ = font;
    tick_font_ = tickFont(font);
    removeGraphs();
    const DisplayScale scale =
        displayScale(variable_, units_, referenceFrequency(content.analyses));
    for (const ShownAnalysis& shown : content.analyses) {
        if (!shown.visible || !shown.analysis || shown.analysis->track.rows() == 0) {
            continue;
        }
        const auto made = std::ranges::find(shown.curves, variable_,
                                            [](const auto& curve) { return curve->variable(); });
        auto* graph = new DecimatedGraph(
            timeAxis(), valueAxis(),
            made == shown.curves.end() ? std::make_shared<CurveData>(shown.analysis, variable_)
                                       : *made);
        graph->setScale(scale);
        graph->setBand(units_.sigma_bands && info(variable_).has_sd);
        graph->setPointers(static_cast<double>(graphs_.size()) /
                           static_cast<double>(content.analyses.size()));
        graph->setLook(readable(shown.color, theme_, shown.shade), theme_.warning);
        graph->setTogether(graphs_);
        graphs_.push_back(graph);
    }
    const auto found = std::ranges::find(content.trends, variable_, &TrendCurve::variable);
    if (found != content.trends.end()) {
        trend_ = mParentPlot->addGraph(timeAxis(), valueAxis());
        const TrendCurve& curve = *found;
        trend_->setData(QVector<double>(curve.time_s.begin(), curve.time_s.end()),
                        QVector<double>(curve.value.begin(), curve.value.end()), true);
        trend_->setPen(QPen(theme_.text, 1.6, Qt::DashLine));
        trend_->setSelectable(QCP::stNone);
    }
    const bool degrees =
        info(variable_).quantity == Quantity::angle && units_.angle == AngleUnit::degrees;
    value_ticker_->setSteps(degrees ? TickSteps::degrees : TickSteps::decimal);
    value_ticker_->setLogarithmic(scale.logarithmic);
    valueAxis()->setScaleType(scale.logarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
    // Without values no scale is shown.
    const bool any = std::any_of(graphs_.begin(), graphs_.end(), [](const DecimatedGraph* graph) {
        return !graph->data().empty();
    });
    valueAxis()->setTickLabels(any);
    valueAxis()->setTicks(any);
    setLook(theme_);
}

void PlotPanel::removeGraphs() {
    for (DecimatedGraph* graph : graphs_) {
        mParentPlot->removePlottable(graph);
    }
    graphs_.clear();
    if (trend_) {
        mParentPlot->removeGraph(trend_);
    }
}

void PlotPanel::setLook(const Theme& theme) {
    setFrameLook(*this, theme, tick_font_);
    timeAxis()->grid()->setZeroLinePen(Qt::NoPen);
}

void PlotPanel::setTimeLabels(bool shown) {
    timeAxis()->setTickLabels(shown);
}

void PlotPanel::setTime(const AxisRange& time) {
    timeAxis()->setRange(time.lower, time.upper);
}

void PlotPanel::setValues(const AxisRange& values) {
    valueAxis()->setRange(values.lower, values.upper);
}

AxisRange PlotPanel::time() const {
    return {timeAxis()->range().lower, timeAxis()->range().upper};
}

AxisRange PlotPanel::values() const {
    return {valueAxis()->range().lower, valueAxis()->range().upper};
}

AxisRange PlotPanel::automaticValues() const {
    ValueRange range;
    bool logarithmic = false;
    for (const DecimatedGraph* graph : graphs_) {
        logarithmic = graph->scale().logarithmic;
        range.add(graph->columns(time(), expected_.width()), graph->scale(),
                  units_.sigma_bands && info(variable_).has_sd);
    }
    return range.range(logarithmic).value_or(logarithmic ? AxisRange{0.1, 1} : AxisRange{0, 1});
}

QString PlotPanel::offsetText(const AxisTicks& ticks) const {
    if (ticks.offset == 0) {
        return {};
    }
    const QString unit = displayUnit(variable_, units_);
    return ticks.offsetText() + (unit.isEmpty() || unit == QStringLiteral("°") ? unit : ' ' + unit);
}

QString PlotPanel::headSymbol() const {
    return displaySymbol(variable_, units_) + offsetText(value_ticker_->ticks());
}

QString PlotPanel::headUnit() const {
    return scaledUnit(displayUnit(variable_, units_), takesPrefix(variable_, units_),
                      value_ticker_->ticks().exponent);
}

void PlotPanel::update(UpdatePhase phase) {
    if (phase == upPreparation) {
        value_ticker_->setRoom(expected_.height(), tick_font_);
        time_ticker_->setRoom(expected_.width(), tick_font_, room().right - 2);
    }
    QCPAxisRect::update(phase);
}

QString PlotPanel::emptyReason() const {
    const bool has_analyses = !graphs_.empty();
    const bool nothing =
        std::all_of(graphs_.begin(), graphs_.end(),
                    [](const DecimatedGraph* graph) { return graph->data().empty(); });
    if (!has_analyses || !nothing) {
        return {};
    }
    const bool by_design =
        std::all_of(graphs_.begin(), graphs_.end(), [](const DecimatedGraph* graph) {
            const auto flags = graph->data().analysis().track.flags();
            return std::all_of(flags.begin(), flags.end(),
                               [](Flags f) { return has(f, Flag::no_quadrature); });
        });
    return by_design && variable_ == SlowVariable::a_B
               ? QCoreApplication::translate("PlotPanel", "not estimated by this algorithm")
               : QCoreApplication::translate("PlotPanel", "no window has a value");
}

void PlotPanel::draw(QCPPainter* painter) {
    QCPAxisRect::draw(painter);
    drawMarks(*painter);
    if (head_ == PlotHead::line) {
        drawHead(*painter);
    } else {
        drawMarginLines(*painter, *this, marginTexts(value_ticker_->ticks()), theme_, font_);
    }
    if (const QString reason = emptyReason(); !reason.isEmpty()) {
        painter->setPen(theme_.mutedText);
        painter->setFont(font_);
        painter->drawText(QRectF(rect()), int(Qt::AlignCenter), reason);
    }
}

void PlotPanel::drawMarks(QCPPainter& painter) const {
    painter.setAntialiasing(false);
    painter.setPen(QPen(theme_.mutedText, 1, Qt::DotLine));
    double last = -std::numeric_limits<double>::infinity();
    for (auto mark = std::ranges::lower_bound(marks_s_, time().lower);
         mark != marks_s_.end() && *mark <= time().upper; ++mark) {
        const double x = timeAxis()->coordToPixel(*mark);
        // Indistinguishable marks are drawn once.
        if (x - last >= least_mark_spacing) {
            painter.drawLine(QLineF(x, rect().top(), x, rect().bottom()));
            last = x;
        }
    }
}

void PlotPanel::drawHead(QCPPainter& painter) const {
    const double base = rect().top() - 7;
    painter.setPen(theme_.text);
    const double x =
        rect().left() + drawIndexText(painter, {double(rect().left()), base}, headSymbol(), font_);
    painter.setPen(theme_.mutedText);
    drawIndexText(painter, {x + unit_gap, base}, headUnit(), font_);
    if (!letter_.isEmpty()) {
        QFont italic(font_);
        italic.setItalic(true);
        painter.setFont(italic);
        painter.setPen(theme_.text);
        painter.drawText(
            QRectF(rect().left(), rect().top() - room().head, rect().width(), room().head - 3),
            int(Qt::AlignRight | Qt::AlignVCenter), letter_);
    }
}

std::vector<MarginLine> PlotPanel::marginTexts(const AxisTicks& ticks) const {
    return marginLines(
        displaySymbol(variable_, units_), offsetText(ticks),
        scaledUnit(displayUnit(variable_, units_), takesPrefix(variable_, units_), ticks.exponent),
        font_);
}

int PlotPanel::calculateAutoMargin(QCP::MarginSide side) {
    const int margin = QCPAxisRect::calculateAutoMargin(side);
    return head_ == PlotHead::margin && side == QCP::msLeft
               ? std::max(margin, marginOf(marginTexts(value_ticker_->ticks())))
               : margin;
}

}  // namespace vybeg::ui
