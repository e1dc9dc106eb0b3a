#pragma once

#include "ui/plots/plot_content.h"
#include "ui/plots/plot_file.h"
#include "ui/plots/plot_panel.h"
#include "ui/plots/time_stack.h"
#include "ui/values/shown_analysis.h"
#include "ui/words/display_units.h"

#include <QString>

#include <vector>

namespace vybeg::ui {

// The plots of the slow variables: part of the track view, its exports and the article's figure. On
// paper with the names of the analyses above, if they are several, or with a title.
class PlotStack : public TimeStack {
public:
    using TimeStack::TimeStack;

    // Instead of the names of the analyses; `name`: literal, before it.
    void setTitle(const QString& title, const QString& name) {
        title_ = title;
        name_ = name;
    }
    // Rebuilds the panels if the variables have changed; sets zoom and value axes.
    void setContent(const PlotContent& content);
    // Sets time and value axes, after prepare(); value axes that are not fixed follow the visible
    // data.
    void setZoom(const ZoomState& zoom);

    void setMarks(const std::vector<double>& times_s);

    const std::vector<PlotPanel*>& panels() const { return panels_; }
    PlotPanel* panel(SlowVariable variable) const;
    // Plot at a position, including its head line.
    PlotPanel* panelAt(const QPointF& position) const;

private:
    void showTitle();
    void showNames(const PlotContent& content);

    QString title_;
    QString name_;
    std::vector<PlotPanel*> panels_;
};

// One column of the article's figure: one window length.
struct FigureColumn {
    QString title;  // e.g. "n = 6"
    ShownAnalysis shown;
};

// The article's figure: a row of panels per variable, whose value axis its columns share for
// comparison of the scatter; a column per window length; one time axis, letters a, b, c ... row by
// row. 420 device-independent pixels per column, 150 per row.
// Needs a QApplication but no window and no display (offscreen platform).
Figure articleFigure(const std::vector<FigureColumn>& columns,
                     const std::vector<SlowVariable>& variables = {SlowVariable::a_A,
                                                                   SlowVariable::a_B,
                                                                   SlowVariable::two_theta_A,
                                                                   SlowVariable::f},
                     const DisplayUnits& units = {});

// Stacked plots on paper: always in the light theme, with the names of several analyses above; as
// wide as a page, each plot as high as in the article's figure. It does not depend on the window.
Figure plotsFigure(const PlotContent& content);

}  // namespace vybeg::ui
