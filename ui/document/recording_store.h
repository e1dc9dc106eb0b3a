#pragma once

#include "core/analysis/identify.h"
#include "core/analysis/measurement_list.h"
#include "ui/document/background_jobs.h"
#include "ui/document/edits.h"
#include "ui/document/message.h"
#include "ui/values/ids.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace vybeg::ui {

// A recording in the window's list. `recording` is empty while the file is being opened; an
// envelope exists earlier where opening takes long.
struct RecordingEntry {
    RecordingId id = RecordingId::none;
    QString path;
    QString name;
    OpenOptions options;
    int together = 0;  // the same of those that were opened at once
    std::optional<Recording> recording;
    std::optional<double> f0_hz;               // once the search has found it
    std::optional<Settings> f0_search;         // with these settings
    Calibration f0_calibration;                // of that search, offsets found
    QString sha256;                            // once it is computed
    std::shared_ptr<const Envelope> envelope;  // of what has been read so far, or of samples of it
    double envelope_rate_hz = 0;               // frames of the envelope in a second
    std::shared_ptr<const SampleFaults> faults;  // of the finished recording check
};

// The open recordings and what the background finds out about each: envelope, carrier, recording
// check, hash.
class RecordingStore : public QObject {
    Q_OBJECT

public:
    RecordingStore(BackgroundJobs& job, const SettingsModel& settings, IdCounter& ids)
        : job_(job), settings_(settings), ids_(ids) {}

    const std::vector<RecordingEntry>& all() const { return recordings_; }
    const RecordingEntry* find(RecordingId id) const;
    const RecordingEntry* findPath(const QString& absolute_path) const;
    // Its place in the list; the size of the list for one that is not open.
    std::size_t place(RecordingId id) const;
    const RecordingEntry* current() const { return find(current_); }
    // The current recording and those that were opened at once with it.
    std::vector<RecordingId> openedTogether() const;
    void setCurrent(RecordingId id);

    void open(const QStringList& paths, const OpenOptions& options);
    // Ids in the order of `wanted`; a recording that is open in the same way is taken as it is.
    std::vector<RecordingId> openOnce(const std::vector<RecordingRef>& wanted);
    // Under the id and at the place of one that was closed.
    void openAs(RecordingId id, std::size_t place, const QString& path, const OpenOptions& options);
    void close(RecordingId id);

    // The carrier that counts windows: the setting, else that of the current recording.
    std::optional<double> carrier() const;
    void searchCarrier(RecordingId id);
    // The settings with the recording's carrier and offsets where a search with these settings has
    // found them: the search always gives the same and is the longest part of a short analysis.
    static Settings withKnownCarrier(const RecordingEntry& entry, Settings settings);
    // Takes the carrier from an analysis with the present settings.
    void learnCarrier(RecordingId id, const Settings& requested, const Settings& used);

signals:
    void listChanged();
    void changed(RecordingId id);        // something became known about one
    void envelopeGrown(RecordingId id);  // it covers more
    void currentChanged();
    void carrierChanged();
    void opened(RecordingId id);
    void openFailed(RecordingId id, const Message& message);
    // A log in place of a recording; `whole_angle`: of an angle under control.
    void foundLog(RecordingId id, const QString& path, bool whole_angle);
    // A file that opens with other import options (rate, channels, raw layout).
    void importWanted(const QString& path, const OpenOptions& options);
    void reported(const Message& message);

private:
    void begin(RecordingId id, std::size_t place, const QString& path, const OpenOptions& options);
    RecordingEntry* entry(RecordingId id) { return const_cast<RecordingEntry*>(find(id)); }
    void showOpened(RecordingId id);
    void whenOpened(RecordingId id, Result<Recording> result);
    void readEnvelope(RecordingId id);
    void checkSamples(RecordingId id);
    void whenChecked(RecordingId id, SampleFaults faults);
    void hashFile(RecordingId id);

    BackgroundJobs& job_;
    const SettingsModel& settings_;
    IdCounter& ids_;
    std::vector<RecordingEntry> recordings_;
    RecordingId current_ = RecordingId::none;
};

}  // namespace vybeg::ui
