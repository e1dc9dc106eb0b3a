#pragma once

#include "core/analysis/measurement_list.h"
#include "core/drift/drift_settings.h"
#include "ui/document/background_jobs.h"
#include "ui/document/edits.h"
#include "ui/document/message.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <memory>
#include <optional>
#include <vector>

namespace vybeg::ui {

// Whole-angle logs, and how they are read. Of a log: its absolute path and, once it is known, the
// SHA-256 of what was read.
struct DriftInput {
    std::vector<RecordingRef> logs;
    DriftSettings settings;
};

// Whole-angle logs of one gyro, how they are read, and their drift, which is computed in the
// background after each change of both.
class DriftStore : public QObject {
    Q_OBJECT

public:
    DriftStore(BackgroundJobs& job, UndoSteps& steps) : job_(job), steps_(steps) {}

    const std::vector<RecordingRef>& logs() const { return input_.logs; }
    const DriftSettings& settings() const { return input_.settings; }
    // Steps of undo. A log that is open already stays as it is.
    void open(const QStringList& paths);
    void remove(const QStringList& paths);
    void setSettings(const DriftSettings& settings);
    // No step: of a session.
    void startWith(DriftInput input);

    bool computing() const { return !input_.logs.empty() && !outcome_ && !failure_; }
    // Of the present logs and settings; null where it is computed yet or there is none.
    std::shared_ptr<const DriftOutcome> outcome() const { return outcome_; }
    // Why there is none.
    const std::optional<Error>& failure() const { return failure_; }

signals:
    void opened();   // logs, by a person
    void changed();  // logs, settings or their drift
    void reported(const Message& message);
    void settled(Topic topic);

private:
    void step(const UndoSteps::Words& words, const DriftInput& after);
    void restore(DriftInput input);
    void compute();
    void take(Result<DriftOutcome>&& result);

    BackgroundJobs& job_;
    UndoSteps& steps_;
    DriftInput input_;
    std::shared_ptr<const DriftOutcome> outcome_;
    std::optional<Error> failure_;
};

}  // namespace vybeg::ui
