#pragma once

#include "ui/values/zoom_state.h"

#include <QObject>
#include <QTimer>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

class QKeyEvent;

namespace vybeg::ui {

// Kind of input of one entry of the zoom history; `none` is an entry of its own.
enum class Gesture : std::uint8_t {
    none,
    wheel_time,
    wheel_value,
    drag,
    key_time,
    key_value,
    outside
};

// The view that plots show, with its history, as in a browser. Successive steps of one gesture are
// one entry.
class ZoomNavigator : public QObject {
    Q_OBJECT

public:
    // `clipped`: a view limited to what can be shown.
    explicit ZoomNavigator(std::function<ZoomState(ZoomState)> clipped, QObject* parent = nullptr);

    const ZoomState& current() const { return states_[position_]; }
    bool canBack() const { return position_ > 0; }
    bool canForward() const { return position_ + 1 < states_.size(); }

    void visit(ZoomState state, Gesture gesture);
    // Goes there unclipped, and forgets what was forward; with `same_entry` in the place of the
    // current entry.
    void goTo(ZoomState state, bool same_entry);
    void restart(const ZoomState& state);
    void back();
    void forward();
    void zoomTime(double factor, double about_s, Gesture gesture);
    void panTime(double fraction);
    // Keys of the time: R and Alt with an arrow for the history, arrows to pan. Returns whether the
    // key is one of them.
    bool takeKey(const QKeyEvent& event);
    // What can be shown has become another: a view of all of it, and one that lies outside, begin
    // anew.
    void follow(const AxisRange& before, const AxisRange& now);

    static constexpr double notch = 0.8;  // of a range per notch of the wheel or key
    static constexpr double arrow = 0.1;  // of a range per arrow key
    void endGesture() { gesture_ = Gesture::none; }

signals:
    void moved();
    void historyChanged();

private:
    void announce();

    std::function<ZoomState(ZoomState)> clipped_;
    std::vector<ZoomState> states_{ZoomState()};
    std::size_t position_ = 0;
    QTimer pause_;  // active while the next step belongs to the same gesture
    Gesture gesture_ = Gesture::none;
};

}  // namespace vybeg::ui
