#pragma once

#include "core/estimators/wave/estimator.h"

#include <QString>

namespace vybeg::ui {

// In the interface's language: the algorithm's name with its number, e.g. "4 Demodulation", and a
// sentence about it.
QString algorithmText(Algorithm algorithm);
QString algorithmTip(Algorithm algorithm);

}  // namespace vybeg::ui
