#include "ui/document/set_store.h"
#include "ui/words/program_name.h"

#include <QFileInfo>

#include <utility>

namespace vybeg::ui {

void SetStore::savePassport(const QString& path, std::function<void(const Status&)> done) {
    const RecordingSet* set = current();
    if (const auto found = set ? outcome(*set) : nullptr) {
        job_.writePassport(ids_.next(), found, programName(), path, std::move(done));
    }
}

void SetStore::openPassport(const QString& path) {
    constexpr int one_at_a_time = 0;  // a newer one replaces one that is being read
    job_.readPassport(one_at_a_time, path, [this, path](Result<Passport> passport) {
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

}  // namespace vybeg::ui
