#pragma once

#include "core/base/message_arg.h"
#include "core/base/result.h"

#include <string>
#include <vector>

namespace vybeg {

// A file that is read; `taken` says so of an output that leads there, e.g. "it is the recording
// itself".
struct InputPath {
    std::string path;
    MessageArg taken;
};

// A file that is written, "-" for standard output; empty: not asked for.
struct OutputPath {
    std::string option;
    std::string path;
    MessageArg taken;  // of a later output that leads here, e.g. "the result goes there already"
};

// An output replaces neither an input nor another output, whatever their paths are called. Errors:
// setting_invalid.
Status check_outputs(const std::vector<OutputPath>& outputs, const std::vector<InputPath>& inputs);

}  // namespace vybeg
