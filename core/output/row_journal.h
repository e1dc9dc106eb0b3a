#pragma once

#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace vybeg {

// Finished rows of a table whose computation takes long, in a file beside it. Each row is on the
// disk when append() returns; a later run reads the rows and computes only those that are missing.
// A row that was half written when the program or the system ended does not count: each has its
// own hash, and bytes after the last line feed are cut off. Not for two threads at once.
class RowJournal {
public:
    // Opens the file, makes it if there is none, and locks it until this object goes. `resume`:
    // takes the rows found; otherwise begins without rows, and those found stay in the file. An
    // empty path: no file, for rows of this run only. Errors: output_failed, also
    // while another process holds the file and where another kind of file has this name;
    // file_read_failed.
    static Result<RowJournal> open(const std::filesystem::path& path, bool resume);

    // `key` names the row and all that it depends on, in one line without spaces.
    bool has(const std::string& key) const { return places_.contains(key); }
    // Whether the file has no rows, those found included.
    bool empty() const { return rows_.empty() && found_ == 0; }
    // Number of rows found that are not taken.
    std::size_t found() const { return found_; }
    std::size_t size() const { return places_.size(); }
    struct Row {
        std::string key;
        std::string text;
    };
    // All rows, in the order of their lines; of several with one key the last counts.
    const std::vector<Row>& rows() const { return rows_; }
    // Precondition: has(key).
    const std::string& row(const std::string& key) const { return rows_[places_.at(key)].text; }
    // `row`: one line without its line feed. An error leaves the rows before. Errors:
    // output_failed.
    Status append(const std::string& key, std::string_view row);

    // Removes the file: the rows are in their table, or there are none.
    void remove() noexcept;

private:
    explicit RowJournal(std::filesystem::path path) : path_(std::move(path)) {}
    Status begin(bool resume);
    Status find_rows();
    void add(const std::string& key, std::string_view row);
    Status write(std::string_view bytes);
    Result<std::string> read(std::int64_t offset, std::size_t size) const;
    Error failed(int error) const;

    std::filesystem::path path_;
    Descriptor descriptor_;
    std::int64_t end_ = 0;
    std::vector<Row> rows_;
    std::map<std::string, std::size_t> places_;  // in rows_, by key
    std::size_t found_ = 0;
};

}  // namespace vybeg
