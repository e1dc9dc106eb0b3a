#include "ui/document/message.h"

#include "ui/words/error_text.h"

namespace vybeg::ui {

Message errorMessage(const Error& error, Topic topic) {
    return {Severity::error, [error] { return errorText(error); }, {}, {}, topic};
}

Message warningMessage(const QString& file, const Diagnostic& diagnostic) {
    return {Severity::warning,
            [file, diagnostic] {
                return QStringLiteral("%1: %2").arg(file, diagnosticText(diagnostic));
            },
            {},
            {}};
}

}  // namespace vybeg::ui
