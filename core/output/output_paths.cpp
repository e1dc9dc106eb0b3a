#include "core/output/output_paths.h"

#include "core/output/same_file.h"

namespace vybeg {

Status check_outputs(const std::vector<OutputPath>& outputs, const std::vector<InputPath>& inputs) {
    for (std::size_t k = 0; k < outputs.size(); ++k) {
        const OutputPath& output = outputs[k];
        if (output.path.empty()) {
            continue;
        }
        const auto refused = [&output](const MessageArg& reason) {
            return Error{ErrorCode::setting_invalid, "", {output.option, output.path, reason}};
        };
        for (const InputPath& input : inputs) {
            if (!input.path.empty() && same_file(input.path, output.path)) {
                return refused(input.taken);
            }
        }
        for (std::size_t earlier = 0; earlier < k; ++earlier) {
            if (!outputs[earlier].path.empty() && same_file(outputs[earlier].path, output.path)) {
                return refused(outputs[earlier].taken);
            }
        }
    }
    return {};
}

}  // namespace vybeg
