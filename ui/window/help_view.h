#pragma once

#include <QTextBrowser>
#include <QWidget>

class QAction;

namespace vybeg::ui {

// The help in the interface's language, in a window of its own. Alt+Left and Alt+Right go through
// the pages visited.
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

    QTextBrowser* browser_;
    QAction* back_;
    QAction* forward_;
    QAction* home_;
    QString language_;
};

}  // namespace vybeg::ui
