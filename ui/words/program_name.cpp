#include "ui/words/program_name.h"

#include <QCoreApplication>

namespace vybeg::ui {

QString programName() {
    return QStringLiteral("vybeg ") + QCoreApplication::applicationVersion();
}

}  // namespace vybeg::ui
