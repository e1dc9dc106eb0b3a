#include "ui/history/history_database.h"

#include "core/analysis/setting_table.h"
#include "core/base/translatable.h"
#include "core/output/identify_json.h"

#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

#include <iterator>
#include <optional>
#include <utility>

namespace vybeg::ui {

namespace {

// The settings of each recording; those that differ stand side by side in one text.
std::optional<std::vector<IdentifySettings>> settingsOf(const StoredResult& result) {
    const QJsonObject json =
        QJsonDocument::fromJson(QByteArray::fromStdString(result.json)).object();
    const QJsonObject settings = json[QStringLiteral("settings")].toObject();
    const IdentifySettings defaults;
    std::vector<IdentifySettings> each(result.recordings.size());
    for (const SettingRow<IdentifySettings>& row : identify_settings()) {
        const QJsonValue value = settings[QString::fromStdString(row.name)];
        const QStringList parts = value.toString().split(QStringLiteral("; "));
        for (std::size_t k = 0; value.isString() && k < each.size(); ++k) {
            const bool differ = each.size() > 1 && parts.size() == std::ssize(each);
            const std::string text =
                (differ ? parts[static_cast<qsizetype>(k)] : value.toString()).toStdString();
            if (text != row.text(defaults) && !row.read(text, each[k])) {
                return std::nullopt;
            }
        }
    }
    return settings.isEmpty() ? std::nullopt : std::optional(std::move(each));
}

}  // namespace

StoredSet storedSet(const StoredResult& result, const IdentifySettings& otherwise) {
    StoredSet stored;
    MeasurementSet set;
    set.name = result.set;
    const auto settings = settingsOf(result);
    stored.settings_known = settings.has_value();
    set.settings = settings && !settings->empty() ? settings->front() : otherwise;
    for (std::size_t k = 0; k < result.recordings.size(); ++k) {
        const RecordingRef& each = result.recordings[k];
        const QString path = QString::fromStdU16String(each.path.u16string());
        if (!QFileInfo(path).isFile()) {
            stored.missing << path;
            continue;
        }
        set.recordings.push_back(each);
        set.settings.of_recordings.push_back(settings ? (*settings)[k].signal : otherwise.signal);
    }
    if (!set.recordings.empty()) {
        stored.list.sets.push_back(std::move(set));
    }
    return stored;
}

namespace {

// While another program writes, a reader waits no longer than a person does.
constexpr double patience_s = 20;

Result<ResultsDatabase> opened(Document& document, const QString& path,
                               ResultsDatabase::Access access, const JobControl& job) {
    const auto tell = [&document](const Diagnostic& waiting) {
        QMetaObject::invokeMethod(
            &document,
            [&document, waiting] {
                for (const Message& message : warningMessages({}, {waiting})) {
                    document.report(message);
                }
            },
            Qt::QueuedConnection);
    };
    return ResultsDatabase::open(path.toStdU16String(), access, job, patience_s, tell);
}

}  // namespace

void makeDatabase(BackgroundJobs& job, int key, Document& document, const QString& path,
                  Done<bool> done) {
    job.run<bool>(
        key,
        [&document, path](const JobControl& control) -> Result<bool> {
            const auto database = opened(document, path, ResultsDatabase::Access::write, control);
            return database ? Result<bool>(true) : database.error();
        },
        std::move(done));
}

void readHistory(BackgroundJobs& job, int key, Document& document, const QString& path,
                 const std::optional<std::string>& gyro, const std::string& parameter,
                 Done<StoredHistory> done) {
    job.run<StoredHistory>(
        key,
        [&document, path, gyro, parameter](const JobControl& control) -> Result<StoredHistory> {
            auto database = TRY(opened(document, path, ResultsDatabase::Access::read, control));
            auto gyros = database.gyros();
            auto points = TRY(gyros ? database.history(gyro, parameter)
                                    : Result<std::vector<HistoryPoint>>(gyros.error()));
            return StoredHistory{std::move(*gyros), std::move(points)};
        },
        std::move(done));
}

void readResult(BackgroundJobs& job, int key, Document& document, const QString& path,
                std::int64_t id, Done<StoredResult> done) {
    job.run<StoredResult>(
        key,
        [&document, path, id](const JobControl& control) -> Result<StoredResult> {
            auto database = opened(document, path, ResultsDatabase::Access::read, control);
            auto found = TRY(database ? database->result(id)
                                      : Result<std::optional<StoredResult>>(database.error()));
            if (!found) {  // another file has taken its place
                return Error{ErrorCode::file_read_failed,
                             path.toStdString(),
                             {words(VYBEG_MESSAGE("Words", "the result is not there any more"))}};
            }
            return std::move(*found);
        },
        std::move(done));
}

void storeResult(BackgroundJobs& job, int key, Document& document, const QString& path,
                 SetResult result, Done<std::optional<StoredName>> done) {
    job.run<std::optional<StoredName>>(
        key,
        [&document, path, result = std::move(result)](
            const JobControl& control) -> Result<std::optional<StoredName>> {
            const auto stored = TRY(stored_result(result, identify_json(result)));
            auto database = TRY(opened(document, path, ResultsDatabase::Access::write, control));
            const auto known = database.holder(stored.key);
            const Result<std::int64_t> id = known ? database.add(stored) : known.error();
            return id ? known : id.error();
        },
        std::move(done));
}

}  // namespace vybeg::ui
