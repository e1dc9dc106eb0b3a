#include "ui/values/zoom_stack.h"

#include <utility>

namespace vybeg::ui {

void ZoomStack::visit(ZoomState state, bool same_gesture) {
    if (state == current()) {
        return;
    }
    states_.resize(position_ + 1);
    if (same_gesture) {
        states_.back() = std::move(state);
        return;
    }
    // Longest useful history; its memory is negligible.
    constexpr std::size_t longest = 200;
    if (states_.size() == longest) {
        states_.erase(states_.begin());
    }
    states_.push_back(std::move(state));
    position_ = states_.size() - 1;
}

void ZoomStack::back() {
    if (canBack()) {
        --position_;
    }
}

void ZoomStack::forward() {
    if (canForward()) {
        ++position_;
    }
}

}  // namespace vybeg::ui
