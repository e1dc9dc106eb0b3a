#pragma once

#include "ui/document/document.h"
#include "ui/report/report_content.h"
#include "ui/values/ids.h"

#include <QString>

#include <vector>

namespace vybeg::ui {

// What a report can be about: a set of recordings, one recording, all sets, or the whole-angle
// logs, which every report but that of all sets holds.
struct ReportSubject {
    QString name;
    std::vector<RecordingId> recordings;  // those that are open
    SetId set = SetId::none;              // none: one recording, all sets, or logs
    bool all_sets = false;

    friend bool operator==(const ReportSubject&, const ReportSubject&) = default;
};

// The current set first where it has the current recording, then the current recording, then the
// other sets, all sets where there are several, and logs with a drift. Of recordings only those
// with an analysis that has all its windows.
std::vector<ReportSubject> reportSubjects(const Document& document);

// What the document holds of a subject: visible analyses, and the newest identification of the set
// or of the recording alone. Without a title but for the date. All sets are a chapter each.
std::vector<ReportContent> reportContentsOf(const Document& document, const ReportSubject& subject);

// The same of one set or recording.
ReportContent reportContentOf(const Document& document, const ReportSubject& subject);

}  // namespace vybeg::ui
