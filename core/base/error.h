#pragma once

#include "core/base/message_arg.h"

#include <exception>
#include <string>
#include <vector>

namespace vybeg {

// Everything that can go wrong, by the rows of error_rows.h.
enum class ErrorCode {
#define ROW(code, status, sentence) code,
#include "core/base/error_rows.h"
#undef ROW
};

// A failure as a value: `where` is the file or setting it concerns; `args` fill the sentence of
// `code`.
struct Error {
    ErrorCode code{};
    std::string where;
    std::vector<MessageArg> args;

    friend bool operator==(const Error&, const Error&) = default;
};

// The name of a code in JSON, e.g. "file-missing".
std::string code_name(ErrorCode code);

// Exit status of the command line for an error (help, files.html): 2, 3, 4, 5 or 130.
int exit_status(ErrorCode code);

MessageRow message_row(ErrorCode code);

// All that a sentence is filled with, in the order of its numbers.
std::vector<MessageArg> message_args(const Error& error);

// The whole English sentence: what, where, why, what to do.
std::string english(const Error& error);

// The error of an exception that no part of the program expects: out_of_memory, out_of_threads,
// or program_fault for a defect.
Error error_of(const std::exception_ptr& exception);

}  // namespace vybeg
