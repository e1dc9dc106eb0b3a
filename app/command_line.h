#pragma once

#include "core/base/read_value.h"
#include "core/base/setting_rows.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace vybeg::cli {

// Values of command-line options, read without regard to the locale (CLI11 itself would follow it).
// What cannot be read throws a CLI::ValidationError with the sentence of setting_invalid.

[[noreturn]] void refuse(const Error& error);
[[noreturn]] void reject(const std::string& option, const std::string& text,
                         const std::string& allowed);

// A value that is refused ends the parse with its sentence.
template <class T>
T accepted(Result<T> value) {
    if (!value) {
        refuse(value.error());
    }
    return std::move(*value);
}

// Adds an option of one value. `placeholder` is the value's name in the help, e.g. "HZ"; `take`
// gets the option's name and the text.
CLI::Option* add_value(CLI::App& app, const std::string& name, const std::string& placeholder,
                       const std::string& help,
                       std::function<void(const std::string&, const std::string&)> take);

// Adds an option, or for an empty placeholder a positional one, whose text goes into `target`.
CLI::Option* add_text(CLI::App& app, const std::string& name, const std::string& placeholder,
                      std::string& target, const std::string& help);

// To be called when all options are defined: an option of one value, or of none, that is given
// twice parses, so that usage_fault() can name it.
void let_repeated_options_parse(CLI::App& app);

// The fault of a command line that does not parse, as one sentence; `words` are the program's
// own name and the line. An option that does not exist comes first, with the one whose name it
// resembles.
std::string parse_fault(const CLI::App& app, const CLI::ParseError& error, std::span<char*> words);

// The fault of a command line that parses: a misspelt option that was read as something else,
// an option given twice, or with an empty value. A sentence; empty where nothing is.
std::string usage_fault(const CLI::App& app, std::span<char*> words);

// The rows of a table of settings as options. `settings` must outlive the parse.
template <class S>
void add_setting(CLI::App& app, const SettingRow<S>& row, S& settings) {
    const auto take = [&row, &settings](const std::string& text) {
        if (const Status read = row.read(text, settings); !read) {
            refuse(read.error());
        }
    };
    if (row.placeholder.empty()) {
        app.add_flag_callback(
            row.option(), [take] { take("yes"); }, row.help);
    } else {
        add_value(app, row.option(), row.placeholder, row.help,
                  [take](const auto&, const auto& text) { take(text); });
    }
}
template <class S>
void add_settings(CLI::App& app, const std::vector<SettingRow<S>>& rows, S& settings) {
    for (const SettingRow<S>& row : rows) {
        add_setting(app, row, settings);
    }
}

// The options that say how a recording is analysed or identified, by their table. `settings` must
// outlive the parse. Their values are checked one by one here and together by validate().
template <class S>
void add_analysis_options(CLI::App& app, const std::vector<SettingRow<S>>& rows, S& settings) {
    add_settings(app, rows, settings);
    app.get_option("--periods")->excludes("--window");
}

}  // namespace vybeg::cli
