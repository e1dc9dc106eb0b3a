#pragma once

#include "core/analysis/identify_settings.h"
#include "core/analysis/passport.h"
#include "core/recording/samples/open_options.h"

#include <string>

namespace vybeg {

// A batch: the sets of a measurement list, the table of their results, and what goes beside it.
struct BatchRequest {
    std::string program;        // name and version, for the table and all that goes beside it
    std::string list;           // or a folder of recordings
    std::string output;         // "-": standard output
    std::string json;           // folder of the results; empty: none
    std::string passports;      // folder of the gyros' passports; empty: none
    std::string new_passports;  // folder of a passport for each set; empty: none
    std::string limits;         // table of limits; empty: none
    std::string database;       // file that the results also go into; empty: none
    std::string only;           // this set alone; empty: all
    int jobs = 1;               // sets at once
    bool resume = false;
    bool watch = false;  // the list is a folder that fills
    bool excel = false;  // the table with ";", decimal commas, a byte order mark, no comment lines
    OpenOptions open;
    IdentifySettings settings;
    CompareOptions compare;
};

}  // namespace vybeg
