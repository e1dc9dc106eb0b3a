#pragma once

#include "ui/document/analysis_job.h"

#include <QDialog>
#include <QPointer>

class QDialogButtonBox;
class QLabel;

namespace vybeg::ui {

class ImportFields;
class ImportPreview;

// How to read a file that does not tell all by itself, with what comes of it beside the choices.
// Starts with what was chosen last for a file of this kind where nothing is said. Does not block
// the window; previews are made in the background.
class ImportDialog : public QDialog {
    Q_OBJECT

public:
    // `job` must outlive the dialog; of one job only one dialog may be open.
    ImportDialog(AnalysisJob& job, const QString& path, const OpenOptions& options,
                 QWidget* parent = nullptr);
    ~ImportDialog() override;

    OpenOptions options() const;

signals:
    void chosen(const QString& path, const OpenOptions& options);

public slots:
    // Remembers the choices for files of the kind and emits chosen().
    void accept() override;

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    void take(const Result<RecordingPreview>& result);
    // Better start values, once the file is known; nothing where these stay.
    std::optional<OpenOptions> proposal(const RecordingPreview& preview);
    void enableOpen();
    void retranslate();

    QPointer<AnalysisJob> job_;  // gone before the dialog where the window closes
    QString path_;
    bool proposed_ = false;                    // for the file as it was given
    bool shown_ = false;                       // a preview has been
    bool raw_proposed_ = false;                // for its first reading as raw samples
    OpenOptions asked_;                        // what the latest preview is, or will be, of
    std::optional<RecordingPreview> preview_;  // of the options as they stand
    QLabel* title_;
    ImportFields* fields_;
    ImportPreview* view_;
    QDialogButtonBox* buttons_;
};

}  // namespace vybeg::ui
