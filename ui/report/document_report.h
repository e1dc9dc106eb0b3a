#pragma once

#include "ui/document/document.h"
#include "ui/report/report_content.h"

#include <QString>

#include <vector>

namespace vybeg::ui {

// What a report can be about: a set of recordings, or one recording.
struct ReportSubject {
    QString name;
    std::vector<int> recordings;  // ids, those that are open
    int set = 0;                  // id; 0: one recording

    friend bool operator==(const ReportSubject&, const ReportSubject&) = default;
};

// The current set first where it has the current recording, then the current recording, then the
// other sets. Only those with an analysis that has all its windows.
std::vector<ReportSubject> reportSubjects(const Document& document);

// What the document holds of a subject: visible analyses, and the newest identification of the set
// or of the recording alone. Without a title but for the date.
ReportContent reportContentOf(const Document& document, const ReportSubject& subject);

}  // namespace vybeg::ui
