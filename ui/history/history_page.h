#pragma once

#include "ui/document/background_jobs.h"
#include "ui/history/history_database.h"
#include "ui/history/history_export.h"
#include "ui/history/history_view.h"
#include "ui/plots/plot_view.h"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QSpinBox;

namespace vybeg::ui {

class Document;

// What of a database is shown: gyro, parameter, axis and baseline, which is kept between sessions.
class HistoryChoices : public QWidget {
    Q_OBJECT

public:
    explicit HistoryChoices(QWidget* parent = nullptr);

    // The chosen gyro stays chosen where it is among them.
    void setGyros(const std::vector<StoredGyro>& gyros);
    void chooseAllGyros();
    std::optional<std::string> gyro() const;  // nothing: all
    const HistoryParameter& parameter() const;
    HistoryAxis axis() const;
    // Results that set the limits.
    std::size_t baseline() const;

signals:
    void dataWanted();
    void limitsChanged();
    void axisChanged();

private:
    void place(int in_a_row);
    void retranslate();

    std::vector<StoredGyro> gyros_;
    QComboBox* gyro_;
    QComboBox* parameter_;
    QComboBox* axis_;
    QSpinBox* baseline_;
    std::array<std::pair<QLabel*, QWidget*>, 4> choices_;
    QGridLayout* grid_;
};

// The history of a gyro's parameters in a laboratory's database of results: values, control charts,
// distribution. Read in the background; the database's path is kept between sessions.
class HistoryPage : public MeasuredPage {
    Q_OBJECT

public:
    explicit HistoryPage(Document& document, QWidget* parent = nullptr);

    // Takes another database; `make`: also one that is still to come.
    void openDatabase(const QString& path, bool make);
    const QString& path() const { return path_; }
    // The history on the page; null without a database.
    const StoredHistory* history() const { return history_ ? &*history_ : nullptr; }
    const HistoryCharts& charts() const { return charts_; }
    bool reading() const { return reading_; }
    FigureSource figures() const override;

signals:
    void exportAllWanted(const HistoryExport& all);
    // `make`: a new one.
    void databaseWanted(bool make);
    // Recordings of a result, open as a set.
    void setOpened();

private:
    struct Chart {
        HistoryPlot (*plotOf)(const HistoryView& view) = nullptr;
        const char* name = nullptr;
        XYPlotView* plot = nullptr;
        HistoryPlot shown{};
    };

    QLayout* buildHead();
    QWidget* buildContent();
    void connectWidgets();
    void retranslate() override;

    void look();
    void read();
    void take(Result<StoredHistory> history);
    void compute();
    void showHistory();
    void showDistribution(const HistoryView& now);
    void showAgain() override { showHistory(); }
    void refresh();
    // Precondition: there is a history.
    HistoryView view() const;
    const Chart& values() const { return plots_.front(); }
    bool hasResults() const { return history_ && !history_->gyros.empty(); }
    QString stateText() const;
    // `place`: of a point in the plot.
    void choose(const HistoryPlot& shown, int place);
    void step(int by);
    void openChosen();
    void openStored(const StoredResult& result);
    void add();
    DatabaseJob job(int key) { return {job_, key, document_, path_}; }

    Document& document_;
    BackgroundJobs job_;
    QString path_;
    bool seen_ = false;
    bool reading_ = false;
    QDateTime written_;  // when the file was, as it was read
    std::optional<Error> failure_;
    std::optional<StoredHistory> history_;
    HistoryCharts charts_;
    std::optional<std::size_t> chosen_;
    QLabel* database_;
    QPushButton* open_;
    QPushButton* new_;
    QPushButton* add_;
    QPushButton* export_;
    HistoryChoices* choices_ = nullptr;
    QLabel* state_;
    QWidget* content_ = nullptr;
    QLabel* verdict_ = nullptr;
    QLabel* point_ = nullptr;
    QPushButton* recordings_ = nullptr;
    std::vector<Chart> plots_;  // from top to bottom, first that of the values
    XYPlotView* distribution_ = nullptr;
};

}  // namespace vybeg::ui
