#pragma once

#include "core/base/result.h"
#include "ui/values/recording_set.h"

#include <QJsonObject>

namespace vybeg::ui {

// An identification as a session keeps it: its passport without the tracks of the waves, the
// warnings, and what became of each recording.
QJsonObject keptResult(const ResonatorOutcome& outcome);

// The reverse, without the motion of the waves, the drift function and the balance of the channels;
// `program`: the one that identified it. Errors: passport_damaged, passport_schema.
struct ReadResult {
    ResonatorOutcome outcome;
    QString program;
};
Result<ReadResult> readKeptResult(const QJsonObject& json);

}  // namespace vybeg::ui
