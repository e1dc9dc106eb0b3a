#pragma once

#include "core/analysis/identify_settings.h"
#include "core/base/error.h"
#include "core/batch/batch_request.h"
#include "ui/batch/batch_form.h"
#include "ui/batch/batch_table.h"
#include "ui/document/background_jobs.h"

#include <QElapsedTimer>
#include <QLabel>
#include <QString>
#include <QTimer>
#include <QWidget>

#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

class QAction;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QTableView;

namespace vybeg::ui {

// How far a batch is, and how long it still takes: as long for each set as for those of this batch.
class BatchProgress {
public:
    void begin(std::size_t sets);
    // `kept`: a row of an earlier batch, which took no time.
    void add(bool kept);

    std::size_t sets() const { return sets_; }
    // Nothing before the first row of this batch, and at the end.
    std::optional<double> secondsLeft() const;

private:
    std::size_t sets_ = 0;
    std::size_t done_ = 0;
    std::size_t computed_ = 0;
    qint64 last_row_ms_ = 0;
    QElapsedTimer since_;
};

// "40 s", "12 min", "3.5 h".
QString durationText(double seconds);

// How a batch ended, below the warnings of its list. Texts are functions, so that a change of
// language reaches them. Hidden while there is nothing to say.
class BatchMessage : public QLabel {
    Q_OBJECT

public:
    using Text = std::function<QString()>;

    explicit BatchMessage(QWidget* parent);

    void begin();  // a new batch: nothing to say
    void warn(Text text);
    void end(Text text, bool fault);
    void refresh();  // in the present language

private:
    void color();

    std::vector<Text> warnings_;
    Text end_;
    bool fault_ = false;
};

// A window of its own for many sets: the files of a batch, its progress, and the table of its
// results, which fills while they are computed. None of their recordings is opened here. The batch
// is that of the command line in the background: finished rows stay on the disk when the window
// goes.
class BatchWindow : public QWidget {
    Q_OBJECT

public:
    explicit BatchWindow(QWidget* parent = nullptr);
    ~BatchWindow() override;

    BatchForm& form() { return *form_; }
    // Settings for what the list leaves open, asked for when the engineer wants those of the panel.
    void setPanelSource(std::function<IdentifySettings()> source) { panel_ = std::move(source); }
    void setUnits(const DisplayUnits& units);
    bool running() const { return job_.busy(); }
    // Called by the program: stops the batch, and closes without a question.
    void leave();

signals:
    // A list of this set alone, with the options and conditions of its rows.
    void setWanted(const vybeg::MeasurementList& list);
    void helpWanted();

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    void buildTable();
    void start();
    void askAndStart();
    void stop();
    // Passes the events of the batch, which come in its thread, to the window.
    BatchEvents events();
    void whenBegun(const std::shared_ptr<const MeasurementList>& list);
    void whenFinished(const FinishedRow& row);
    void whenEnded(const Status& status);
    void showProgress();
    void showDetails();
    // Their widths, and which are there.
    void showColumns();
    void widenFor(int row);
    void refresh();
    void openCurrent();
    void copyRows() const;
    void applyTheme();
    void retranslate();

    std::function<IdentifySettings()> panel_;
    std::stop_source batch_stop_;
    bool leaving_ = false;
    bool stopping_ = false;
    QString output_;  // of the batch that runs or ran
    BatchProgress progress_;
    QTimer tick_;

    BatchTable model_;
    BatchOrder* order_;
    BatchForm* form_;
    QPushButton* start_;
    QPushButton* stop_;
    QProgressBar* bar_;
    QLabel* progress_text_;
    BatchMessage* message_;
    QTableView* table_;
    QPlainTextEdit* details_;
    QAction* open_;
    QAction* copy_;
    BackgroundJobs job_;  // the last member: it waits for its threads, which use the others
};

}  // namespace vybeg::ui
