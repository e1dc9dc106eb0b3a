#include "core/database/sqlite.h"

#include <algorithm>
#include <limits>
#include <new>
#include <sqlite3.h>
#include <zlib.h>

namespace vybeg {
namespace {

void check(int result, sqlite3* connection) {
    if (result == SQLITE_OK || result == SQLITE_ROW || result == SQLITE_DONE) {
        return;
    }
    if ((result & 0xFF) == SQLITE_NOMEM) {
        throw std::bad_alloc();
    }
    const int extended =
        connection != nullptr ? sqlite3_extended_errcode(connection) : static_cast<int>(result);
    throw SqliteFailure(
        extended, connection != nullptr ? sqlite3_system_errno(connection) : 0,
        connection != nullptr ? sqlite3_errmsg(connection) : sqlite3_errstr(result));
}

// The file is untrusted: its packed texts may be of any length. 500 recordings have 10 MB.
constexpr std::size_t longest_packed = std::size_t{64} << 20;

std::string deflated(std::string_view text) {
    uLongf size = compressBound(text.size());
    std::string packed(size, '\0');
    // The best compression takes four times the time for three percent.
    if (compress(reinterpret_cast<Bytef*>(packed.data()), &size,
                 reinterpret_cast<const Bytef*>(text.data()), text.size()) != Z_OK) {
        throw std::bad_alloc();
    }
    packed.resize(size);
    return packed;
}

std::string inflated(std::string_view packed) {
    constexpr std::size_t least_room = 4096;
    constexpr std::size_t usual_ratio = 8;
    std::string text;
    int state = Z_BUF_ERROR;
    for (std::size_t room = std::max(least_room, usual_ratio * packed.size());
         state == Z_BUF_ERROR && text.size() < longest_packed; room *= 2) {
        text.resize(std::min(room, longest_packed));
        uLongf size = text.size();
        state = uncompress(reinterpret_cast<Bytef*>(text.data()), &size,
                           reinterpret_cast<const Bytef*>(packed.data()), packed.size());
        if (state == Z_OK) {
            text.resize(size);
        }
    }
    if (state == Z_MEM_ERROR) {
        throw std::bad_alloc();
    }
    if (state != Z_OK) {
        throw SqliteFailure(SQLITE_CORRUPT, 0, "packed data are wrong or too long");
    }
    return text;
}

int ask(void* wait, int times) {
    return (*static_cast<std::function<bool(int)>*>(wait))(times) ? 1 : 0;
}

}  // namespace

void SqliteConnection::Close::operator()(sqlite3* connection) const {
    sqlite3_close_v2(connection);
}

SqliteConnection::SqliteConnection(const std::string& path, std::function<bool(int)> wait)
    : wait_(std::make_unique<std::function<bool(int)>>(std::move(wait))) {
    sqlite3* opened = nullptr;
    const int result = sqlite3_open_v2(path.c_str(), &opened,
                                       SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOMUTEX, nullptr);
    connection_.reset(opened);
    check(result, opened);
    check(sqlite3_busy_handler(opened, ask, wait_.get()), opened);
    // The file may be anyone's: nothing in its schema runs, and its pages are looked over.
    sqlite3_db_config(opened, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(opened, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(opened, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    run("PRAGMA cell_size_check = ON");
    run("PRAGMA foreign_keys = ON");
    // A row reported as stored survives a loss of power.
    run("PRAGMA synchronous = EXTRA");
}

void SqliteConnection::run(const char* sql) {
    check(sqlite3_exec(get(), sql, nullptr, nullptr, nullptr), get());
}

bool SqliteConnection::read_only() const {
    return sqlite3_db_readonly(get(), "main") == 1;
}

bool SqliteConnection::within_transaction() const {
    return sqlite3_get_autocommit(get()) == 0;
}

void SqliteStatement::Finalize::operator()(sqlite3_stmt* statement) const {
    sqlite3_finalize(statement);
}

SqliteStatement::SqliteStatement(const SqliteConnection& connection, const char* sql) {
    sqlite3_stmt* prepared = nullptr;
    const int result = sqlite3_prepare_v2(connection.get(), sql, -1, &prepared, nullptr);
    statement_.reset(prepared);
    check(result, connection.get());
}

SqliteStatement& SqliteStatement::bound(int result) {
    check(result, sqlite3_db_handle(statement_.get()));
    return *this;
}

SqliteStatement& SqliteStatement::bind(std::int64_t value) {
    return bound(sqlite3_bind_int64(statement_.get(), ++bound_, value));
}

SqliteStatement& SqliteStatement::bind(double value) {
    return bound(sqlite3_bind_double(statement_.get(), ++bound_, value));
}

SqliteStatement& SqliteStatement::bind(std::string_view text) {
    // A null pointer would be NULL.
    return bound(sqlite3_bind_text64(statement_.get(), ++bound_, text.empty() ? "" : text.data(),
                                     text.size(), SQLITE_TRANSIENT, SQLITE_UTF8));
}

SqliteStatement& SqliteStatement::bind_packed(std::string_view text) {
    const std::string packed = deflated(text);
    return bound(sqlite3_bind_blob64(statement_.get(), ++bound_, packed.data(), packed.size(),
                                     SQLITE_TRANSIENT));
}

bool SqliteStatement::step() {
    const int result = sqlite3_step(statement_.get());
    check(result, sqlite3_db_handle(statement_.get()));
    return result == SQLITE_ROW;
}

void SqliteStatement::run() {
    while (step()) {
    }
    sqlite3_reset(statement_.get());
    sqlite3_clear_bindings(statement_.get());
    bound_ = 0;
}

bool SqliteStatement::is_null(int column) const {
    return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL;
}

std::int64_t SqliteStatement::whole(int column) const {
    return sqlite3_column_int64(statement_.get(), column);
}

double SqliteStatement::number(int column) const {
    return is_null(column) ? std::numeric_limits<double>::quiet_NaN()
                           : sqlite3_column_double(statement_.get(), column);
}

std::string SqliteStatement::text(int column) const {
    if (sqlite3_column_type(statement_.get(), column) == SQLITE_BLOB) {
        const auto* packed =
            static_cast<const char*>(sqlite3_column_blob(statement_.get(), column));
        const int length = sqlite3_column_bytes(statement_.get(), column);
        return inflated({packed != nullptr ? packed : "", static_cast<std::size_t>(length)});
    }
    const auto* bytes =
        reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
    const int size = sqlite3_column_bytes(statement_.get(), column);
    return bytes != nullptr ? std::string(bytes, static_cast<std::size_t>(size)) : std::string();
}

SqliteTransaction::SqliteTransaction(SqliteConnection& connection, const char* sql)
    : connection_(connection) {
    connection_.run(sql);
}

SqliteTransaction::~SqliteTransaction() {
    // A full disk may have rolled it back already.
    if (connection_.within_transaction()) {
        sqlite3_exec(connection_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
    }
}

void SqliteTransaction::commit() {
    connection_.run("COMMIT");
}

}  // namespace vybeg
