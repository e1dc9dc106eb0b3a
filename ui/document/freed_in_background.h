#pragma once

#include <QThreadPool>

#include <memory>
#include <utility>

namespace vybeg::ui {

// The threads that free memory; not the global pool, because Qt draws with that.
QThreadPool& freeingPool();

// Gives the memory of a long recording's results back in the background: that takes longer than the
// window may stand still.
template <class Value>
std::shared_ptr<const Value> freedInBackground(std::shared_ptr<const Value> value) {
    const Value* place = value.get();
    return {place, [value = std::move(value)](const Value*) mutable {
                freeingPool().start([value = std::move(value)] {});
            }};
}

}  // namespace vybeg::ui
