#include "ui/batch/batch_window.h"

#include "core/output/batch_csv.h"
#include "ui/widgets/page_parts.h"
#include "ui/widgets/theme.h"
#include "ui/words/error_text.h"

#include <QAction>
#include <QClipboard>
#include <QCloseEvent>
#include <QCoreApplication>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLocale>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QShortcut>
#include <QStringList>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

namespace vybeg::ui {

namespace {

constexpr double minute_s = 60;
constexpr double hour_s = 3600;
constexpr double ms_per_s = 1000;

}  // namespace

void BatchProgress::begin(std::size_t sets) {
    *this = BatchProgress();
    sets_ = sets;
    since_.start();
}

void BatchProgress::add(bool kept) {
    ++done_;
    if (!kept) {
        ++computed_;
        last_row_ms_ = since_.elapsed();
    }
}

std::optional<double> BatchProgress::secondsLeft() const {
    if (computed_ == 0 || done_ == sets_) {
        return std::nullopt;
    }
    const double each_ms = static_cast<double>(last_row_ms_) / static_cast<double>(computed_);
    const double left_ms = each_ms * static_cast<double>(sets_ - done_) -
                           static_cast<double>(since_.elapsed() - last_row_ms_);
    return std::max(left_ms, 0.) / ms_per_s;
}

QString durationText(double seconds) {
    const QLocale locale;
    if (seconds < 1.5 * minute_s) {
        return QCoreApplication::translate("Duration", "%1 s")
            .arg(locale.toString(std::ceil(seconds), 'f', 0));
    }
    if (seconds < 1.5 * hour_s) {
        return QCoreApplication::translate("Duration", "%1 min")
            .arg(locale.toString(std::ceil(seconds / minute_s), 'f', 0));
    }
    return QCoreApplication::translate("Duration", "%1 h")
        .arg(locale.toString(seconds / hour_s, 'f', 1));
}

BatchMessage::BatchMessage(QWidget* parent) : QLabel(parent) {
    setObjectName(QStringLiteral("batchMessage"));
    setWordWrap(true);
    setTextFormat(Qt::PlainText);
    setTextInteractionFlags(Qt::TextSelectableByMouse);
    whenChanged(*this, {QEvent::PaletteChange}, [this] { color(); });
    hide();
}

void BatchMessage::begin() {
    warnings_.clear();
    end_ = nullptr;
    fault_ = false;
    refresh();
}

void BatchMessage::warn(Text text) {
    warnings_.push_back(std::move(text));
    refresh();
}

void BatchMessage::end(Text text, bool fault) {
    end_ = std::move(text);
    fault_ = fault;
    refresh();
}

void BatchMessage::refresh() {
    QStringList lines;
    for (const Text& warning : warnings_) {
        lines << QStringLiteral("⚠ ") + warning();
    }
    if (end_) {
        lines << end_();
    }
    setText(lines.join(QLatin1Char('\n')));
    setVisible(!lines.isEmpty());
    color();
}

void BatchMessage::color() {
    const QPalette usual = parentWidget()->palette();
    QPalette colors = usual;
    if (fault_) {
        colors.setColor(QPalette::WindowText, themeOf(usual).broken);
    }
    if (palette() != colors) {
        setPalette(colors);
    }
}

namespace {

constexpr int tick_ms = 1000;
constexpr int lines_of_details = 4;
constexpr int widest_column = 260;
constexpr int cell_margin = 16;

void ask(QWidget* window, const QString& title, const QString& text, const QString& yes,
         const QString& no, const std::function<void()>& then) {
    auto* question =
        new QMessageBox(QMessageBox::Question, title, text, QMessageBox::NoButton, window);
    question->setAttribute(Qt::WA_DeleteOnClose);
    const auto* wanted = question->addButton(yes, QMessageBox::AcceptRole);
    question->addButton(no, QMessageBox::RejectRole);
    QObject::connect(question, &QMessageBox::buttonClicked, window,
                     [wanted, then](const QAbstractButton* pressed) {
                         if (pressed == wanted) {
                             then();
                         }
                     });
    question->open();
}

}  // namespace

BatchWindow::BatchWindow(QWidget* parent)
    : QWidget(parent, Qt::Window),
      order_(new BatchOrder(this)),
      form_(new BatchForm(this)),
      start_(withName(new QPushButton(this), "batchStart")),
      stop_(withName(new QPushButton(this), "batchStop")),
      bar_(new QProgressBar(this)),
      progress_text_(withName(new QLabel(this), "batchProgress")),
      message_(new BatchMessage(this)),
      table_(withName(new QTableView(this), "batchTable")),
      details_(withName(new QPlainTextEdit(this), "batchDetails")),
      open_(new QAction(table_)),
      copy_(new QAction(table_)) {
    setObjectName(QStringLiteral("batch_window"));
    resize(1180, 680);
    bar_->setTextVisible(false);
    bar_->setFixedWidth(220);
    buildTable();
    details_->setReadOnly(true);
    details_->setTabChangesFocus(true);
    details_->setFixedHeight(lines_of_details * details_->fontMetrics().lineSpacing() +
                             2 * details_->frameWidth() + 8);
    auto* row = fill(new QHBoxLayout, {start_, stop_, bar_, {progress_text_, 1}});
    fill(new QVBoxLayout(this), {form_, row, message_, {table_, 1}, details_});
    tick_.setInterval(tick_ms);
    connect(&tick_, &QTimer::timeout, this, &BatchWindow::showProgress);
    connect(form_, &BatchForm::changed, this, &BatchWindow::refresh);
    connect(start_, &QPushButton::clicked, this, &BatchWindow::askAndStart);
    connect(stop_, &QPushButton::clicked, this, &BatchWindow::stop);
    connect(new QShortcut(QKeySequence::HelpContents, this), &QShortcut::activated, this,
            &BatchWindow::helpWanted);
    applyTheme();
    whenChanged(*this, {QEvent::PaletteChange}, [this] { applyTheme(); });
    // Once it has left and is shown again, it is the window it was.
    whenChanged(*this, {QEvent::Show}, [this] { leaving_ = false; });
    keepTranslated(*this, [this] { retranslate(); });
    refresh();
}

BatchWindow::~BatchWindow() {
    batch_stop_.request_stop();
}

void BatchWindow::buildTable() {
    order_->setSourceModel(&model_);
    table_->setModel(order_);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setTabKeyNavigation(false);
    table_->setAlternatingRowColors(true);
    table_->setShowGrid(false);
    table_->setWordWrap(false);
    table_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    table_->setContextMenuPolicy(Qt::ActionsContextMenu);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(table_->fontMetrics().height() + 8);
    QHeaderView* header = table_->horizontalHeader();
    header->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    header->setSectionsMovable(true);
    header->setHighlightSections(false);
    header->setSortIndicatorClearable(true);
    header->setSortIndicator(-1, Qt::AscendingOrder);
    table_->setSortingEnabled(true);
    open_->setShortcuts({QKeySequence(Qt::Key_Return), QKeySequence(Qt::Key_Enter)});
    copy_->setShortcut(QKeySequence::Copy);
    for (QAction* action : {open_, copy_}) {
        action->setShortcutContext(Qt::WidgetShortcut);
        table_->addAction(action);
    }
    connect(open_, &QAction::triggered, this, &BatchWindow::openCurrent);
    connect(copy_, &QAction::triggered, this, &BatchWindow::copyRows);
    connect(table_, &QTableView::doubleClicked, this, &BatchWindow::openCurrent);
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            &BatchWindow::showDetails);
    showColumns();
}

void BatchWindow::setUnits(const DisplayUnits& units) {
    model_.setUnits(units);
    showColumns();
}

void BatchWindow::leave() {
    leaving_ = true;
    stop();
    close();
}

void BatchWindow::askAndStart() {
    // A batch that stopped left rows, but no table: this is the table of a whole one.
    const QString results = form_->path(BatchPath::results);
    if (!QFileInfo::exists(results)) {
        start();
        return;
    }
    if (!is_batch_table(results.toStdU16String())) {
        message_->begin();
        message_->end(
            [results] {
                return tr("%1 already exists and is not a table of results: choose another name.")
                    .arg(results);
            },
            true);
        return;
    }
    ask(this, tr("Replace the results?"),
        tr("%1 already exists. The new table replaces it when it is complete.").arg(results),
        tr("Replace"), tr("Cancel"), [this] { start(); });
}

void BatchWindow::start() {
    if (running()) {
        return;
    }
    BatchRequest request = form_->request();
    // One table, whichever program writes it, and either goes on where the other stopped.
    request.program = "vybeg-cli " + QCoreApplication::applicationVersion().toStdString();
    request.resume = true;
    if (form_->takesPanel() && panel_) {
        request.settings = panel_();
    }
    output_ = QString::fromStdString(request.output);
    stopping_ = false;
    message_->begin();
    model_.begin(std::make_shared<const MeasurementList>());  // the table of the batch before goes
    progress_.begin(0);
    batch_stop_ = std::stop_source();
    constexpr int only_one = 0;
    job_.write(
        only_one,
        [this, request, token = batch_stop_.get_token()](const JobControl&) {
            return compute_batch(request, events(), token);
        },
        [this](const Status& status) { whenEnded(status); });
    refresh();
}

void BatchWindow::stop() {
    if (running()) {
        stopping_ = true;
        batch_stop_.request_stop();
        refresh();
    }
}

BatchEvents BatchWindow::events() {
    const auto post = [this](std::function<void()> act) {
        QMetaObject::invokeMethod(this, std::move(act), Qt::QueuedConnection);
    };
    return {
        [this, post](const std::vector<Diagnostic>& warnings) {
            for (const Diagnostic& each : warnings) {
                post([this, each] { message_->warn([each] { return diagnosticText(each); }); });
            }
        },
        [this, post](const MeasurementList& list) {
            post([this, own = std::make_shared<const MeasurementList>(list)] { whenBegun(own); });
        },
        [this, post](const FinishedRow& row) { post([this, row] { whenFinished(row); }); }};
}

void BatchWindow::whenBegun(const std::shared_ptr<const MeasurementList>& list) {
    model_.begin(list);
    progress_.begin(list->sets.size());
    tick_.start();
    showColumns();
    showProgress();
    showDetails();
}

void BatchWindow::whenFinished(const FinishedRow& row) {
    model_.add(row);
    progress_.add(row.kept);
    widenFor(static_cast<int>(row.set));
    showProgress();
    showDetails();
}

void BatchWindow::whenEnded(const Status& status) {
    tick_.stop();
    const auto kept = [] { return tr("What is computed is kept: Start goes on from here."); };
    if (status) {
        message_->end([path = output_] { return tr("Written: %1").arg(path); }, false);
    } else if (status.error().code == ErrorCode::interrupted_midway) {
        message_->end([kept] { return tr("Stopped.") + QLatin1Char(' ') + kept(); }, false);
    } else if (status.error().code == ErrorCode::interrupted) {
        message_->end([] { return tr("Stopped."); }, false);
    } else {
        message_->end(
            [error = status.error(), kept, some = model_.finished() > 0] {
                return BatchForm::errorText(error) + (some ? QLatin1Char(' ') + kept() : QString());
            },
            true);
    }
    refresh();
    if (leaving_) {
        close();
    }
}

void BatchWindow::showProgress() {
    const auto sets = static_cast<int>(progress_.sets());
    bar_->setRange(0, std::max(sets, 1));
    bar_->setValue(model_.finished());
    QStringList parts;
    if (sets > 0) {
        parts << tr("%1 of %n set(s)", nullptr, sets).arg(model_.finished());
    }
    if (model_.failed() > 0) {
        parts << tr("%n without a result", nullptr, model_.failed());
    }
    const auto left = progress_.secondsLeft();
    if (running() && stopping_) {
        parts << tr("stopping…");
    } else if (running() && left) {
        parts << tr("%1 left").arg(durationText(*left));
    }
    progress_text_->setText(parts.join(QStringLiteral("; ")));
}

void BatchWindow::showColumns() {
    for (int k = 0; k < model_.columnCount(); ++k) {
        int width = 0;
        const QString title = model_.headerData(k, Qt::Horizontal, Qt::DisplayRole).toString();
        for (const QString& line : title.split(QLatin1Char('\n'))) {
            // Beside the sign of the order.
            width = std::max(width, fontMetrics().horizontalAdvance(line) + 2 * cell_margin);
        }
        table_->setColumnWidth(k, width);
        // Conditions that no set has, and passports where there are none, take no room.
        static const std::set<std::string> optional{"gyro", "date", "verdict", "changed"};
        const std::string& name = model_.columns()[static_cast<std::size_t>(k)].name;
        table_->setColumnHidden(k, optional.contains(name) && model_.isEmpty(k));
    }
    for (int row = 0; row < model_.rowCount(); ++row) {
        widenFor(row);
    }
}

void BatchWindow::widenFor(int row) {
    for (int k = 0; k < model_.columnCount(); ++k) {
        const QString text = model_.index(row, k).data().toString();
        if (text.isEmpty()) {
            continue;
        }
        table_->setColumnHidden(k, false);
        const int needed = fontMetrics().horizontalAdvance(text) + cell_margin;
        if (table_->columnWidth(k) < std::min(needed, widest_column)) {
            table_->setColumnWidth(k, std::min(needed, widest_column));
        }
    }
}

void BatchWindow::showDetails() {
    const QModelIndex current = order_->mapToSource(table_->currentIndex());
    const QString text =
        current.isValid() ? model_.details(current.row()).join(QLatin1Char('\n')) : QString();
    if (details_->toPlainText() != text) {
        details_->setPlainText(text);
    }
    details_->setPlaceholderText(
        current.isValid() && model_.hasResult(current.row())
            ? tr("This set has a result, and no warnings.")
            : tr("Choose a set to see why it has no result, and its warnings."));
    open_->setEnabled(current.isValid());
    copy_->setEnabled(current.isValid());
}

void BatchWindow::refresh() {
    form_->setEnabled(!running());
    start_->setEnabled(!running() && form_->isComplete());
    stop_->setEnabled(running() && !stopping_);
    bar_->setVisible(running());
    showProgress();
}

void BatchWindow::openCurrent() {
    const QModelIndex current = order_->mapToSource(table_->currentIndex());
    if (!current.isValid() || model_.list() == nullptr) {
        return;
    }
    const auto place = static_cast<std::size_t>(current.row());
    emit setWanted({model_.list()->other_columns, {model_.list()->sets[place]}, {}});
}

void BatchWindow::copyRows() const {
    std::vector<int> rows;
    for (int row = 0; row < order_->rowCount(); ++row) {
        if (table_->selectionModel()->isRowSelected(row)) {
            rows.push_back(order_->mapToSource(order_->index(row, 0)).row());
        }
    }
    std::vector<int> columns;
    const QHeaderView* header = table_->horizontalHeader();
    for (int place = 0; place < header->count(); ++place) {
        if (const int column = header->logicalIndex(place); !header->isSectionHidden(column)) {
            columns.push_back(column);
        }
    }
    QGuiApplication::clipboard()->setText(model_.tableText(rows, columns));
}

void BatchWindow::closeEvent(QCloseEvent* event) {
    if (!running() || leaving_) {  // then the batch stops where this object goes
        QWidget::closeEvent(event);
        return;
    }
    event->ignore();
    ask(this, tr("Stop the batch?"),
        tr("The batch is running. What is computed is kept beside the table, and Start with the "
           "same files goes on from there."),
        tr("Stop and close"), tr("Go on"), [this] { leave(); });
}

void BatchWindow::applyTheme() {
    model_.setTheme(themeOf(palette()));
}

void BatchWindow::retranslate() {
    setWindowTitle(tr("Batch of sets"));
    start_->setText(tr("&Start"));
    start_->setToolTip(
        tr("Compute every set of the list; rows of a stopped batch with the same files and options "
           "are kept"));
    stop_->setText(tr("S&top"));
    stop_->setToolTip(tr("Stop; what is computed is kept"));
    bar_->setAccessibleName(tr("Progress of the batch"));
    setWords(*table_, tr("Results of the batch"),
             tr("A double click or Return opens the set in the main window"));
    setWords(*details_, tr("About the chosen set"),
             tr("Why the chosen set has no result, and its warnings"));
    open_->setText(tr("Open the set in the main window"));
    copy_->setText(tr("Copy rows"));
    message_->refresh();
    model_.retranslate();
    showColumns();
    showDetails();
    showProgress();
}

}  // namespace vybeg::ui

#include "moc_batch_window.cpp"
