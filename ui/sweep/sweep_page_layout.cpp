#include "ui/document/document.h"
#include "ui/plots/xy_plot_view.h"
#include "ui/sweep/length_field.h"
#include "ui/sweep/sweep_page.h"
#include "ui/sweep/sweep_text.h"
#include "ui/widgets/page_parts.h"
#include "ui/widgets/quantity_table.h"
#include "ui/words/algorithm_text.h"
#include "ui/words/index_text.h"
#include "ui/words/rich_text.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QGridLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace vybeg::ui {

namespace {

constexpr int least_plot_height = 250;
constexpr int progress_steps = 1000;
}  // namespace

QLayout* SweepPage::buildHead() {
    recording_->setTextFormat(Qt::PlainText);
    recording_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    for ([[maybe_unused]] const Algorithm each : all_algorithms) {
        algorithm_->addItem(QString());
    }
    algorithm_label_->setBuddy(algorithm_);
    lengths_label_->setBuddy(lengths_);
    progress_->setRange(0, progress_steps);
    progress_->setMaximumHeight(compute_->sizeHint().height());
    auto* first = fill(new QHBoxLayout, {{recording_, 1}, algorithm_label_, algorithm_, snap_});
    auto* second =
        fill(new QHBoxLayout, {lengths_label_, {lengths_, 2}, compute_, {progress_, 1}, cancel_});
    auto* rows = fill(new QVBoxLayout, {6, 4, 6, 0}, 4, {first, second, state_});
    return rows;
}

QWidget* SweepPage::buildContent() {
    auto* content = new QWidget(this);
    variable_label_ = new QLabel(content);
    variable_ = withName(new QComboBox(content), "sweepVariable");
    variable_->setItemDelegate(new IndexDelegate(variable_));
    for ([[maybe_unused]] const SlowVariable each : main_slow_variables) {
        variable_->addItem(QString());
    }
    variable_->setCurrentIndex(2);
    variable_label_->setBuddy(variable_);
    copy_ = withName(new QPushButton(content), "sweepCopy");
    scatter_ = addPlot("sweepScatter", least_plot_height);
    residual_ = addPlot("sweepResidual", least_plot_height);
    advice_ = sentence(content, "sweepAdvice", QMargins());
    point_ = sentence(content, "sweepPoint", QMargins());
    use_ = withName(new QPushButton(content), "sweepUse");
    table_ = withName(new QuantityTable(content), "sweepTable");
    auto* choice = fill(new QHBoxLayout, {variable_label_, variable_, LayoutPart(1), copy_});
    auto* advice = fill(new QHBoxLayout, {{advice_, 1}, {use_, 0, Qt::AlignTop}});
    auto* grid = new QGridLayout(content);
    grid->setContentsMargins(6, 0, 6, 0);
    grid->setSpacing(4);
    grid->addLayout(choice, 0, 0, 1, 2);
    grid->addWidget(scatter_, 1, 0);
    grid->addWidget(residual_, 1, 1);
    grid->addWidget(point_, 2, 0, 1, 2);
    grid->addLayout(advice, 3, 0, 1, 2);
    grid->addWidget(table_, 4, 0, 1, 2);
    grid->setRowStretch(1, 1);
    grid->setColumnStretch(0, 5);
    grid->setColumnStretch(1, 3);
    return content;
}

void SweepPage::connectWidgets() {
    connect(compute_, &QPushButton::clicked, this, &SweepPage::compute);
    connect(cancel_, &QPushButton::clicked, this, &SweepPage::cancel);
    connect(use_, &QPushButton::clicked, this, &SweepPage::useWindow);
    connect(lengths_, &QLineEdit::textChanged, this, &SweepPage::refresh);
    connect(lengths_, &QLineEdit::returnPressed, this, &SweepPage::compute);
    connect(algorithm_, &QComboBox::currentIndexChanged, this, &SweepPage::refresh);
    connect(snap_, &QCheckBox::toggled, this, &SweepPage::refresh);
    connect(variable_, &QComboBox::currentIndexChanged, this, &SweepPage::showFound);
    connect(copy_, &QPushButton::clicked, this, [this] {
        if (sweep()) {
            QGuiApplication::clipboard()->setText(sweepTable(*sweep(), view()));
        }
    });
    for (XYPlotView* plot : {scatter_, residual_}) {
        connect(plot, &XYPlotView::pointClicked, this,
                [this](int point) { choose(static_cast<std::size_t>(point)); });
        connect(plot, &XYPlotView::stepWanted, this, [this](int by) {
            if (const WindowSweep* shown = sweep()) {
                const int count = static_cast<int>(shown->lengths.size());
                const int from = static_cast<int>(offered().value_or(0));
                choose(static_cast<std::size_t>(std::clamp(from + by, 0, count - 1)));
            }
        });
    }
    connect(&job_, &BackgroundJobs::analysisProgress, this, [this](int, double fraction) {
        progress_->setValue(static_cast<int>(progress_steps * fraction));
    });
    connect(&document_, &Document::settingsChanged, this, &SweepPage::followSettings);
    connect(&document_, &Document::recordingsChanged, this, &SweepPage::dropOldResults);
    connect(&document_, &Document::recordingChanged, this, &SweepPage::dropOldResults);
    connect(&document_, &Document::currentRecordingChanged, this, [this] {
        chosen_.reset();
        showFound();
    });
}

void SweepPage::retranslate() {
    {
        const QSignalBlocker quiet(algorithm_);
        for (std::size_t k = 0; k < all_algorithms.size(); ++k) {
            algorithm_->setItemText(static_cast<int>(k), algorithmText(all_algorithms[k]));
        }
    }
    for (std::size_t v = 0; v < sweep_variable_count; ++v) {
        variable_->setItemText(static_cast<int>(v),
                               indexPlain(displaySymbol(main_slow_variables[v], units_)) +
                                   QStringLiteral(" – ") + displayMeaning(main_slow_variables[v]));
    }
    algorithm_label_->setText(tr("Algorithm"));
    algorithm_->setAccessibleName(tr("Algorithm of the sweep"));
    algorithm_->setToolTip(richTip(tr("Follows the panel Analysis; may be another one here")));
    snap_->setText(tr("Snap"));
    snap_->setAccessibleName(tr("Snap every length"));
    snap_->setToolTip(richTip(tr("Moves every length to whole half-periods of the carrier")));
    lengths_label_->setText(tr("Lengths"));
    lengths_->retranslate();
    compute_->setText(tr("Compute"));
    compute_->setAccessibleName(tr("Compute the sweep"));
    cancel_->setText(tr("Cancel"));
    cancel_->setAccessibleName(tr("Cancel the sweep"));
    progress_->setAccessibleName(tr("Progress of the sweep"));
    variable_label_->setText(tr("Variable"));
    variable_->setAccessibleName(tr("Variable of the sweep"));
    variable_->setToolTip(richTip(tr("The variable of the left plot and of the table")));
    copy_->setText(tr("Copy table"));
    copy_->setToolTip(richTip(tr("All variables and lengths to the clipboard, for a spreadsheet")));
    use_->setToolTip(
        richTip(tr("Puts this window and the algorithm of the sweep into the panel "
                   "Analysis; Undo takes them back")));
    scatter_->setAccessibleName(tr("Scatter against the length of the window"));
    residual_->setAccessibleName(tr("Residual against the length of the window"));
    table_->setAccessibleName(tr("Numbers of the sweep"));
    showFound();
}

}  // namespace vybeg::ui
