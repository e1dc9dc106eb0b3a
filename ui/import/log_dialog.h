#pragma once

#include "core/analysis/measurement_list.h"
#include "ui/import/import_fields.h"
#include "ui/import/log_files.h"

#include <QDialog>
#include <QStringList>

#include <set>
#include <span>
#include <vector>

class QDialogButtonBox;
class QLabel;

namespace vybeg::ui {

class ImportPreview;

// Asks what logs are that take the place of recordings: looks at the files in the background and
// shows a field for each fact that they do not hold. The window stays free. Of a set that is there
// it shows the logs and the choices about them.
class LogDialog : public QDialog {
    Q_OBJECT

public:
    // `job` must outlive the dialog; of one job only one dialog may be open.
    // `given`: the set, which may be empty; `paths`: further logs.
    LogDialog(BackgroundJobs& job, const QStringList& paths, MeasurementSet given = {},
              QWidget* parent = nullptr);
    ~LogDialog() override;

    // Further logs of the same resonator, made alike.
    void add(const QStringList& paths) { files_->add(paths); }
    const QStringList& files() const { return files_->files(); }
    // The logs with the choices about them.
    MeasurementSet set() const;

signals:
    void chosen(const vybeg::MeasurementSet& set);
    // As of ImportFields.
    void filesWanted(const vybeg::ui::TakeFiles& take);

public slots:
    void accept() override;

private:
    LogChoice choice() const;
    OpenOptions options() const;
    // Logs of one channel by pairs; empty where one has no partner.
    std::vector<RecordingRef> logs() const;
    // The file of channel D of a file of channel C; empty where none is known.
    QString partnerOf(const QString& file) const;
    bool isOfPhasors() const;
    void look();
    void take();
    void showPreview();
    void showRows();
    // Why the logs cannot be opened yet; empty: they can.
    QString lacking(std::span<const RecordingRef> found) const;
    void refresh();

    // The set's own row of a file of channel C; null: the file is a further one.
    const RecordingRef* givenRow(const QString& file) const;
    void showGiven();
    void showAs(const LogChoice& known);

    const MeasurementSet given_;
    LogFiles* files_;
    LogChoice looked_with_;
    std::set<QComboBox*> by_person_;  // chosen by a person: not set by the files
    bool known_shown_ = false;        // the fields have the findings of the first look
    QFormLayout* form_;
    QComboBox* kind_;
    QLineEdit* columns_;
    QLineEdit* channel_d_;
    QComboBox* angle_unit_;
    NumberField* f_ref_;
    QComboBox* y_sign_;
    QComboBox* amplitude_;
    QComboBox* order_;
    NumberField* bandwidth_;
    NumberField* rate_;
    NumberField* from_;
    QLabel* lacking_;
    ImportPreview* preview_;
    QDialogButtonBox* buttons_;
};

}  // namespace vybeg::ui
