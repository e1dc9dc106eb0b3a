#pragma once

#include "core/base/result.h"
#include "core/recording/arrays/tdms_segments.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/bytes/number_type.h"
#include "core/recording/samples/sample_source.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace vybeg {

// y = c0 + c1 x + c2 x^2 + ...
struct TdmsPolynomial {
    std::vector<double> coefficients;
};

// y over x, linear between the points; beyond the ends the value of the end, as in DAQmx.
struct TdmsTable {
    std::vector<double> x;  // rising
    std::vector<double> y;
};

// Conversion of a channel's raw numbers to its unit: the linear scale of the decoder, then the
// steps.
struct TdmsScaling {
    std::optional<std::uint32_t>
        scaler;  // id of the number of a DAQmx channel; empty: its only one
    Scale linear;
    std::vector<std::variant<TdmsPolynomial, TdmsTable>> steps;
};

// Scaling by the NI_Scale properties of the channel, otherwise of its group, otherwise of the file
// (`objects` in this order): from the last scale back through its input sources to the raw numbers.
// None if NI_Scaling_Status marks the samples as scaled. Errors: format_unsupported, with the name
// of the scale, for scales of sensors and others that are no function of one number;
// format_damaged.
Result<TdmsScaling> tdms_scaling(const FileBytes& file,
                                 const std::vector<const TdmsObject*>& nearest_first);

// Source with the steps of each channel's scaling; the source itself without steps. Values that are
// not finite become NaN.
std::shared_ptr<const SampleSource> scaled_by(std::shared_ptr<const SampleSource> source,
                                              const TdmsScaling& c, const TdmsScaling& d);

}  // namespace vybeg
