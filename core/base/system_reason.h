#pragma once

#include "core/base/message_arg.h"

namespace vybeg {

// Why a call of the system failed, by its errno, as words: English on the command line in every
// locale.
MessageArg system_reason(int error);

}  // namespace vybeg
