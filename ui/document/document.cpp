#include "ui/document/document.h"

#include "ui/words/error_text.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>

namespace vybeg::ui {

namespace {

// Whether a file could be opened if the engineer said how to read it.
bool isFixableByImportOptions(ErrorCode code) {
    switch (code) {
        case ErrorCode::setting_invalid:
        case ErrorCode::format_unknown:
        case ErrorCode::text_not_a_number:
        case ErrorCode::text_time_backwards:
        case ErrorCode::text_no_table:
        case ErrorCode::text_lines_missing:
        case ErrorCode::column_out_of_range:
        case ErrorCode::channel_out_of_range:
        case ErrorCode::channel_is_time:
        case ErrorCode::rate_unknown:
        case ErrorCode::variable_missing: return true;
        default: return false;
    }
}

}  // namespace

// One change of the settings.
class SettingsCommand : public QUndoCommand {
public:
    SettingsCommand(Document& document, Settings after, int gesture)
        : document_(document),
          before_(document.settings_),
          after_(std::move(after)),
          gesture_(gesture) {}

    void undo() override { document_.apply(before_); }
    void redo() override { document_.apply(after_); }
    int id() const override { return gesture_; }
    bool mergeWith(const QUndoCommand* other) override {
        after_ = static_cast<const SettingsCommand*>(other)->after_;
        return true;
    }

private:
    Document& document_;
    Settings before_;
    Settings after_;
    int gesture_;
};

Document::Document(QObject* parent) : QObject(parent) {
    undo_.setUndoLimit(200);
    connect(&job_, &AnalysisJob::analysisProgress, this, [this](int key, double fraction) {
        if (requests_.contains(key)) {
            fraction_ = fraction;
            emit progressChanged();
        }
    });
    connect(&job_, &AnalysisJob::analysisStarted, this, [this] {
        fraction_ = 0;
        emit progressChanged();
    });
}

RecordingEntry* Document::find(int id) {
    const auto found = std::ranges::find(recordings_, id, &RecordingEntry::id);
    return found == recordings_.end() ? nullptr : &*found;
}

const RecordingEntry* Document::recording(int id) const {
    const auto found = std::ranges::find(recordings_, id, &RecordingEntry::id);
    return found == recordings_.end() ? nullptr : &*found;
}

const RunEntry* Document::run(int id) const {
    const auto found =
        std::ranges::find_if(runs_, [id](const RunEntry& entry) { return entry.run.id == id; });
    return found == runs_.end() ? nullptr : &*found;
}

void Document::reportError(const Error& error) {
    emit reported({Severity::error, [error] { return errorText(error); }, {}, {}});
}

void Document::open(const QStringList& paths, const OpenOptions& options) {
    for (const QString& path : paths) {
        const int id = ++last_id_;
        RecordingEntry entry;
        entry.id = id;
        entry.path = QFileInfo(path).absoluteFilePath();
        entry.name = QFileInfo(path).fileName();
        entry.options = options;
        recordings_.push_back(std::move(entry));
        job_.open(
            id, path, options, [this, id](const FirstLook& look) { whenLookedAt(id, look); },
            [this, id](Result<Recording> result) { whenOpened(id, std::move(result)); });
    }
    if (!paths.isEmpty()) {
        emit recordingsChanged();
    }
}

void Document::reopen(int id, const OpenOptions& options) {
    RecordingEntry* entry = find(id);
    if (!entry) {
        return;
    }
    const QString path = entry->path;
    std::vector<int> holders;  // sets that hold it, and will hold it as it is read now
    for (const RunSet& set : sets_) {
        if (std::ranges::count(set.recordings, id) > 0) {
            holders.push_back(set.id);
        }
    }
    closeRecording(id);
    open({path}, options);
    for (const int holder : holders) {
        RunSet& set = *findSet(holder);
        set.recordings.push_back(recordings_.back().id);
        edited(set);
    }
}

void Document::whenLookedAt(int id, const FirstLook& look) {
    if (RecordingEntry* entry = find(id)) {
        entry->envelope = look.envelope;
        entry->envelope_rate_hz = look.rate_hz;
        setCurrentRecording(id);
        emit recordingChanged(id);
    }
}

void Document::whenOpened(int id, Result<Recording> result) {
    RecordingEntry* entry = find(id);
    if (!entry) {
        return;
    }
    if (!result) {
        const Error error = result.error();
        Message message{Severity::error, [error] { return errorText(error); }, {}, {}};
        if (isFixableByImportOptions(error.code)) {
            message.reopen_path = entry->path;
            message.reopen_options = entry->options;
        }
        closeRecording(id);
        emit reported(message);
        return;
    }
    entry->recording = std::move(*result);
    readEnvelope(id);
    if (!live_) {
        searchCarrier(id);  // a live run tells it, too
    }
    for (const Diagnostic& diagnostic : entry->recording->diagnostics) {
        if (diagnostic.kind != DiagnosticKind::text_lines_ignored) {
            emit reported({Severity::warning,
                           [name = entry->name, diagnostic] {
                               return QStringLiteral("%1: %2").arg(name,
                                                                   diagnosticText(diagnostic));
                           },
                           {},
                           {}});
        }
    }
    if (id == current_) {
        emit currentRecordingChanged();  // it has been looked at, and there is more to tell now
    }
    setCurrentRecording(id);
    emit recordingChanged(id);
    emit opened(entry->path);
    if (live_) {
        follow(id);
    } else {
        ask(id, settings_, 0);
    }
}

void Document::readEnvelope(int id) {
    using Picture = std::shared_ptr<const Envelope>;
    const auto show = [this, id](const Picture& picture) {
        if (RecordingEntry* entry = find(id)) {
            entry->envelope = picture;
            entry->envelope_rate_hz = entry->recording->rate_hz;
            emit envelopeGrown(id);
        }
    };
    job_.buildEnvelope(id, *find(id)->recording, show, [this, id, show](Result<Picture> whole) {
        if (whole) {
            show(*whole);
        } else {
            reportError(whole.error());
        }
        // What is to be seen comes first, and the file then is in memory as far as it fits.
        checkSamples(id);
        hashFile(id);
    });
}

void Document::hashFile(int id) {
    if (const RecordingEntry* entry = find(id); entry && entry->recording) {
        job_.hash(id, *entry->recording, [this, id](Result<std::string> hash) {
            RecordingEntry* hashed = find(id);
            if (hashed && hash) {
                hashed->sha256 = QString::fromStdString(*hash);
                emit recordingChanged(id);
            }
        });
    }
}

void Document::closeRecording(int id) {
    const bool was_current = current_ == id;
    job_.forget(id);
    std::vector<int> keys;
    for (const auto& [key, request] : requests_) {
        if (request.recording_id == id) {
            keys.push_back(key);
        }
    }
    for (const int key : keys) {
        job_.forget(key);
        requestDone(key);
    }
    forgetInSets(id);
    std::erase_if(recordings_, [id](const RecordingEntry& entry) { return entry.id == id; });
    const auto gone =
        std::erase_if(runs_, [id](const RunEntry& entry) { return entry.recording_id == id; });
    if (was_current) {
        current_ = recordings_.empty() ? 0 : recordings_.back().id;
    }
    emit recordingsChanged();
    if (was_current) {
        emit currentRecordingChanged();
        emit carrierChanged();
    }
    if (gone > 0) {
        emit runsChanged();
    }
    if (was_current) {
        catchUp(current_);
    }
}

void Document::setCurrentRecording(int id) {
    if (id != current_ && recording(id)) {
        current_ = id;
        emit currentRecordingChanged();
        emit carrierChanged();
        catchUp(id);
    }
}

void Document::searchCarrier(int id) {
    RecordingEntry* entry = find(id);
    entry->f0_hz.reset();
    job_.findCarrier(id, *entry->recording, settings_,
                     [this, id, search = settings_](Result<double> f0) {
                         if (f0) {
                             Settings used = search;
                             used.f0_hz = *f0;
                             learnCarrier(id, search, used);
                         }
                     });
}

void Document::checkSamples(int id) {
    const RecordingEntry& entry = *find(id);
    const std::size_t known = entry.recording->diagnostics.size();
    Settings settings = settings_;
    if (!settings.f0_hz) {
        settings.f0_hz = entry.f0_hz;  // most often it has been found by now
    }
    job_.inspect(id, *entry.recording, settings, [this, id, known](Result<SampleFaults> faults) {
        RecordingEntry* checked = find(id);
        if (!checked || !faults) {
            return;  // a file that cannot be read is told of by its envelope
        }
        checked->faults = std::make_shared<const SampleFaults>(std::move(*faults));
        emit recordingChanged(id);
        const std::vector<Diagnostic>& findings = checked->faults->findings;
        if (findings.size() == known) {
            return;
        }
        const auto more = static_cast<int>(findings.size() - known) - 1;
        emit reported({Severity::warning,
                       [name = checked->name, first = findings[known], more] {
                           const QString text =
                               QStringLiteral("%1: %2").arg(name, diagnosticText(first));
                           return more == 0 ? text
                                            : text + QLatin1Char(' ') +
                                                  tr("%n more finding(s) in the recording check.",
                                                     nullptr, more);
                       },
                       {},
                       {}});
    });
}

std::optional<double> Document::carrier() const {
    if (settings_.f0_hz) {
        return settings_.f0_hz;
    }
    const RecordingEntry* entry = currentRecording();
    return entry ? entry->f0_hz : std::nullopt;
}

void Document::setSettings(const Settings& settings, int gesture) {
    if (!(settings == settings_)) {
        undo_.push(new SettingsCommand(*this, settings, gesture));
    }
}

void Document::startWith(const Settings& settings) {
    undo_.clear();
    apply(settings);
}

void Document::apply(const Settings& settings) {
    const Settings before = std::exchange(settings_, settings);
    emit settingsChanged();
    emit setsChanged();  // what was found with other settings is out of date
    if (!same_carrier_search(before, settings) || before.f0_hz != settings.f0_hz) {
        for (const RecordingEntry& entry : recordings_) {
            const bool told_by_live_run = live_ && entry.id == current_;
            if (entry.recording && !settings_.f0_hz && !told_by_live_run) {
                searchCarrier(entry.id);
            }
        }
        emit carrierChanged();
    }
    if (live_) {
        follow(current_);
    }
}

}  // namespace vybeg::ui
