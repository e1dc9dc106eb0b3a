#pragma once

#include "ui/history/history_plots.h"

#include <QString>

namespace vybeg::ui {

// "HRG-17, 2026-03-31, set A: τ = 21.3(1) s; f = 5300.1 Hz; 22.5 °C; outside the limits, above".
QString pointText(const StoredHistory& history, const HistoryCharts& charts,
                  const HistoryView& view, std::size_t point);

// What the charts say: which results lie outside, and what is missing for an answer.
QString verdictText(const StoredHistory& history, const HistoryCharts& charts,
                    const HistoryView& view, std::size_t baseline);

}  // namespace vybeg::ui
