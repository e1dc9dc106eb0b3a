#pragma once

namespace vybeg {

// The tables of a database of results, `PRAGMA user_version` 4. README.md has the columns.
inline constexpr int results_schema = 4;
// `PRAGMA application_id`: "VybR".
inline constexpr int results_application = 0x56796252;

inline constexpr const char* results_tables = R"sql(
CREATE TABLE about (identity TEXT NOT NULL);
INSERT INTO about VALUES (lower(hex(randomblob(16))));

CREATE TABLE result (
    id INTEGER PRIMARY KEY,
    key TEXT NOT NULL UNIQUE,
    set_name TEXT NOT NULL,
    gyro TEXT NOT NULL,
    date TEXT NOT NULL,
    date_from TEXT NOT NULL CHECK (date_from IN ('', 'list', 'recording')),
    program TEXT NOT NULL,
    model TEXT NOT NULL,
    warnings TEXT NOT NULL DEFAULT ''
);
CREATE INDEX result_gyro ON result (gyro);

CREATE TABLE recording (
    result INTEGER NOT NULL REFERENCES result ON DELETE CASCADE,
    position INTEGER NOT NULL,
    file TEXT NOT NULL,
    path TEXT NOT NULL,
    name TEXT NOT NULL,
    sha256 TEXT NOT NULL,
    start TEXT NOT NULL,
    seconds REAL,
    rate_hz REAL,
    f0_hz REAL,
    channel_c INTEGER NOT NULL,
    channel_d INTEGER NOT NULL,
    gyro TEXT NOT NULL,
    date TEXT NOT NULL,
    bias_v REAL,
    temperature_c REAL,
    exchanged INTEGER NOT NULL,
    operator TEXT NOT NULL,
    comment TEXT NOT NULL,
    others TEXT NOT NULL,
    opening TEXT NOT NULL DEFAULT '[]',
    PRIMARY KEY (result, position)
) WITHOUT ROWID;

CREATE TABLE parameter (
    name TEXT NOT NULL,
    result INTEGER NOT NULL REFERENCES result ON DELETE CASCADE,
    position INTEGER NOT NULL,
    value REAL,
    sd REAL,
    u REAL,
    reason TEXT NOT NULL,
    reason_args TEXT NOT NULL,
    PRIMARY KEY (name, result)
) WITHOUT ROWID;
CREATE INDEX parameter_result ON parameter (result);

CREATE TABLE document (
    result INTEGER PRIMARY KEY REFERENCES result ON DELETE CASCADE,
    raw_names TEXT NOT NULL,
    raw_values TEXT NOT NULL,
    raw_covariance TEXT NOT NULL,
    json TEXT NOT NULL
);
)sql";

// What a database of schema 1 lacks, and what one of schema 2 does, besides the view. One of schema
// 3 has the long texts of its documents as they are.
inline constexpr const char* opening_column =
    "ALTER TABLE recording ADD COLUMN opening TEXT NOT NULL DEFAULT '[]'";
inline constexpr const char* warnings_column =
    "ALTER TABLE result ADD COLUMN warnings TEXT NOT NULL DEFAULT ''";

}  // namespace vybeg
