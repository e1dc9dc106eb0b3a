#include "ui/document/freed_in_background.h"

namespace vybeg::ui {

QThreadPool& freeingPool() {
    static QThreadPool pool;
    return pool;
}

}  // namespace vybeg::ui
