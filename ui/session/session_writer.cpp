#include "ui/session/session_writer.h"

#include "core/output/output_file.h"
#include "core/recording/bytes/sha256.h"

#include <QCryptographicHash>
#include <QFileInfo>
#include <QJsonDocument>

#include <algorithm>
#include <string_view>
#include <utility>

namespace vybeg::ui {

QByteArray bytesOf(const QJsonObject& json) {
    return QJsonDocument(json).toJson(QJsonDocument::Indented);
}

QByteArray digest(const QByteArray& bytes) {
    return QCryptographicHash::hash(bytes, QCryptographicHash::Sha256);
}

namespace {

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

}  // namespace

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

namespace {

Status writeToDisk(const QString& path, const QByteArray& bytes) {
    return write_file(path.toStdU16String(), std::string_view(bytes.data(), bytes.size()),
                      JobControl());
}

SessionWriter::Disk& disk() {
    static SessionWriter::Disk used = writeToDisk;
    return used;
}

}  // namespace

SessionWriter::SessionWriter(QObject* parent) : QObject(parent) {}

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
            const QByteArray bytes = bytesOf(state);
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

void SessionWriter::finish() {
    job_.finish();
}

}  // namespace vybeg::ui
