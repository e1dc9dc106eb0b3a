#include "ui/panels/ledger_head.h"

#include "ui/widgets/keep_translated.h"
#include "ui/widgets/page_parts.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QHBoxLayout>
#include <QToolButton>

namespace vybeg::ui {

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
