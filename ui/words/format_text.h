#pragma once

#include "core/recording/samples/recording.h"

#include <QString>

namespace vybeg::ui {

// E.g. "WAV, 64 bit float, 2 channels", in the interface's language.
QString formatText(const RecordingFormat& format);

}  // namespace vybeg::ui
