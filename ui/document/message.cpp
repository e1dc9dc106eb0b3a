#include "ui/document/message.h"

#include "ui/words/error_text.h"

namespace vybeg::ui {

Message errorMessage(const Error& error, Topic topic) {
    return {Severity::error, [error] { return errorText(error); }, {}, {}, topic};
}

}  // namespace vybeg::ui
