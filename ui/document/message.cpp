#include "ui/document/message.h"

#include "ui/words/error_text.h"

#include <algorithm>
#include <utility>

namespace vybeg::ui {

Message errorMessage(const Error& error, Topic topic) {
    return {MessageLevel::error, [error] { return errorText(error); }, topic};
}

Message warningMessage(std::function<QString()> text) {
    return {MessageLevel::warning, std::move(text)};
}

std::vector<Message> warningMessages(const QString& file,
                                     const std::vector<Diagnostic>& diagnostics) {
    std::vector<Message> messages;
    const std::vector<Finding> findings = findings_of(diagnostics);
    for (std::size_t k = 0; k < std::min(count_warnings(findings), most_shown); ++k) {
        messages.push_back(warningMessage([file, finding = findings[k]] {
            return QStringLiteral("%1: %2").arg(file, findingText(finding));
        }));
    }
    return messages;
}

}  // namespace vybeg::ui
