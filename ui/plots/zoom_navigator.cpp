#include "ui/plots/zoom_navigator.h"

#include <QKeyEvent>

#include <utility>

namespace vybeg::ui {
namespace {

// Longest pause between steps of one entry of the zoom history.
constexpr int gesture_pause_ms = 600;
// Longest useful history; its memory is negligible.
constexpr std::size_t longest = 200;

}  // namespace

ZoomNavigator::ZoomNavigator(std::function<ZoomState(ZoomState)> clipped, QObject* parent)
    : QObject(parent), clipped_(std::move(clipped)) {
    pause_.setSingleShot(true);
    pause_.setInterval(gesture_pause_ms);
}

void ZoomNavigator::announce() {
    emit moved();
    emit historyChanged();
}

void ZoomNavigator::visit(ZoomState state, Gesture gesture) {
    state = clipped_(std::move(state));
    if (state == current()) {
        return;
    }
    const bool same = gesture != Gesture::none && gesture == gesture_ && pause_.isActive();
    gesture_ = gesture;
    pause_.start();
    goTo(std::move(state), same);
}

void ZoomNavigator::goTo(ZoomState state, bool same_entry) {
    if (state != current()) {
        states_.resize(position_ + 1);
        if (same_entry) {
            states_.pop_back();
        } else if (states_.size() == longest) {
            states_.erase(states_.begin());
        }
        states_.push_back(std::move(state));
        position_ = states_.size() - 1;
    }
    announce();
}

void ZoomNavigator::restart(const ZoomState& state) {
    states_ = {state};
    position_ = 0;
    announce();
}

void ZoomNavigator::back() {
    if (canBack()) {
        endGesture();
        --position_;
        announce();
    }
}

void ZoomNavigator::forward() {
    if (canForward()) {
        endGesture();
        ++position_;
        announce();
    }
}

void ZoomNavigator::zoomTime(double factor, double about_s, Gesture gesture) {
    ZoomState state = current();
    const AxisRange old = state.time;
    state.time = {about_s + factor * (old.lower - about_s),
                  about_s + factor * (old.upper - about_s)};
    visit(std::move(state), gesture);
}

void ZoomNavigator::panTime(double fraction) {
    ZoomState state = current();
    const double step = fraction * state.time.span();
    state.time = {state.time.lower + step, state.time.upper + step};
    visit(std::move(state), Gesture::key_time);
}

bool ZoomNavigator::takeKey(const QKeyEvent& event) {
    const bool history = event.modifiers() & Qt::AltModifier;
    switch (event.key()) {
        case Qt::Key_R: back(); return true;
        case Qt::Key_Left: history ? back() : panTime(-arrow); return true;
        case Qt::Key_Right: history ? forward() : panTime(arrow); return true;
        default: return false;
    }
}

void ZoomNavigator::follow(const AxisRange& before, const AxisRange& now) {
    const AxisRange& shown = current().time;
    if (before != now && (shown == before || shown.lower >= now.upper || shown.upper > now.upper)) {
        restart({now, {}});
    }
}

}  // namespace vybeg::ui
