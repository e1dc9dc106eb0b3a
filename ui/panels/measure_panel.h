#pragma once

#include "ui/document/document.h"
#include "ui/panels/fitted_trend.h"
#include "ui/values/ids.h"
#include "ui/values/trend_curve.h"
#include "ui/words/display_units.h"

#include <QWidget>

#include <array>
#include <optional>
#include <vector>

class QComboBox;
class QLabel;
class QTableWidget;

namespace vybeg::ui {

class NumberField;

// Readings of one analysis at the cursors A and B: values, their difference, the trend between
// them, decay time and drift. The times can be typed. Hidden without an analysis.
class MeasurePanel : public QWidget {
    Q_OBJECT

public:
    explicit MeasurePanel(Document& document, QWidget* parent = nullptr);

    void setAnalysis(AnalysisId id);
    void setCursors(std::optional<double> a_s, std::optional<double> b_s);
    void setUnits(const DisplayUnits& units);
    TrendKind trendKind() const;
    void setTrendKind(TrendKind kind);
    // The table as tab-separated text, numbers as in CursorPanel::tableText(); empty without both
    // cursors.
    QString tableText() const;

signals:
    void cursorsEdited(std::optional<double> a_s, std::optional<double> b_s);
    // Trends to draw over the plots; empty without both cursors.
    void trendsChanged(const std::vector<TrendCurve>& trends);

protected:
    void changeEvent(QEvent* event) override;

private:
    const Analysis* analysis() const;
    // Whether a cursor stands where the analysis has windows.
    bool isInside(const std::optional<double>& time_s) const;
    void retranslate();
    void refresh();
    void measure(const Analysis& analysis);
    void showOwner();
    void showTimes();
    void showTable(const Analysis& analysis);
    void showSentences();
    // The beat of the analysis's recording by the resonators identified from it.
    QStringList resonatorSentences() const;
    void drawTrends(const Analysis* analysis);
    // Rate or beat frequency of a variable.
    Reading trendOf(const Analysis& analysis, SlowVariable variable) const;
    QString trendHeader() const;

    Document& document_;
    std::array<QLabel*, 2> names_{};
    std::array<NumberField*, 2> fields_{};
    QLabel* owner_;
    QLabel* difference_;
    QLabel* kind_name_;
    QComboBox* kind_;
    QTableWidget* table_;
    QLabel* sentences_;
    AnalysisId analysis_id_ = AnalysisId::none;
    std::optional<double> a_s_;
    std::optional<double> b_s_;
    DisplayUnits units_;
    std::vector<FittedTrend> trends_;  // of the shown variables that have one
    std::vector<TrendCurve> drawn_;
};

}  // namespace vybeg::ui
