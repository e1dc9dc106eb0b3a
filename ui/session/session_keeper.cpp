#include "ui/session/session_keeper.h"

#include "core/recording/bytes/file_bytes.h"
#include "core/recording/bytes/sha256.h"
#include "ui/words/error_text.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <memory>
#include <utility>

namespace vybeg::ui {

namespace {

const QString backup_key = QStringLiteral("backup_of");

// What a copy holds, by which its owner knows it.
struct CopyContent {
    QString name;  // of the gyro, else of the session's file, else of its first recording
    int recordings = 0;
    QString written;
};

CopyContent contentOf(const QString& copy) {
    const Result<std::string> text = own_file_text(copy.toStdString());
    const QJsonObject json =
        text ? QJsonDocument::fromJson(QByteArray::fromStdString(*text)).object() : QJsonObject();
    const QJsonArray recordings = json[QLatin1String("recordings")].toArray();
    const QString gyro = json[QLatin1String("gyro")].toObject()[QLatin1String("serial")].toString();
    QString path = json[backup_key].toString();
    if (path.isEmpty()) {
        path = recordings.isEmpty() ? copy : recordings[0][QLatin1String("path")].toString();
    }
    return {gyro.isEmpty() ? QFileInfo(path).completeBaseName() : gyro,
            static_cast<int>(recordings.size()),
            QFileInfo(copy).lastModified().toString("yyyy-MM-dd HH:mm")};
}

// `place`: of the copy among so many, from 0.
QString offerText(const CopyContent& copy, qsizetype place, qsizetype count) {
    return count == 1
               ? SessionKeeper::tr(
                     "A session was not closed, and can be recovered: %1, %n recording(s), %2.",
                     nullptr, copy.recordings)
                     .arg(copy.name, copy.written)
               : SessionKeeper::tr(
                     "Session %1 of %2 that were not closed: %3, %n recording(s), %4.", nullptr,
                     copy.recordings)
                     .arg(place + 1)
                     .arg(count)
                     .arg(copy.name, copy.written);
}

// Of files under another name so much is read, which takes half a second.
constexpr qint64 most_bytes_read = 256'000'000;

// The session's folder and the folders in it.
QList<QDir> foldersOf(const QDir& folder) {
    QList<QDir> folders{folder};
    for (const QString& each : folder.entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name)) {
        folders << QDir(folder.absoluteFilePath(each));
    }
    return folders;
}

// A file in the session's folder or a folder in it for a recording that is not at its path: one of
// its name, otherwise one of its ending and content, compared over 256 MB at most. Empty: none.
QString foundNear(const QDir& folder, const QString& path, const QString& sha256) {
    const QFileInfo missing(path);
    const QList<QDir> folders = foldersOf(folder);
    for (const QDir& each : folders) {
        const QString candidate = each.absoluteFilePath(missing.fileName());
        if (QFileInfo(candidate).isFile()) {
            return QDir::cleanPath(candidate);
        }
    }
    qint64 read = 0;
    for (const QDir& each : folders) {
        const QString ending = QStringLiteral("*.") + missing.suffix();
        for (const QFileInfo& file : each.entryInfoList({ending}, QDir::Files, QDir::Name)) {
            if (sha256.isEmpty() || (read += file.size()) > most_bytes_read) {
                return {};
            }
            const auto hash = file_sha256(file.absoluteFilePath().toStdU16String(), JobControl());
            if (hash && QString::fromStdString(*hash) == sha256) {
                return QDir::cleanPath(file.absoluteFilePath());
            }
        }
    }
    return {};
}

}  // namespace

SessionKeeper::SessionKeeper(Document& document, TrackView& tracks, QObject* parent)
    : QObject(parent), document_(document), tracks_(tracks), backup_([this] { return backup(); }) {
    for (const auto changed : {&Document::busyChanged, &Document::recordingsChanged}) {
        connect(&document_, changed, this, &SessionKeeper::finishWhenComputed,
                Qt::QueuedConnection);
    }
    // Opening a recording without an analysis ends with this signal alone.
    connect(&document_, &Document::recordingChanged, this, &SessionKeeper::finishWhenComputed,
            Qt::QueuedConnection);
    connect(&document_, &Document::recordingChanged, this, &SessionKeeper::compareHash);
    connect(&document_, &Document::finished, this, [this] { backup_.soon(); });
    connect(&document_.drift(), &DriftStore::changed, this, &SessionKeeper::compareHashesOfLogs);
    connect(&document_.sets(), &SetStore::identified, this, [this] { backup_.soon(); });
}

bool SessionKeeper::isSession(const QString& path) {
    return path.endsWith(QLatin1String(".vybeg"), Qt::CaseInsensitive);
}

void SessionKeeper::open(const QStringList& paths, const OpenOptions& options) {
    QStringList recordings = paths;
    const auto session = std::ranges::find_if(paths, &SessionKeeper::isSession);
    if (session != paths.end()) {
        recordings.removeIf(&SessionKeeper::isSession);
        openSession(*session);
    }
    const auto is_list = [](const QString& path) {
        return is_measurement_list(path.toStdU16String());
    };
    for (const QString& path : std::as_const(recordings)) {
        if (is_list(path)) {
            document_.sets().openList(path, options);
        }
    }
    recordings.removeIf(is_list);
    document_.open(recordings, options);
}

void SessionKeeper::warn(std::function<QString()> text) {
    document_.report(warningMessage(std::move(text)));
}

void SessionKeeper::fail(std::function<QString()> text) {
    document_.report({MessageLevel::error, std::move(text)});
}

bool SessionKeeper::openSession(const QString& path) {
    const Result<std::string> text = own_file_text(path.toStdString());
    if (!text) {
        document_.report(errorMessage(text.error()));
        return false;
    }
    QJsonParseError fault;
    const QByteArray bytes = QByteArray::fromStdString(*text);
    const QJsonObject json = QJsonDocument::fromJson(bytes, &fault).object();
    if (fault.error != QJsonParseError::NoError) {
        fail([path, at = fault.offset] {
            return tr("%1 is not a session that can be read: it is no JSON at byte %2.")
                .arg(path)
                .arg(at);
        });
        return false;
    }
    const int schema = json[session_schema_key].toInt();
    if (schema < 1) {
        fail([path] { return tr("%1 is not a session of Vybeg.").arg(path); });
        return false;
    }
    if (const QString key = misplacedKey(json); !key.isEmpty()) {
        fail([path, key] {
            return tr("The session %1 is damaged: “%2” holds something else than a session has "
                      "there. Restore the file from a copy.")
                .arg(path, key);
        });
        return false;
    }
    if (schema > session_schema) {
        warn([path] {
            return tr("%1 was written by a later version of Vybeg. What this version does not know "
                      "of it is kept, but not shown.")
                .arg(path);
        });
    }
    const bool is_backup = json.contains(backup_key);
    const QDir folder = is_backup ? QDir::root() : QFileInfo(path).absoluteDir();
    Result<Session> session = sessionFromJson(json, folder);
    if (!session) {
        Error error = session.error();
        error.where = path.toStdString();
        fail([path, error] {
            return error.code == ErrorCode::setting_invalid  // which does not name the file
                       ? tr("The session %1 cannot be opened: %2 Open it with the version of Vybeg "
                            "that wrote it, or restore the file from a copy.")
                             .arg(path, errorText(error))
                       : errorText(error);
        });
        return false;
    }
    session->unknown.remove(backup_key);
    path_ = is_backup ? json[backup_key].toString() : QFileInfo(path).absoluteFilePath();
    recovered_ = is_backup;
    in_file_ = is_backup ? QByteArray() : digest(bytes);
    emit pathChanged();
    begin(std::move(*session));
    return true;
}

void SessionKeeper::begin(Session session) {
    unknown_ = session.unknown;
    absent_.clear();
    stated_.clear();
    hashes_of_logs_.clear();
    opening_ = true;
    keepAbsent(session);
    for (const RecordingRef& log : session.drift.logs) {
        hashes_of_logs_[log.path] = log.sha256;
    }
    wanted_ids_ = restoreSession(session, document_);
    const std::vector<RecordingSet>& sets = document_.sets().all();
    int absent_id = 0;
    for (ClosedRecording& absent : absent_) {
        for (std::size_t set = 0; set < session.sets.size(); ++set) {
            if (std::ranges::count(session.sets[set].recordings, absent.id) > 0) {
                absent.sets.push_back(sets[set].id);
            }
        }
        absent.id = static_cast<RecordingId>(--absent_id);
    }
    for (std::size_t k = 0; k < wanted_ids_.size(); ++k) {
        if (wanted_ids_[k] != RecordingId::none) {
            stated_[wanted_ids_[k]] = session.recordings[k];
        }
    }
    wanted_ = std::move(session);
    emit unitsWanted(wanted_.view.units);
    finishWhenComputed();
}

void SessionKeeper::keepAbsent(Session& session) {
    const QDir folder = path_.isEmpty() ? QDir::root() : QFileInfo(path_).absoluteDir();
    // Where a file is that may have moved with the session.
    const auto present = [&folder](const QString& path, const QString& sha256) {
        const QString found = folder.isRoot() || QFileInfo::exists(path)
                                  ? QString()
                                  : foundNear(folder, path, sha256);
        return found.isEmpty() ? path : found;
    };
    const auto follow = [&present](std::string& file) {
        file = file.empty() ? file : present(QString::fromStdString(file), {}).toStdString();
    };
    const auto follow_all = [&follow](OpenOptions& options) {
        follow(options.channel_d_file);
        std::ranges::for_each(options.join, follow);
    };
    const auto follow_row = [&](RecordingRef& row) {
        follow_all(row.open);
        row.path = present(pathText(row), QString::fromStdString(row.sha256)).toStdU16String();
    };
    for (ClosedRecording& recording : session.recordings) {
        follow_all(recording.options);
        recording.path = present(recording.path, recording.sha256);
        if (QFileInfo::exists(recording.path)) {
            continue;
        }
        const std::size_t absent = absent_.size();
        absent_.push_back(recording);
        Message message = warningMessage([path = recording.path] {
            return tr("The session's recording %1 is not there. The session keeps its place and "
                      "its analyses.")
                .arg(path);
        });
        message.buttons = {{[] { return tr("Find…"); },
                            [this, absent, name = QFileInfo(recording.path).fileName()] {
                                emit fileWanted(absent, name);
                            }}};
        document_.report(message);
        recording.path.clear();
    }
    std::ranges::for_each(session.drift.logs, follow_row);
    if (!session.passport.file.path.empty()) {
        follow_row(session.passport.file);
    }
    for (RecordingSet& set : session.sets) {
        if (set.listed) {
            auto listed = std::make_shared<MeasurementSet>(*set.listed);
            std::ranges::for_each(listed->recordings, follow_row);
            set.listed = std::move(listed);
        }
    }
}

void SessionKeeper::supply(std::size_t absent, const QString& path) {
    if (absent >= absent_.size() || absent_[absent].path.isEmpty()) {
        return;
    }
    const QString missing = std::exchange(absent_[absent].path, {});
    ClosedRecording found = absent_[absent];
    found.path = path;
    const auto id = document_.restore(found);
    stated_[id] = found;
    for (const SetId set_id : found.sets) {
        if (const RecordingSet* set = document_.sets().find(set_id)) {
            if (set->listed) {
                document_.sets().setListed(set_id, withRowFor(*set->listed, missing, id));
            }
            document_.sets().addTo(set_id, {id});
        }
    }
}

void SessionKeeper::finishWhenComputed() {
    const bool opens = std::ranges::any_of(wanted_ids_, [this](RecordingId id) {
        const RecordingEntry* entry = document_.recording(id);
        return entry && !entry->recording;
    });
    if (!opening_ || opens || document_.busy()) {
        return;
    }
    opening_ = false;
    if (wanted_.current >= 0) {
        document_.setCurrentRecording(wanted_ids_[static_cast<std::size_t>(wanted_.current)]);
    }
    document_.setLive(wanted_.live);
    restoreView(wanted_.view, tracks_);
    saved_ = content();
    // The waves, plots and reports of an identification are not kept.
    for (const RecordingSet& set : document_.sets().all()) {
        if (set.kept_up_to_date && isComplete(set) && hasMembers(set)) {
            document_.sets().identifySet(set.id);
        }
    }
    if (wanted_.current_analysis >= 0 &&
        wanted_.current_analysis < static_cast<int>(document_.analyses().size())) {
        emit analysisWanted(
            document_.analyses()[static_cast<std::size_t>(wanted_.current_analysis)].shown.id);
    }
    emit viewRestored(wanted_.view);
}

bool SessionKeeper::isComplete(const RecordingSet& set) const {
    const auto is_of_set = [&set](const ClosedRecording& absent) {
        return std::ranges::count(absent.sets, set.id) > 0;
    };
    const auto is_open = [this](RecordingId id) {
        return document_.recording(id)->recording.has_value();
    };
    return std::ranges::none_of(absent_, is_of_set) && std::ranges::all_of(set.recordings, is_open);
}

std::optional<QString> SessionKeeper::lackingSet() const {
    const auto is_lost = [this](RecordingId of_session) {
        const auto place = static_cast<std::size_t>(number(of_session) - 1);
        return place < wanted_ids_.size() && !document_.recording(wanted_ids_[place]);
    };
    const auto lacking = std::ranges::find_if(wanted_.sets, [&](const RecordingSet& set) {
        return std::ranges::any_of(set.recordings, is_lost);
    });
    return lacking == wanted_.sets.end() ? std::nullopt : std::optional(lacking->name);
}

void SessionKeeper::compareHash(RecordingId recording_id) {
    const auto stated = stated_.find(recording_id);
    const RecordingEntry* entry = document_.recording(recording_id);
    if (stated == stated_.end() || !entry || entry->sha256.isEmpty()) {
        return;
    }
    const QString sha256 = std::exchange(stated->second.sha256, {});
    if (!sha256.isEmpty() && sha256 != entry->sha256) {
        warnOfOtherFile(entry->path);
    }
}

// When their drift is there, and with it what was read.
void SessionKeeper::compareHashesOfLogs() {
    if (!document_.drift().outcome()) {
        return;
    }
    for (const RecordingRef& log : document_.drift().logs()) {
        const auto stated = hashes_of_logs_.find(log.path);
        if (stated != hashes_of_logs_.end() && !stated->second.empty() &&
            stated->second != log.sha256) {
            warnOfOtherFile(pathText(log));
        }
    }
    hashes_of_logs_.clear();
}

void SessionKeeper::warnOfOtherFile(const QString& path) {
    warn([path] {
        return tr("%1 is another file than that of the session: its SHA-256 differs. The "
                  "analyses are computed from the present file.")
            .arg(path);
    });
}

Session SessionKeeper::present() const {
    Session session = sessionOf(document_, tracks_);
    session.unknown = unknown_;
    add_to_view_(session.view);
    const auto shown = std::ranges::find_if(
        document_.analyses(),
        [this](const AnalysisEntry& entry) { return entry.shown.id == current_analysis_; });
    if (shown != document_.analyses().end()) {
        session.current_analysis = static_cast<int>(shown - document_.analyses().begin());
    }
    for (ClosedRecording& recording : session.recordings) {
        if (const auto found = stated_.find(recording.id); found != stated_.end()) {
            recording.unknown = found->second.unknown;
        }
    }
    for (const ClosedRecording& absent : absent_) {
        if (absent.path.isEmpty()) {
            continue;
        }
        session.recordings.push_back(absent);
        for (RecordingSet& set : session.sets) {
            if (std::ranges::count(absent.sets, set.id) > 0) {
                set.recordings.push_back(absent.id);
            }
        }
    }
    return session;
}

QJsonObject SessionKeeper::content() const {
    Session session = present();
    session.view = {};
    session.current_analysis = -1;
    for (ClosedRecording& recording : session.recordings) {
        recording.sha256.clear();
    }
    for (RecordingRef& log : session.drift.logs) {
        log.sha256.clear();
    }
    session.passport.file.sha256.clear();
    session.current = -1;
    return sessionToJson(session, QDir::root());
}

bool SessionKeeper::isModified() const {
    if (opening_) {
        return false;
    }
    if (path_.isEmpty() && !recovered_) {
        const bool has_sets = std::ranges::any_of(
            document_.sets().all(),
            [](const RecordingSet& set) { return isOfLogs(set) || !set.recordings.empty(); });
        const bool has_files = !document_.recordings().empty() || !document_.drift().logs().empty();
        return has_sets || (has_files && !document_.undoStack().isClean());
    }
    return recovered_ || content() != saved_;
}

bool SessionKeeper::isChangedElsewhere() const {
    const Result<std::string> text =
        in_file_.isEmpty() ? Result(std::string()) : own_file_text(path_.toStdString());
    return !in_file_.isEmpty() && text && digest(QByteArray::fromStdString(*text)) != in_file_;
}

void SessionKeeper::save(const QString& path, std::function<void()> then) {
    const QString target = QFileInfo(path).absoluteFilePath();
    const auto ended = [this, target, content = content(), undo = document_.undoStack().index(),
                        then = std::move(then)](const Result<QByteArray>& in_file) {
        if (in_file) {
            path_ = target;
            in_file_ = *in_file;
            recovered_ = false;
            saved_ = content;
            if (document_.undoStack().index() == undo) {
                document_.undoStack().setClean();
            }
            emit pathChanged();
        } else {
            document_.report(errorMessage(in_file.error()));
        }
        if (in_file && then) {
            then();
        }
        if (!isSaving()) {
            emit saveEnded();
        }
    };
    writer_.write(target, sessionToJson(present(), QFileInfo(target).absoluteDir()), ended);
}

QJsonObject SessionKeeper::backup() const {
    const bool has_logs =
        std::ranges::any_of(document_.sets().all(), isOfLogs) || !document_.drift().logs().empty();
    if (opening_ || (document_.recordings().empty() && absent_.empty() && !has_logs)) {
        return {};
    }
    QJsonObject json = sessionToJson(present(), QDir::root());
    json[backup_key] = path_;
    return json;
}

// One copy, from the newest on; those before it by a button.
void SessionKeeper::offerAbandoned(qsizetype place) {
    const QStringList copies = SessionBackup::abandoned();
    const qsizetype count = copies.size();
    if (count == 0) {
        return;
    }
    place %= count;
    const QString& copy = copies[count - 1 - place];
    Message message = warningMessage(
        [what = contentOf(copy), place, count] { return offerText(what, place, count); });
    message.buttons.emplace_back([] { return tr("Recover"); },
                                 [this, copy] {
                                     if (openSession(copy)) {
                                         backup_.take(copy);
                                     }
                                 });
    if (count > 1) {
        message.buttons.emplace_back([] { return tr("Another…"); },
                                     [this, place] { offerAbandoned(place + 1); });
    }
    message.buttons.emplace_back(
        [] { return tr("Forget"); },
        [this, copy, place] {
            const QString aside = SessionBackup::setAside(copy);
            document_.report({MessageLevel::info, [aside] {
                                  return tr("The copy of the session stays: %1").arg(aside);
                              }});
            offerAbandoned(place);
        });
    message.until_answered = true;
    document_.report(message);
}

void SessionKeeper::end() {
    writer_.finish();
    backup_.end();
}

}  // namespace vybeg::ui

#include "moc_session_keeper.cpp"
