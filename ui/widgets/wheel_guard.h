#pragma once

class QWidget;

namespace vybeg::ui {

// After this call the wheel over a combo or spin box inside `panel` changes it only if it has the
// focus, and otherwise scrolls the area around it.
void guardFromWheel(QWidget& panel);

}  // namespace vybeg::ui
