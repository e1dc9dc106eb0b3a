#pragma once

#include "core/sweep/window_sweep.h"
#include "ui/document/background_jobs.h"
#include "ui/plots/plot_view.h"
#include "ui/sweep/shown_sweep.h"
#include "ui/values/ids.h"

#include <QLineEdit>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

class QBoxLayout;
class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace vybeg::ui {

// Window lengths as typed: numbers and ranges "6..600" (about 15 lengths in equal ratios),
// separated by commas, semicolons or spaces; ascending, each once.
struct LengthList {
    std::vector<std::int64_t> lengths;
    QString refusal;  // why the text is no such list; empty for a list
};
LengthList readLengthList(const QString& text);

// A field for such a list. A wrong one is framed in red, with the reason as its tooltip.
class LengthField : public QLineEdit {
    Q_OBJECT

public:
    explicit LengthField(QWidget* parent = nullptr);

    LengthList list() const { return readLengthList(text()); }
    // Texts of the field itself, in the language of the interface.
    void retranslate();

protected:
    void paintEvent(QPaintEvent* event) override;
};

class Document;
class QuantityTable;
struct RecordingEntry;

// The current recording in windows of many lengths: scatter, bound, leakage and residual against
// the length, and the recommended window. Computed in the background on demand; a
// result is kept for each recording until the recording is closed or opened anew.
class SweepPage : public MeasuredPage {
    Q_OBJECT

public:
    explicit SweepPage(Document& document, QWidget* parent = nullptr);

    // The sweep on the page; null without a result.
    const WindowSweep* sweep() const;
    bool running() const { return running_ != RecordingId::none; }

    FigureSource figures() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    // A result, with the settings it was asked for.
    struct Found {
        WindowSweep sweep;
        Settings asked;
        std::weak_ptr<const SampleSource> source;
    };

    QWidget* buildContent();
    QLayout* buildHead();
    void connectWidgets();
    const RecordingEntry* current() const;
    const Found* found() const;
    // The settings of the panel with the choices of this page, without a window.
    Settings wanted() const;
    SweepView view() const;
    // The length of the button: the chosen one, otherwise the recommended one.
    std::optional<std::size_t> offered() const;
    void followSettings();
    void dropOldResults();
    void compute();
    void cancel();
    void take(RecordingId recording, const Settings& asked, Result<WindowSweep> result);
    void choose(std::optional<std::size_t> length);
    void useWindow();
    QString stateText() const;
    QString missing() const;
    void refresh();
    void showFound();
    void showAgain() override { retranslate(); }
    void retranslate() override;

    Document& document_;
    BackgroundJobs job_;
    QComboBox* algorithm_;
    QCheckBox* snap_;
    LengthField* lengths_;
    QPushButton* compute_;
    QProgressBar* progress_;
    QPushButton* cancel_;
    QLabel* state_;
    QWidget* content_ = nullptr;
    QBoxLayout* parts_ = nullptr;  // plots, and the numbers beside or below them
    QWidget* numbers_ = nullptr;
    QComboBox* variable_ = nullptr;
    QPushButton* copy_ = nullptr;
    XYPlotView* scatter_ = nullptr;
    XYPlotView* residual_ = nullptr;
    QLabel* advice_ = nullptr;
    QPushButton* use_ = nullptr;
    QLabel* point_ = nullptr;
    QuantityTable* table_ = nullptr;
    std::optional<Algorithm> followed_;  // of the panel
    bool followed_snap_ = false;
    RecordingId running_ = RecordingId::none;
    std::map<RecordingId, Found> results_;
    std::map<RecordingId, Error> failures_;
    std::optional<std::size_t> chosen_;
};

}  // namespace vybeg::ui
