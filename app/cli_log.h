#pragma once

#include "core/base/error.h"
#include "core/base/finding.h"

#include <span>
#include <string>
#include <vector>

namespace vybeg::cli {

// What goes to standard error: sentences for people, or with --json-log one JSON object per line,
// {"level": "warning"|"error"|"waiting"|"progress", "code": .., "text": .., ..}.
class Log {
public:
    // `quiet` leaves only errors; `verbose` shows people all warnings, and notes. Progress for
    // people is shown on a terminal alone.
    Log(bool json, bool quiet, bool verbose = false);
    ~Log();

    // The worst of them, each kind once. `set`: which they concern, where there are several.
    void warnings(std::span<const NamedWarnings> all, const std::string& set = {});
    void warnings(const std::vector<Diagnostic>& diagnostics);
    // Returns the exit status of the error. `about`: the set without a result, where others follow.
    int fail(const Error& error, const std::string& about = {});
    // A wrong command line: exit status 2.
    int fail_usage(const std::string& sentence);
    // What the program waits for; `code` names it in the JSON.
    void waiting(const std::string& code, const std::string& sentence);
    // Never called from two threads at once; fraction 0..1.
    void progress(double fraction);

private:
    void line(const std::string& text);
    void each_warning(std::span<const NamedWarnings> all, const std::string& set);
    void worst_warnings(std::span<const NamedWarnings> all, const std::string& set);
    void clear_progress();

    bool json_;
    bool quiet_;
    bool verbose_;
    bool terminal_;
    int percent_ = -1;  // on the screen
};

}  // namespace vybeg::cli
