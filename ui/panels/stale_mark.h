#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace vybeg::ui {

class Document;

// A line at the plots that says that they are older than the analysis panel, and in what, with the
// button that mends it. It hides itself where an analysis of the current recording that is shown
// has the settings of the panel, or such a one is being computed for Live.
class StaleMark : public QWidget {
    Q_OBJECT

public:
    explicit StaleMark(const Document& document, QWidget* parent = nullptr);

    QString text() const;

signals:
    void runWanted();

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();

    const Document& document_;
    QLabel* text_;
    QPushButton* run_;
};

}  // namespace vybeg::ui
