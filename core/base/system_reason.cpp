#include "core/base/system_reason.h"

#include <array>
#include <cstring>

namespace vybeg {
namespace {

// The texts of glibc that the window has translations for.
[[maybe_unused]] constexpr std::array translated{
    VYBEG_MESSAGE("Words", "Disk quota exceeded"),
    VYBEG_MESSAGE("Words", "File name too long"),
    VYBEG_MESSAGE("Words", "File too large"),
    VYBEG_MESSAGE("Words", "Input/output error"),
    VYBEG_MESSAGE("Words", "Is a directory"),
    VYBEG_MESSAGE("Words", "No space left on device"),
    VYBEG_MESSAGE("Words", "No such file or directory"),
    VYBEG_MESSAGE("Words", "Not a directory"),
    VYBEG_MESSAGE("Words", "Operation not permitted"),
    VYBEG_MESSAGE("Words", "Permission denied"),
    VYBEG_MESSAGE("Words", "Read-only file system"),
    VYBEG_MESSAGE("Words", "Too many open files"),
};

}  // namespace

MessageArg system_reason(int error) {
    const char* reason = strerrordesc_np(error);  // unlike strerror, the same in every locale
    return words(reason != nullptr ? reason : VYBEG_MESSAGE("Words", "unknown error"));
}

}  // namespace vybeg
