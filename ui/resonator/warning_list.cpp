#include "ui/resonator/warning_list.h"

#include "ui/widgets/page_parts.h"
#include "ui/words/error_text.h"

#include <algorithm>
#include <utility>

namespace vybeg::ui {

WarningList::WarningList(QWidget* parent) : QLabel(parent) {
    makeSentence(*this);
    setTextInteractionFlags(Qt::TextBrowserInteraction);
    connect(this, &QLabel::linkActivated, this, [this] {
        open_ = !open_;
        refresh();
    });
}

void WarningList::setFindings(std::vector<Finding> findings) {
    findings_ = std::move(findings);
    refresh();
}

void WarningList::refresh() {
    const std::size_t shown = open_ ? findings_.size() : std::min(findings_.size(), most_shown);
    QString html;
    for (std::size_t k = 0; k < shown; ++k) {
        const bool note = severity(findings_[k].diagnostic.kind) == Severity::note;
        html += paragraphs({findingText(findings_[k])},
                           note ? QStringLiteral("%1") : QStringLiteral("⚠ %1"));
    }
    if (findings_.size() > most_shown) {
        html += QStringLiteral("<p style=\"margin:2px 0\"><a href=\"more\">%1</a></p>")
                    .arg(open_ ? tr("Only the worst") : moreText(findings_.size() - most_shown));
    }
    setText(html);
    setVisible(!findings_.empty());
}

}  // namespace vybeg::ui

#include "moc_warning_list.cpp"
