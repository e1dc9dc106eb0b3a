#pragma once

#include "core/analysis/measurement_list.h"

#include <QStringList>

namespace vybeg::ui {

// What a measurement list tells of a recording, a line each: "gyro: G7", "bias: 100 V", ...
// `other_columns` as the list's.
QStringList conditionsText(const ListedRecording& recording,
                           const std::vector<std::string>& other_columns);

}  // namespace vybeg::ui
