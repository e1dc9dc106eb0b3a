#include "app/cli_log.h"

#include "core/base/messages.h"
#include "core/base/plain_text.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <unistd.h>

namespace vybeg::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string json_line(const Json& object) {
    return object.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

Log::Log(bool json, bool quiet) : json_(json), quiet_(quiet), terminal_(isatty(STDERR_FILENO)) {}

Log::~Log() {
    clear_progress();
}

// One write for one line: lines of several programs on one terminal stay whole.
void Log::line(const std::string& text) {
    clear_progress();
    std::fputs((text + "\n").c_str(), stderr);
}

void Log::clear_progress() {
    if (percent_ >= 0 && !json_) {
        std::fputs("\r      \r", stderr);
        percent_ = -1;
    }
}

void Log::warnings(std::span<const Diagnostic> diagnostics, const std::string& about) {
    if (quiet_) {
        return;
    }
    for (const Diagnostic& diagnostic : diagnostics) {
        const std::string text = english(diagnostic);
        if (!json_) {
            line("vybeg-cli: warning: " + (about.empty() ? "" : plain_text(about) + ": ") + text);
            continue;
        }
        Json object{{"level", "warning"},
                    {"code", kind_name(diagnostic.kind)},
                    {"text", text},
                    {"first_frame", diagnostic.first_frame},
                    {"count", diagnostic.count}};
        if (!about.empty()) {
            object["input"] = about;
        }
        line(json_line(object));
    }
}

void Log::warnings(std::span<const NamedWarnings> all) {
    for (const auto& [about, diagnostics] : all) {
        warnings(diagnostics, about);
    }
}

int Log::fail(const Error& error, const std::string& about) {
    const std::string text = english(error);
    const int status = exit_status(error.code);
    if (!json_) {
        line("vybeg-cli: " + (about.empty() ? "" : plain_text(about) + ": ") + text);
        return status;
    }
    Json object{
        {"level", "error"}, {"code", code_name(error.code)}, {"text", text}, {"status", status}};
    if (!about.empty()) {
        object["set"] = about;
    }
    line(json_line(object));
    return status;
}

int Log::fail_usage(const std::string& sentence) {
    const int status = exit_status(ErrorCode::setting_invalid);
    line(json_ ? json_line({{"level", "error"},
                            {"code", code_name(ErrorCode::setting_invalid)},
                            {"text", sentence},
                            {"status", status}})
               : "vybeg-cli: " + sentence + " See vybeg-cli --help.");
    return status;
}

void Log::progress(double fraction) {
    const int percent = static_cast<int>(100 * fraction);
    if (quiet_ || percent == percent_ || !(json_ || terminal_)) {
        return;
    }
    if (json_) {
        if (percent / 10 == percent_ / 10 && percent_ >= 0) {
            return;  // ten lines are enough for a log
        }
        line(json_line({{"level", "progress"},
                        {"code", "progress"},
                        {"text", std::to_string(percent) + " %"},
                        {"percent", percent}}));
    } else {
        std::fprintf(stderr, "\r%3d %% ", percent);
    }
    percent_ = percent;
}

}  // namespace vybeg::cli
