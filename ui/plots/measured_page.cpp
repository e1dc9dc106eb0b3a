#include "ui/plots/measured_page.h"

#include "ui/plots/xy_plot_view.h"
#include "ui/widgets/page_parts.h"

namespace vybeg::ui {

MeasuredPage::MeasuredPage(QWidget* parent) : QWidget(parent) {
    whenChanged(*this, {QEvent::LanguageChange}, [this] { retranslate(); });
}

void MeasuredPage::setTheme(const Theme& theme) {
    theme_ = theme;
    for (XYPlotView* plot : plots_) {
        plot->setTheme(theme);
    }
    showAgain();
}

void MeasuredPage::setUnits(const DisplayUnits& units) {
    units_ = units;
    showAgain();
}

XYPlotView* MeasuredPage::addPlot(const char* name, int least_height) {
    constexpr int least_width = 180;
    auto* plot = withName(new XYPlotView(this), name);
    plot->setMinimumSize(least_width, least_height);
    plot->setMaximumHeight(QWIDGETSIZE_MAX);
    connect(plot, &XYPlotView::exportWanted, this, &MeasuredPage::exportWanted);
    plots_.push_back(plot);
    return plot;
}

}  // namespace vybeg::ui

#include "moc_measured_page.cpp"
