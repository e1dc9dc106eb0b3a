#include "ui/document/message.h"

#include "ui/words/error_text.h"

#include <utility>

namespace vybeg::ui {

Message errorMessage(const Error& error, Topic topic) {
    return {Severity::error, [error] { return errorText(error); }, {}, {}, topic};
}

Message warningMessage(std::function<QString()> text) {
    return {Severity::warning, std::move(text), {}, {}};
}

Message warningMessage(const QString& file, const Diagnostic& diagnostic) {
    return warningMessage([file, diagnostic] {
        return QStringLiteral("%1: %2").arg(file, diagnosticText(diagnostic));
    });
}

}  // namespace vybeg::ui
