#pragma once

#include "ui/document/document.h"
#include "ui/values/trend_curve.h"
#include "ui/words/display_units.h"

#include <QWidget>

#include <optional>
#include <vector>

class QLabel;
class QTableWidget;

namespace vybeg::ui {

// Readings of one run at the cursors A and B: values, their difference, the trend between them
// (core/track/trend.h), decay time and drift. Hidden without a cursor.
class MeasurePanel : public QWidget {
    Q_OBJECT

public:
    explicit MeasurePanel(Document& document, QWidget* parent = nullptr);

    void setRun(int id);
    void setCursors(std::optional<double> a_s, std::optional<double> b_s);
    void setUnits(const DisplayUnits& units);
    // What is shown as tab-separated text, numbers as in CursorPanel::tableText(); empty without a
    // cursor.
    QString tableText() const;

signals:
    // Trends to draw over the plots; empty without two cursors.
    void trendsChanged(const std::vector<TrendCurve>& trends);

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    void showTable(const Analysis& analysis);
    void showSentences(const Analysis& analysis);
    std::vector<TrendCurve> curves(const Analysis& analysis) const;
    const Analysis* analysis() const;

    Document& document_;
    QLabel* times_;
    QTableWidget* table_;
    QLabel* sentences_;
    int run_ = 0;
    std::optional<double> a_s_;
    std::optional<double> b_s_;
    DisplayUnits units_;
};

}  // namespace vybeg::ui
