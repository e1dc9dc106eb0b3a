#include "ui/session/session_writer.h"

#include "core/output/output_file.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QStandardPaths>

#include <algorithm>
#include <string_view>
#include <utility>

namespace vybeg::ui {

namespace {

Status writeToDisk(const QString& path, const QByteArray& bytes) {
    return write_file(path.toStdU16String(), std::string_view(bytes.data(), bytes.size()),
                      JobControl());
}

SessionWriter::Disk& disk() {
    static SessionWriter::Disk used = writeToDisk;
    return used;
}

constexpr int interval_ms = 10000;
constexpr int soon_ms = 500;

QDir folder() {
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
                QStringLiteral("/backups"));
}

QString lockOf(const QString& path) {
    return path + QStringLiteral(".lock");
}

}  // namespace

QByteArray digest(const QByteArray& bytes) {
    return QCryptographicHash::hash(bytes, QCryptographicHash::Sha256);
}

SessionWriter::~SessionWriter() {
    for (Waiting& each : waiting_) {
        each.done.clear();
    }
    finish();
}

void SessionWriter::setDisk(Disk used) {
    disk() = used ? std::move(used) : writeToDisk;
}

void SessionWriter::write(const QString& path, const QJsonObject& state, Done done) {
    const auto from = waiting_.begin() + (waiting_.empty() ? 0 : 1);
    const auto found = std::find_if(from, waiting_.end(),
                                    [&path](const Waiting& each) { return each.path == path; });
    if (found != waiting_.end()) {
        found->state = state;
        found->done.push_back(std::move(done));
        return;
    }
    waiting_.push_back({path, state, {std::move(done)}});
    if (waiting_.size() == 1) {
        begin();
    }
}

void SessionWriter::begin() {
    job_.run<QByteArray>(
        0,
        [path = waiting_.front().path, state = waiting_.front().state,
         put = disk()](const JobControl&) -> Result<QByteArray> {
            const QByteArray bytes = QJsonDocument(state).toJson(QJsonDocument::Indented);
            const Status written = put(path, bytes);
            return written ? Result<QByteArray>(digest(bytes)) : written.error();
        },
        [this](const Result<QByteArray>& result) {
            const Waiting written = std::move(waiting_.front());
            waiting_.erase(waiting_.begin());
            if (busy()) {
                begin();
            }
            for (const Done& done : written.done) {
                done(result);
            }
        });
}

SessionBackup::SessionBackup(std::function<QJsonObject()> content) : content_(std::move(content)) {
    timer_.setInterval(interval_ms);
    soon_.setInterval(soon_ms);
    soon_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &SessionBackup::write);
    connect(&soon_, &QTimer::timeout, this, &SessionBackup::write);
    timer_.start();
}

void SessionBackup::soon() {
    if (timer_.isActive() && !soon_.isActive()) {
        soon_.start();
    }
}

void SessionBackup::take(const QString& path) {
    taken_ << path;
    soon();
}

void SessionBackup::write() {
    QJsonObject content = content_();
    if (content == written_ || content.isEmpty()) {
        return;
    }
    if (!lock_) {
        folder().mkpath(QStringLiteral("."));
        path_ = folder().filePath(QStringLiteral("%1-%2.vybeg")
                                      .arg(QDateTime::currentDateTimeUtc().toString(
                                          QStringLiteral("yyyyMMdd-hhmmss-zzz")))
                                      .arg(QCoreApplication::applicationPid()));
        lock_ = std::make_unique<QLockFile>(lockOf(path_));
        lock_->setStaleLockTime(0);  // stale as soon as its program is gone
        if (!lock_->tryLock(0)) {
            lock_.reset();  // a folder that cannot be written: without copies
            timer_.stop();
            return;
        }
    }
    written_ = std::move(content);
    writer_.write(path_, written_, [this](const Result<QByteArray>& result) {
        if (!result) {
            written_ = {};  // no failure of the work: the next copy may succeed
            return;
        }
        for (const QString& copy : std::exchange(taken_, {})) {
            discard(copy);
        }
    });
}

void SessionBackup::end() {
    timer_.stop();
    soon_.stop();
    writer_.finish();
    if (lock_) {
        QFile::remove(path_);
        lock_->unlock();
        lock_.reset();
    }
}

QStringList SessionBackup::abandoned() {
    QStringList found;
    const QStringList names =
        folder().entryList({QStringLiteral("*.vybeg")}, QDir::Files, QDir::Name);
    for (const QString& name : names) {
        const QString path = folder().filePath(name);
        QLockFile lock(lockOf(path));
        lock.setStaleLockTime(0);
        if (lock.tryLock(0)) {
            found << path;
        }
    }
    return found;
}

void SessionBackup::discard(const QString& path) {
    QFile::remove(path);
    QFile::remove(lockOf(path));
}

QString SessionBackup::setAside(const QString& path) {
    const QString aside = path + QStringLiteral(".declined");
    QFile::rename(path, aside);
    QFile::remove(lockOf(path));
    return aside;
}

}  // namespace vybeg::ui

#include "moc_session_writer.cpp"
