#pragma once

#include "ui/panels/measuring.h"
#include "ui/plots/track_view.h"
#include "ui/values/zoom_state.h"
#include "ui/words/display_units.h"

#include <QJsonObject>
#include <QString>

#include <array>
#include <optional>
#include <vector>

namespace vybeg::ui {

// What the plots show.
struct SessionView {
    ZoomState zoom;
    std::vector<SlowVariable> variables;
    DisplayUnits units;
    std::array<std::optional<double>, 2> cursors_s;  // A and B
    TrendKind trend = TrendKind::line;               // between them
    QString page;                                    // its word, pageWord(); empty: any
};

// What the plots of a session show; for the end of the computations, because plots begin with the
// whole range of each recording that joins.
void restoreView(const SessionView& view, TrackView& tracks);

// What the plots of a session show. Values that are missing or out of their range keep their
// defaults.
QJsonObject viewToJson(const SessionView& view);
SessionView viewFromJson(const QJsonObject& json);

}  // namespace vybeg::ui
