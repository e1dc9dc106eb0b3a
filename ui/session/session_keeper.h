#pragma once

#include "core/base/result.h"
#include "ui/document/document.h"
#include "ui/session/session.h"
#include "ui/session/session_writer.h"
#include "ui/values/ids.h"

#include <QJsonObject>
#include <QObject>
#include <QString>
#include <QStringList>

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vybeg::ui {

// The session of the window and its file: opens, saves and backs it up.
class SessionKeeper : public QObject {
    Q_OBJECT

public:
    SessionKeeper(Document& document, TrackView& tracks, QObject* parent = nullptr);

    static bool isSession(const QString& path);

    // Recordings, measurement lists and sessions; a session takes the place of everything open.
    void open(const QStringList& paths, const OpenOptions& options = {});
    // Errors are reported; false: the session is not opened.
    bool openSession(const QString& path);
    // In the background; `then` after it has succeeded.
    void save(const QString& path, std::function<void()> then = {});
    // Whether a session that is to be saved is not in its file yet.
    bool isSaving() const { return writer_.busy(); }
    QString path() const { return path_; }
    // Whether the session's file is not as it was opened or saved here.
    bool isChangedElsewhere() const;
    // The analysis that the window's panels show.
    void setCurrentAnalysis(AnalysisId id) { current_analysis_ = id; }
    // Adds to a view what the window alone knows of it: page and trend.
    void setViewSource(std::function<void(SessionView&)> add) { add_to_view_ = std::move(add); }
    // Whether closing loses something: changes of a saved session; without a file, changed settings
    // or sets.
    bool isModified() const;
    // Until the recordings of the session that was opened last are read and analysed.
    bool isOpening() const { return opening_; }
    // Offers the sessions of programs that did not end as they should.
    void offerAbandoned(qsizetype place = 0);
    // Name of a set of the session that was opened last of which a recording is not there, or
    // cannot be read; none: all are complete.
    std::optional<QString> lackingSet() const;
    // Opens a recording that was not found in the place of one of the session.
    void supply(std::size_t absent, const QString& path);
    // The window closes: waits for the save under way; the backup is not needed any more.
    void end();

signals:
    // No session waits to be saved any more, whether its file was written or not.
    void saveEnded();
    void pathChanged();
    void unitsWanted(const DisplayUnits& units);
    void viewRestored(const SessionView& view);
    void analysisWanted(AnalysisId id);
    void fileWanted(std::size_t absent, const QString& name);

private:
    // The session with the absent recordings.
    Session present() const;
    // What saving keeps from a change: the session without its view and hashes.
    QJsonObject content() const;
    QJsonObject backup() const;
    // Whether all recordings of a set are there and open.
    bool isComplete(const RecordingSet& set) const;
    void begin(Session session);
    void keepAbsent(Session& session);
    void finishWhenComputed();
    void compareHash(RecordingId recording_id);
    void compareHashesOfLogs();
    void warnOfOtherFile(const QString& path);
    void warn(std::function<QString()> text);
    void fail(std::function<QString()> text);

    Document& document_;
    TrackView& tracks_;
    SessionBackup backup_;
    QString path_;
    QJsonObject unknown_;
    QByteArray in_file_;  // digest of the file as it was opened or saved here
    AnalysisId current_analysis_ = AnalysisId::none;
    std::function<void(SessionView&)> add_to_view_ = [](SessionView&) {};
    QJsonObject saved_;  // content() when it was saved or opened
    // Recordings of the session that are not where they were, under negative ids. Without a path:
    // it is found.
    std::vector<ClosedRecording> absent_;
    // Recordings as the session states them; without a hash: it is compared.
    std::map<RecordingId, ClosedRecording> stated_;
    std::map<std::filesystem::path, std::string> hashes_of_logs_;  // that it states, by path
    // Until the session that is being opened is computed.
    bool opening_ = false;
    Session wanted_;
    std::vector<RecordingId> wanted_ids_;
    bool recovered_ = false;  // from a copy, and not saved since
    SessionWriter writer_;
};

}  // namespace vybeg::ui
