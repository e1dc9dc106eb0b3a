#include "ui/history/history_job.h"

#include "core/base/message_arg.h"
#include "core/output/identify_json.h"

namespace vybeg::ui {

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
                  std::function<void(Result<bool>)> done) {
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
                 std::function<void(Result<StoredHistory>)> done) {
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
                std::int64_t id, std::function<void(Result<StoredResult>)> done) {
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
                 SetResult result, std::function<void(Result<std::optional<StoredName>>)> done) {
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
