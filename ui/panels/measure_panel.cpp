#include "ui/panels/measure_panel.h"

#include "ui/values/covered_time.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/theme.h"
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

namespace vybeg::ui {

namespace {

enum Column { symbol, at_a, at_b, difference, trend, column_count };

constexpr int measured_rows = static_cast<int>(main_slow_variables.size());

QString nameOf(SlowVariable variable, const DisplayUnits& units) {
    const QString unit = displayUnit(variable, units);
    const QString name = displaySymbol(variable, units);
    return unit.isEmpty() ? name : QStringLiteral("%1, %2").arg(name, unit);
}

}  // namespace

MeasurePanel::MeasurePanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      owner_(new QLabel(this)),
      difference_(new QLabel(this)),
      kind_name_(new QLabel(this)),
      kind_(new QComboBox(this)),
      table_(new QTableWidget(measured_rows, column_count, this)),
      sentences_(new QLabel(this)) {
    auto* grid = new QGridLayout;
    grid->setContentsMargins(6, 2, 6, 2);
    grid->setHorizontalSpacing(6);
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
    owner_->setObjectName(QStringLiteral("owner"));
    kind_name_->setBuddy(kind_);
    kind_->addItems(QStringList(trend_kinds));
    kind_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    grid->addWidget(kind_name_, 1, 0);
    grid->addWidget(kind_, 1, 1, 1, 3);
    connect(kind_, &QComboBox::activated, this, &MeasurePanel::refresh);
    for (QLabel* label : {owner_, difference_, sentences_}) {
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
    layout->addWidget(owner_);
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
    connect(&document_, &Document::analysesChanged, this, &MeasurePanel::refresh);
    connect(&document_.sets(), &SetStore::changed, this, &MeasurePanel::refresh);
    retranslate();
}

void MeasurePanel::setAnalysis(AnalysisId id) {
    if (id != analysis_id_) {
        analysis_id_ = id;
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
    const AnalysisEntry* entry = document_.analysis(analysis_id_);
    const bool usable = entry && entry->shown.visible && entry->shown.analysis->track.rows() > 0;
    return usable ? entry->shown.analysis.get() : nullptr;
}

TrendKind MeasurePanel::trendKind() const {
    return static_cast<TrendKind>(kind_->currentIndex());
}

void MeasurePanel::setTrendKind(TrendKind kind) {
    kind_->setCurrentIndex(static_cast<int>(kind));
    refresh();
}

bool MeasurePanel::isInside(const std::optional<double>& time_s) const {
    return time_s && covers(*document_.analysis(analysis_id_)->shown.analysis, *time_s);
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
    const std::array kinds{tr("Line; exponential for the working wave"), tr("Parabola"),
                           tr("Polynomial of the third degree"), tr("Beat: damped sinusoid")};
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
        kind_->setItemText(static_cast<int>(kind), kinds[kind]);
    }
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
    trends_.clear();
    if (shown) {
        measure(*shown);
        showOwner();
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
    for (const SlowVariable variable : main_slow_variables) {
        if (auto trend = fitTrend(analysis, variable, trendKind(), *a_s_, *b_s_)) {
            trends_.push_back(std::move(*trend));
        }
    }
}

void MeasurePanel::showOwner() {
    const ShownAnalysis& shown = document_.analysis(analysis_id_)->shown;
    const Theme theme = isDark(palette()) ? darkTheme() : lightTheme();
    owner_->setText(
        QStringLiteral("<span style=\"color:%1\">━</span> %2")
            .arg(readable(shown.color, theme, shown.shade).name(), shown.name.toHtmlEscaped()));
    owner_->setToolTip(plainTip(shown.recording));
}

void MeasurePanel::showTimes() {
    fields_[0]->setValue(a_s_);
    fields_[1]->setValue(b_s_);
    const bool apart = a_s_ && b_s_ && *a_s_ != *b_s_;
    const bool outside = (a_s_ && !isInside(a_s_)) || (b_s_ && !isInside(b_s_));
    difference_->setText(
        outside ? tr("A cursor stands where the analysis has no windows.")
        : apart
            ? tr("B − A = %1 s, 1/|B − A| = %2 Hz")
                  .arg(QLocale().toString(*b_s_ - *a_s_, 'g', 8).replace('-', QChar(0x2212)),
                       QLocale().toString(1 / std::abs(*b_s_ - *a_s_), 'g', 6))
            : tr("The keys 1 and 2 in the plots set the cursors A and B at the mouse; the trend "
                 "between them is measured."));
}

Reading MeasurePanel::trendOf(const Analysis& analysis, SlowVariable variable) const {
    const auto found = std::ranges::find(trends_, variable, &FittedTrend::variable);
    return found == trends_.end() ? Reading() : trendReading(analysis, *found, units_);
}

QString MeasurePanel::trendHeader() const {
    return trendKind() == TrendKind::beat ? tr("Beat, Hz") : tr("Rate, per s");
}

void MeasurePanel::showTable(const Analysis& analysis) {
    table_->setHorizontalHeaderLabels({QString(), tr("A"), tr("B"), tr("B − A"), trendHeader()});
    const bool both = a_s_ && b_s_;
    table_->setVisible(a_s_ || b_s_);
    table_->setColumnHidden(at_a, !a_s_);
    table_->setColumnHidden(at_b, !b_s_);
    table_->setColumnHidden(difference, !both);
    table_->setColumnHidden(trend, !both);
    const std::size_t row_a = nearestRow(analysis.track, a_s_.value_or(0));
    const std::size_t row_b = nearestRow(analysis.track, b_s_.value_or(0));
    for (int line = 0; line < measured_rows; ++line) {
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
            set(trend, trendOf(analysis, variable));
        }
    }
}

void MeasurePanel::showSentences() {
    const bool both = isInside(a_s_) && isInside(b_s_);
    sentences_->setVisible(both);
    if (both) {
        QStringList sentences = trendSentences(*analysis(), trendKind(), trends_, units_);
        if (trendKind() == TrendKind::beat) {
            sentences << resonatorSentences();
        }
        for (QString& sentence : sentences) {
            sentence = richText(sentence);
        }
        sentences_->setText(sentences.join(QStringLiteral("<br>")));
    }
}

// A large swing is no sinusoid, yet the modes beat with the split that their resonator has.
QStringList MeasurePanel::resonatorSentences() const {
    const RecordingId recording = document_.analysis(analysis_id_)->recording_id;
    QStringList sentences;
    for (const RecordingSet& set : document_.sets().all()) {
        const auto outcome = document_.sets().outcome(set);
        if (!outcome ||
            std::ranges::find(outcome->recordings, recording) == outcome->recordings.end()) {
            continue;
        }
        const Estimate& split = outcome->identification.fit.resonator.split_hz;
        if (split.given()) {
            sentences << tr("The resonator of this recording beats at its split, %1 Hz")
                             .arg(valueText(split.value, split.uncertainty()));
        }
    }
    return sentences;
}

void MeasurePanel::drawTrends(const Analysis* analysis) {
    std::vector<TrendCurve> curves;
    curves.reserve(trends_.size());
    for (const FittedTrend& trend : trends_) {
        curves.push_back(curveOf(*analysis, trend, *a_s_, *b_s_, units_));
        curves.back().of = analysis_id_;
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
    QStringList text{QStringList{
        document_.analysis(analysis_id_)->shown.name, tr("A = %1 s").arg(spreadsheetNumber(*a_s_)),
        sd, tr("B = %1 s").arg(spreadsheetNumber(*b_s_)), sd, tr("B − A"), sd, trendHeader(), sd}
                         .join(QLatin1Char('\t'))};
    for (const SlowVariable variable : main_slow_variables) {
        QStringList cells{nameOf(variable, units_)};
        for (const Reading& reading :
             {readingAt(*shown, variable, row_a, units_),
              readingAt(*shown, variable, row_b, units_),
              differenceOf(*shown, variable, row_a, row_b, units_), trendOf(*shown, variable)}) {
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
    } else if (event->type() == QEvent::PaletteChange) {
        refresh();  // the owner's colour is readable on the theme's ground
    }
}

}  // namespace vybeg::ui
