#pragma once

#include <QTimer>
#include <QWidget>

#include <functional>

class QLabel;
class QProgressBar;
class QPushButton;

namespace vybeg::ui {

class Document;

// The status bar: news that need no answer, how the last analysis ended, or the progress of the one
// under way, with the button that stops it. Over a page that owns the window it is shown only while
// it has news.
class StatusLine : public QWidget {
    Q_OBJECT

public:
    explicit StatusLine(Document& document, QWidget* parent = nullptr);

    QString text() const;
    void cancel();
    // So wide is the progress at its right.
    int progressWidth() const;
    // Over the lower edge of `page`, its parent from now on; null: in its row, which holds it.
    void floatOver(QWidget* page);

signals:
    void progressPlaced();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void tell(std::function<QString()> text);
    void whenBusyChanged();
    void refresh();
    void place();
    void retranslate();

    Document& document_;
    QLabel* status_;
    QLabel* time_left_;
    QProgressBar* progress_;
    QPushButton* cancel_;
    std::function<QString()> text_;  // a function, so that a change of language reaches it
    QTimer wait_;                    // what takes less than this shows no progress
    QTimer news_;                    // runs while the text is new
    bool floats_ = false;
    bool was_busy_ = false;
    bool analysing_ = false;  // is what the text says
    bool cancelled_ = false;
};

}  // namespace vybeg::ui
