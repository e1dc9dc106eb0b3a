#pragma once

#include "tests/ui/gui_test.h"

#include <QStringList>

namespace vybeg::ui {

// What the recordings below are decays of.
struct TestResonator {
    double split_hz = 0.01;
    double theta_w = 0.2;
    double tau_s = 40;
    double kappa = 1;
    double delay_d_s = 0;
    double offset_c = 0;
};

// Four runs of 4 s at 8000 Hz (carrier 1000 Hz, amplitude 1, noise 1e-3) of one resonator, started
// at theta_A = 0, 22.5, 45, 67.5 degrees; WAV files named by `prefix` and the angle.
QStringList resonatorRuns(const GuiTestHome& home, const QString& prefix,
                          const TestResonator& resonator = {});

}  // namespace vybeg::ui
