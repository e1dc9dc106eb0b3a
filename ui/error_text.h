#pragma once

#include "core/base/diagnostic.h"
#include "core/base/error.h"
#include "core/estimators/flags.h"
#include "core/track/events.h"

#include <QString>

namespace vybeg::ui {

// Sentences in the interface's language for what core/ returns as codes.
QString errorText(const Error& error);
QString diagnosticText(const Diagnostic& diagnostic);

// Why a window's value is missing or doubtful, e.g. "samples are missing"; empty without a reason.
QString flagsText(Flags flags);

// E.g. "2θ_A passes −π/2, rising".
QString eventText(const Event& event);

}  // namespace vybeg::ui
