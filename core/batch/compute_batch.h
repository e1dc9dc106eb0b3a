#pragma once

#include "core/base/result.h"
#include "core/batch/batch_request.h"

#include <stop_token>

namespace vybeg {

// The resonators of all sets of a list, as the table RESULTS.csv of the help, which appears
// when its last row is there. The rows until then are in a journal beside it, and each is on the
// disk when its event comes. A set without a result has a row, too. Errors: those of a list and
// of settings; output_failed; out_of_memory and out_of_threads; interrupted, interrupted_midway
// where the journal holds rows, which `resume` of a later batch keeps.
Status compute_batch(const BatchRequest& request, const BatchEvents& events, std::stop_token stop);

}  // namespace vybeg
