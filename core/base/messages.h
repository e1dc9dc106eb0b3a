#pragma once

#include "core/base/diagnostic.h"
#include "core/base/error.h"

#include <string>

namespace vybeg {

// One code: its name in JSON, its grade, its English sentence, and the
// window's sentence where that of the command line names options. %1 stands for `where` and %2, %3,
// ... for the arguments of an error; %1, %2, ... for the arguments of a diagnostic. The desktop
// program translates a sentence (context "Message") before it fills it.
struct MessageRow {
    const char* name;
    int grade;  // of an error the exit status of the command line, of a diagnostic its Severity
    const char* sentence;
    const char* in_window = nullptr;
};

MessageRow message_row(ErrorCode code);
MessageRow message_row(DiagnosticKind kind);

// All that a sentence is filled with, in the order of its numbers.
std::vector<MessageArg> message_args(const Error& error);

// The whole English sentence: what, where, why, what to do.
std::string english(const Error& error);
std::string english(const Diagnostic& diagnostic);

}  // namespace vybeg
