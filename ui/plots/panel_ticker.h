#pragma once

#include "ui/plots/axis_ticks.h"

#include <qcustomplot.h>

namespace vybeg::ui {

// Passes the ticks of axis_ticks.h to a QCPAxis. Precondition of each layout: setRoom() with the
// length and font of the axis.
class PanelTicker : public QCPAxisTicker {
public:
    explicit PanelTicker(Qt::Orientation orientation) : orientation_(orientation) {}

    // `beyond`: pixels after the upper end of a horizontal axis that a label may use.
    void setRoom(double length, const QFont& font, double beyond = 0);
    void setSteps(TickSteps steps) { steps_ = steps; }
    void setLogarithmic(bool logarithmic) { logarithmic_ = logarithmic; }

    // As of the latest layout.
    const AxisTicks& ticks() const { return ticks_; }

    void generate(const QCPRange& range, const QLocale& locale, QChar formatChar, int precision,
                  QVector<double>& ticks, QVector<double>* subTicks,
                  QVector<QString>* tickLabels) override;

private:
    Qt::Orientation orientation_;
    double length_ = 100;
    double beyond_ = 0;
    QFont font_;
    TickSteps steps_ = TickSteps::decimal;
    bool logarithmic_ = false;
    AxisTicks ticks_;
};

}  // namespace vybeg::ui
