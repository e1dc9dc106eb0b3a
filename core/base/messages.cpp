#include "core/base/messages.h"

namespace vybeg {

std::string code_name(ErrorCode code) {
    return message_row(code).name;
}

std::string kind_name(DiagnosticKind kind) {
    return message_row(kind).name;
}

int exit_status(ErrorCode code) {
    return message_row(code).grade;
}

Severity severity(DiagnosticKind kind) {
    return static_cast<Severity>(message_row(kind).grade);
}

std::string severity_name(Severity severity) {
    switch (severity) {
        case Severity::note: return "note";
        case Severity::warning: return "warning";
        case Severity::serious: return "serious";
    }
    return "";
}

std::vector<MessageArg> message_args(const Error& error) {
    std::vector<MessageArg> args{error.where};
    args.insert(args.end(), error.args.begin(), error.args.end());
    return args;
}

std::string english(const Error& error) {
    return english(message_row(error.code).sentence, message_args(error));
}

std::string english(const Diagnostic& diagnostic) {
    return english(message_row(diagnostic.kind).sentence, diagnostic.args);
}

}  // namespace vybeg
