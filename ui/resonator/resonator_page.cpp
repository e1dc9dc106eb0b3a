#include "ui/resonator/resonator_page.h"

#include "ui/resonator/comparison_view.h"
#include "ui/resonator/figures_view.h"
#include "ui/resonator/numbers_view.h"
#include "ui/resonator/page_parts.h"
#include "ui/resonator/set_panel.h"
#include "ui/widgets/wheel_guard.h"
#include "ui/words/error_text.h"

#include <QEvent>
#include <QLabel>
#include <QScrollArea>
#include <QSplitter>
#include <QVBoxLayout>

namespace vybeg::ui {

ResonatorPage::ResonatorPage(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      theme_(lightTheme()),
      set_(new SetPanel(document, this)),
      state_(sentence(this)),
      numbers_(new NumbersView(this)),
      figures_(new FiguresView(this)),
      comparison_(new ComparisonView(document, this)) {
    state_->setObjectName(QStringLiteral("state"));
    auto* numbers = new QVBoxLayout;
    numbers->addWidget(numbers_);
    numbers->addStretch(1);
    auto* left = new QWidget(this);
    auto* left_column = new QVBoxLayout(left);
    left_column->setContentsMargins(0, 0, 0, 0);
    left_column->setSpacing(0);
    left_column->addWidget(set_);
    left_column->addWidget(state_);
    left_column->addWidget(scrolled(numbers), 1);
    auto* right = new QVBoxLayout;
    right->addWidget(figures_);
    right->addWidget(comparison_);
    right->addStretch(1);
    auto* sides = new QSplitter(Qt::Horizontal, this);
    sides->setChildrenCollapsible(false);
    sides->addWidget(left);
    sides->addWidget(scrolled(right));
    sides->setStretchFactor(0, 2);
    sides->setStretchFactor(1, 3);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(sides);
    connect(figures_, &FiguresView::exportWanted, this, &ResonatorPage::exportWanted);
    connect(comparison_, &ComparisonView::exportWanted, this, &ResonatorPage::exportWanted);
    connect(&document_.sets(), &SetStore::changed, this, &ResonatorPage::refresh);
    connect(&document_, &Document::recordingChanged, this, &ResonatorPage::refresh);
    connect(&document_.dossier(), &DossierModel::changed, this,
            [this] { numbers_->setLimits(document_.dossier().dossier().limits); });
    guardFromWheel(*this);
    rebuild();
}

void ResonatorPage::setUnits(const DisplayUnits& units) {
    numbers_->setUnits(units);
    figures_->setUnits(units);
    comparison_->setUnits(units);
}

void ResonatorPage::setTheme(const Theme& theme) {
    theme_ = theme;
    numbers_->setTheme(theme);
    figures_->setTheme(theme);
    comparison_->setTheme(theme);
    refresh();
}

FigureSource ResonatorPage::figures() const {
    return figures_->figures();
}

void ResonatorPage::showComparison() {
    comparison_->open();
}

// Changes of the settings, many per second during a drag, affect only the state of the result.
void ResonatorPage::refresh() {
    const RunSet* set = document_.sets().current();
    const auto outcome = set ? document_.sets().outcome(*set) : nullptr;
    if (outcome != shown_) {
        rebuild();
    } else {
        showState(set, outcome.get());
    }
}

void ResonatorPage::rebuild() {
    const RunSet* set = document_.sets().current();
    shown_ = set ? document_.sets().outcome(*set) : nullptr;
    showState(set, shown_.get());
    numbers_->setOutcome(shown_);
    figures_->setOutcome(shown_);
    comparison_->setOutcome(shown_);
}

void ResonatorPage::showState(const RunSet* set, const ResonatorOutcome* outcome) {
    if (!outcome) {
        state_->setText(document_.sets().canIdentify()
                            ? tr("Nothing identified yet.")
                            : tr("Open recordings of a free decay to identify the resonator."));
        return;
    }
    const ResonatorFit& fit = outcome->identification.fit;
    const QString model =
        fit.model == ResonatorModel::structured ? tr("Structured model") : tr("Free model");
    QString text = tr("%1, %n recording(s); χ² per degree of freedom %2", nullptr,
                      static_cast<int>(outcome->inputs.size()))
                       .arg(model, shortNumberText(fit.chi2_per_dof, 3));
    if (document_.sets().outOfDate(*set, *outcome)) {
        text = QStringLiteral("<b style=\"color:%1\">⚠ %2</b> %3")
                   .arg(readable(theme_.warning, theme_).name(), tr("Out of date."),
                        tr("The set or its settings have changed since: identify again.")) +
               QStringLiteral("<br>") + text;
    }
    state_->setText(text);
}

void ResonatorPage::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refresh();
    }
}

}  // namespace vybeg::ui
