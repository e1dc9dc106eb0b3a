#pragma once

#include "core/analysis/measurement_list.h"

#include <QStringList>

namespace vybeg::ui {

// What a measurement list tells of a recording, a line each: "gyro: G7", "bias: 100 V", ...
QStringList conditionsText(const RecordingRef& recording);

}  // namespace vybeg::ui
