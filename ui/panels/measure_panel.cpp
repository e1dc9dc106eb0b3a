#include "ui/panels/measure_panel.h"

#include "ui/widgets/number_field.h"
#include "ui/words/rich_text.h"

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QScrollArea>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vybeg::ui {

namespace {

enum Column { symbol, at_a, at_b, difference, trend, column_count };
enum Kind { line_kind, beat_kind };

constexpr int shown_count = static_cast<int>(main_slow_variables.size());
constexpr int curve_points = 200;
constexpr double turn = 2 * std::numbers::pi;

// theta_A in degrees an hour, of 2theta_A in rad/s.
constexpr double degrees_an_hour = 0.5 * 360 / turn * 3600;

std::size_t lineOf(SlowVariable variable) {
    return static_cast<std::size_t>(std::ranges::find(main_slow_variables, variable) -
                                    main_slow_variables.begin());
}

QString nameOf(SlowVariable variable, const DisplayUnits& units) {
    const QString unit = displayUnit(variable, units);
    const QString name = displaySymbol(variable, units);
    return unit.isEmpty() ? name : QStringLiteral("%1, %2").arg(name, unit);
}

}  // namespace

MeasurePanel::MeasurePanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      difference_(new QLabel(this)),
      kind_name_(new QLabel(this)),
      kind_(new QComboBox(this)),
      table_(new QTableWidget(shown_count, column_count, this)),
      sentences_(new QLabel(this)) {
    auto* grid = new QGridLayout;
    grid->setContentsMargins(6, 2, 6, 2);
    for (std::size_t which = 0; which < fields_.size(); ++which) {
        auto* field = new NumberField(this);
        field->setOptional(true);
        field->setDigits(9);
        field->setStep(0.1);
        names_[which] = new QLabel(this);
        names_[which]->setBuddy(field);
        fields_[which] = field;
        grid->addWidget(names_[which], 0, 2 * static_cast<int>(which));
        grid->addWidget(field, 0, 2 * static_cast<int>(which) + 1);
        connect(field, &NumberField::valueEdited, this,
                [this] { emit cursorsEdited(fields_[0]->value(), fields_[1]->value()); });
    }
    kind_name_->setBuddy(kind_);
    kind_->addItems({{}, {}});
    kind_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    grid->addWidget(kind_name_, 1, 0);
    grid->addWidget(kind_, 1, 1, 1, 3);
    connect(kind_, &QComboBox::activated, this, &MeasurePanel::refresh);
    for (QLabel* label : {difference_, sentences_}) {
        label->setContentsMargins(6, 2, 6, 2);
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    difference_->setAlignment(Qt::AlignTop);
    table_->setItemDelegate(new IndexDelegate(table_));
    table_->verticalHeader()->hide();
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionMode(QAbstractItemView::ContiguousSelection);
    table_->setWordWrap(true);
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table_->setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents);
    table_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    table_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(grid);
    // One scroll bar for all readings: the table is as high as its rows.
    auto* readings = new QWidget;
    auto* column = new QVBoxLayout(readings);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(difference_);
    column->addWidget(table_);
    column->addWidget(sentences_);
    column->addStretch(1);
    auto* scroll = new QScrollArea(this);
    scroll->setWidget(readings);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    layout->addWidget(scroll, 1);
    connect(&document_, &Document::runsChanged, this, &MeasurePanel::refresh);
    retranslate();
}

void MeasurePanel::setRun(int id) {
    if (id != run_) {
        run_ = id;
        refresh();
    }
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

bool MeasurePanel::showsBeats() const {
    return kind_->currentIndex() == beat_kind;
}

bool MeasurePanel::isInside(const std::optional<double>& time_s) const {
    if (!time_s) {
        return false;
    }
    const Run& run = document_.run(run_)->run;
    const auto times = run.analysis->track.time_s();
    const double window_s = static_cast<double>(run.analysis->plan.length) / run.rate_hz;
    return *time_s >= times.front() - window_s && *time_s <= times.back() + window_s;
}

void MeasurePanel::retranslate() {
    const std::array names{tr("A"), tr("B")};
    const std::array accessible{tr("Time of cursor A"), tr("Time of cursor B")};
    for (std::size_t which = 0; which < fields_.size(); ++which) {
        names_[which]->setText(names[which]);
        fields_[which]->setUnit(tr("s"));
        fields_[which]->setAccessibleName(accessible[which]);
        fields_[which]->setToolTip(
            tr("Seconds from the start of the recording; empty: no cursor. The keys 1 and 2 in the "
               "plots set the cursors at the mouse, 0 removes both."));
    }
    kind_name_->setText(tr("Trend"));
    kind_->setItemText(line_kind, tr("Line; exponential for the working wave"));
    kind_->setItemText(beat_kind, tr("Beat: damped sinusoid"));
    kind_->setAccessibleName(tr("Trend between the cursors"));
    kind_->setToolTip(
        tr("Fitted by weighted least squares to the windows between the cursors that share no "
           "samples. Where they scatter more than their noise, the deviations grow by that."));
    table_->setAccessibleName(tr("Readings at the cursors"));
    table_->setToolTip(
        tr("Values at A and B, their difference and the trend between them, with "
           "standard deviations"));
    refresh();
}

void MeasurePanel::refresh() {
    const Analysis* shown = analysis();
    setVisible(shown != nullptr);
    lines_ = {};
    beats_ = {};
    if (shown) {
        measure(*shown);
        showTimes();
        showTable(*shown);
        showSentences();
    }
    drawTrends(shown);
}

void MeasurePanel::measure(const Analysis& analysis) {
    if (!isInside(a_s_) || !isInside(b_s_)) {
        return;
    }
    for (std::size_t line = 0; line < main_slow_variables.size(); ++line) {
        const SlowVariable variable = main_slow_variables[line];
        lines_[line] = trendOf(analysis, variable, *a_s_, *b_s_);
        if (showsBeats()) {
            beats_[line] = beatOf(analysis, variable, *a_s_, *b_s_);
        }
    }
}

void MeasurePanel::showTimes() {
    fields_[0]->setValue(a_s_);
    fields_[1]->setValue(b_s_);
    const bool apart = a_s_ && b_s_ && *a_s_ != *b_s_;
    const bool outside = (a_s_ && !isInside(a_s_)) || (b_s_ && !isInside(b_s_));
    difference_->setText(
        outside ? tr("A cursor stands where the run has no windows.")
        : apart
            ? tr("B − A = %1 s, 1/|B − A| = %2 Hz")
                  .arg(QLocale().toString(*b_s_ - *a_s_, 'g', 8).replace('-', QChar(0x2212)),
                       QLocale().toString(1 / std::abs(*b_s_ - *a_s_), 'g', 6))
            : tr("The keys 1 and 2 in the plots set the cursors A and B at the mouse; the trend "
                 "between them is measured."));
}

Reading MeasurePanel::trendReading(const Analysis& analysis, std::size_t line) const {
    if (showsBeats()) {
        const auto& beat = beats_[line];
        return beat ? Reading{beat->frequency_hz, beat->sd_frequency_hz} : Reading();
    }
    return lines_[line] ? rateOf(analysis, main_slow_variables[line], *lines_[line], units_)
                        : Reading();
}

void MeasurePanel::showTable(const Analysis& analysis) {
    table_->setHorizontalHeaderLabels({QString(), tr("A"), tr("B"), tr("B − A"),
                                       showsBeats() ? tr("Beat, Hz") : tr("Rate, per s")});
    const bool both = a_s_ && b_s_;
    table_->setVisible(a_s_ || b_s_);
    table_->setColumnHidden(at_a, !a_s_);
    table_->setColumnHidden(at_b, !b_s_);
    table_->setColumnHidden(difference, !both);
    table_->setColumnHidden(trend, !both);
    const std::size_t row_a = nearestRow(analysis.track, a_s_.value_or(0));
    const std::size_t row_b = nearestRow(analysis.track, b_s_.value_or(0));
    for (int line = 0; line < shown_count; ++line) {
        const SlowVariable variable = main_slow_variables[static_cast<std::size_t>(line)];
        table_->setItem(line, symbol, new QTableWidgetItem(nameOf(variable, units_)));
        const auto set = [&](Column column, const Reading& reading) {
            auto* item = new QTableWidgetItem(
                valueText(reading.value, reading.sd)
                    .replace(QStringLiteral(" ± "), QStringLiteral("\n± ")));  // narrower
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            table_->setItem(line, column, item);
        };
        set(at_a, isInside(a_s_) ? readingAt(analysis, variable, row_a, units_) : Reading());
        set(at_b, isInside(b_s_) ? readingAt(analysis, variable, row_b, units_) : Reading());
        if (both && (!isInside(a_s_) || !isInside(b_s_))) {
            set(difference, {});
            set(trend, {});
        } else if (both) {
            set(difference, differenceOf(analysis, variable, row_a, row_b, units_));
            set(trend, trendReading(analysis, static_cast<std::size_t>(line)));
        }
    }
}

QStringList MeasurePanel::lineSentences() const {
    const auto& amplitude = lines_[lineOf(SlowVariable::a_A)];
    const auto& angle = lines_[lineOf(SlowVariable::two_theta_A)];
    const auto& f = lines_[lineOf(SlowVariable::f)];
    QStringList sentences;
    if (const auto decay = amplitude ? decay_time(*amplitude) : std::nullopt) {
        sentences << tr("Decay time of a_A: %1 s").arg(valueText(decay->tau_s, decay->sd_s));
    } else if (amplitude) {
        sentences << tr("The decay of a_A lies within its noise here.");
    }
    if (angle) {
        sentences << tr("Drift of θ_A: %1 °/h")
                         .arg(valueText(angle->slope_per_s * degrees_an_hour,
                                        angle->sd_slope_per_s * degrees_an_hour));
    }
    if (f) {
        sentences << tr("Drift of f: %1 Hz/s").arg(valueText(f->slope_per_s, f->sd_slope_per_s))
                  << tr("%n window(s) without common samples", nullptr,
                        static_cast<int>(f->windows));
    }
    QStringList leaving;
    for (std::size_t line = 0; line < lines_.size(); ++line) {
        if (lines_[line] && lines_[line]->enlargement > 1) {
            leaving << displaySymbol(main_slow_variables[line], units_);
        }
    }
    if (!leaving.isEmpty()) {
        sentences << tr("No line within the noise: %1. The deviations are enlarged.")
                         .arg(leaving.join(QStringLiteral(", ")));
    }
    return sentences.isEmpty() ? QStringList{tr("Fewer than three windows between the cursors.")}
                               : sentences;
}

QStringList MeasurePanel::beatSentences(const Analysis& analysis) const {
    QStringList sentences;
    for (std::size_t line = 0; line < main_slow_variables.size(); ++line) {
        if (const auto& beat = beats_[line]) {
            const SlowVariable variable = main_slow_variables[line];
            const Reading amplitude = amplitudeOf(analysis, variable, *beat, units_);
            const QString unit = displayUnit(variable, units_);
            sentences << tr("%1: amplitude %2 %3, damping %4 1/s")
                             .arg(displaySymbol(variable, units_),
                                  valueText(amplitude.value, amplitude.sd), unit,
                                  valueText(beat->damping_per_s, beat->sd_damping_per_s));
        }
    }
    return sentences.isEmpty()
               ? QStringList{tr("No beat of 1¼ to 100 periods between the cursors.")}
               : sentences;
}

void MeasurePanel::showSentences() {
    const bool both = isInside(a_s_) && isInside(b_s_);
    sentences_->setVisible(both);
    if (both) {
        QStringList sentences = showsBeats() ? beatSentences(*analysis()) : lineSentences();
        for (QString& sentence : sentences) {
            sentence = richText(sentence);
        }
        sentences_->setText(sentences.join(QStringLiteral("<br>")));
    }
}

void MeasurePanel::drawTrends(const Analysis* analysis) {
    std::vector<TrendCurve> curves;
    for (std::size_t line = 0; line < main_slow_variables.size(); ++line) {
        const auto& beat = beats_[line];
        if (showsBeats() ? !beat : !lines_[line]) {
            continue;
        }
        const SlowVariable variable = main_slow_variables[line];
        const DisplayScale scale = displayScale(variable, units_, analysis->f0_hz());
        const double span = std::abs(*b_s_ - *a_s_);
        const int points =
            beat ? std::max(curve_points, static_cast<int>(20 * beat->frequency_hz * span))
                 : curve_points;
        TrendCurve curve{variable, {}, {}};
        for (int k = 0; k <= points; ++k) {
            const double time_s = std::min(*a_s_, *b_s_) + span * k / points;
            curve.time_s.push_back(time_s);
            curve.value.push_back(
                scale.value(beat ? beat->at(time_s) : trendValue(variable, *lines_[line], time_s)));
        }
        curves.push_back(std::move(curve));
    }
    if (curves != drawn_) {
        drawn_ = std::move(curves);
        emit trendsChanged(drawn_);
    }
}

QString MeasurePanel::tableText() const {
    const Analysis* shown = analysis();
    if (!shown || !isInside(a_s_) || !isInside(b_s_)) {
        return {};
    }
    const std::size_t row_a = nearestRow(shown->track, *a_s_);
    const std::size_t row_b = nearestRow(shown->track, *b_s_);
    const QString sd = tr("sd");
    QStringList text{QStringList{document_.run(run_)->run.name,
                                 tr("A = %1 s").arg(spreadsheetNumber(*a_s_)), sd,
                                 tr("B = %1 s").arg(spreadsheetNumber(*b_s_)), sd, tr("B − A"), sd,
                                 showsBeats() ? tr("Beat, Hz") : tr("Rate, per s"), sd}
                         .join(QLatin1Char('\t'))};
    for (std::size_t line = 0; line < main_slow_variables.size(); ++line) {
        const SlowVariable variable = main_slow_variables[line];
        QStringList cells{nameOf(variable, units_)};
        for (const Reading& reading :
             {readingAt(*shown, variable, row_a, units_),
              readingAt(*shown, variable, row_b, units_),
              differenceOf(*shown, variable, row_a, row_b, units_), trendReading(*shown, line)}) {
            cells << spreadsheetNumber(reading.value) << spreadsheetNumber(reading.sd);
        }
        text << cells.join(QLatin1Char('\t'));
    }
    return text.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

void MeasurePanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
}

}  // namespace vybeg::ui
