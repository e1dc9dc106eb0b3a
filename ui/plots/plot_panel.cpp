#include "ui/plots/plot_panel.h"

#include "ui/plots/decimated_graph.h"
#include "ui/values/curve_data.h"

#include <QCoreApplication>

#include <algorithm>
#include <limits>

namespace vybeg::ui {
namespace {

constexpr double least_mark_spacing = 4;

}  // namespace

PlotPanel::PlotPanel(QCustomPlot* plot, SlowVariable variable, PlotHead head)
    : TimePanel(plot, head), variable_(variable) {}

void PlotPanel::setContent(const PlotContent& content, const QFont& font) {
    units_ = content.units;
    marks_s_ = content.marks_s;
    setLook(content.theme, font);
    removeGraphs();
    const DisplayScale scale =
        displayScale(variable_, units_, referenceFrequency(content.analyses));
    for (const ShownAnalysis& shown : content.analyses) {
        if (!shown.visible || !shown.analysis || shown.analysis->track.rows() == 0) {
            continue;
        }
        auto* graph = new DecimatedGraph(timeAxis(), valueAxis(), shown.curve(variable_));
        graph->setScale(scale);
        graph->setBand(units_.sigma_bands && info(variable_).has_sd);
        graph->setPointers(static_cast<double>(graphs_.size()) /
                           static_cast<double>(content.analyses.size()));
        graph->setLook(readable(shown.color, theme(), shown.shade), theme().warning);
        graph->setTogether(graphs_);
        graphs_.push_back(graph);
    }
    const auto found = std::ranges::find(content.trends, variable_, &TrendCurve::variable);
    if (found != content.trends.end()) {
        trend_ = mParentPlot->addGraph(timeAxis(), valueAxis());
        const TrendCurve& curve = *found;
        trend_->setData(QVector<double>(curve.time_s.begin(), curve.time_s.end()),
                        QVector<double>(curve.value.begin(), curve.value.end()), true);
        trend_->setPen(QPen(theme().text, 1.6, Qt::DashLine));
        trend_->setSelectable(QCP::stNone);
    }
    const bool degrees =
        info(variable_).quantity == Quantity::angle && units_.angle == AngleUnit::degrees;
    valueTicker().setSteps(degrees ? TickSteps::degrees : TickSteps::decimal);
    valueTicker().setLogarithmic(scale.logarithmic);
    valueAxis()->setScaleType(scale.logarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
    setScaleShown(std::ranges::any_of(
        graphs_, [](const DecimatedGraph* graph) { return !graph->data().empty(); }));
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

AxisRange PlotPanel::automaticValues() const {
    ValueRange range;
    bool logarithmic = false;
    for (const DecimatedGraph* graph : graphs_) {
        logarithmic = graph->scale().logarithmic;
        range.add(graph->columns(time(), expectedSize().width()), graph->scale(),
                  units_.sigma_bands && info(variable_).has_sd);
    }
    return range.range(logarithmic).value_or(logarithmic ? AxisRange{0.1, 1} : AxisRange{0, 1});
}

QString PlotPanel::offset(const AxisTicks& ticks) const {
    if (ticks.offset == 0) {
        return {};
    }
    const QString unit = displayUnit(variable_, units_);
    return ticks.offsetText() + (unit.isEmpty() || unit == QStringLiteral("°") ? unit : ' ' + unit);
}

QString PlotPanel::unit(const AxisTicks& ticks) const {
    return scaledUnit(displayUnit(variable_, units_), takesPrefix(variable_, units_),
                      ticks.exponent);
}

QString PlotPanel::emptyText() const {
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
    TimePanel::draw(painter);
    drawMarks(*painter);
}

void PlotPanel::drawMarks(QCPPainter& painter) const {
    painter.setAntialiasing(false);
    painter.setPen(QPen(theme().mutedText, 1, Qt::DotLine));
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

}  // namespace vybeg::ui
