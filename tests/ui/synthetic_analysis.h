#pragma once

#include "ui/values/shown_analysis.h"

namespace vybeg::ui {

// A free decay as an analysis of `window` samples would see it, without an analysis: smooth slow
// variables with noise and standard deviations that follow the window. 33333 Hz, 5300 Hz.
struct SyntheticAnalysis {
    double seconds = 28;
    int window = 60;
    double noise = 1e-3;
    unsigned seed = 1;
    bool no_quadrature = false;
    double gap_from_s = 0;  // windows without a value; empty range: none
    double gap_to_s = 0;
};

ShownAnalysis syntheticAnalysis(int index, const SyntheticAnalysis& what);

}  // namespace vybeg::ui
