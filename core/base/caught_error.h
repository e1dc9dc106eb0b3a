#pragma once

#include "core/base/error.h"

#include <exception>

namespace vybeg {

// The error behind an exception that no part of the program expects: out_of_memory, out_of_threads,
// or program_fault for a defect.
Error error_of(const std::exception_ptr& exception);

}  // namespace vybeg
