#include "ui/resonator/figures_view.h"

#include "ui/charts/round_plot.h"
#include "ui/plots/xy_plot_view.h"
#include "ui/resonator/resonator_plots.h"
#include "ui/resonator/resonator_text.h"
#include "ui/widgets/page_parts.h"
#include "ui/widgets/quantity_table.h"
#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QResizeEvent>
#include <QVBoxLayout>

namespace vybeg::ui {

FiguresView::FiguresView(QWidget* parent) : OutcomeView(parent), hint_(sentence(this, "hint")) {
    plots_ = buildPlots();
    hint_->setAlignment(Qt::AlignCenter);
    hint_->setMinimumHeight(120);
    fill(new QVBoxLayout(this), {}, 2, {hint_, plots_});
    connect(rim_, &RoundView::exportWanted, this, &FiguresView::exportWanted);
    for (XYPlotView* plot : {drift_plot_, balance_plot_}) {
        connect(plot, &XYPlotView::exportWanted, this, &FiguresView::exportWanted);
    }
    connect(balance_axis_, &QComboBox::activated, this, &FiguresView::showBalance);
    keepTranslated(*this, [this] { retranslate(); });
}

QWidget* FiguresView::buildPlots() {
    auto* plots = new QWidget(this);
    auto* grid = new QGridLayout(plots);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(2);
    for (QLabel** name : {&rim_name_, &drift_name_, &balance_name_}) {
        *name = sentence(plots, "");
    }
    rim_ = withName(new RoundView(true, plots), "rim");
    rim_->setMinimumSize(240, 300);
    drift_plot_ = withName(new XYPlotView(plots), "drift");
    drift_ = withName(new QuantityTable(plots), "harmonics");
    balance_plot_ = withName(new XYPlotView(plots), "balance");
    balance_axis_ = new QComboBox(plots);
    balance_axis_->addItems({QString(), QString()});  // in the order of BalanceAxis
    balance_name_->setBuddy(balance_axis_);
    auto* balance_head = fill(new QHBoxLayout, {{balance_name_, 1}, balance_axis_});
    grid->addLayout(balance_head, 5, 0, 1, 2);
    grid->addWidget(balance_plot_, 6, 0, 1, 2);
    grid_ = grid;
    place(true);
    return plots;
}

void FiguresView::place(bool side_by_side) {
    side_by_side_ = side_by_side;
    const int span = side_by_side ? 1 : 2;
    const int drift_row = side_by_side ? 0 : 2;
    const int drift_column = side_by_side ? 1 : 0;
    for (QWidget* part :
         std::initializer_list<QWidget*>{rim_name_, rim_, drift_name_, drift_plot_, drift_}) {
        grid_->removeWidget(part);
    }
    grid_->addWidget(rim_name_, 0, 0, 1, span);
    grid_->addWidget(rim_, 1, 0, side_by_side ? 2 : 1, span);
    grid_->addWidget(drift_name_, drift_row, drift_column, 1, span);
    grid_->addWidget(drift_plot_, drift_row + 1, drift_column, 1, span);
    grid_->addWidget(drift_, drift_row + 2, drift_column, 1, span, Qt::AlignTop);
    grid_->setColumnStretch(0, 2);
    grid_->setColumnStretch(1, 3);
}

void FiguresView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    constexpr int wide = 620;
    if (side_by_side_ != (width() >= wide)) {
        place(width() >= wide);
    }
}

void FiguresView::setTheme(const Theme& theme) {
    rim_->setTheme(theme);
    drift_plot_->setTheme(theme);
    balance_plot_->setTheme(theme);
}

FigureSource FiguresView::figures() const {
    if (plots_->isHidden()) {
        return {};
    }
    return sourceOf({{rim_->accessibleName(), rim_->figure()},
                     {drift_plot_->accessibleName(), drift_plot_->figure()},
                     {balance_plot_->accessibleName(), balance_plot_->figure()}},
                    QStringLiteral("resonator"), QString());
}

void FiguresView::rebuild() {
    const bool structured =
        shown_ && shown_->identification.fit.model == ResonatorModel::structured;
    plots_->setVisible(structured);
    hint_->setVisible(!structured);
    hint_->setText(shown_ ? reasonText({ReasonCode::free_model, {}})
                          : tr("Rim, drift and balance of the channels appear here when the "
                               "resonator is identified."));
    if (structured) {
        rim_->setContent(rimPlot(*shown_));
        drift_plot_->setContent(driftPlot(*shown_, units_));
        drift_->setContent({}, driftRows(shown_->identification, units_));
        showBalance();
    }
}

void FiguresView::showBalance() {
    if (shown_) {
        const auto axis = static_cast<BalanceAxis>(balance_axis_->currentIndex());
        balance_plot_->setContent(balancePlot(*shown_, axis, units_));
    }
}

void FiguresView::retranslate() {
    const auto head = [](QLabel* label, QWidget* widget, const QString& title) {
        label->setText(QStringLiteral("<b>%1</b>").arg(title));
        widget->setAccessibleName(title);
    };
    head(rim_name_, rim_, tr("Rim"));
    head(drift_name_, drift_plot_, tr("Drift function"));
    head(balance_name_, balance_plot_, tr("Channel balance, condition (30)"));
    rim_->setToolTip(
        richTip(tr("The rim from the side of the electrodes, clockwise from C: electrodes, the "
                   "axes of the faster mode (θ_w) and of larger damping (θ_τ) as wide as their "
                   "standard deviations, and the wave of each recording at its start, out of "
                   "scale")));
    balance_axis_->setAccessibleName(tr("What the balance is drawn against"));
    setTexts(*balance_axis_, {tr("over time"), tr("over the wave angle")});
    drift_->setAccessibleName(tr("Harmonics of the drift function"));
    drift_plot_->setToolTip(richTip(
        tr("Drift of the wave angle against the angle: measured points with their standard "
           "deviations, and the harmonics fitted to them with their combined uncertainty u as "
           "a band; dashed: by the fitted resonator. Without what the quadrature adds")));
    balance_plot_->setToolTip(
        richTip(tr("Zero within its band while the channels are balanced as the fit has them")));
    rebuild();
}

}  // namespace vybeg::ui
