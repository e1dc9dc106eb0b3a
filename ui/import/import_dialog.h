#pragma once

#include "core/recording/open/preview.h"
#include "core/recording/samples/open_options.h"
#include "ui/document/background_jobs.h"
#include "ui/import/import_fields.h"
#include "ui/widgets/theme.h"

#include <QDialog>
#include <QPointer>
#include <QString>
#include <QWidget>

#include <optional>

class QDialogButtonBox;
class QCustomPlot;
class QLabel;
class QTableWidget;

namespace vybeg::ui {

// Beginning of a recording: the first rows as a table, with the columns of C, D and the time
// marked, and the first samples as curves. A problem is shown above.
class ImportPreview : public QWidget {
    Q_OBJECT

public:
    explicit ImportPreview(QWidget* parent = nullptr);

    void setPreview(const RecordingPreview& preview);
    void setError(const Error& error);

private:
    void fillTable();
    QString unitOfSamples() const;
    void drawSamples();
    void applyLook();

    QLabel* what_;  // the format, or the problem
    QTableWidget* table_;
    QCustomPlot* plot_;
    Theme theme_;
    RecordingPreview preview_;
};

// Last import options of each kind of file, stored in QSettings.

// Key of a kind of file: for text the ending, the number of columns and their guessed names; for
// raw samples (`raw`) and all others the ending.
QString importKind(const QString& path, const RecordingPreview& preview, bool raw);

std::optional<OpenOptions> rememberedImport(const QString& kind);

// Stores the options; keeps the last 50 kinds.
void rememberImport(const QString& kind, const OpenOptions& options);

// Options for reading a file with incomplete information, with a preview. Without given options it
// starts with the last choices for files of this kind. Does not block the window; previews are
// computed in the background.
class ImportDialog : public QDialog {
    Q_OBJECT

public:
    // `job` must outlive the dialog; of one job only one dialog may be open.
    ImportDialog(BackgroundJobs& job, const QString& path, const OpenOptions& options,
                 QWidget* parent = nullptr);
    ~ImportDialog() override;

    OpenOptions options() const;

signals:
    void chosen(const QString& path, const OpenOptions& options);
    // As of ImportFields.
    void filesWanted(const vybeg::ui::TakeFiles& take);

public slots:
    // Remembers the choices for files of the kind and emits chosen().
    void accept() override;

private:
    void refresh();
    void take(const Result<RecordingPreview>& result);
    // Better start values from the preview; empty if none.
    std::optional<OpenOptions> proposal(const RecordingPreview& preview);
    void enableOpen();

    QPointer<BackgroundJobs> job_;  // may be destroyed before the dialog when the window closes
    QString path_;
    bool proposed_ = false;      // start values for the given file were set
    bool shown_ = false;         // a preview was shown
    bool raw_proposed_ = false;  // start values for the first reading as raw samples were set
    OpenOptions asked_;          // options of the latest requested preview
    std::optional<RecordingPreview> preview_;  // of the present options
    ImportFields* fields_;
    ImportPreview* view_;
    QDialogButtonBox* buttons_;
};

}  // namespace vybeg::ui
