#pragma once

#include "core/analysis/log_look.h"
#include "core/analysis/measurement_list.h"
#include "ui/document/background_jobs.h"
#include "ui/panels/file_list.h"

#include <QPointer>
#include <QStringList>

#include <span>
#include <vector>

namespace vybeg::ui {

// The logs of the dialog, and what each is seen to hold: looked at in the background.
class LogFiles : public FileList {
    Q_OBJECT

public:
    struct Looked {
        LogLook look;
        bool readable = true;  // otherwise look.problem is why
    };

    // `job` must outlive the list; of one job only one list may be there.
    LogFiles(BackgroundJobs& job, const QStringList& files, QWidget* parent);
    ~LogFiles() override;

    const QStringList& files() const { return files_; }
    // Looks at all files anew, with the given choices.
    void look(const OpenOptions& options, const LogChoice& given);
    // Of the files; empty: still looking.
    const std::vector<Looked>& looks() const { return looks_; }
    // The first that shows its kind; the first one that can be read where none does, or the first
    // one. Null: still looking.
    const Looked* sound() const;
    // Of the chosen file, otherwise sound().
    const Looked* chosen() const;
    // Whether one of the files is found to be so.
    bool any(bool LogLook::*found) const;
    bool isOfOneChannel(const QString& file) const;
    qsizetype ofOneChannel() const;
    // The file of channel D by their names: of one file any beside it. Empty: the names do not say.
    QString partner() const;

    void add(const QStringList& files);
    // Each file with its channel, where it has one, or that it cannot be opened.
    void show(std::span<const RecordingRef> logs);

signals:
    void changed();  // other files
    void looked();

private:
    void remove(const QStringList& files);

    QPointer<BackgroundJobs> job_;  // may be destroyed before the dialog when the window closes
    QStringList files_;
    std::vector<Looked> looks_;
};

}  // namespace vybeg::ui
