#include "ui/plots/plot_stack.h"

#include "ui/plots/plot_strip.h"
#include "ui/words/short_names.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>
#include <memory>
#include <utility>

namespace vybeg::ui {

void PlotStack::setContent(const PlotContent& content) {
    const bool same_panels =
        std::ranges::equal(panels_, content.variables, {}, &PlotPanel::variable);
    if (!same_panels || panels_.empty()) {
        for (PlotPanel* panel : panels_) {
            panel->removeGraphs();
        }
        panels_.clear();
        for (const SlowVariable variable : content.variables) {
            panels_.push_back(new PlotPanel(&plot(), variable, head()));
        }
        build({panels_.begin(), panels_.end()});
    }
    for (PlotPanel* panel : panels_) {
        panel->setContent(content, plotFont(plot()));
    }
    setLook(content.theme);
    if (!title_.isEmpty()) {
        showTitle();
    } else if (head() == PlotHead::line) {
        showNames(content);
    }
    setZoom(content.zoom);
}

void PlotStack::showTitle() {
    constexpr int beside = 44;
    const int right = TimePanel::room(head()).right();
    std::vector<StripEntry> entries{StripEntry{title_}};
    if (!name_.isEmpty()) {
        entries.insert(entries.begin(), {name_, true});
    }
    headStrip().setEntries(std::move(entries), Qt::AlignHCenter);
    headStrip().setInset(right + beside, right, 0);
}

void PlotStack::showNames(const PlotContent& content) {
    std::vector<StripEntry> entries;
    for (const ShownAnalysis& shown : content.analyses) {
        if (shown.visible && shown.analysis) {
            entries.push_back(
                {shown.name, true, true, readable(shown.color, content.theme, shown.shade)});
            if (!content.trends.empty() && content.trends.front().of == shown.id) {
                entries.push_back({QCoreApplication::translate("PlotStack", "and its trend"), false,
                                   true, content.theme.text, Qt::DashLine});
            }
        }
    }
    // A single curve needs no legend, nor does its trend.
    if (std::ranges::count(entries, true, &StripEntry::literal) <= 1) {
        entries.clear();
    }
    headStrip().setShown(!entries.empty());
    headStrip().setEntries(std::move(entries), Qt::AlignLeft);
}

void PlotStack::setMarks(const std::vector<double>& times_s) {
    for (PlotPanel* panel : panels_) {
        panel->setMarks(times_s);
    }
}

void PlotStack::setZoom(const ZoomState& zoom) {
    for (PlotPanel* panel : panels_) {
        panel->setTime(zoom.time);
        const auto fixed = zoom.fixed.find(panel->variable());
        panel->setValues(fixed == zoom.fixed.end() ? panel->automaticValues() : fixed->second);
    }
}

PlotPanel* PlotStack::panel(SlowVariable variable) const {
    const auto found = std::ranges::find(panels_, variable, &PlotPanel::variable);
    return found == panels_.end() ? nullptr : *found;
}

PlotPanel* PlotStack::panelAt(const QPointF& position) const {
    return static_cast<PlotPanel*>(frameAt(position));  // its frames are its panels
}

namespace {

using FigureColumns = std::vector<FigureColumn>;
using Stacks = std::vector<std::unique_ptr<PlotStack>>;

// One time axis for all columns.
AxisRange commonTime(const FigureColumns& columns) {
    std::vector<ShownAnalysis> analyses;
    for (const FigureColumn& column : columns) {
        analyses.push_back(column.shown);
    }
    return coveredTime(analyses).value_or(AxisRange{0, 1});
}

// The value axes that show every column of a row.
std::map<SlowVariable, AxisRange> commonValues(const Stacks& stacks,
                                               const std::vector<SlowVariable>& variables) {
    std::map<SlowVariable, AxisRange> common;
    for (const SlowVariable variable : variables) {
        for (const auto& stack : stacks) {
            const AxisRange own = stack->panel(variable)->automaticValues();
            const auto [known, first] = common.emplace(variable, own);
            if (!first) {
                known->second = {std::min(known->second.lower, own.lower),
                                 std::max(known->second.upper, own.upper)};
            }
        }
    }
    // A curve without a range of its own may lie at an end of the common one.
    constexpr double small = 0.5;
    constexpr double spare = 0.05;
    for (auto& each : common) {
        const SlowVariable variable = each.first;
        AxisRange& range = each.second;
        const double span = range.span();
        const bool at_an_end = std::ranges::any_of(stacks, [&](const auto& stack) {
            const AxisRange own = stack->panel(variable)->automaticValues();
            return own.span() < small * span &&
                   std::min(own.lower - range.lower, range.upper - own.upper) < spare * span;
        });
        if (at_an_end) {
            range = {range.lower - spare * span, range.upper + spare * span};
        }
    }
    return common;
}

// What differs between the names of the columns' recordings; empty for one recording.
QStringList namesOf(const FigureColumns& columns) {
    QStringList names;
    for (const FigureColumn& column : columns) {
        names << QFileInfo(column.shown.recording).completeBaseName();
    }
    return names.count(names.value(0)) == names.size() ? QStringList(names.size())
                                                       : distinctNames(names);
}

void setLetters(const Stacks& stacks, std::size_t rows) {
    int letter = 0;
    for (std::size_t row = 0; row < rows; ++row) {
        for (const auto& stack : stacks) {
            // "aa" would follow z; figures of this program have fewer plots.
            QString text(QChar('a' + letter % 26));
            stack->panels()[row]->setLetter(text.repeated(1 + letter / 26));
            ++letter;
        }
    }
}

void drawFigure(const FigureColumns& columns, const std::vector<SlowVariable>& variables,
                const DisplayUnits& units, QCPPainter& painter, QSize size) {
    const QSize column_size(size.width() / std::max(1, static_cast<int>(columns.size())),
                            size.height());
    QCustomPlot plot;
    preparePlot(plot, lightTheme());
    Stacks stacks;
    ZoomState zoom{commonTime(columns), {}};
    const QStringList names = namesOf(columns);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        stacks.push_back(std::make_unique<PlotStack>(plot, static_cast<int>(i), PlotHead::line));
        stacks.back()->setTitle(columns[i].title, names[static_cast<qsizetype>(i)]);
        PlotContent content;
        content.analyses = {columns[i].shown};
        // A column has one analysis, so no legend is needed.
        content.analyses.front().visible = true;
        content.analyses.front().color = curveStyle(0).color;
        content.analyses.front().shade = 0;
        content.variables = variables;
        content.units = units;
        content.zoom = zoom;
        stacks.back()->setContent(content);
        stacks.back()->prepare(column_size);
    }
    zoom.fixed = commonValues(stacks, variables);
    for (const auto& stack : stacks) {
        stack->setZoom(zoom);
    }
    setLetters(stacks, variables.size());
    plot.toPainter(&painter, size.width(), size.height());
}

// Of rows of plots with the strips above and below.
int heightOf(std::size_t rows) {
    return 66 + 150 * static_cast<int>(rows);
}

}  // namespace

Figure articleFigure(const std::vector<FigureColumn>& columns,
                     const std::vector<SlowVariable>& variables, const DisplayUnits& units) {
    return {[=](QCPPainter& painter, QSize size) {
                drawFigure(columns, variables, units, painter, size);
            },
            {420 * std::max(1, static_cast<int>(columns.size())), heightOf(variables.size())},
            QStringLiteral("figure")};
}

Figure plotsFigure(const PlotContent& content) {
    constexpr int width = 900;
    PlotContent paper = content;
    paper.theme = lightTheme();
    return {[paper](QCPPainter& painter, QSize size) {
                QCustomPlot plot;
                preparePlot(plot, paper.theme);
                PlotStack stack(plot, 0, PlotHead::line);
                // Twice, because the room for the names is known after the first layout.
                stack.setContent(paper);
                stack.prepare(size);
                stack.setZoom(paper.zoom);
                plot.toPainter(&painter, size.width(), size.height());
            },
            {width, heightOf(content.variables.size())},
            QStringLiteral("vybeg")};
}

}  // namespace vybeg::ui
