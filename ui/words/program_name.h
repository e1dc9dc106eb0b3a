#pragma once

#include <QString>

namespace vybeg::ui {

// The program as files name what wrote them, e.g. "vybeg 0.1.0".
QString programName();

}  // namespace vybeg::ui
