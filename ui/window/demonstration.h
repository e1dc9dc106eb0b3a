#pragma once

#include "core/base/result.h"

#include <QObject>
#include <QString>

#include <functional>

namespace vybeg::ui {

// Writes the article's case, simulated, as demonstration.wav into the program's own folder, in the
// background, unless it is there already. `done` gets its path, in the thread of `context`, if that
// still exists. Errors: output_failed.
void makeDemonstration(QObject* context, std::function<void(const Result<QString>&)> done);

}  // namespace vybeg::ui
