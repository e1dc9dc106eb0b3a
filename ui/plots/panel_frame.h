#pragma once

#include "ui/plots/panel_ticker.h"
#include "ui/widgets/theme.h"

#include <qcustomplot.h>

namespace vybeg::ui {

// A full frame with ticks at the left and bottom only, on the layers of preparePlot(). Labels under
// the frame lie outside its margins.
void addFrame(QCPAxisRect& panel, const QSharedPointer<PanelTicker>& x,
              const QSharedPointer<PanelTicker>& y);

void setFrameLook(QCPAxisRect& panel, const Theme& theme, const QFont& tick_font);

// The font of tick labels beside texts of a font.
QFont tickFont(const QFont& font);

}  // namespace vybeg::ui
