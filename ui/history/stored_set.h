#pragma once

#include "core/analysis/measurement_list.h"
#include "core/database/stored_result.h"

#include <QStringList>

#include <string>
#include <vector>

namespace vybeg::ui {

// A stored result as a measurement list of one set, with its settings; `settings_known`: whether
// they could be read from the result. Recordings that are not where they were are left out.
struct StoredSet {
    MeasurementList list;
    QStringList missing;  // paths
    bool settings_known = true;
};

StoredSet storedSet(const StoredResult& result, const IdentifySettings& otherwise);

// The set under this gyro and date, for the whole of it.
void tellGyroAndDate(MeasurementSet& set, const std::string& gyro, const std::string& date);

}  // namespace vybeg::ui
