#include "ui/widgets/check_list.h"

#include "core/base/diagnostic.h"
#include "ui/widgets/page_parts.h"
#include "ui/words/error_text.h"

#include <QLabel>
#include <QLocale>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>

namespace vybeg::ui {

namespace {

const QString fold_link = QStringLiteral("more");

}  // namespace

int findingsIn(const std::vector<Diagnostic>& diagnostics) {
    return static_cast<int>(std::ranges::count_if(diagnostics, [](const Diagnostic& diagnostic) {
        return severity(diagnostic.kind) != Severity::note;
    }));
}

CheckList::CheckList(QWidget* parent)
    : QWidget(parent), title_(new QLabel(this)), list_(new QTextBrowser(this)) {
    title_->setWordWrap(true);
    title_->setContentsMargins(6, 2, 6, 2);
    list_->setOpenLinks(false);
    list_->setFrameShape(QFrame::NoFrame);
    fill(new QVBoxLayout(this), {}, 0, {title_, {list_, 1}});
    connect(list_, &QTextBrowser::anchorClicked, this, &CheckList::choose);
    keepTranslated(*this, [this] { refresh(); });
    // The HTML keeps the colour that links had.
    whenChanged(*this, {QEvent::PaletteChange}, [this] { refresh(); });
}

void CheckList::setRunning() {
    running_ = true;
    findings_.clear();
    refresh();
}

void CheckList::setFindings(const std::vector<Diagnostic>& findings, double rate_hz) {
    if (!running_ && findings == findings_ && rate_hz == rate_hz_) {
        return;  // keeps the scroll position of the list
    }
    running_ = false;
    findings_ = findings;
    rate_hz_ = rate_hz;
    refresh();
}

void CheckList::refresh() {
    list_->setAccessibleName(tr("Recording check"));
    list_->setVisible(!findings_.empty());
    if (running_) {
        title_->setText(tr("Recording check: reading…"));
        return;
    }
    const int found = findingsIn(findings_);  // notes stand in the list all the same
    title_->setText(found == 0 ? tr("Recording check: nothing found")
                               : tr("Recording check: %n finding(s)", nullptr, found));
    const std::vector<Finding> findings = findings_of(findings_);
    QString rows;
    for (std::size_t k = 0; k < findings.size() && (open_ || k < most_shown); ++k) {
        const Finding& finding = findings[k];
        rows += rowOf(finding.diagnostic,
                      open_ ? diagnosticText(finding.diagnostic) : findingText(finding));
        for (std::size_t i = 0; open_ && i < finding.more.size(); ++i) {
            rows += rowOf(finding.more[i], diagnosticText(finding.more[i]));
        }
    }
    std::size_t hidden = 0;
    for (std::size_t k = 0; k < findings.size(); ++k) {
        hidden += findings[k].more.size() + (k < most_shown ? 0 : 1);
    }
    if (hidden > 0) {
        rows += QStringLiteral("<tr><td></td><td><a href=\"%1\">%2</a></td></tr>")
                    .arg(fold_link, open_ ? tr("Only the worst") : moreText(hidden));
    }
    list_->setHtml(QStringLiteral("<table cellspacing=\"3\">%1</table>").arg(rows));
}

// The place of a finding is its link; one without a place has none.
QString CheckList::rowOf(const Diagnostic& finding, const QString& text) const {
    QString place;
    if (finding.first_frame >= 0) {
        const QString time = QLocale().toString(seconds(finding.first_frame), 'f', 4);
        place = QStringLiteral("<a href=\"%1,%2\">%3</a>")
                    .arg(finding.first_frame)
                    .arg(finding.count)
                    .arg(tr("%1 s").arg(time));
    }
    return QStringLiteral("<tr><td align=\"right\">%1</td><td>%2</td></tr>")
        .arg(place, text.toHtmlEscaped());
}

void CheckList::choose(const QUrl& link) {
    if (link.toString() == fold_link) {
        open_ = !open_;
        refresh();
        return;
    }
    const QStringList place = link.toString().split(QLatin1Char(','));
    emit placeChosen(seconds(place.value(0).toLongLong()), seconds(place.value(1).toLongLong()));
}

}  // namespace vybeg::ui
