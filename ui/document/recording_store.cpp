#include "ui/document/recording_store.h"

#include "core/analysis/prepare.h"
#include "core/recording/samples/open_table.h"
#include "core/recording/samples/recording.h"
#include "ui/values/recording_set.h"
#include "ui/words/error_text.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <array>
#include <utility>

namespace vybeg::ui {

namespace {

// Of files that other import options may open.
constexpr std::array fixable_by_import_options{
    ErrorCode::setting_invalid,     ErrorCode::format_unknown, ErrorCode::text_not_a_number,
    ErrorCode::text_time_backwards, ErrorCode::text_no_table,  ErrorCode::text_lines_missing,
    ErrorCode::column_out_of_range, ErrorCode::no_channels,    ErrorCode::too_few_channels,
    ErrorCode::parts_differ,        ErrorCode::rates_differ,   ErrorCode::channel_out_of_range,
    ErrorCode::channel_is_time,     ErrorCode::rate_unknown,   ErrorCode::variable_missing,
    ErrorCode::variables_ambiguous};

}  // namespace

const RecordingEntry* RecordingStore::find(RecordingId id) const {
    const auto found = std::ranges::find(recordings_, id, &RecordingEntry::id);
    return found == recordings_.end() ? nullptr : &*found;
}

const RecordingEntry* RecordingStore::findPath(const QString& absolute_path) const {
    const auto found = std::ranges::find(recordings_, absolute_path, &RecordingEntry::path);
    return found == recordings_.end() ? nullptr : &*found;
}

std::size_t RecordingStore::place(RecordingId id) const {
    const auto found = std::ranges::find(recordings_, id, &RecordingEntry::id);
    return static_cast<std::size_t>(found - recordings_.begin());
}

void RecordingStore::setCurrent(RecordingId id) {
    if (id != current_ && find(id)) {
        current_ = id;
        emit currentChanged();
        emit carrierChanged();
    }
}

std::vector<RecordingId> RecordingStore::openedTogether() const {
    const RecordingEntry* chosen = current();
    std::vector<RecordingId> ids;
    for (const RecordingEntry& entry : recordings_) {
        if (chosen &&
            (&entry == chosen || (entry.together != 0 && entry.together == chosen->together))) {
            ids.push_back(entry.id);
        }
    }
    return ids;
}

void RecordingStore::open(const QStringList& paths, const OpenOptions& options) {
    const int together = ids_.next();
    for (const QString& path : paths) {
        begin(ids_.next<RecordingId>(), recordings_.size(), path, options);
        recordings_.back().together = together;
    }
    if (!paths.isEmpty()) {
        emit listChanged();
    }
}

std::vector<RecordingId> RecordingStore::openOnce(const std::vector<RecordingRef>& wanted) {
    std::vector<RecordingId> ids;
    const std::size_t before = recordings_.size();
    for (const RecordingRef& each : wanted) {
        const QFileInfo file(pathText(each));
        const QString path = QDir::cleanPath(file.absoluteFilePath());
        const auto open = std::ranges::find_if(recordings_, [&](const RecordingEntry& entry) {
            return entry.path == path && entry.options == each.open;
        });
        if (open != recordings_.end()) {
            ids.push_back(open->id);
        } else {
            ids.push_back(ids_.next<RecordingId>());
            begin(ids.back(), recordings_.size(), path, each.open);
        }
    }
    if (recordings_.size() != before) {
        emit listChanged();
    }
    return ids;
}

void RecordingStore::openAs(RecordingId id, std::size_t place, const QString& path,
                            const OpenOptions& options) {
    begin(id, std::min(place, recordings_.size()), path, options);
    emit listChanged();
}

void RecordingStore::begin(RecordingId id, std::size_t place, const QString& path,
                           const OpenOptions& options) {
    RecordingEntry entry;
    entry.id = id;
    entry.path = QFileInfo(path).absoluteFilePath();
    entry.name = QFileInfo(path).fileName();
    entry.options = options;
    // Absolute for sessions, as the path is.
    find_files_from(QDir::currentPath().toStdU16String(), entry.options);
    recordings_.insert(recordings_.begin() + static_cast<std::ptrdiff_t>(place), std::move(entry));
    job_.open(
        number(id), path, options,
        [this, id](const QuickOverview& look) {
            RecordingEntry& looked_at = *this->entry(id);
            looked_at.envelope = look.envelope;
            looked_at.envelope_rate_hz = look.rate_hz;
            showOpened(id);
            emit changed(id);
        },
        [this, id](Result<Recording> result) { whenOpened(id, std::move(result)); });
}

void RecordingStore::close(RecordingId id) {
    job_.forget(number(id));
    std::erase_if(recordings_, [id](const RecordingEntry& entry) { return entry.id == id; });
    const bool was_current = current_ == id;
    if (was_current) {
        current_ = recordings_.empty() ? RecordingId::none : recordings_.back().id;
    }
    emit listChanged();
    if (was_current) {
        emit currentChanged();
        emit carrierChanged();
    }
}

// Of many that are opened at once the first and the last ones are shown: each costs the window a
// redraw of all that shows a recording.
void RecordingStore::showOpened(RecordingId id) {
    constexpr std::ptrdiff_t few = 4;
    const auto opening = std::ranges::count_if(
        recordings_, [](const RecordingEntry& entry) { return !entry.recording; });
    if (current_ == RecordingId::none || opening <= few) {
        setCurrent(id);
    }
}

void RecordingStore::whenOpened(RecordingId id, Result<Recording> result) {
    RecordingEntry& loaded = *entry(id);
    if (!result && (result.error().code == ErrorCode::holds_log ||
                    result.error().code == ErrorCode::holds_angle)) {
        // Its entry goes.
        emit foundLog(id, QString(loaded.path), result.error().code == ErrorCode::holds_angle);
        return;
    }
    if (!result) {
        Message message = errorMessage(result.error());
        if (std::ranges::count(fixable_by_import_options, result.error().code) > 0) {
            message.buttons = {
                {[] { return QCoreApplication::translate("vybeg::ui::MessageBar", "Import…"); },
                 [this, path = loaded.path, options = loaded.options] {
                     emit importWanted(path, options);
                 }}};
        }
        emit openFailed(id, message);
        return;
    }
    loaded.recording = std::move(*result);
    readEnvelope(id);
    for (const Message& message : warningMessages(loaded.name, loaded.recording->diagnostics)) {
        emit reported(message);
    }
    if (id == current_) {
        emit currentChanged();  // an envelope was all that was known of it
    }
    showOpened(id);
    emit changed(id);
    emit opened(id);
}

void RecordingStore::readEnvelope(RecordingId id) {
    using Picture = std::shared_ptr<const Envelope>;
    const auto show = [this, id](const Picture& picture) {
        RecordingEntry& shown = *entry(id);
        shown.envelope = picture;
        shown.envelope_rate_hz = shown.recording->rate_hz;
        emit envelopeGrown(id);
    };
    job_.buildEnvelope(number(id), *find(id)->recording, show,
                       [this, id, show](Result<Picture> whole) {
                           if (whole) {
                               show(*whole);
                           } else {
                               emit reported(errorMessage(whole.error()));
                           }
                           // After the first picture; the file then is in memory as far as it
                           // fits.
                           checkSamples(id);
                           hashFile(id);
                       });
}

void RecordingStore::hashFile(RecordingId id) {
    job_.run<std::string>(
        BackgroundJobs::Kind::hash, number(id),
        [recording = *find(id)->recording](const JobControl& job) {
            return recording_sha256(recording, job);
        },
        [this, id](const Result<std::string>& hash) {
            if (hash) {
                entry(id)->sha256 = QString::fromStdString(*hash);
                emit changed(id);
            }
        });
}

void RecordingStore::checkSamples(RecordingId id) {
    const RecordingEntry& checked = *find(id);
    Settings settings = settings_.settings();
    if (!settings.f0_hz) {
        settings.f0_hz = checked.f0_hz;  // most often it has been found by now
    }
    job_.run<SampleFaults>(
        BackgroundJobs::Kind::check, number(id),
        [recording = *checked.recording, settings](const JobControl& job) {
            return inspect(recording, settings, job);
        },
        [this, id](Result<SampleFaults> faults) {
            if (faults) {  // otherwise the envelope reports the unreadable file
                whenChecked(id, std::move(*faults));
            }
        });
}

void RecordingStore::whenChecked(RecordingId id, SampleFaults faults) {
    RecordingEntry& checked = *entry(id);
    checked.faults = std::make_shared<const SampleFaults>(std::move(faults));
    emit changed(id);
    const std::vector<Diagnostic>& all = checked.faults->findings;
    const auto known = static_cast<std::ptrdiff_t>(checked.recording->diagnostics.size());
    const std::vector<Finding> findings =
        findings_of(std::vector<Diagnostic>(all.begin() + known, all.end()));
    const std::size_t count = count_warnings(findings);
    if (count == 0) {
        return;
    }
    const auto more = static_cast<int>(count) - 1;
    emit reported(warningMessage([name = checked.name, first = findings.front(), more] {
        const QString text = QStringLiteral("%1: %2").arg(name, findingText(first));
        return more == 0 ? text
                         : text + QLatin1Char(' ') +
                               tr("%n more finding(s) in the recording check.", nullptr, more);
    }));
}

std::optional<double> RecordingStore::carrier() const {
    if (settings_.settings().f0_hz) {
        return settings_.settings().f0_hz;
    }
    const RecordingEntry* shown = current();
    return shown ? shown->f0_hz : std::nullopt;
}

void RecordingStore::searchCarrier(RecordingId id) {
    RecordingEntry& searched = *entry(id);
    searched.f0_hz.reset();
    const Settings& search = settings_.settings();
    job_.run<double>(
        BackgroundJobs::Kind::carrier, number(id),
        [recording = *searched.recording, search](const JobControl& job) {
            return find_recording_carrier(recording, search, job);
        },
        [this, id, search](const Result<double>& f0) {
            if (f0) {
                Settings used = search;
                used.f0_hz = *f0;
                learnCarrier(id, search, used);
            }
        });
}

Settings RecordingStore::withKnownCarrier(const RecordingEntry& entry, Settings settings) {
    // The search for lost samples uses another carrier, that of the file itself.
    const bool known = entry.f0_hz && entry.f0_search && !settings.repair_lost &&
                       same_carrier_search(*entry.f0_search, settings);
    if (known && !settings.f0_hz) {
        settings.f0_hz = entry.f0_hz;
        settings.calibration = entry.f0_calibration;
    }
    return settings;
}

void RecordingStore::learnCarrier(RecordingId id, const Settings& requested, const Settings& used) {
    RecordingEntry* learnt = entry(id);
    if (!learnt || requested.f0_hz || !same_carrier_search(requested, settings_.settings())) {
        return;
    }
    const bool differs = learnt->f0_hz != used.f0_hz;
    learnt->f0_hz = used.f0_hz;
    learnt->f0_search = requested;
    learnt->f0_calibration = used.calibration;
    if (used.calibration.offset_auto) {
        learnt->f0_search.reset();  // the offsets are not found yet, and depend on the carrier
    }
    if (differs) {
        emit changed(id);
        if (id == current_) {
            emit carrierChanged();
        }
    }
}

}  // namespace vybeg::ui

#include "moc_recording_store.cpp"
