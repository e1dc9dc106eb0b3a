#pragma once

class QWidget;

namespace vybeg::ui {

// From here on the wheel over a choice or a spin box inside `panel` changes it only while it has
// the focus, and else scrolls what it stands in.
void guardFromWheel(QWidget& panel);

}  // namespace vybeg::ui
