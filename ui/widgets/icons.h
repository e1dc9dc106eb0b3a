#pragma once

#include <QIcon>
#include <QString>

class QPalette;

namespace vybeg::ui {

// An icon of resources/icons in the text colours of a palette, legible on light and dark.
QIcon themedIcon(const QString& name, const QPalette& palette);

}  // namespace vybeg::ui
