#pragma once

#include "ui/plots/plot_file.h"
#include "ui/widgets/theme.h"
#include "ui/words/display_units.h"

#include <QWidget>

#include <vector>

namespace vybeg::ui {

class XYPlotView;

// A page of the window: plots, and numbers beside them.
class MeasuredPage : public QWidget {
    Q_OBJECT

public:
    explicit MeasuredPage(QWidget* parent);

    virtual FigureSource figures() const = 0;
    virtual void setTheme(const Theme& theme);
    virtual void setUnits(const DisplayUnits& units);

signals:
    void exportWanted(const Figure& figure);
    void figuresChanged();  // figures() are others, or there are some now

protected:
    const Theme& theme() const { return theme_; }
    const DisplayUnits& units() const { return units_; }
    // Theme or units are others.
    virtual void showAgain() {}
    // A plot of at least that height, pixels, in the page's theme; its export is exportWanted().
    XYPlotView* addPlot(const char* name, int least_height);
    // The texts of the page in the language of the window.
    virtual void retranslate() {}

private:
    Theme theme_ = lightTheme();
    DisplayUnits units_;
    std::vector<XYPlotView*> plots_;
};

}  // namespace vybeg::ui
