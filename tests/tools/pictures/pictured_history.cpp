#include "tests/tools/pictures/pictured_history.h"

#include "core/database/results_database.h"
#include "core/resonator/results/resonator_parameters.h"

#include <QDate>

#include <random>
#include <string>

namespace vybeg::test {
namespace {

constexpr int results = 48;
constexpr int outside = 40;

}  // namespace

Status write_pictured_history(const std::filesystem::path& path) {
    auto database = ResultsDatabase::open(path, ResultsDatabase::Access::write, JobControl());
    if (!database) {
        return database.error();
    }
    std::mt19937 random(17);
    std::normal_distribution<double> normal;
    for (int k = 0; k < results; ++k) {
        const bool first = k % 4 != 3;
        const std::string number = std::to_string(k + 1);
        StoredResult result;
        result.key = number;
        result.set = "run " + number;
        result.gyro = first ? "HRG-17" : "HRG-18";
        result.date = {QDate(2026, 1, 8).addDays(qint64{3} * k).toString(Qt::ISODate).toStdString(),
                       DateSource::list};
        result.program = "vybeg";
        result.model = "structured";
        for (const ResonatorParameter& parameter : resonator_parameters) {
            const double typical = parameter.name == std::string("f_mean_hz") ? 5300.0
                                   : parameter.name == std::string("tau_s")   ? 640.0
                                                                              : 2e-3;
            const double sd = 0.01 * (parameter.name == std::string("f_mean_hz") ? 1.0 : typical);
            const double off = k == outside ? 8 * sd : 0;
            result.parameters.push_back(
                {parameter.name, {typical + sd * normal(random) + off, 0.7 * sd, {}, sd}});
        }
        if (const auto added = database->add(result); !added) {
            return added.error();
        }
    }
    return {};
}

}  // namespace vybeg::test
