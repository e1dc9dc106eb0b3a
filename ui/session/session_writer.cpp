#include "ui/session/session_writer.h"

#include "core/output/output_file.h"

#include <QCryptographicHash>
#include <QJsonDocument>

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

void SessionWriter::finish() {
    job_.finish();
}

}  // namespace vybeg::ui
