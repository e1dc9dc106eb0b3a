#include "ui/window/demonstration.h"

#include "core/output/sample_files.h"
#include "core/simulation/free_decay.h"
#include "core/simulation/simulate.h"

#include <QDir>
#include <QFileInfo>
#include <QFuture>
#include <QPromise>
#include <QStandardPaths>
#include <QThreadPool>

#include <filesystem>
#include <memory>
#include <utility>

namespace vybeg::ui {

namespace {

Result<QString> written(const QString& path) {
    if (QFileInfo::exists(path)) {
        return path;
    }
    QDir().mkpath(QFileInfo(path).path());
    const FreeDecay decay = demo_decay();
    const auto samples = TRY(simulate(decay, JobControl()));
    auto file = TRY(OutputFile::create(std::filesystem::path(path.toStdU16String()), JobControl()));
    Status done =
        write_samples(file, SampleFormat::wav, {samples.c, samples.d, decay.rate_hz}, JobControl());
    done = done ? file.commit() : done;
    return done ? Result<QString>(path) : done.error();
}

}  // namespace

void makeDemonstration(QObject* context, std::function<void(const Result<QString>&)> done) {
    const QString path =
        QDir(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation))
            .filePath(QStringLiteral("demonstration.wav"));
    const auto promise = std::make_shared<QPromise<std::shared_ptr<Result<QString>>>>();
    promise->start();
    promise->future().then(
        context, [done = std::move(done)](const std::shared_ptr<Result<QString>>& result) {
            done(*result);
        });
    QThreadPool::globalInstance()->start([promise, path] {
        promise->addResult(std::make_shared<Result<QString>>(written(path)));
        promise->finish();
    });
}

}  // namespace vybeg::ui
