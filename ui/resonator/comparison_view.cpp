#include "ui/resonator/comparison_view.h"

#include "ui/plots/xy_plot_view.h"
#include "ui/resonator/difference_text.h"
#include "ui/resonator/resonator_plots.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/page_parts.h"
#include "ui/widgets/quantity_table.h"
#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>

namespace vybeg::ui {

ComparisonView::ComparisonView(Document& document, QWidget* parent)
    : OutcomeView(parent),
      document_(document),
      passport_(sentence(this, "passport")),
      other_gyro_(sentence(this, "otherGyro")),
      differences_(withName(new QuantityTable(this), "differences")),
      incomparable_(sentence(this, "incomparable")),
      track_choice_(new QComboBox(this)),
      tracks_(withName(new XYPlotView(this), "tracks")),
      close_(new QPushButton(this)) {
    auto* limit = new QWidget(this);
    limit_label_ = new QLabel(limit);
    limit_ = new NumberField(limit);
    limit_->setLimits(0, 1e6);
    limit_->setUnit(QStringLiteral("ppm"));
    limit_label_->setBuddy(limit_);
    fill(new QHBoxLayout(limit), {6, 0, 6, 0}, {limit_label_, {limit_, 1}});
    track_choice_->addItems({QString(), QString(), QString()});  // in the order of TrackVariable
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    section_ = addSection(*column, {passport_, other_gyro_, limit, differences_, incomparable_,
                                    track_choice_, tracks_, close_});
    connect(close_, &QPushButton::clicked, &document_.sets(), &SetStore::closePassport);
    connect(limit_, &NumberField::valueEdited, this,
            [this](auto ppm) { document_.sets().setFrequencyLimit(*ppm); });
    connect(track_choice_, &QComboBox::activated, this, &ComparisonView::rebuild);
    connect(tracks_, &XYPlotView::exportWanted, this, &ComparisonView::exportWanted);
    connect(&document_.sets(), &SetStore::passportChanged, this, &ComparisonView::rebuild);
    connect(&document_.dossier(), &DossierModel::changed, this, &ComparisonView::rebuild);
    keepTranslated(*this, [this] { retranslate(); });
}

void ComparisonView::setTheme(const Theme& theme) {
    tracks_->setTheme(theme);
    OutcomeView::setTheme(theme);
}

void ComparisonView::open() {
    section_->setOpen(true);
}

void ComparisonView::rebuild() {
    const OpenPassport* passport = document_.sets().passport();
    setVisible(passport != nullptr);
    if (!passport) {
        return;
    }
    const QString name = passport->name.toHtmlEscaped();
    const std::vector<Difference> differences = document_.sets().differences();
    const auto other = document_.sets().otherGyro(document_.dossier().dossier().gyro);
    other_gyro_->setText(other ? QStringLiteral("⚠ ") + diagnosticText(*other) : QString());
    other_gyro_->setVisible(other.has_value());
    passport_->setText(
        shown_
            ? tr("Compared with %1. Changed: by %2 uncertainties u of the "
                 "difference or more; by chance in one comparison of 370.")
                  .arg(name, QLocale().toString(changed_from(count_compared(differences)), 'f', 1))
            : tr("%1 is open: identify the set to compare.").arg(name));
    limit_->setValue(document_.sets().frequencyLimit());
    const QStringList reasons = incomparableTexts(differences);
    for (QWidget* part : std::initializer_list<QWidget*>{differences_, track_choice_, tracks_}) {
        part->setVisible(shown_ != nullptr);
    }
    incomparable_->setVisible(!reasons.isEmpty());
    if (shown_) {
        differences_->setContent(differenceHeaders(), differenceRows(differences, units_, theme_));
        incomparable_->setText(paragraphs(reasons, tr("Not comparable: %1")));
        tracks_->setContent(trackPlot(*shown_, passport->passport,
                                      static_cast<TrackVariable>(track_choice_->currentIndex()),
                                      units_));
    }
}

void ComparisonView::retranslate() {
    section_->setTitle(tr("Comparison with the passport"));
    differences_->setAccessibleName(tr("Comparison with the passport"));
    limit_label_->setText(tr("Frequencies change from"));
    limit_->setAccessibleName(tr("Frequencies change from"));
    limit_->setToolTip(
        richTip(tr("Frequencies follow the temperature: smaller changes, in parts per million, are "
                   "none of the gyro")));
    tracks_->setAccessibleName(tr("Tracks of the runs and of the passport"));
    tracks_->setToolTip(
        richTip(tr("In the colours of the recordings; further from the background: the passport")));
    track_choice_->setAccessibleName(tr("What to overlay"));
    setTexts(*track_choice_, {tr("Amplitude of the working wave"),
                              tr("Amplitude of the quadrature wave"), tr("Wave angle")});
    close_->setText(tr("Close the passport"));
    rebuild();
}

}  // namespace vybeg::ui
