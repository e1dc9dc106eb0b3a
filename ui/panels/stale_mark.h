#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace vybeg::ui {

class Document;

// A line at the plots: they are older than the analysis panel, with the differences and a button to
// analyse again. Hidden if a visible analysis of the current recording has the settings of the
// panel or is being computed by Live.
class StaleMark : public QWidget {
    Q_OBJECT

public:
    explicit StaleMark(const Document& document, QWidget* parent = nullptr);

    QString text() const;

signals:
    void analyseWanted();

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();

    const Document& document_;
    QLabel* text_;
    QPushButton* analyse_;
};

}  // namespace vybeg::ui
