#pragma once

#include "core/track/track.h"

#include <QDialog>

class QLabel;
class QPushButton;

namespace vybeg::ui {

class NumberField;
class TrackView;

// Asks for the limits of the value axis of one plot of the tracks, displayed units: an empty field
// leaves that end to the data.
class AxisLimitsDialog : public QDialog {
    Q_OBJECT

public:
    AxisLimitsDialog(TrackView& tracks, SlowVariable variable, QWidget* parent);

private:
    void check();
    void apply();

    TrackView& tracks_;
    SlowVariable variable_;
    NumberField* lower_;
    NumberField* upper_;
    QLabel* fault_;
    QPushButton* ok_;
};

// Of the chosen plot; nothing without one.
void askForAxisLimits(TrackView& tracks, QWidget* window);

}  // namespace vybeg::ui
