#pragma once

#include "ui/plots/plot_file.h"

#include <QDialog>

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace vybeg::ui {

class NumberField;

// Asks which plots make a figure, its size on paper, its resolution and its caption, and shows it.
class ExportDialog : public QDialog {
    Q_OBJECT

public:
    explicit ExportDialog(FigureSource source, QWidget* parent = nullptr);

    // The figure as chosen, with its caption.
    Figure figure() const;
    Paper paper() const;

signals:
    void saveWanted();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    std::vector<int> chosen() const;
    QString shownSettings() const;  // below the plots
    // The size that the chosen plots propose.
    void propose();
    void refresh();
    double leastHeightMm() const;
    // Why no figure can be made; empty: it can.
    QString fault() const;

    FigureSource source_;
    QLabel* preview_;
    std::vector<QCheckBox*> plots_;
    NumberField* width_mm_;
    NumberField* height_mm_;
    NumberField* dpi_;
    QLineEdit* title_;
    QCheckBox* settings_;
    QPushButton* copy_;
    QPushButton* save_;
};

}  // namespace vybeg::ui
