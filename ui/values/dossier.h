#pragma once

#include "core/base/describe.h"
#include "core/resonator/results/resonator_parameters.h"

#include <QString>

#include <vector>

namespace vybeg::ui {

// What a person says of the gyro of a session; empty where nothing is said.
struct GyroData {
    QString serial;
    QString type;
    QString operator_name;
    QString comment;

    friend bool operator==(const GyroData&, const GyroData&) = default;
};

template <class Archive, Described<GyroData> Owner>
void describe(Archive&& archive, Owner& gyro) {
    archive("serial", gyro.serial);
    archive("type", gyro.type);
    archive("operator", gyro.operator_name);
    archive("comment", gyro.comment);
}

// The gyro of a session, and what its resonator has to keep.
struct Dossier {
    GyroData gyro;
    std::vector<ParameterLimit> limits;

    friend bool operator==(const Dossier&, const Dossier&) = default;
};

}  // namespace vybeg::ui
