#pragma once

#include <QString>

class QAction;
class QWidget;

namespace vybeg::ui {

class Document;

// Program, libraries, platform and numbers of recordings and analyses, for a report of a fault:
// English whatever the interface's language, as those who mend the program read it.
QString diagnosticsOf(const Document& document, const QString& language, bool dark, double scale);

// `copy_diagnostics` has a button in it.
void showAbout(QWidget* window, QAction* copy_diagnostics);

}  // namespace vybeg::ui
