#include "ui/document/document.h"
#include "ui/history/history_choices.h"
#include "ui/history/history_page.h"
#include "ui/plots/xy_plot_view.h"
#include "ui/widgets/page_parts.h"
#include "ui/words/rich_text.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace vybeg::ui {

namespace {

constexpr int plot_height = 240;
}  // namespace

QLayout* HistoryPage::buildHead() {
    database_->setTextFormat(Qt::PlainText);
    database_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* first = fill(new QHBoxLayout, {{database_, 1}, open_, new_, add_, export_});

    choices_ = new HistoryChoices(this);
    auto* rows = fill(new QVBoxLayout, {6, 4, 6, 0}, 4, {first, choices_, state_});
    return rows;
}

// Side by side where both have room for their titles.
void HistoryPage::placeSmallPlots(bool side_by_side) {
    side_by_side_ = side_by_side;
    for (QWidget* plot : {ranges_, average_}) {
        grid_->removeWidget(plot);
    }
    grid_->addWidget(ranges_, 3, 0, 1, side_by_side ? 1 : 2);
    grid_->addWidget(average_, side_by_side ? 3 : 4, side_by_side ? 1 : 0, 1, side_by_side ? 1 : 2);
}

void HistoryPage::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    constexpr int wide = 760;
    if (side_by_side_ != (width() >= wide)) {
        placeSmallPlots(width() >= wide);
    }
}

QWidget* HistoryPage::buildContent() {
    auto* content = new QWidget(this);
    verdict_ = sentence(content, "historyVerdict", QMargins());
    point_ = sentence(content, "historyPoint", QMargins());
    recordings_ = withName(new QPushButton(content), "historyRecordings");
    values_ = addPlot("historyValues", plot_height + 20);
    ranges_ = addPlot("historyRanges", plot_height);
    average_ = addPlot("historyAverage", plot_height);
    distribution_ = addPlot("historyDistribution", plot_height);
    auto* chosen = fill(new QHBoxLayout, {{point_, 1}, {recordings_, 0, Qt::AlignTop}});
    auto* grid = new QGridLayout(content);
    grid->setContentsMargins(6, 0, 6, 0);
    grid->setSpacing(4);
    grid->addWidget(verdict_, 0, 0, 1, 2);
    grid->addWidget(values_, 1, 0, 1, 2);
    grid->addLayout(chosen, 2, 0, 1, 2);
    grid->addWidget(distribution_, 5, 0, 1, 2);
    grid_ = grid;
    placeSmallPlots(true);
    grid->setRowStretch(1, 3);
    grid->setRowStretch(3, 2);
    grid->setRowStretch(5, 2);
    return content;
}

void HistoryPage::connectWidgets() {
    connect(open_, &QPushButton::clicked, this, &HistoryPage::openWanted);
    connect(new_, &QPushButton::clicked, this, &HistoryPage::newWanted);
    connect(add_, &QPushButton::clicked, this, &HistoryPage::askToAdd);
    connect(export_, &QPushButton::clicked, this, [this] {
        emit exportAllWanted(historyExport(*history_, charts_, view(), database_->text(),
                                           choices_->gyro(), choices_->baseline()));
    });
    connect(&adder_, &ResultAdder::added, this, [this](const QString& path) {
        if (path == path_) {
            read();
        }
    });
    connect(recordings_, &QPushButton::clicked, this, &HistoryPage::openChosen);
    connect(choices_, &HistoryChoices::dataWanted, this, &HistoryPage::read);
    connect(choices_, &HistoryChoices::axisChanged, this, &HistoryPage::showHistory);
    connect(choices_, &HistoryChoices::limitsChanged, this, &HistoryPage::compute);
    for (XYPlotView* plot : {values_, ranges_, average_, distribution_}) {
        connect(plot, &XYPlotView::stepWanted, this, &HistoryPage::step);
    }
    for (const auto& [plot, shown] :
         {std::pair{values_, &shown_values_}, std::pair{ranges_, &shown_ranges_},
          std::pair{average_, &shown_average_}}) {
        connect(plot, &XYPlotView::pointClicked, this,
                [this, shown = shown](int place) { choose(*shown, place); });
        connect(plot, &XYPlotView::pointActivated, this, [this, shown = shown](int place) {
            choose(*shown, place);
            openChosen();
        });
    }
    connect(&document_.sets(), &SetStore::changed, this, &HistoryPage::refresh);
    connect(&document_.sets(), &SetStore::passportChanged, this, &HistoryPage::showHistory);
    connect(&document_.dossier(), &DossierModel::changed, this, &HistoryPage::showHistory);
}

void HistoryPage::retranslate() {
    open_->setText(tr("Open…"));
    open_->setAccessibleName(tr("Open a database"));
    open_->setToolTip(richTip(tr("A database of results, of this window or of the command line")));
    new_->setText(tr("New…"));
    new_->setAccessibleName(tr("Make a database"));
    new_->setToolTip(richTip(tr("An empty database of results in a new file")));
    add_->setText(tr("Add this result…"));
    export_->setText(tr("Export…"));
    export_->setAccessibleName(tr("Export the results shown"));
    export_->setToolTip(
        richTip(tr("The results shown as a table (CSV), or as a report with the charts (PDF)")));
    recordings_->setText(tr("Open its recordings"));
    recordings_->setToolTip(
        richTip(tr("As a set, with the settings and conditions of the result; a double click on "
                   "the point does the same")));
    values_->setAccessibleName(tr("Values of the parameter"));
    ranges_->setAccessibleName(tr("Moving range"));
    average_->setAccessibleName(tr("Weighted average"));
    distribution_->setAccessibleName(tr("Distribution of the parameter"));
    const QString tip =
        richTip(tr("A click chooses a result, a double click opens its recordings; "
                   "Left and Right go to its neighbours"));
    for (XYPlotView* plot : {values_, ranges_, average_}) {
        plot->setToolTip(tip);
    }
    distribution_->setToolTip(richTip(tr("How often each value occurs among the results shown")));
    showHistory();
}

}  // namespace vybeg::ui
