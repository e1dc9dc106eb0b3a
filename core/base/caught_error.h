#pragma once

#include "core/base/error.h"

#include <exception>

namespace vybeg {

// The error behind an exception that no part of the program expects: out_of_memory or
// out_of_threads. Other exceptions are thrown on.
Error error_of(const std::exception_ptr& exception);

}  // namespace vybeg
