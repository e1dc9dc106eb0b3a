#pragma once

#include "core/analysis/identify.h"
#include "core/resonator/results/passport.h"

#include <QString>

#include <memory>
#include <vector>

namespace vybeg::ui {

// What an identification found, and from what.
struct ResonatorOutcome {
    Identification identification;        // its settings are as asked for
    std::vector<IdentifiedInput> inputs;  // as identification.runs
    std::vector<int> recordings;          // ids in the document, in that order
    double seconds = 0;                   // that it took
};

// Recordings of one resonator, started at different angles, that are identified together. A single
// recording is a set of one.
struct RunSet {
    int id = 0;
    int number = 0;               // in its name, where it has none of its own
    QString name;                 // empty: not named by the engineer
    std::vector<int> recordings;  // ids in the document, in the order in which they were added
    FitOptions::Model model = FitOptions::Model::automatic;
    // The newest last. All have the same recordings, else there is one alone: the last that was
    // found, which is out of date.
    std::vector<std::shared_ptr<const ResonatorOutcome>> outcomes;
};

// A passport that sets are compared with.
struct OpenPassport {
    QString name;  // of its file
    Passport passport;
};

}  // namespace vybeg::ui
