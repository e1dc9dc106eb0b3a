#include "ui/panels/ledger_cells.h"

#include "ui/plots/axis_ticks.h"
#include "ui/widgets/page_parts.h"
#include "ui/words/rich_text.h"
#include "ui/words/unit_text.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace vybeg::ui {

namespace {

struct CellWords {
    Q_DECLARE_TR_FUNCTIONS(LedgerCells)
};

// The power of ten of a column, so that its numbers have no more than seven digits before or three
// zeros behind the decimal sign.
int exponentOf(const std::vector<Reading>& readings) {
    double largest = 0;
    for (const Reading& reading : readings) {
        for (const double number : {std::abs(reading.value), reading.sd}) {
            largest = std::isfinite(number) ? std::max(largest, number) : largest;
        }
    }
    const bool ordinary = largest == 0 || (largest >= 1e-3 && largest < 1e7);
    return ordinary
               ? 0
               : std::clamp(3 * static_cast<int>(std::floor(std::log10(largest) / 3)), -15, 12);
}

Reading read(const LedgerReader& reader, const AnalysisEntry* entry, SlowVariable variable) {
    if (!entry || !entry->shown.visible) {
        return {};
    }
    const Analysis& analysis = *entry->shown.analysis;
    Measuring here = reader.measuring;
    if (!here.mouse_s && analysis.track.rows() > 0) {
        here.mouse_s = analysis.track.time_s().front();
    }
    return readingOf(analysis, variable, reader.at, here, reader.trends.of(entry->shown.id),
                     reader.units);
}

// Symbol and unit, with the prefix or power of ten of the column.
QString headOf(const LedgerReader& reader, SlowVariable variable, int exponent) {
    const bool beat = reader.at == ReadAt::rate && reader.measuring.kind == TrendKind::beat;
    QString unit = displayUnit(variable, reader.units);
    if (beat) {
        unit = CellWords::tr("Hz");
    } else if (reader.at == ReadAt::rate) {
        unit = unit.isEmpty() ? CellWords::tr("1/s") : CellWords::tr("%1/s").arg(unit);
    }
    const QString scaled = scaledUnit(unit, beat || takesPrefix(variable, reader.units), exponent);
    return withUnit(displaySymbol(variable, reader.units), scaled);
}

}  // namespace

CellColumn variableColumn(const LedgerReader& reader, const std::vector<const AnalysisEntry*>& rows,
                          SlowVariable variable, bool concise) {
    std::vector<Reading> readings;
    readings.reserve(rows.size());
    for (const AnalysisEntry* entry : rows) {
        readings.push_back(read(reader, entry, variable));
    }
    const int exponent = exponentOf(readings);
    const double scale = std::pow(10., -exponent);
    CellColumn column{headOf(reader, variable, exponent), {}};
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const double value = scale * readings[row].value;
        const double sd = scale * readings[row].sd;
        column.cells << (!rows[row] ? QString()
                         : concise  ? conciseText(value, sd)
                                    : valueText(value, sd));
    }
    return column;
}

std::pair<QString, QString> trendCell(const LedgerReader& reader, const AnalysisEntry* entry) {
    if (!entry || !entry->shown.visible) {
        return {};
    }
    const Analysis& analysis = *entry->shown.analysis;
    const Measuring& measuring = reader.measuring;
    const auto& time_s = reader.at == ReadAt::a   ? measuring.a_s
                         : reader.at == ReadAt::b ? measuring.b_s
                                                  : measuring.mouse_s;
    const bool between = reader.at == ReadAt::difference || reader.at == ReadAt::rate;
    QString text = !between && time_s ? reasonAt(analysis, *time_s) : QString();
    if (text.isEmpty() && measuring.both()) {
        if (isInside(analysis, measuring.a_s) && isInside(analysis, measuring.b_s)) {
            const auto& trends = reader.trends.of(entry->shown.id);
            QStringList sentences =
                measuredSentences(reader.document, *entry, measuring, trends, reader.units);
            std::ranges::transform(sentences, sentences.begin(), richText);
            return {trendSummary(measuring.kind, trends, reader.units),
                    QStringLiteral("<p>%1</p>").arg(sentences.join(QStringLiteral("<br>")))};
        }
        text = CellWords::tr("no windows there");
    }
    return {text, plainTip(text)};
}

LedgerHead::LedgerHead(QWidget* parent)
    : QWidget(parent), kind_(withName(new QComboBox(this), "trend")) {
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(2, 0, 2, 0);
    line->setSpacing(1);
    auto* group = new QButtonGroup(this);
    constexpr std::array names{"readMouse", "readA", "readB", "readDifference", "readRate"};
    for (std::size_t at = 0; at < buttons_.size(); ++at) {
        auto* button = new QToolButton(this);
        button->setObjectName(QLatin1String(names[at]));
        button->setCheckable(true);
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::StrongFocus);
        group->addButton(button, static_cast<int>(at));
        line->addWidget(button);
        buttons_[at] = button;
    }
    kind_->addItems(QStringList(trend_kinds));
    kind_->setFrame(false);
    line->addWidget(kind_);
    line->addStretch(1);
    connect(group, &QButtonGroup::idClicked, this,
            [this](int at) { emit readAtChosen(static_cast<ReadAt>(at)); });
    connect(kind_, &QComboBox::activated, this,
            [this](int kind) { emit kindChosen(static_cast<TrendKind>(kind)); });
    keepTranslated(*this, [this] { retranslate(); });
}

void LedgerHead::show(ReadAt at, const Measuring& measuring) {
    const std::array usable{true, measuring.a_s.has_value(), measuring.b_s.has_value(),
                            measuring.both(), measuring.both()};
    for (std::size_t k = 0; k < buttons_.size(); ++k) {
        buttons_[k]->setEnabled(usable[k]);
    }
    buttons_[static_cast<std::size_t>(at)]->setChecked(true);
    kind_->setCurrentIndex(static_cast<int>(measuring.kind));
    kind_->setVisible(measuring.both());
}

void LedgerHead::retranslate() {
    const std::array texts{tr("mouse"), tr("A"), tr("B"), tr("B − A"), tr("trend")};
    const std::array tips{
        tr("Values of the windows at the mouse in the plots, with standard deviations"),
        tr("Values of the windows at cursor A"), tr("Values of the windows at cursor B"),
        tr("Differences of the windows at the cursors; without standard deviation where they "
           "share samples"),
        tr("Rates of the trends between the cursors, or frequencies of the beats")};
    for (std::size_t k = 0; k < buttons_.size(); ++k) {
        buttons_[k]->setText(texts[k]);
        buttons_[k]->setToolTip(tips[k]);
    }
    setTexts(*kind_, {tr("line"), tr("parabola"), tr("cubic"), tr("beat")});
    kind_->setAccessibleName(tr("Trend between the cursors"));
    kind_->setToolTip(
        tr("A line is an exponential for the working wave; a beat is a damped sinusoid. "
           "Fitted by weighted least squares to the windows between the cursors that share no "
           "samples. Where they scatter more than their noise, the deviations grow by that."));
}

}  // namespace vybeg::ui
