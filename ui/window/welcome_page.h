#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace vybeg::ui {

// What stands in the middle of the window while no recording is open.
class WelcomePage : public QWidget {
    Q_OBJECT

public:
    explicit WelcomePage(QWidget* parent = nullptr);

signals:
    void openWanted();

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();

    QLabel* text_;
    QPushButton* open_;
};

}  // namespace vybeg::ui
