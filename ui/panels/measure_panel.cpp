#include "ui/panels/measure_panel.h"

#include "ui/panels/reading.h"
#include "ui/words/rich_text.h"

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QTableWidget>
#include <QVBoxLayout>

#include <array>
#include <cmath>
#include <numbers>

namespace vybeg::ui {

namespace {

enum Column { symbol, at_a, at_b, difference, rate, column_count };

constexpr int shown_count = static_cast<int>(shown_slow_variables.size());
constexpr int curve_points = 50;

// theta_A in degrees an hour, of 2theta_A in rad/s.
constexpr double degrees_an_hour = 0.5 * 180 / std::numbers::pi * 3600;

SlowVariable variableOf(int line) {
    return shown_slow_variables[static_cast<std::size_t>(line)];
}

QString secondsText(double seconds) {
    return QLocale().toString(seconds, 'f', 5);
}

}  // namespace

MeasurePanel::MeasurePanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      times_(new QLabel(this)),
      table_(new QTableWidget(shown_count, column_count, this)),
      sentences_(new QLabel(this)) {
    for (QLabel* label : {times_, sentences_}) {
        label->setContentsMargins(6, 2, 6, 2);
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    table_->setItemDelegate(new IndexDelegate(table_));
    table_->verticalHeader()->hide();
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionMode(QAbstractItemView::ContiguousSelection);
    table_->setWordWrap(true);
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(times_);
    layout->addWidget(table_, 1);
    layout->addWidget(sentences_);
    connect(&document_, &Document::runsChanged, this, &MeasurePanel::refresh);
    refresh();
}

void MeasurePanel::setRun(int id) {
    run_ = id;
    refresh();
}

void MeasurePanel::setCursors(std::optional<double> a_s, std::optional<double> b_s) {
    a_s_ = a_s;
    b_s_ = b_s;
    refresh();
}

void MeasurePanel::setUnits(const DisplayUnits& units) {
    units_ = units;
    refresh();
}

const Analysis* MeasurePanel::analysis() const {
    const RunEntry* entry = document_.run(run_);
    const bool usable = entry && entry->run.visible && entry->run.analysis->track.rows() > 0;
    return usable ? entry->run.analysis.get() : nullptr;
}

void MeasurePanel::refresh() {
    const Analysis* shown = analysis();
    const bool any = shown && (a_s_ || b_s_);
    setVisible(any);
    if (!any) {
        emit trendsChanged({});
        return;
    }
    QStringList times{document_.run(run_)->run.name};
    if (a_s_) {
        times << tr("A = %1 s").arg(secondsText(*a_s_));
    }
    if (b_s_) {
        times << tr("B = %1 s").arg(secondsText(*b_s_));
    }
    if (a_s_ && b_s_ && *a_s_ != *b_s_) {
        const double span = *b_s_ - *a_s_;
        times << tr("B − A = %1 s").arg(secondsText(span).replace(QLatin1Char('-'), QChar(0x2212)))
              << tr("1/|B − A| = %1 Hz").arg(QLocale().toString(1 / std::abs(span), 'g', 6));
    }
    times_->setText(times.join(QStringLiteral(", ")));
    showTable(*shown);
    showSentences(*shown);
    emit trendsChanged(a_s_ && b_s_ ? curves(*shown) : std::vector<TrendCurve>());
}

void MeasurePanel::showTable(const Analysis& analysis) {
    table_->setAccessibleName(tr("Readings at the cursors"));
    table_->setHorizontalHeaderLabels(
        {QString(), tr("A"), tr("B"), tr("B − A"), tr("Rate, per s")});
    const bool both = a_s_ && b_s_;
    table_->setColumnHidden(at_a, !a_s_);
    table_->setColumnHidden(at_b, !b_s_);
    table_->setColumnHidden(difference, !both);
    table_->setColumnHidden(rate, !both);
    const std::size_t row_a = nearestRow(analysis.track, a_s_.value_or(0));
    const std::size_t row_b = nearestRow(analysis.track, b_s_.value_or(0));
    for (int line = 0; line < shown_count; ++line) {
        const SlowVariable variable = variableOf(line);
        const QString unit = displayUnit(variable, units_);
        const QString name = displaySymbol(variable, units_);
        table_->setItem(
            line, symbol,
            new QTableWidgetItem(unit.isEmpty() ? name : QStringLiteral("%1, %2").arg(name, unit)));
        const auto set = [&](Column column, const Reading& reading) {
            auto* item = new QTableWidgetItem(
                valueText(reading.value, reading.sd)
                    .replace(QStringLiteral(" ± "), QStringLiteral("\n± ")));  // narrower
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            table_->setItem(line, column, item);
        };
        set(at_a, readingAt(analysis, variable, row_a, units_));
        set(at_b, readingAt(analysis, variable, row_b, units_));
        if (both) {
            set(difference, differenceOf(analysis, variable, row_a, row_b, units_));
            const auto trend = trendOf(analysis, variable, *a_s_, *b_s_);
            set(rate, trend ? rateOf(analysis, variable, *trend, units_) : Reading());
        }
    }
}

void MeasurePanel::showSentences(const Analysis& analysis) {
    QStringList lines;
    if (!a_s_ || !b_s_) {
        lines << tr("Keys 1 and 2 place the cursors A and B; between them the trend is measured.");
    } else {
        const auto amplitude = trendOf(analysis, SlowVariable::a_A, *a_s_, *b_s_);
        if (const auto decay = amplitude ? decay_time(*amplitude) : std::nullopt) {
            lines << tr("Decay time of a_A: %1 s").arg(valueText(decay->tau_s, decay->sd_s));
        } else if (amplitude) {
            lines << tr("The decay of a_A lies within its noise here.");
        }
        if (const auto angle = trendOf(analysis, SlowVariable::two_theta_A, *a_s_, *b_s_)) {
            lines << tr("θ_A drifts by %1 °/h")
                         .arg(valueText(angle->slope_per_s * degrees_an_hour,
                                        angle->sd_slope_per_s * degrees_an_hour));
        }
        if (const auto f = trendOf(analysis, SlowVariable::f, *a_s_, *b_s_)) {
            lines << tr("f drifts by %1 Hz/s").arg(valueText(f->slope_per_s, f->sd_slope_per_s))
                  << tr("%n window(s) without common samples", nullptr,
                        static_cast<int>(f->windows));
        } else {
            lines << tr("Fewer than three windows lie between the cursors.");
        }
    }
    for (QString& line : lines) {
        line = richText(line);
    }
    sentences_->setText(lines.join(QStringLiteral("<br>")));
}

std::vector<TrendCurve> MeasurePanel::curves(const Analysis& analysis) const {
    std::vector<TrendCurve> drawn;
    for (const SlowVariable variable : shown_slow_variables) {
        const auto trend = trendOf(analysis, variable, *a_s_, *b_s_);
        if (!trend) {
            continue;
        }
        const DisplayScale scale = displayScale(variable, units_, analysis.f0_hz());
        TrendCurve curve{variable, {}, {}};
        for (int k = 0; k <= curve_points; ++k) {
            const double time_s =
                std::min(*a_s_, *b_s_) + std::abs(*b_s_ - *a_s_) * k / curve_points;
            curve.time_s.push_back(time_s);
            curve.value.push_back(scale.value(trendValue(variable, *trend, time_s)));
        }
        drawn.push_back(std::move(curve));
    }
    return drawn;
}

QString MeasurePanel::tableText() const {
    const Analysis* shown = analysis();
    if (!shown || !a_s_ || !b_s_) {
        return {};
    }
    const std::size_t row_a = nearestRow(shown->track, *a_s_);
    const std::size_t row_b = nearestRow(shown->track, *b_s_);
    QStringList lines{QStringList{times_->text(), tr("A"), tr("sd"), tr("B"), tr("sd"), tr("B − A"),
                                  tr("sd"), tr("Rate, per s"), tr("sd")}
                          .join(QLatin1Char('\t'))};
    for (const SlowVariable variable : shown_slow_variables) {
        const QString unit = displayUnit(variable, units_);
        const QString name = displaySymbol(variable, units_);
        QStringList cells{unit.isEmpty() ? name : QStringLiteral("%1, %2").arg(name, unit)};
        const auto trend = trendOf(*shown, variable, *a_s_, *b_s_);
        for (const Reading& reading :
             {readingAt(*shown, variable, row_a, units_),
              readingAt(*shown, variable, row_b, units_),
              differenceOf(*shown, variable, row_a, row_b, units_),
              trend ? rateOf(*shown, variable, *trend, units_) : Reading()}) {
            cells << spreadsheetNumber(reading.value) << spreadsheetNumber(reading.sd);
        }
        lines << cells.join(QLatin1Char('\t'));
    }
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

void MeasurePanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refresh();
    }
}

}  // namespace vybeg::ui
