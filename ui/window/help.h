#pragma once

#include <QString>
#include <QTextBrowser>
#include <QWidget>

class QAction;
class QLineEdit;

namespace vybeg::ui {

class Document;

// The help in the interface's language, in a window of its own. Alt+Left and Alt+Right go through
// the pages visited; the field finds its text on this page and then on the others.
class HelpView : public QWidget {
    Q_OBJECT

public:
    // `language` is "en" or "ru".
    explicit HelpView(const QString& language, QWidget* parent = nullptr);

    // Shows the page that is open in another language, or the first page where it has none there.
    void setLanguage(const QString& language);
    const QTextBrowser& browser() const { return *browser_; }

private:
    void retranslate();
    void findNext();

    QTextBrowser* browser_;
    QAction* back_;
    QAction* forward_;
    QAction* home_;
    QLineEdit* wanted_;
    QString language_;
};

// Program, libraries, platform and numbers of recordings and analyses, for a report of a fault:
// English whatever the interface's language, as those who mend the program read it.
QString diagnosticsOf(const Document& document, const QString& language, bool dark, double scale);

// `copy_diagnostics` has a button in it.
void showAbout(QWidget* window, QAction* copy_diagnostics);

}  // namespace vybeg::ui
