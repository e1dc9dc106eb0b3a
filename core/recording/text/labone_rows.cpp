#include "core/recording/text/labone_rows.h"

#include "core/base/number_text.h"
#include "core/recording/samples/text_fields.h"
#include "core/recording/text/text_lines.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>

namespace vybeg {
namespace {

constexpr double missing_value = std::numeric_limits<double>::quiet_NaN();
constexpr std::string_view first_name = "chunk";
constexpr std::size_t values_from = 4;  // place of the first one in a line

// Fields of all chunks so far.
struct LaboneFields {
    std::vector<LaboneField> each;
    std::size_t before = 0;  // values of each before the present chunk

    void begin_chunk() {
        for (const LaboneField& field : each) {
            before = std::max(before, field.values.size());
        }
        for (LaboneField& field : each) {
            field.values.resize(before, missing_value);
        }
    }

    void add(const std::vector<std::string_view>& parts) {
        const std::string name(trimmed(parts[values_from - 1]));
        auto field = std::ranges::find(each, name, &LaboneField::name);
        if (field == each.end()) {
            each.push_back({name, std::vector<double>(before, missing_value)});
            field = std::prev(each.end());
        }
        const auto size = parse_number(trimmed(parts[values_from - 2]));
        const std::size_t count = parts.size() - values_from;
        const bool told = size && *size >= 0 && *size < static_cast<double>(count);
        const std::size_t end = values_from + (told ? static_cast<std::size_t>(*size) : count);
        for (std::size_t k = values_from; k < end; ++k) {
            field->values.push_back(parse_number(trimmed(parts[k])).value_or(missing_value));
        }
    }
};

}  // namespace

bool is_labone_rows(std::string_view head) {
    const std::string_view line = head.substr(0, head.find_first_of("\r\n"));
    return line.starts_with(first_name) && line.find("fieldname") != std::string_view::npos;
}

Result<std::vector<LaboneField>> read_labone_rows(std::shared_ptr<const FileBytes> file,
                                                  const JobControl& job) {
    TextLines lines(file);
    const auto heading = TRY(lines.next());
    LaboneFields fields;
    if (!heading || heading->size() <= first_name.size()) {
        return std::move(fields.each);
    }
    const char delimiter = (*heading)[first_name.size()];
    std::string chunk;
    int chunks = 0;
    while (true) {
        const auto line = TRY(lines.next());
        if (!line) {
            break;
        }
        TRY(job.go_on());
        const std::vector<std::string_view> parts = parts_between(*line, delimiter);
        if (parts.size() <= values_from) {
            continue;
        }
        if (chunks == 0 || parts[0] != chunk) {
            chunk = parts[0];
            ++chunks;
            fields.begin_chunk();
        }
        fields.add(parts);
    }
    fields.begin_chunk();
    const bool timed =
        std::ranges::find(fields.each, "timestamp", &LaboneField::name) != fields.each.end();
    if (chunks > 1 && !timed) {
        return file->unsupported(
            "LabOne", VYBEG_MESSAGE("Words", "several chunks without a field timestamp"));
    }
    return std::move(fields.each);
}

}  // namespace vybeg
