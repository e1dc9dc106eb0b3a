#pragma once

#include "core/analysis/measurement_list.h"
#include "core/base/result.h"
#include "core/batch/batch_request.h"

#include <filesystem>
#include <map>
#include <optional>
#include <stop_token>
#include <string>

namespace vybeg {

// What has come to a folder so far: the sets of its measurement list, where it has one, whose
// recordings are all there, and every other file as a set of its own. A file counts when its size
// and times are those of the look before: nothing writes it any more.
class FolderWatch {
public:
    static constexpr double pause_s = 1;  // between two looks

    // `request` must outlive this object.
    explicit FolderWatch(const BatchRequest& request) : request_(request) {}

    // Nothing while the folder's list has a fault or is being written. Errors: those of
    // list_of_folder().
    Result<MeasurementList> look();

    // Why the folder's list does not count at the last look: those of read_measurement_list(), and
    // list_invalid for a second list.
    const std::optional<Error>& fault() const { return fault_; }

private:
    bool is_settled(const std::filesystem::path& path);

    const BatchRequest& request_;
    std::optional<Error> fault_;
    std::map<std::filesystem::path, std::string> stamps_;  // of the look before, and of this one
};

// Waits, or until the token stops it.
void pause(const std::stop_token& stop, double seconds);

}  // namespace vybeg
