#pragma once

#include "core/residuals/find_residuals.h"
#include "ui/document/background_jobs.h"
#include "ui/plots/plot_view.h"
#include "ui/plots/xy_plot.h"
#include "ui/values/ids.h"

#include <QTimer>

#include <memory>
#include <optional>

class QComboBox;
class QLabel;
class QPushButton;

namespace vybeg::ui {

class Document;
class NumberField;
class QuantityTable;
class TrackView;
struct AnalysisEntry;

// The residual of the chosen analysis: its spectrum with the lines above the noise, its
// distribution and its autocorrelation, of the window at the cursor, the visible part or the whole.
// Computed in the background while the page is shown; a newer request replaces the one before.
class ResidualsPage : public MeasuredPage {
    Q_OBJECT

public:
    enum class Range { window, visible, whole };

    // `tracks` has the visible part and the cursor.
    ResidualsPage(Document& document, TrackView& tracks, QWidget* parent = nullptr);

    void setAnalysis(AnalysisId id) override;
    // The residuals on the page; null until they are computed.
    const Residuals* residuals() const { return found_ ? &*found_ : nullptr; }
    bool computing() const { return computing_; }

    FigureSource figures() const override;

private:
    // A residual is that of this analysis in this range.
    struct Request {
        std::shared_ptr<const Analysis> analysis;
        ResidualRange range;

        friend bool operator==(const Request&, const Request&) = default;
    };

    QWidget* buildContent();
    void setCursor(double time_s);
    Range range() const;
    const AnalysisEntry* entry() const;
    std::optional<Request> wanted() const;
    QString unit() const;
    void refresh();
    void compute();
    void stop();
    void take(Result<Residuals> result);
    QString stateText() const;
    QString emptyText() const;
    void showFound();
    void showNumbers();
    void chooseLine(std::optional<std::size_t> line);
    void showLine();
    void putFilter();
    void showAgain() override { showFound(); }
    void retranslate() override;

    Document& document_;
    TrackView& tracks_;
    BackgroundJobs job_;
    QTimer pause_;  // between the last change and the computation
    QComboBox* range_;
    NumberField* time_;
    QComboBox* lines_;
    QPushButton* filter_;
    QLabel* state_;
    XYPlotView* spectrum_ = nullptr;
    XYPlotView* histogram_ = nullptr;
    XYPlotView* correlation_ = nullptr;
    QuantityTable* numbers_ = nullptr;
    AnalysisId analysis_id_ = AnalysisId::none;
    double cursor_s_ = 0;           // in whose window
    std::optional<Request> asked_;  // shown or under way
    bool computing_ = false;
    std::optional<Error> failure_;
    std::optional<Residuals> found_;     // of what was asked before, while computing
    std::optional<std::size_t> chosen_;  // of the lines found
};

}  // namespace vybeg::ui
