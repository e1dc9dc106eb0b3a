#pragma once

#include "core/base/diagnostic.h"
#include "core/base/error.h"
#include "core/estimators/wave/estimator.h"
#include "core/recording/samples/recording.h"
#include "core/resonator/model/reason.h"
#include "core/track/events.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace vybeg::ui {

// Sentences in the interface's language for what core/ returns as codes.
QString errorText(const Error& error);
QString diagnosticText(const Diagnostic& diagnostic);
// As english(finding) of core/base/diagnostic.h.
QString findingText(const Finding& finding);
QStringList findingTexts(const std::vector<Finding>& findings);
// "4 more".
QString moreText(std::size_t count);
// Of sentences, the worst first, the most_shown worst and the number of the others.
QStringList worstOf(QStringList sentences);
// Empty for a number that is given.
QString reasonText(const Reason& reason);

// Why a window's value is missing or doubtful, e.g. "samples are missing"; empty without a reason.
QString flagsText(Flags flags);

// E.g. "2θ_A passes −90°, rising".
QString eventText(const Event& event);

// E.g. "WAV, 64 bit float, 2 channels", in the interface's language.
QString formatText(const RecordingFormat& format);

}  // namespace vybeg::ui
