#include "app/option_values.h"

#include "core/base/messages.h"
#include "core/base/number_text.h"

#include <charconv>
#include <cmath>
#include <utility>

namespace vybeg::cli {

void reject(const std::string& option, const std::string& text, const std::string& allowed) {
    throw CLI::ValidationError(
        english(Error{ErrorCode::setting_invalid, "", {option, text, allowed}}));
}

double number_value(const std::string& option, const std::string& text) {
    const std::optional<double> number = parse_number(text);
    if (!number || !std::isfinite(*number)) {
        reject(option, text, "it must be a number, with a point and without a unit");
    }
    return *number;
}

std::int64_t whole_value(const std::string& option, const std::string& text) {
    std::int64_t number = 0;
    const char* const end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, number);
    if (parsed.ec != std::errc{} || parsed.ptr != end) {
        reject(option, text, "it must be a whole number");
    }
    return number;
}

std::vector<double> list_value(const std::string& option, const std::string& text,
                               std::size_t count, const std::string& allowed) {
    std::vector<double> numbers;
    std::size_t begin = 0;
    while (begin <= text.size()) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::optional<double> number = parse_number(text.substr(begin, end - begin));
        if (!number || !std::isfinite(*number)) {
            reject(option, text, allowed);
        }
        numbers.push_back(*number);
        begin = end + 1;
    }
    if (numbers.size() != count) {
        reject(option, text, allowed);
    }
    return numbers;
}

CLI::Option* add_value(CLI::App& app, const std::string& name, const std::string& placeholder,
                       const std::string& help,
                       std::function<void(const std::string&, const std::string&)> take) {
    return app
        .add_option_function<std::string>(
            name, [name, take = std::move(take)](const std::string& text) { take(name, text); },
            help)
        ->type_name(placeholder);
}

CLI::Option* add_number(CLI::App& app, const std::string& name, double& target,
                        const std::string& placeholder, const std::string& help) {
    return add_value(app, name, placeholder, help,
                     [&target](const std::string& option, const std::string& text) {
                         target = number_value(option, text);
                     });
}

CLI::Option* add_number(CLI::App& app, const std::string& name, std::optional<double>& target,
                        const std::string& placeholder, const std::string& help) {
    return add_value(app, name, placeholder, help,
                     [&target](const std::string& option, const std::string& text) {
                         target = number_value(option, text);
                     });
}

namespace {

// Positional ones, and those that take every occurrence.
bool may_repeat(const CLI::Option& option) {
    return option.get_positional() ||
           option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
}

}  // namespace

void let_repeated_options_parse(CLI::App& app) {
    for (CLI::Option* option : app.get_options()) {
        if (!may_repeat(*option)) {
            option->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
        }
    }
    for (CLI::App* command : app.get_subcommands({})) {
        let_repeated_options_parse(*command);
    }
}

std::string usage_fault(const CLI::App& app) {
    for (const CLI::Option* option : app.get_options()) {
        if (may_repeat(*option)) {
            continue;
        }
        if (option->count() > 1) {
            return option->get_name() + " is given twice.";
        }
        if (option->count() == 1 && option->get_expected_max() > 0 &&
            option->results().front().empty()) {
            return option->get_name() + " needs a value.";
        }
    }
    for (const CLI::App* command : app.get_subcommands()) {
        if (const std::string fault = usage_fault(*command); !fault.empty()) {
            return fault;
        }
    }
    return {};
}

}  // namespace vybeg::cli
