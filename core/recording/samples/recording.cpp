#include "core/recording/samples/recording.h"

namespace vybeg {

std::string rate_origin_name(RateOrigin origin) {
    switch (origin) {
        case RateOrigin::file: return "file";
        case RateOrigin::time_column: return "time column";
        case RateOrigin::option: return "option";
    }
    return "";
}

}  // namespace vybeg
