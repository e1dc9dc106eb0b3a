#include "app/option_values.h"

#include "core/base/messages.h"
#include "core/base/read_value.h"

#include <utility>

namespace vybeg::cli {

namespace {

// A value that is refused ends the parse with its sentence.
template <class T>
T accepted(Result<T> value) {
    if (!value) {
        throw CLI::ValidationError(english(value.error()));
    }
    return std::move(*value);
}

}  // namespace

void reject(const std::string& option, const std::string& text, const std::string& allowed) {
    throw CLI::ValidationError(english(refused_value(option, text, allowed)));
}

double number_value(const std::string& option, const std::string& text) {
    return accepted(read_number(option, text));
}

std::int64_t whole_value(const std::string& option, const std::string& text) {
    return accepted(read_whole(option, text));
}

std::vector<double> list_value(const std::string& option, const std::string& text,
                               std::size_t count, const std::string& allowed) {
    return accepted(read_numbers(option, text, count, allowed));
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
