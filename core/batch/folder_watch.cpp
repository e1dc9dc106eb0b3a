#include "core/batch/folder_watch.h"

#include "core/batch/batch_paths.h"
#include "core/batch/list_sets.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

namespace vybeg {

Result<MeasurementList> FolderWatch::look() {
    auto files = TRY(wanted_list(request_));
    fault_.reset();
    MeasurementList come;
    std::set<std::filesystem::path> listed;
    std::optional<std::filesystem::path> list_path;
    std::vector<MeasurementSet> single;
    bool list_in_writing = false;
    for (MeasurementSet& file : files.sets) {
        const std::filesystem::path& path = file.recordings.front().path;
        const bool settled = is_settled(path);
        const bool is_list = is_measurement_list(path);
        list_in_writing = list_in_writing || (is_list && !settled);
        if (!settled) {
            continue;
        }
        if (!is_list) {
            single.push_back(std::move(file));
            continue;
        }
        if (list_path) {
            fault_ = Error{ErrorCode::list_invalid,
                           path.string(),
                           {count_arg(1), "file",
                            words(VYBEG_MESSAGE("Words", "the folder has another list, %1"),
                                  {list_path->filename().string()})}};
            continue;
        }
        list_path = path;
        Result<MeasurementList> list =
            read_measurement_list(path, {request_.open, request_.settings});
        if (!list) {
            fault_ = list.error();
            continue;
        }
        come = std::move(*list);
    }
    if (fault_ || list_in_writing) {  // which files are of its sets is unknown
        return MeasurementList{};
    }
    for (const MeasurementSet& set : come.sets) {
        for (const RecordingRef& recording : set.recordings) {
            listed.insert(recording.path.lexically_normal());
        }
    }
    std::erase_if(come.sets, [this](const MeasurementSet& set) {
        return !std::ranges::all_of(set.recordings, [this](const RecordingRef& recording) {
            return is_settled(recording.path.lexically_normal());
        });
    });
    for (MeasurementSet& file : single) {
        RecordingRef& recording = file.recordings.front();
        if (!listed.contains(recording.path.lexically_normal())) {
            for (const std::string& column : come.other_columns) {
                recording.others.emplace_back(column, "");
            }
            come.sets.push_back(std::move(file));
        }
    }
    return come;
}

bool FolderWatch::is_settled(const std::filesystem::path& path) {
    const std::string now = file_stamp(path);
    std::string& before = stamps_[path.lexically_normal()];
    const bool same = before == now && now != no_file;
    before = now;
    return same;
}

void pause(const std::stop_token& stop, double seconds) {
    std::mutex mutex;
    std::condition_variable_any never;
    std::unique_lock lock(mutex);
    never.wait_for(lock, stop, std::chrono::duration<double>(seconds), [] { return false; });
}

}  // namespace vybeg
