#include "core/resonator/model/reason.h"

#include <array>

namespace vybeg {

MessageRow message_row(ReasonCode code) {
    static constexpr auto rows = std::to_array<MessageRow>({
#define ROW(code, sentence) {#code, 0, sentence},
#include "core/resonator/model/reason_rows.h"
#undef ROW
    });
    return row_at(rows, static_cast<std::size_t>(code));
}

std::string reason_name(ReasonCode code) {
    return message_row(code).name();
}

std::string english(const Reason& reason) {
    return english(message_row(reason.code).sentence, reason.args);
}

}  // namespace vybeg
