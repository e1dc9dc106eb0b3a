#pragma once

#include "core/analysis/identify.h"
#include "core/analysis/identify_settings.h"
#include "core/analysis/measurement_list.h"
#include "core/analysis/passport.h"
#include "core/base/diagnostic.h"
#include "core/base/error.h"
#include "core/base/result.h"
#include "core/output/batch_csv.h"
#include "core/recording/samples/open_options.h"
#include "core/resonator/results/resonator_parameters.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace vybeg {

// One set of a batch, on its way to its row.
struct SetTask {
    const MeasurementSet* set = nullptr;
    std::string passport;      // file that it is compared with; empty: none
    std::string json;          // file of the result; empty: none
    std::string new_passport;  // file of the set's own passport; empty: none
    std::optional<std::vector<ParameterLimit>> limits;  // none: the table has no limits
    std::string key;                                    // of its row
    std::optional<Error> fault = {};                    // why it cannot be computed
};

// A row that is safe on the disk.
struct FinishedRow {
    std::size_t set = 0;  // its place in the list
    BatchRow fields;      // of the table
    bool kept = false;    // of an earlier batch
    // Of a row of this batch.
    std::vector<NamedWarnings> warnings{};
    std::optional<Error> error{};  // why the set has no result
    IdentifyTiming timing{};
    double write_s = 0;  // files and database
};

// Receivers of the events of a batch, called in its threads, never two at once; the first three are
// set.
struct BatchEvents {
    std::function<void(const std::vector<Diagnostic>&)> warned;  // about the list
    // Everything has been checked; the rows come next, those of an earlier batch first.
    std::function<void(const MeasurementList&)> begun;
    std::function<void(const FinishedRow&)> finished;
    // The caller's monotonic clock, s (job_control.h); empty: no durations.
    std::function<double()> clock{};
    // Of a watched folder: why its list does not count now; empty: nobody asks.
    std::function<void(const Error&)> failed{};
};

// A batch: the sets of a measurement list, the table of their results, and what goes beside it.
struct BatchRequest {
    std::string program;        // name and version, for the table and all that goes beside it
    std::string list;           // or a folder of recordings
    std::string output;         // "-": standard output
    std::string json;           // folder of the results; empty: none
    std::string passports;      // folder of the gyros' passports; empty: none
    std::string new_passports;  // folder of a passport for each set; empty: none
    std::string limits;         // table of limits; empty: none
    std::string database;       // file that the results also go into; empty: none
    std::string only;           // this set alone; empty: all
    int jobs = 1;               // sets at once
    bool resume = false;
    bool watch = false;  // the list is a folder that fills
    bool excel = false;  // the table with ";", decimal commas, a byte order mark, no comment lines
    OpenOptions open;
    IdentifySettings settings;
    CompareOptions compare;
};

// The resonators of all sets of a list, as the table RESULTS.csv of the help, which appears
// when its last row is there. The rows until then are in a journal beside it, and each is on the
// disk when its event comes. A set without a result has a row, too. Errors: those of a list and
// of settings; output_failed; out_of_memory and out_of_threads; interrupted, interrupted_midway
// where the journal holds rows, which `resume` of a later batch keeps.
Status compute_batch(const BatchRequest& request, const BatchEvents& events, std::stop_token stop);

}  // namespace vybeg
