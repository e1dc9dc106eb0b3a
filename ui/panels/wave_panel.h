#pragma once

#include "ui/document/document.h"
#include "ui/plots/plot_file.h"
#include "ui/widgets/theme.h"

#include <QWidget>

#include <optional>

class QLabel;

namespace vybeg::ui {

class RoundView;

// The waves of every visible analysis at the tracker as figures: amplitude against the angle on the
// rim, and D against C over one period.
class WavePanel : public QWidget {
    Q_OBJECT

public:
    explicit WavePanel(Document& document, QWidget* parent = nullptr);

    // Analyses unlike the chosen one are not drawn over it.
    void setAnalysis(AnalysisId id);
    void setTime(std::optional<double> time_s);

signals:
    void exportWanted(const Figure& figure);

private:
    void refresh();
    void retranslate();

    Document& document_;
    QLabel* time_;
    RoundView* pattern_;
    RoundView* ellipse_;
    std::optional<double> time_s_;
    AnalysisId chosen_ = AnalysisId::none;
};

}  // namespace vybeg::ui
