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

// y over x, straight lines between; beyond the ends, the value of the end, as DAQmx coerces.
struct TdmsTable {
    std::vector<double> x;  // rising
    std::vector<double> y;
};

// How a channel's raw numbers become its unit: the linear scale of the decoder, then the steps.
struct TdmsScaling {
    std::optional<std::uint32_t>
        scaler;  // which of a DAQmx channel's numbers; nothing: its only one
    Scale linear;
    std::vector<std::variant<TdmsPolynomial, TdmsTable>> steps;
};

// The scaling that the NI_Scale properties of the channel, else of its group, else of the file
// describe, the objects being given in this order: from the last scale back through its input
// sources to the raw numbers. None where NI_Scaling_Status says that the samples are scaled
// already. Errors: format_unsupported, with the scale's name, for those of sensors and others that
// are no function of one number; format_damaged.
Result<TdmsScaling> tdms_scaling(const FileBytes& file,
                                 const std::vector<const TdmsObject*>& nearest_first);

// The source with the steps of each channel's scaling applied; the source itself without any. What
// is not finite becomes NaN.
std::shared_ptr<const SampleSource> scaled_by(std::shared_ptr<const SampleSource> source,
                                              const TdmsScaling& c, const TdmsScaling& d);

}  // namespace vybeg
