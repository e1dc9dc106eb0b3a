#pragma once

#include <functional>

class QWidget;

namespace vybeg::ui {

// Sets the texts of a widget by `translate`: now, and again in each further language.
void keepTranslated(QWidget& widget, std::function<void()> translate);

}  // namespace vybeg::ui
