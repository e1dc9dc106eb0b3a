#pragma once

#include "ui/document/document.h"
#include "ui/words/display_units.h"

#include <QWidget>

#include <optional>

class QLabel;
class QTableWidget;

namespace vybeg::ui {

// The values of every visible analysis at the tracker, with their standard deviations.
class CursorPanel : public QWidget {
    Q_OBJECT

public:
    explicit CursorPanel(Document& document, QWidget* parent = nullptr);

    void setTime(std::optional<double> time_s);
    void setUnits(const DisplayUnits& units);
    // The table as tab-separated text: value and standard deviation of an analysis in separate
    // columns, in displayed units, with the decimal sign of the interface's language.
    QString tableText() const;

    QSize sizeHint() const override { return {260, 300}; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    // Time of the tracker, or of the first window before the mouse enters the plots.
    double shownTime(const ShownAnalysis& first) const;
    void retranslate();

    Document& document_;
    QLabel* time_;
    QTableWidget* table_;
    std::optional<double> time_s_;
    DisplayUnits units_;
};

}  // namespace vybeg::ui
