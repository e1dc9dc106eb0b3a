#include "core/analysis/measurement_list.h"
#include "core/output/identify_json.h"
#include "core/output/output_file.h"
#include "core/output/passport_json.h"
#include "ui/document/set_store.h"

#include <QFileInfo>

#include <filesystem>
#include <utility>

namespace vybeg::ui {

namespace {

// What the window says of the gyro, where the list of the set says nothing.
MeasurementSet told(MeasurementSet set, const GyroData& session) {
    for (RecordingRef& recording : set.recordings) {
        Conditions& conditions = recording.conditions;
        for (const auto& [text, otherwise] :
             {std::pair{&conditions.gyro, &session.serial},
              std::pair{&conditions.operator_name, &session.operator_name},
              std::pair{&conditions.comment, &session.comment}}) {
            *text = text->empty() ? otherwise->toStdString() : *text;
        }
    }
    return set;
}

}  // namespace

SetResult SetStore::underPresentConditions(const RecordingSet& set,
                                           const ResonatorOutcome& outcome) const {
    RecordingSet ordered = set;
    ordered.recordings = outcome.recordings;
    SetResult result = outcome;
    result.set = measured(ordered);
    for (std::size_t k = 0; k < result.set.recordings.size(); ++k) {
        const RecordingRef& read = outcome.set.recordings[k];
        RecordingRef& told = result.set.recordings[k];
        told.sha256 = read.sha256;
        told.start = read.start;
        told.seconds = read.seconds;
        told.rate_hz = read.rate_hz;
        told.f0_hz = read.f0_hz;
    }
    return result;
}

void SetStore::savePassport(const QString& path, const GyroData& session,
                            std::function<void(const Status&)> done) {
    const RecordingSet* set = current();
    if (const auto found = set ? outcome(*set) : nullptr) {
        SetResult result = underPresentConditions(*set, *found);
        result.set = told(std::move(result.set), session);
        job_.write(
            ids_.next(),
            [result = std::move(result),
             to = std::filesystem::path(path.toStdU16String())](const JobControl& job) {
                return write_file(to, passport_json(passport_of(result)), job);
            },
            std::move(done));
    }
}

void SetStore::openPassport(const QString& path) {
    constexpr int one_at_a_time = 0;  // a newer one replaces one that is being read
    job_.run<Passport>(
        one_at_a_time,
        [from = std::filesystem::path(path.toStdU16String())](const JobControl&) {
            return read_passport_file(from);
        },
        [this, path](Result<Passport> passport) {
            if (!passport) {
                emit reported(errorMessage(passport.error()));
                return;
            }
            passport_ = OpenPassport{QFileInfo(path).fileName(), std::move(*passport)};
            emit passportChanged();
        });
}

void SetStore::closePassport() {
    passport_.reset();
    emit passportChanged();
}

void SetStore::setFrequencyLimit(double ppm) {
    if (ppm != compare_.f_limit_ppm) {
        compare_.f_limit_ppm = ppm;
        emit passportChanged();
    }
}

std::vector<Difference> SetStore::differences() const {
    const RecordingSet* set = current();
    const auto found = set ? outcome(*set) : nullptr;
    return passport_ && found ? compare(passport_->passport, found->identification.fit, compare_)
                              : std::vector<Difference>();
}

std::optional<Diagnostic> SetStore::otherGyro(const GyroData& session) const {
    const RecordingSet* set = current();
    return set && passport_
               ? other_gyro(passport_->passport, gyro_of(told(measured(*set), session)))
               : std::nullopt;
}

}  // namespace vybeg::ui
