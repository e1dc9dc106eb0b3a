#pragma once

#include "core/base/diagnostic.h"
#include "core/base/error.h"

#include <QString>

#include <cstdint>
#include <functional>
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
    // A button of its own, with its action.
    std::function<QString()> button = {};
    std::function<void()> press = {};
    // What closing the message without its button says.
    std::function<void()> dismiss = {};
    // A question that newer messages do not push out.
    bool until_answered = false;
};

Message errorMessage(const Error& error, Topic topic = Topic::none);
Message warningMessage(std::function<QString()> text);
// A message for each of the worst findings about a file; none for notes.
std::vector<Message> warningMessages(const QString& file,
                                     const std::vector<Diagnostic>& diagnostics);

}  // namespace vybeg::ui
