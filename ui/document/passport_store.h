#pragma once

#include "core/analysis/passport.h"
#include "core/base/describe.h"
#include "ui/document/background_jobs.h"
#include "ui/document/edits.h"
#include "ui/document/message.h"

#include <QObject>
#include <QString>

#include <memory>
#include <vector>

namespace vybeg::ui {

// The passport that results are compared with.
struct PassportInput {
    RecordingRef file;  // its absolute path, and SHA-256; without a path: none
    std::shared_ptr<const Passport> passport;  // its content; null: not read
    // Smallest change of a frequency that counts, ppm.
    double f_limit_ppm = CompareOptions().f_limit_ppm;
};

// What a session keeps besides the file.
template <class Archive, Described<PassportInput> Owner>
void describe(Archive&& archive, Owner& input) {
    archive("frequency_limit_ppm", input.f_limit_ppm);
}

// The passport that results are compared with; its file is read in the background.
class PassportStore : public QObject {
    Q_OBJECT

public:
    PassportStore(BackgroundJobs& job, UndoSteps& steps) : job_(job), steps_(steps) {}

    const PassportInput& input() const { return input_; }
    // Null: none is open.
    const Passport* content() const { return input_.passport.get(); }
    // Steps of undo. Errors of opening are reported.
    void open(const QString& path);
    void close();
    void setFrequencyLimit(double ppm);
    // No step: of a session, which keeps the file's place also where it cannot be read.
    void startWith(const PassportInput& input);
    // From the passport; empty without one.
    std::vector<Difference> differences(const ResonatorFit& now) const;

signals:
    void opened();   // by a person
    void changed();  // also the limit
    void wanted();   // another file for that of a session
    void reported(const Message& message);

private:
    void read(const QString& path, Done<PassportComparison> done);
    void step(const UndoSteps::Words& words, const PassportInput& after);
    void show(const PassportInput& input);
    void takeOfSession(Result<PassportComparison>&& read);

    BackgroundJobs& job_;
    UndoSteps& steps_;
    PassportInput input_;
};

}  // namespace vybeg::ui
