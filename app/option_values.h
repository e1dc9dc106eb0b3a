#pragma once

#include <CLI/CLI.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vybeg::cli {

// Values of command-line options, read without regard to the locale (CLI11 itself would follow it).
// What cannot be read throws a CLI::ValidationError with the sentence of setting_invalid.

[[noreturn]] void reject(const std::string& option, const std::string& text,
                         const std::string& allowed);

double number_value(const std::string& option, const std::string& text);
std::int64_t whole_value(const std::string& option, const std::string& text);
// Exactly `count` numbers with commas between them.
std::vector<double> list_value(const std::string& option, const std::string& text,
                               std::size_t count, const std::string& allowed);

// Adds an option of one value. `placeholder` stands for the value in the help, e.g. "HZ"; `take`
// gets the option's name and the text.
CLI::Option* add_value(CLI::App& app, const std::string& name, const std::string& placeholder,
                       const std::string& help,
                       std::function<void(const std::string&, const std::string&)> take);

// The same for a number.
CLI::Option* add_number(CLI::App& app, const std::string& name, double& target,
                        const std::string& placeholder, const std::string& help);
CLI::Option* add_number(CLI::App& app, const std::string& name, std::optional<double>& target,
                        const std::string& placeholder, const std::string& help);

// To be called when all options are defined: an option of one value, or of none, that is given
// twice parses, so that usage_fault() can name it.
void let_repeated_options_parse(CLI::App& app);

// What is wrong with a command line that does not parse, as one sentence; `words` are the program's
// own name and the line. An option that does not exist comes first, with the one whose name it
// resembles.
std::string parse_fault(const CLI::App& app, const CLI::ParseError& error, std::span<char*> words);

// What is wrong with a command line that parses: a misspelt option that was read as something else,
// an option given twice, or with an empty value. A sentence; empty where nothing is.
std::string usage_fault(const CLI::App& app, std::span<char*> words);

}  // namespace vybeg::cli
