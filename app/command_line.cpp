#include "app/command_line.h"

#include "core/analysis/list_fields.h"
#include "core/base/error.h"
#include "core/base/plain_text.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

namespace vybeg::cli {
namespace {

// Positional ones, and those that take every occurrence.
bool may_repeat(const CLI::Option& option) {
    return option.get_positional() ||
           option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
}

// The app whose options the words of the line name: the last command of the line.
const CLI::App& command_of(const CLI::App& app) {
    const auto commands = app.get_subcommands();
    return commands.empty() ? app : command_of(*commands.back());
}

std::vector<std::string> option_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        names.insert(names.end(), option->get_lnames().begin(), option->get_lnames().end());
    }
    return names;
}

// The option that a name resembles, or the only one that it begins; empty: none.
std::string option_near(const CLI::App& command, const std::string& name) {
    constexpr std::size_t shortest_beginning = 3;
    const std::vector<std::string> names = option_names(command);
    const auto like = std::ranges::find_if(
        names, [&name](const std::string& each) { return names_resemble(name, each); });
    if (like != names.end()) {
        return *like;
    }
    const auto begins = [&name](const std::string& each) { return each.starts_with(name); };
    const bool only =
        name.size() >= shortest_beginning && std::ranges::count_if(names, begins) == 1;
    return only ? *std::ranges::find_if(names, begins) : "";
}

// Whether CLI11 takes a word for no option, or for another one than its writer means.
bool is_misread(const CLI::App& app, const std::string& word) {
    const CLI::App& command = command_of(app);
    const auto takes = [&word](const CLI::Option* option) {
        return option->get_positional() && std::ranges::count(option->results(), word) > 0;
    };
    const auto is_whole_name = [&] {  // "-output x" would be "-o utput x"
        return std::ranges::count(option_names(command), word.substr(1)) > 0;
    };
    return std::ranges::count(app.remaining(true), word) > 0 ||
           std::ranges::any_of(command.get_options(), takes) ||
           (!word.starts_with("--") && is_whole_name());
}

std::string unknown_option(const CLI::App& app, const std::string& word) {
    const std::string text = "There is no option " + plain_text(word) + ".";
    const std::size_t begin = std::min(word.find_first_not_of('-'), word.size());
    const std::string name = word.substr(begin, word.find('=') - begin);
    const CLI::App& command = command_of(app);
    const bool has_commands = !app.get_subcommands([](const CLI::App*) { return true; }).empty();
    if (&command == &app && has_commands) {
        return "A subcommand is required before " + plain_text(word) + ".";
    }
    if (word == "--" + name && std::ranges::count(option_names(command), name) > 0) {
        return word + " follows its command, as in " + command.get_name() + " " + word + ".";
    }
    if (const std::string near = option_near(command, name); !near.empty()) {
        return text + " Did you mean --" + near + "?";
    }
    std::error_code failed;
    return std::filesystem::exists(word, failed)
               ? text + " The file of this name is ./" + plain_text(word) + "."
               : text;
}

// The first word before "--" that looks like an option and is none, as a sentence; empty: none.
std::string unknown_option(const CLI::App& app, std::span<char*> words) {
    for (const std::string_view word : words.subspan(std::min<std::size_t>(1, words.size()))) {
        if (word == "--") {
            break;
        }
        if (word.size() > 1 && word.starts_with('-') && is_misread(app, std::string(word))) {
            return unknown_option(app, std::string(word));
        }
    }
    return {};
}

// An option of this app or its commands that is given twice, or with an empty value.
std::string repeated_or_empty(const CLI::App& app) {
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
        if (const std::string fault = repeated_or_empty(*command); !fault.empty()) {
            return fault;
        }
    }
    return {};
}

}  // namespace

void refuse(const Error& error) {
    throw CLI::ValidationError(english(error));
}

void reject(const std::string& option, const std::string& text, const std::string& allowed) {
    refuse(refused_value(option, text, allowed));
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

CLI::Option* add_text(CLI::App& app, const std::string& name, const std::string& placeholder,
                      std::string& target, const std::string& help) {
    return app.add_option(name, target, help)->type_name(placeholder);
}

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

// CLI11's own words where they are clear.
std::string parse_fault(const CLI::App& app, const CLI::ParseError& error, std::span<char*> words) {
    if (const std::string fault = unknown_option(app, words); !fault.empty()) {
        return fault;
    }
    std::string text = error.what();
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
        return text.substr(0, text.find(':')) + " needs a value.";
    }
    const bool without_command = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr &&
                                 text.starts_with("A subcommand");
    if (without_command && words.size() > 1 && words[1][0] != '-') {
        return "There is no subcommand \"" + plain_text(words[1]) + "\".";
    }
    std::ranges::replace(text, '\n', ' ');
    text = plain_text(text);
    return text.ends_with('.') ? text : text + ".";
}

std::string usage_fault(const CLI::App& app, std::span<char*> words) {
    const std::string fault = unknown_option(app, words);
    return fault.empty() ? repeated_or_empty(app) : fault;
}

}  // namespace vybeg::cli
