#pragma once

#include <QWidget>

class QLabel;
class QListWidget;
class QPushButton;

namespace vybeg::ui {

// What stands in the middle of the window while no recording is open: ways to open one.
class WelcomePage : public QWidget {
    Q_OBJECT

public:
    explicit WelcomePage(QWidget* parent = nullptr);

    // Paths of the last files, the newest first.
    void setRecent(const QStringList& paths);

signals:
    void openWanted();
    void demonstrationWanted();
    void recentChosen(const QString& path);

private:
    void retranslate();

    QLabel* text_;
    QPushButton* open_;
    QPushButton* demonstration_;
    QLabel* recent_name_;
    QListWidget* recent_;
};

}  // namespace vybeg::ui
