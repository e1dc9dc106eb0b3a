#pragma once

#include "core/base/diagnostic.h"
#include "core/base/error.h"

#include <QString>

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace vybeg::ui {

enum class MessageLevel : std::uint8_t { info, warning, error };

// A newer message of a topic replaces the older one; all of them disappear when the topic is
// settled.
enum class Topic : std::uint8_t { none, live, drift };

// A message to the engineer. The text is a function, so that a change of language reaches messages
// that are already on the screen.
struct Message {
    MessageLevel severity = MessageLevel::info;
    std::function<QString()> text;
    Topic topic = Topic::none;
    // Texts of its buttons, with their actions.
    std::vector<std::pair<std::function<QString()>, std::function<void()>>> buttons = {};
    // A question: its buttons close it, newer messages do not push it out.
    bool until_answered = false;
};

Message errorMessage(const Error& error, Topic topic = Topic::none);
Message warningMessage(std::function<QString()> text);
// A message for each of the worst findings about a file; none for notes.
std::vector<Message> warningMessages(const QString& file,
                                     const std::vector<Diagnostic>& diagnostics);

}  // namespace vybeg::ui
