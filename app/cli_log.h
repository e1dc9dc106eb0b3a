#pragma once

#include "core/base/diagnostic.h"
#include "core/base/error.h"
#include "core/batch/batch_events.h"

#include <span>
#include <string>

namespace vybeg::cli {

// What goes to standard error: sentences for people, or with --json-log one JSON object per line,
// {"level": "warning"|"error"|"progress", "code": .., "text": .., ..}.
class Log {
public:
    // `quiet` leaves only errors. Progress for people is shown on a terminal alone.
    Log(bool json, bool quiet);
    ~Log();

    // `about`: the file that they concern, where there are several; empty: none.
    void warnings(std::span<const Diagnostic> diagnostics, const std::string& about = {});
    void warnings(std::span<const NamedWarnings> all);
    // Returns the exit status of the error. `about`: the set without a result, where others follow.
    int fail(const Error& error, const std::string& about = {});
    // A wrong command line: exit status 2.
    int fail_usage(const std::string& sentence);
    // Never called from two threads at once; fraction 0..1.
    void progress(double fraction);

private:
    void line(const std::string& text);
    void clear_progress();

    bool json_;
    bool quiet_;
    bool terminal_;
    int percent_ = -1;  // on the screen
};

}  // namespace vybeg::cli
