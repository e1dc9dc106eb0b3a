#include "ui/widgets/check_list.h"

#include "ui/words/error_text.h"

#include <QEvent>
#include <QLabel>
#include <QLocale>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>

namespace vybeg::ui {

CheckList::CheckList(QWidget* parent)
    : QWidget(parent), title_(new QLabel(this)), list_(new QTextBrowser(this)) {
    title_->setWordWrap(true);
    title_->setContentsMargins(6, 2, 6, 2);
    list_->setOpenLinks(false);
    list_->setFrameShape(QFrame::NoFrame);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(title_);
    layout->addWidget(list_, 1);
    connect(list_, &QTextBrowser::anchorClicked, this, &CheckList::choose);
    refresh();
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
    title_->setText(findings_.empty() ? tr("Recording check: nothing found")
                                      : tr("Recording check: %n finding(s)", nullptr,
                                           static_cast<int>(findings_.size())));
    // The number of a finding is its link; findings without a place have no link.
    QString rows;
    for (std::size_t i = 0; i < findings_.size(); ++i) {
        const Diagnostic& finding = findings_[i];
        QString place;
        if (finding.first_frame >= 0) {
            place =
                QStringLiteral("<a href=\"%1\">%2</a>")
                    .arg(i)
                    .arg(tr("%1 s").arg(QLocale().toString(seconds(finding.first_frame), 'f', 4)));
        }
        rows += QStringLiteral("<tr><td align=\"right\">%1</td><td>%2</td></tr>")
                    .arg(place, diagnosticText(finding).toHtmlEscaped());
    }
    list_->setHtml(QStringLiteral("<table cellspacing=\"3\">%1</table>").arg(rows));
}

void CheckList::choose(const QUrl& link) {
    const Diagnostic& finding = findings_.at(link.toString().toUInt());
    emit placeChosen(seconds(finding.first_frame), seconds(finding.count));
}

void CheckList::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refresh();
    }
}

}  // namespace vybeg::ui
