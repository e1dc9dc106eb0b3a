#pragma once

#include "ui/values/recording_set.h"
#include "ui/widgets/theme.h"
#include "ui/words/display_units.h"

#include <QWidget>

#include <memory>
#include <utility>

namespace vybeg::ui {

// What a part of the page Resonator shows of an identification.
class OutcomeView : public QWidget {
public:
    using QWidget::QWidget;

    // Null: the set is not identified yet.
    void setOutcome(std::shared_ptr<const ResonatorOutcome> outcome) {
        shown_ = std::move(outcome);
        rebuild();
    }
    void setUnits(const DisplayUnits& units) {
        units_ = units;
        rebuild();
    }
    virtual void setTheme(const Theme& theme) {
        theme_ = theme;
        rebuild();
    }

protected:
    virtual void rebuild() = 0;

    std::shared_ptr<const ResonatorOutcome> shown_;
    DisplayUnits units_;
    Theme theme_ = lightTheme();
};

}  // namespace vybeg::ui
