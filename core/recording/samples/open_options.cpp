#include "core/recording/samples/open_options.h"

#include "core/base/number_text.h"
#include "core/base/read_value.h"

#include <algorithm>
#include <array>
#include <system_error>

namespace vybeg {
namespace {

template <class Value>
struct Named {
    std::string_view name;
    Value value;
};

constexpr std::array<Named<char>, 5> delimiters = {
    {{"comma", ','}, {"semicolon", ';'}, {"tab", '\t'}, {"space", ' '}, {"bar", '|'}}};

constexpr std::array<Named<double>, 4> time_units = {
    {{"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}}};

template <class Value, std::size_t count>
std::optional<Value> value_of(const std::array<Named<Value>, count>& list, std::string_view name) {
    const auto found = std::ranges::find(list, name, &Named<Value>::name);
    return found == list.end() ? std::nullopt : std::optional(found->value);
}

template <class Value, std::size_t count>
std::string name_of(const std::array<Named<Value>, count>& list, Value value) {
    const auto found = std::ranges::find(list, value, &Named<Value>::value);
    return found == list.end() ? "" : std::string(found->name);
}

}  // namespace

Status check_choice(const TextChoice& choice) {
    if (choice.delimiter && delimiter_name(*choice.delimiter).empty()) {
        return refused_value("--delimiter", std::string(1, *choice.delimiter),
                             "it is comma, semicolon, tab, space or bar");
    }
    if (choice.lines_to_skip &&
        (*choice.lines_to_skip < 0 || *choice.lines_to_skip > most_skipped_lines)) {
        return refused_value("--skip-lines", integer_text(*choice.lines_to_skip),
                             "it must lie between 0 and " + integer_text(most_skipped_lines));
    }
    if (choice.time_column && *choice.time_column < 0) {
        return refused_value("--time-column", std::to_string(*choice.time_column),
                             "it is the number of a column, from 1, or none");
    }
    if (choice.time_unit_s && time_unit_name(*choice.time_unit_s).empty()) {
        return refused_value("--time-unit", short_text(*choice.time_unit_s),
                             "it is s, ms, us or ns");
    }
    return {};
}

std::optional<char> delimiter_from_name(std::string_view name) {
    return value_of(delimiters, name);
}

std::string delimiter_name(char delimiter) {
    return name_of(delimiters, delimiter);
}

std::optional<double> time_unit_from_name(std::string_view name) {
    return value_of(time_units, name);
}

std::string time_unit_name(double seconds) {
    return name_of(time_units, seconds);
}

std::filesystem::path file_from(const std::filesystem::path& folder, std::string name) {
    std::error_code unknown;
    if (!std::filesystem::exists(folder / name, unknown)) {
        std::ranges::replace(name, '\\', '/');
    }
    return folder / name;
}

void find_files_from(const std::filesystem::path& folder, OpenOptions& options) {
    const auto find = [&folder](std::string& name) {
        name = name.empty() ? name : file_from(folder, name).lexically_normal().string();
    };
    find(options.channel_d_file);
    for (std::string& name : options.join) {
        find(name);
    }
}

std::vector<std::filesystem::path> further_files(const OpenOptions& options) {
    std::vector<std::filesystem::path> files(options.join.begin(), options.join.end());
    if (!options.channel_d_file.empty()) {
        files.emplace_back(options.channel_d_file);
    }
    return files;
}

}  // namespace vybeg
