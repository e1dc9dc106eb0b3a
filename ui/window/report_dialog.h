#pragma once

#include "ui/report/document_report.h"

#include <QDialog>

#include <array>
#include <vector>

class QCheckBox;
class QComboBox;
class QLineEdit;

namespace vybeg::ui {

// Asks what a report is about and for its title block. Gyro, operator and comment are those that a
// measurement list tells, otherwise those of the session's dossier, which takes what is typed here;
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
