#pragma once

#include "core/base/result.h"
#include "core/recording/text/text_blocks.h"
#include "core/recording/text/text_columns.h"
#include "core/recording/text/text_rows.h"

#include <cstdint>
#include <memory>

namespace vybeg {

// A table of numbers in a text file: where its lines stand, and what is read of them.
struct TextTable {
    TextBlocks blocks;
    TextFormat format;
    TextColumns columns;
    std::int64_t header_lines = 0;  // of those above the table, the ones that are not blank
    std::int64_t footer_lines = 0;  // of those behind it
    bool may_repeat = false;        // the time of the row before, as in logs
};

// Finds the first line below those that `format` skips, and the last one before those that stand
// behind the table (is_behind_table()). Errors: file_read_failed, format_limit.
Result<TextTable> find_table(std::shared_ptr<const FileBytes> file, const TextFormat& format,
                             const TextColumns& columns);

}  // namespace vybeg
