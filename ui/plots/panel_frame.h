#pragma once

#include "ui/plots/axis_ticks.h"
#include "ui/widgets/theme.h"

#include <qcustomplot.h>

#include <functional>
#include <utility>
#include <vector>

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

    // Widths of the texts that share the labels' room, for the ticks of the coming layout: lines
    // from the top of a vertical axis, or one at the end of a horizontal one. Labels that would
    // touch them are omitted, and those of a vertical axis that would leave its length.
    using Texts = std::function<std::vector<double>(const AxisTicks&)>;
    void setShared(Texts texts, double room = 0) {
        shared_ = std::move(texts);
        shared_room_ = room;
    }

    // As of the latest layout.
    const AxisTicks& ticks() const { return ticks_; }

    void generate(const QCPRange& range, const QLocale& locale, QChar formatChar, int precision,
                  QVector<double>& ticks, QVector<double>* subTicks,
                  QVector<QString>* tickLabels) override;

private:
    void omitLabels(const AxisRange& range, QVector<QString>& labels) const;

    Qt::Orientation orientation_;
    double length_ = 100;
    double beyond_ = 0;
    QFont font_;
    TickSteps steps_ = TickSteps::decimal;
    bool logarithmic_ = false;
    Texts shared_;
    double shared_room_ = 0;  // beside a vertical axis
    AxisTicks ticks_;
};

// A full frame with ticks at the left and bottom only, on the layers of preparePlot(). Labels under
// the frame lie outside its margins.
void addFrame(QCPAxisRect& panel, const QSharedPointer<PanelTicker>& x,
              const QSharedPointer<PanelTicker>& y);

void setFrameLook(QCPAxisRect& panel, const Theme& theme, const QFont& tick_font);

// The font of tick labels beside texts of a font.
QFont tickFont(const QFont& font);

}  // namespace vybeg::ui
