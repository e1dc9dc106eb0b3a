#include "ui/import/log_files.h"

#include "core/recording/samples/reader_rules.h"
#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace vybeg::ui {

namespace {

using Looked = LogFiles::Looked;

constexpr int look_key = 2;  // previews of recordings have others

Looked unreadable(const Error& error) {
    Looked looked;
    looked.look.problem = error;
    looked.readable = false;
    return looked;
}

Result<std::vector<Looked>> lookAt(const std::vector<std::filesystem::path>& paths,
                                   const OpenOptions& options, LogChoice choice,
                                   const JobControl& job) {
    std::vector<Looked> looks;
    const auto again = [&](std::size_t k) -> Status {
        const Result<LogLook> look = look_at_log(paths[k], options, choice, job);
        if (!look && look.error().code == ErrorCode::interrupted) {
            return look.error();
        }
        looks[k] = look ? Looked{*look} : unreadable(look.error());
        return {};
    };
    for (std::size_t k = 0; k < paths.size(); ++k) {
        looks.emplace_back();
        TRY(again(k));
        // The others are of the kind of the first one that shows its own.
        if (!looks[k].look.problem && !choice.given() && looks[k].look.choice.given()) {
            choice = looks[k].look.choice;
            for (std::size_t before = 0; before < k; ++before) {
                TRY(again(before));
            }
        }
    }
    return looks;
}

}  // namespace

LogFiles::LogFiles(BackgroundJobs& job, const QStringList& files, QWidget* parent)
    : FileList(6, parent), job_(&job) {
    add(files);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setHint([] { return tr("Drop logs of one resonator here"); });
    connect(this, &FileList::dropped, this, &LogFiles::add);
    connect(this, &FileList::removalWanted, this, &LogFiles::remove);
}

LogFiles::~LogFiles() {
    if (job_) {
        job_->forget(look_key);
    }
}

void LogFiles::look(const OpenOptions& options, const LogChoice& given) {
    looks_.clear();
    std::vector<std::filesystem::path> paths;
    for (const QString& file : files_) {
        paths.emplace_back(file.toStdU16String());
    }
    job_->run<std::vector<Looked>>(
        look_key,
        [paths = std::move(paths), options, given](const JobControl& job) {
            return lookAt(paths, options, given, job);
        },
        [this](const Result<std::vector<Looked>>& result) {
            looks_ = result ? *result
                            : std::vector(static_cast<std::size_t>(files_.size()),
                                          unreadable(result.error()));
            emit looked();
        });
}

const LogFiles::Looked* LogFiles::sound() const {
    const auto first = [this](const auto& is) {
        const auto found = std::ranges::find_if(looks_, is);
        return found == looks_.end() ? nullptr : &*found;
    };
    const Looked* best = first(
        [](const Looked& looked) { return !looked.look.problem && looked.look.choice.given(); });
    best = best ? best : first([](const Looked& looked) { return !looked.look.problem; });
    return best ? best : first([](const Looked&) { return true; });
}

const LogFiles::Looked* LogFiles::chosen() const {
    const QList<QListWidgetItem*> items = selectedItems();
    const auto at = static_cast<std::size_t>(items.isEmpty() ? count() : row(items.first()));
    return at < looks_.size() ? &looks_[at] : sound();
}

bool LogFiles::any(bool LogLook::*found) const {
    return std::ranges::any_of(looks_,
                               [found](const Looked& looked) { return looked.look.*found; });
}

bool LogFiles::isOfOneChannel(const QString& file) const {
    const auto at = static_cast<std::size_t>(files_.indexOf(file));
    return at < looks_.size() && looks_[at].look.one_channel;
}

qsizetype LogFiles::ofOneChannel() const {
    return std::ranges::count_if(files_,
                                 [this](const QString& file) { return isOfOneChannel(file); });
}

QString LogFiles::partner() const {
    for (const QString& file : files_) {
        const auto found = isOfOneChannel(file) ? partner_of(file.toStdU16String()) : std::nullopt;
        const QString path = found ? QString::fromStdU16String(found->u16string()) : QString();
        if (found && (ofOneChannel() == 1 || files_.contains(path))) {
            return path;
        }
    }
    return {};
}

void LogFiles::add(const QStringList& files) {
    const qsizetype before = files_.size();
    for (const QString& file : files) {
        const QString path = QFileInfo(file).absoluteFilePath();
        if (!files_.contains(path)) {
            files_ << path;
        }
    }
    files_.sort();
    if (files_.size() != before) {
        emit changed();
    }
}

void LogFiles::remove(const QStringList& files) {
    if (files_.removeIf([&files](const QString& file) { return files.contains(file); }) > 0) {
        emit changed();
    }
}

void LogFiles::show(std::span<const RecordingRef> logs) {
    if (count() != files_.size()) {
        clear();
        for (qsizetype k = 0; k < files_.size(); ++k) {
            new QListWidgetItem(this);
        }
        updateGeometry();
    }
    for (int k = 0; k < count(); ++k) {
        const QString& file = files_[k];
        const auto at = static_cast<std::size_t>(k);
        QString text = QFileInfo(file).fileName();
        QString tip = QDir::toNativeSeparators(file);
        if (at < looks_.size() && looks_[at].look.problem) {
            text = tr("%1 — cannot be opened so").arg(text);
            tip += QLatin1Char('\n') + errorText(*looks_[at].look.problem);
        } else if (isOfOneChannel(file)) {
            const auto of_c =
                std::ranges::find(logs, file.toStdU16String(),
                                  [](const RecordingRef& log) { return log.path.u16string(); });
            const auto of_d =
                std::ranges::find(logs, file.toStdString(),
                                  [](const RecordingRef& log) { return log.open.channel_d_file; });
            if (of_c != logs.end()) {
                text = tr("%1 — channel C").arg(text);
            } else if (of_d != logs.end()) {
                text = tr("%1 — channel D of %2").arg(text, QString::fromStdString(of_d->name()));
            }
        }
        item(k)->setText(text);
        item(k)->setData(Qt::UserRole, file);
        item(k)->setToolTip(plainTip(tip));
    }
}

}  // namespace vybeg::ui

#include "moc_log_files.cpp"
