#pragma once

#include <QString>
#include <QStringList>

#include <sqlite3.h>

namespace vybeg::test {

// Rows of a query by SQLite itself, columns joined by "|"; "(error)" where it fails.
inline QStringList rows_by_sqlite(const QString& path, const char* sql) {
    sqlite3* connection = nullptr;
    sqlite3_stmt* statement = nullptr;
    QStringList rows;
    bool done = sqlite3_open(path.toUtf8().constData(), &connection) == SQLITE_OK &&
                sqlite3_prepare_v2(connection, sql, -1, &statement, nullptr) == SQLITE_OK;
    int step = SQLITE_DONE;
    while (done && (step = sqlite3_step(statement)) == SQLITE_ROW) {
        QStringList fields;
        for (int k = 0; k < sqlite3_column_count(statement); ++k) {
            fields << QString::fromUtf8(
                reinterpret_cast<const char*>(sqlite3_column_text(statement, k)));
        }
        rows << fields.join('|');
    }
    sqlite3_finalize(statement);
    sqlite3_close(connection);
    return done && step == SQLITE_DONE ? rows : QStringList("(error)");
}

}  // namespace vybeg::test
