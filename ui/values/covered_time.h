#pragma once

#include "core/analysis/analysis.h"

namespace vybeg::ui {

// Whether the windows of an analysis reach this time: at most a window's length before the first
// centre or behind the last one. A single window counts as everywhere.
bool covers(const Analysis& analysis, double time_s);

}  // namespace vybeg::ui
