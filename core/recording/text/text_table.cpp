#include "core/recording/text/text_table.h"

#include "core/recording/samples/text_fields.h"
#include "core/recording/text/text_lines.h"

#include <array>
#include <string_view>

namespace vybeg {

Result<TextTable> find_table(std::shared_ptr<const FileBytes> file, const TextFormat& format,
                             const TextColumns& columns) {
    std::array<char, 4> bytes{};
    const auto got = TRY(file->read(0, bytes));
    const std::string_view head(bytes.data(), static_cast<std::size_t>(got));
    auto begin = static_cast<std::int64_t>(mark_length(head));
    std::int64_t header_lines = 0;
    TextLines lines(file);
    while (lines.number() < format.lines_to_skip) {
        const auto line = TRY(lines.next());
        if (!line) {
            break;
        }
        header_lines += trimmed(*line).empty() ? 0 : 1;
        begin = lines.position();
    }
    const auto content = TRY(end_of_content(*file, encoding_of(head), begin));
    std::int64_t footer_lines = 0;
    const auto end =
        TRY(end_of_table(*file, encoding_of(head), begin, content, [&](std::string_view line) {
            const bool behind = is_behind_table(line, format);
            footer_lines += behind && !trimmed(line).empty() ? 1 : 0;
            return behind;
        }));
    return TextTable{TextBlocks(file, encoding_of(head), begin, end), format, columns, header_lines,
                     footer_lines};
}

}  // namespace vybeg
