#pragma once

#include <QCoreApplication>
#include <QString>

namespace vybeg::ui {

// The program as files name what wrote them, e.g. "vybeg 0.1.0".
inline QString programName() {
    return QStringLiteral("vybeg ") + QCoreApplication::applicationVersion();
}

}  // namespace vybeg::ui
