#pragma once

#include <QDir>
#include <QString>
#include <QStringList>

namespace vybeg::test {

// Simulated recordings and logs for the pictures, written into a folder. All throw
// std::runtime_error where a file cannot be written.

// That of `vybeg-cli simulate --demo`.
QString write_demonstration(const QDir& folder);

// Four of one resonator, started at different angles.
QStringList write_simulated_set(const QDir& folder);

// Three whole-angle logs of one gyro at different rates.
QStringList write_simulated_logs(const QDir& folder);

}  // namespace vybeg::test
