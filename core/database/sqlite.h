#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace vybeg {

// SQLite as objects that close what they opened. For core/database alone: failures are exceptions
// there, and become errors at its boundary.

// A call of SQLite that failed.
struct SqliteFailure : std::runtime_error {
    SqliteFailure(int result, int system, const std::string& text)
        : std::runtime_error(text), code(result), system_error(system) {}

    int code;          // SQLite's, extended
    int system_error;  // errno of the failed system call; 0: none
};

class SqliteConnection {
public:
    // Opens a file that exists, for reading only where the system does not allow more. `wait` is
    // asked, with the number of times since the lock was met, whether to try again; it may sleep.
    // Not for two threads at once. Throws SqliteFailure, std::bad_alloc; so does all below.
    SqliteConnection(const std::string& path, std::function<bool(int)> wait);

    // Statements without results.
    void run(const char* sql);
    bool read_only() const;
    // Whether a transaction is open.
    bool within_transaction() const;
    sqlite3* get() const { return connection_.get(); }

private:
    struct Close {
        void operator()(sqlite3* connection) const;
    };

    std::unique_ptr<std::function<bool(int)>> wait_;  // where SQLite finds it after a move, too
    std::unique_ptr<sqlite3, Close> connection_;
};

// A statement, its values in the order of its question marks, and its rows.
class SqliteStatement {
public:
    SqliteStatement(const SqliteConnection& connection, const char* sql);

    SqliteStatement& bind(std::int64_t value);
    SqliteStatement& bind(double value);  // NaN: NULL
    SqliteStatement& bind(std::string_view text);
    // A long text, as a BLOB that is zlib's stream of it.
    SqliteStatement& bind_packed(std::string_view text);

    // The next row; false: there is none.
    bool step();
    // Runs it to its end and clears its values for the next time.
    void run();

    // Columns of the row, from 0; NULL is NaN, 0 or an empty text. A text that is a BLOB is
    // unpacked.
    bool is_null(int column) const;
    std::int64_t whole(int column) const;
    double number(int column) const;
    std::string text(int column) const;

private:
    struct Finalize {
        void operator()(sqlite3_stmt* statement) const;
    };

    SqliteStatement& bound(int result);

    std::unique_ptr<sqlite3_stmt, Finalize> statement_;
    int bound_ = 0;
};

// BEGIN at its start; ROLLBACK at its end, unless it was committed.
class SqliteTransaction {
public:
    // `sql`: "BEGIN IMMEDIATE" to write, "BEGIN" to read one state of the file.
    SqliteTransaction(SqliteConnection& connection, const char* sql);
    ~SqliteTransaction();
    SqliteTransaction(const SqliteTransaction&) = delete;
    SqliteTransaction& operator=(const SqliteTransaction&) = delete;

    void commit();

private:
    SqliteConnection& connection_;
};

}  // namespace vybeg
