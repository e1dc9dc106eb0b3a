#pragma once

#include "ui/plots/figure.h"

#include <QDialog>

#include <cstdint>
#include <vector>

class QDialogButtonBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QScrollArea;

namespace vybeg::ui {

class PictureView;

// "Compare windows": a list of window lengths, and the article's figure of them, one column per
// length, to look at and to export. Does not block the window.
class CompareDialog : public QDialog {
    Q_OBJECT

public:
    explicit CompareDialog(QWidget* parent = nullptr);

    // Lengths in samples as typed; empty where the text is no list of whole numbers from 5.
    std::vector<std::int64_t> lengths() const;
    void setLengths(const QString& text);
    void setBusy(bool busy);
    void showFigure(std::vector<FigureColumn> columns, const FigureOptions& options);
    const std::vector<FigureColumn>& columns() const { return columns_; }

signals:
    void compareWanted(const std::vector<std::int64_t>& lengths);
    void exportWanted();

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void refreshButtons();

    QLabel* label_;
    QLineEdit* list_;
    QPushButton* compare_;
    QPushButton* export_;
    QLabel* hint_;
    PictureView* figure_;
    std::vector<FigureColumn> columns_;
    bool busy_ = false;
};

// "6, 60" as numbers: commas, semicolons and spaces separate.
std::vector<std::int64_t> readLengths(const QString& text);

}  // namespace vybeg::ui
