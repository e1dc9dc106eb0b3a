#include "core/recording/text/text_layout.h"

#include <algorithm>

namespace vybeg {

std::vector<int> channel_columns(const TextFormat& format) {
    std::vector<int> columns;
    for (int column = 0; column < format.columns; ++column) {
        if (column != format.time_column && column != format.counter_column &&
            std::ranges::find(format.no_channels, column) == format.no_channels.end()) {
            columns.push_back(column);
        }
    }
    return columns;
}

}  // namespace vybeg
