#pragma once

#include "ui/plots/plot_file.h"
#include "ui/report/report_content.h"

#include <QDialog>

#include <array>
#include <vector>

class QCheckBox;
class QComboBox;
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

// Asks what a report is about and for its title block. Gyro, operator and comment are those of a
// measurement list, otherwise those of the session's dossier, which takes the texts typed here;
// the instrument is the last one.
class ReportDialog : public QDialog {
    Q_OBJECT

public:
    // `of_set`: proposes the current set rather than the current recording. Precondition: the
    // document has a subject of a report.
    ReportDialog(Document& document, bool of_set, QWidget* parent = nullptr);

    const ReportSubject& subject() const;
    std::vector<ReportContent> contents() const;

signals:
    void saveWanted();

private:
    void propose();
    ReportTitle typed() const;
    void keep();

    Document& document_;
    std::vector<ReportSubject> subjects_;
    ReportTitle proposed_;
    QComboBox* subject_;
    std::array<QLineEdit*, title_fields.size()> fields_;
    QCheckBox* summary_;
    QCheckBox* all_plots_;
};

}  // namespace vybeg::ui
