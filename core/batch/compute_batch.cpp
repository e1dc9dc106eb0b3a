#include "core/analysis/measurement_list.h"
#include "core/analysis/setting_table.h"
#include "core/base/number_text.h"
#include "core/base/read_value.h"
#include "core/base/result.h"
#include "core/batch/batch_request.h"
#include "core/batch/batch_sets.h"
#include "core/batch/limits.h"
#include "core/batch/set_work.h"
#include "core/database/results_database.h"
#include "core/output/batch_csv.h"
#include "core/output/output_file.h"
#include "core/output/output_paths.h"
#include "core/recording/bytes/sha256.h"
#include "core/recording/samples/open_table.h"
#include "core/recording/text/csv_rows.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

namespace fs = std::filesystem;

Result<std::vector<std::string>> header_of(const BatchRequest& request, const JobControl& job) {
    const bool folder = is_folder(request.list);
    const fs::path path = fs::path(request.list).lexically_normal();
    const fs::path name = path.has_filename() ? path.filename() : path.parent_path().filename();
    std::vector<std::string> lines{request.program,
                                   (folder ? "folder: " : "list: ") + name.string()};
    if (!folder) {
        const auto sha256 = TRY(file_sha256(request.list, job));
        lines.push_back("sha256: " + sha256);
    }
    if (request.open.rate_hz) {
        lines.push_back("rate: " + round_trip_text(*request.open.rate_hz));
    }
    lines.push_back("channels: " + integer_text(request.open.channel_c) + "," +
                    integer_text(request.open.channel_d));
    if (const std::string read_with = options_text(request.open); !read_with.empty()) {
        lines.push_back("read with: " + read_with);
    }
    for (const auto& [setting, value] : settings_list(request.settings)) {
        lines.push_back(setting + ": " + value);
    }
    if (!request.passports.empty()) {
        lines.push_back("f-limit: " + round_trip_text(request.compare.f_limit_ppm));
    }
    if (!request.compare.limits.empty()) {
        lines.push_back("limit: " + practical_limits_text(request.compare.limits));
    }
    if (!request.limits.empty()) {
        const auto sha256 = TRY(file_sha256(request.limits, job));
        lines.push_back("limits: " + fs::path(request.limits).filename().string() +
                        ", sha256: " + sha256);
    }
    return lines;
}

// How many sets do not keep the limits, by the table's column.
struct LimitCounts {
    std::int64_t failed = 0;
    std::int64_t undecided = 0;
};

Status write_table(OutputFile& output, const BatchRequest& request, const std::string& head,
                   const std::vector<SetTask>& tasks, const RowJournal& journal,
                   LimitCounts& counts) {
    const bool limits = !request.limits.empty();
    const std::vector<std::string> names = batch_columns(limits);
    const auto passed = std::ranges::find(names, passed_column) - names.begin();
    TRY(output.write((request.excel ? excel_head(head) : head) + "\n"));
    for (const SetTask& task : tasks) {
        const auto row = TRY(journal.row(task.key));
        if (limits) {
            const std::string field = csv_fields(row).at(static_cast<std::size_t>(passed));
            counts.failed += field == passed_text(Conformity::outside) ? 1 : 0;
            counts.undecided += field == passed_text(Conformity::unknown) ? 1 : 0;
        }
        TRY(output.write((request.excel ? excel_row(row, limits) : row) + "\n"));
    }
    return output.commit();
}

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

    // The folder's measurement list at the last look; empty: none.
    const fs::path& list() const { return list_; }

    // Why the folder's list does not count at the last look: those of read_measurement_list(), and
    // list_invalid for a second list.
    const std::optional<Error>& fault() const { return fault_; }

private:
    bool is_settled(const fs::path& path);

    const BatchRequest& request_;
    fs::path list_;
    std::optional<Error> fault_;
    std::map<fs::path, std::string> stamps_;         // of this look
    std::map<fs::path, std::string> stamps_before_;  // of the look before
};

Result<MeasurementList> FolderWatch::look() {
    auto files = TRY(wanted_list(request_));
    stamps_before_ = std::exchange(stamps_, {});
    fault_.reset();
    list_.clear();
    MeasurementList come;
    std::set<fs::path> listed;
    std::vector<MeasurementSet> single;
    bool list_in_writing = false;
    for (MeasurementSet& file : files.sets) {
        const fs::path& path = file.recordings.front().path;
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
        if (!list_.empty()) {
            fault_ = Error{ErrorCode::list_invalid,
                           path.string(),
                           {count_arg(1), "file",
                            words(VYBEG_MESSAGE("Words", "the folder has another list, %1"),
                                  {list_.filename().string()})}};
            continue;
        }
        list_ = path;
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
    std::erase_if(come.sets, [&](const MeasurementSet& set) {
        bool complete = true;
        for (const RecordingRef& recording : set.recordings) {
            std::vector<fs::path> parts = further_files(recording.open);
            parts.push_back(recording.path);
            for (const fs::path& part : parts) {
                listed.insert(part.lexically_normal());
                complete = is_settled(part) && complete;
            }
        }
        return !complete;
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
    std::ranges::copy(files.warnings, std::back_inserter(come.warnings));
    return come;
}

// A file is looked at once a look, so that one of the folder and of its list is the same.
bool FolderWatch::is_settled(const fs::path& path) {
    const fs::path key = path.lexically_normal();
    const auto [now, is_new] = stamps_.try_emplace(key);
    if (is_new) {
        now->second = file_stamp(path);
    }
    const auto before = stamps_before_.find(key);
    return before != stamps_before_.end() && before->second == now->second &&
           now->second != no_file;
}

// Waits, or until the token stops it.
void pause(const std::stop_token& stop, double seconds) {
    std::mutex mutex;
    std::condition_variable_any never;
    std::unique_lock lock(mutex);
    never.wait_for(lock, stop, std::chrono::duration<double>(seconds), [] { return false; });
}

// A batch, of one list or of all that come to a folder.
class Batch {
public:
    Batch(const BatchRequest& request, const BatchEvents& events, std::stop_token stop)
        : request_(request), events_(events), stop_(std::move(stop)), job_(stop_) {}

    Status compute() {
        TRY(check_request());
        if (request_.watch) {
            return watch();
        }
        const auto list = TRY(chosen_list());
        return compute(list);
    }

private:
    // The sets that are asked for.
    Result<MeasurementList> chosen_list() const {
        auto list = TRY(wanted_list(request_));
        events_.warned(list.warnings);
        if (!request_.only.empty()) {
            auto set = TRY(set_named(list, "--only", request_.only));
            list.sets = {std::move(set)};
        }
        return list;
    }

    Status check_request() {
        TRY(validate(request_.settings));
        TRY(check_options(request_.open));
        for (const std::string& folder :
             {request_.passports, request_.watch ? request_.list : std::string()}) {
            if (!folder.empty() && !is_folder(folder)) {
                return Error{ErrorCode::file_missing, folder, {}};
            }
        }
        if (request_.watch && request_.output == "-") {
            return refused_value("-o", request_.output, "--watch needs a file");
        }
        for (const auto& [option, folder] :
             {std::pair{"--json", &request_.json}, {"--passports-out", &request_.new_passports}}) {
            if (request_.watch && same_file(request_.list, *folder)) {
                return refused_value(option, *folder, "recordings come to this folder");
            }
        }
        if (!request_.limits.empty()) {
            auto read = TRY(read_limits(request_.limits));
            limits_ = std::move(read);
        }
        return {};
    }

    // Computes what has come whenever something has, until it is interrupted.
    Status watch() {
        FolderWatch folder(request_);
        std::optional<Error> told;
        std::vector<Diagnostic> warned;
        std::int64_t sets = 0;
        while (!stop_.stop_requested()) {
            const auto list = TRY(folder.look());
            TRY(check_outputs(
                {{"-o", request_.output, ""}, {"--database", request_.database, ""}},
                {{folder.list().string(),
                  words(VYBEG_MESSAGE("Words", "it is the list of the recordings"))}}));
            std::vector<Diagnostic> fresh;
            std::ranges::copy_if(list.warnings, std::back_inserter(fresh), [&](const auto& each) {
                return std::ranges::find(warned, each) == warned.end();
            });
            if (!fresh.empty()) {
                events_.warned(fresh);
                std::ranges::copy(fresh, std::back_inserter(warned));
            }
            if (folder.fault() != told) {
                told = folder.fault();
                if (told && events_.failed) {
                    events_.failed(*told);
                }
            }
            sets = std::ssize(list.sets);
            TRY(list.sets.empty() ? Status() : compute(list));
            pause(stop_, FolderWatch::pause_s);
        }
        return sets == 0 ? Error{ErrorCode::interrupted, {}, {}}
                         : Error{ErrorCode::interrupted_midway,
                                 request_.output,
                                 {count_arg(sets), count_arg(sets)}};
    }

    // The table of these sets. Of a folder that is watched it stays as it is where all rows are in.
    Status compute(const MeasurementList& list) {
        auto tasks = TRY(tasks_of(request_, list, limits_));
        const auto header = TRY(header_of(request_, job_));
        TRY(check_paths(request_, tasks));
        for (const std::string* folder : {&request_.json, &request_.new_passports}) {
            TRY(folder->empty() ? Status() : make_folder(*folder));
        }
        const auto is_kept = [this](const SetTask& task) { return journal_->has(task.key); };
        if (journal_) {
            TRY(set_keys(tasks));
            if (std::ranges::all_of(tasks, is_kept)) {
                return {};
            }
        }
        auto output = TRY(open_output(request_.output, job_));
        if (!journal_) {
            TRY(open_files(output));
            TRY(set_keys(tasks));
            tell_other_rows(tasks);
        }
        events_.begun(list);
        for (std::size_t k = 0; k < tasks.size(); ++k) {
            if (is_kept(tasks[k])) {  // the row of an earlier batch
                const auto row = TRY(journal_->row(tasks[k].key));
                events_.finished({.set = k,
                                  .text = row,
                                  .kept = true,
                                  .warnings = {},
                                  .error = {},
                                  .timing = {}});
            }
        }
        return compute_rows(list, tasks, header, output);
    }

    // Gives each task the key of its row.
    Status set_keys(std::vector<SetTask>& tasks) const {
        for (SetTask& task : tasks) {
            auto key = TRY(row_key(request_, task, identity_));
            task.key = std::move(key);
        }
        return {};
    }

    Status open_files(const OutputFile& output) {
        if (request_.resume && !output.seekable()) {
            return refused_value("-o", request_.output, "--resume needs a file");
        }
        if (!request_.database.empty()) {
            constexpr double patience_s = 60;
            const auto waits = [this](const Diagnostic& waiting) {
                const std::lock_guard lock(mutex_);
                events_.warned({waiting});
            };
            auto opened = TRY(ResultsDatabase::open(
                request_.database, ResultsDatabase::Access::write, job_, patience_s, waits));
            auto identity = TRY(opened.identity());
            identity_ = std::move(identity);
            database_.emplace(std::move(opened));
        }
        auto journal = TRY(RowJournal::open(output.seekable() ? journal_of(request_.output) : "",
                                            request_.resume));
        journal_.emplace(std::move(journal));
        if (journal_->found() > 0) {
            events_.warned({{DiagnosticKind::earlier_rows,
                             {journal_of(request_.output),
                              count_arg(static_cast<std::int64_t>(journal_->found()))}}});
        }
        return {};
    }

    // Under --only the rows of other sets are theirs.
    void tell_other_rows(const std::vector<SetTask>& tasks) {
        const auto kept = std::ranges::count_if(
            tasks, [this](const SetTask& task) { return journal_->has(task.key); });
        const auto others = static_cast<std::int64_t>(journal_->size()) - kept;
        if (request_.only.empty() && others > 0) {
            events_.warned(
                {{DiagnosticKind::other_rows, {journal_of(request_.output), count_arg(others)}}});
        }
    }

    Status compute_rows(const MeasurementList& list, const std::vector<SetTask>& tasks,
                        const std::vector<std::string>& header, OutputFile& output) {
        const auto last_id = TRY(database_ ? database_->last_id() : Result<std::int64_t>(0));
        SetWork work({request_, tasks, *journal_, database_ ? &*database_ : nullptr, last_id,
                      events_, mutex_},
                     stop_);
        Status done = work.run();
        LimitCounts counts;
        if (done) {
            done = write_table(output, request_,
                               batch_head(header, list.other_columns, !request_.limits.empty()),
                               tasks, *journal_, counts);
        }
        if (!done) {
            return as_left(done.error(), output, work.done(), std::ssize(tasks));
        }
        if (request_.watch) {
            return {};
        }
        journal_->remove();
        if (counts.failed + counts.undecided > 0) {
            events_.warned({{DiagnosticKind::limits_not_kept,
                             {count_arg(counts.failed), count_arg(counts.undecided),
                              count_arg(std::ssize(tasks))}}});
        }
        return {};
    }

    // The error that ends the batch; one of an interruption that leaves rows names --resume.
    // Removes a journal without rows.
    Error as_left(const Error& error, const OutputFile& output, std::size_t done,
                  std::int64_t sets) {
        if (journal_->empty()) {  // rows of other settings may be wanted again
            journal_->remove();
        }
        const bool kept = done > 0 && output.seekable();
        return error.code == ErrorCode::interrupted && kept
                   ? Error{ErrorCode::interrupted_midway,
                           output.name(),
                           {count_arg(static_cast<std::int64_t>(done)), count_arg(sets)}}
                   : output.as_it_stands(error);
    }

    const BatchRequest& request_;
    const BatchEvents& events_;
    std::mutex mutex_;  // of the events, while several threads work
    std::stop_token stop_;
    JobControl job_;
    std::vector<TypedLimit> limits_;
    std::optional<ResultsDatabase> database_;
    std::string identity_;  // of the database
    std::optional<RowJournal> journal_;
};

}  // namespace

Status compute_batch(const BatchRequest& request, const BatchEvents& events, std::stop_token stop) {
    return Batch(request, events, std::move(stop)).compute();
}

}  // namespace vybeg
