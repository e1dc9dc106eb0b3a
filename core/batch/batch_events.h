#pragma once

#include "core/analysis/measurement_list.h"
#include "core/base/error.h"
#include "core/base/finding.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vybeg {

// A row that is safe on the disk.
struct FinishedRow {
    std::size_t set = 0;  // its place in the list
    std::string text;     // as batch_csv.h writes it
    bool kept = false;    // of an earlier batch
    // Of a row of this batch.
    std::vector<NamedWarnings> warnings;
    std::optional<Error> error;  // why the set has no result
};

// Receivers of the events of a batch, called in its threads, never two at once. An empty one
// receives nothing.
struct BatchEvents {
    std::function<void(const std::vector<Diagnostic>&)> warned;  // about the list
    // Everything has been checked; the rows come next, those of an earlier batch first.
    std::function<void(const MeasurementList&)> begun;
    std::function<void(const FinishedRow&)> finished;
    // Another program uses the database; the batch waits for it up to so many seconds. Once, and
    // also beside another event.
    std::function<void(double patience_s)> waiting;
};

}  // namespace vybeg
