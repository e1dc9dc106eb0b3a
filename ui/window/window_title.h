#pragma once

#include "ui/document/document.h"

#include <QString>

namespace vybeg::ui {

// "session.vybeg — HRG-17 — run.wav — Vybeg", as far as there are these. `session`: its path.
QString titleOf(const Document& document, const QString& session);

}  // namespace vybeg::ui
