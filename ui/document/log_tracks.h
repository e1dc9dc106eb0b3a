#pragma once

#include "core/analysis/identify_settings.h"
#include "core/analysis/measurement_list.h"
#include "core/drift/drift_settings.h"
#include "ui/document/background_jobs.h"
#include "ui/document/drift_store.h"
#include "ui/document/set_store.h"
#include "ui/values/ids.h"
#include "ui/values/shown_analysis.h"

#include <QObject>

#include <filesystem>
#include <vector>

namespace vybeg::ui {

// The tracks of the open logs, computed in the background: of the current set, where it has logs,
// and of whole-angle logs, which hold the angle alone. A log that cannot be read has none; who
// reads it for its result says why.
class LogTracks : public QObject {
    Q_OBJECT

public:
    LogTracks(const SetStore& sets, const DriftStore& drift);

    // In the order of the logs, those of the set first.
    const std::vector<ShownAnalysis>& shown() const { return shown_; }

signals:
    void changed();

private:
    // What the tracks follow from, and nothing else.
    struct Input {
        std::vector<RecordingRef> logs;  // of the set: paths and options
        IdentifySettings settings;       // of these: signals and columns
        std::vector<std::filesystem::path> whole_angle;
        DriftSettings drift;  // of those, how they are read

        friend bool operator==(const Input&, const Input&) = default;
    };
    static Result<std::vector<ShownAnalysis>> tracksOf(const Input& input, const JobControl& job);
    Input present() const;
    void follow();
    void take(std::vector<ShownAnalysis> tracks);

    const SetStore& sets_;
    const DriftStore& drift_;
    int made_ = 0;  // ids below zero, which no analysis of the document has
    Input of_;
    std::vector<ShownAnalysis> shown_;
    BackgroundJobs job_;
};

}  // namespace vybeg::ui
