#include "ui/import/log_dialog.h"

#include "core/analysis/logs.h"
#include "core/analysis/setting_table.h"
#include "core/recording/open/log_columns.h"
#include "core/recording/samples/open_table.h"
#include "core/recording/samples/reader_rules.h"
#include "ui/import/import_dialog.h"
#include "ui/import/log_files.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/page_parts.h"
#include "ui/widgets/theme.h"
#include "ui/words/display_units.h"
#include "ui/words/error_text.h"

#include <QAction>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPointer>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <iterator>
#include <numbers>
#include <utility>

namespace vybeg::ui {

namespace {

// What the columns are, in the order of the list.
enum class Columns { unknown, powers, waves, fixed, common, pll };

// As the entries of the list; the first one is that of the file.
constexpr int most_stages = 8;

Columns columnsOf(const LogChoice& choice) {
    switch (choice.phasors.frame) {
        case PhasorFrame::fixed: return Columns::fixed;
        case PhasorFrame::common: return Columns::common;
        case PhasorFrame::pll: return Columns::pll;
        case PhasorFrame::none: break;
    }
    return !choice.given()                                 ? Columns::unknown
           : column_wishes(choice.names, roles_of_waves()) ? Columns::waves
                                                           : Columns::powers;
}

const char* usualNames(Columns columns) {
    switch (columns) {
        case Columns::powers: return "E,R,S,Q";
        case Columns::waves: return "a,b,theta";
        case Columns::pll: return "Xc,Yc,Xd,Yd,Pc,Pd";
        case Columns::common: return "Xc,Yc,Xd,Yd,F";
        default: return "Xc,Yc,Xd,Yd";
    }
}

QString pathOf(const RecordingRef& log) {
    return QFileInfo(QString::fromStdU16String(log.path.u16string())).absoluteFilePath();
}

// The files of its logs, and further ones.
QStringList filesOf(const MeasurementSet& set, const QStringList& further) {
    QStringList files = further;
    for (const RecordingRef& log : set.recordings) {
        files << pathOf(log);
        if (!log.open.channel_d_file.empty()) {
            files << QString::fromStdString(log.open.channel_d_file);
        }
    }
    return files;
}

// That of a log alone is its file's.
std::string nameOf(const std::vector<RecordingRef>& logs) {
    return logs.size() == 1 ? QFileInfo(pathOf(logs.front())).completeBaseName().toStdString()
                            : std::string();
}

// Full name of a file that is beside another one, or is given by its path.
QString beside(const QString& file, const QString& other) {
    return QFileInfo(QFileInfo(file).absoluteDir(), other).absoluteFilePath();
}

}  // namespace

LogDialog::LogDialog(BackgroundJobs& job, const QStringList& paths, MeasurementSet given,
                     QWidget* parent)
    : QDialog(parent),
      given_(std::move(given)),
      files_(withName(new LogFiles(job, filesOf(given_, paths), this), "logFiles")),
      form_(new QFormLayout),
      lacking_(withName(new QLabel(this), "lacking")),
      preview_(new ImportPreview(this)),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, this)) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(given_.settings.logs.given() ? tr("Logs of the set") : tr("Open logs"));
    setWords(*files_, tr("Logs"),
             tr("Logs of one resonator, made alike. Delete removes the chosen ones"));
    buttons_->button(QDialogButtonBox::Open)->setText(tr("Open"));
    buttons_->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
    lacking_->setTextFormat(Qt::PlainText);
    lacking_->setWordWrap(true);
    form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    const FormRows rows{this, form_, 20, [this](QWidget* field) {
                            if (auto* box = qobject_cast<QComboBox*>(field)) {
                                by_person_.insert(box);
                            }
                            refresh();
                        }};
    const auto bounds = [](const char* name) { return bounds_in(log_settings(), name); };
    const QString choose = tr("choose…");
    kind_ = rows.list(
        "kind",
        {tr("Columns are"),
         tr("What the log keeps. The frame of phasors is whose phase they are relative to")},
        {choose, tr("powers E, R, S, Q"), tr("amplitudes a, b and the angle θ"),
         tr("phasors, one frequency"), tr("phasors, an oscillator that moves"),
         tr("phasors, each channel its own phase")});
    columns_ = rows.text(
        "columns", {tr("Named"), tr("The columns, with commas between them, each with =COLUMN, a "
                                    "name or a number, where the file calls it otherwise, as in "
                                    "Xc=3,Yc=4,Xd=5,Yd=6")});
    channel_d_ = rows.text("channel_d_file",
                           {tr("Channel D in"), tr("The file of the other channel, with the same "
                                                   "times")});
    auto* choose_file = channel_d_->addAction(themedIcon(QStringLiteral("open"), palette()),
                                              QLineEdit::TrailingPosition);
    choose_file->setToolTip(tr("Choose the file"));
    angle_unit_ =
        rows.list("angle_unit", {tr("Unit of angles"), tr("Of θ, or of the phase columns")},
                  {choose, tr("degrees"), tr("radians"), tr("turns")});
    f_ref_ = rows.number(
        "f_ref", {tr("Reference"), tr("Frequency of the reference, which the file does not tell")},
        bounds("f-ref"));
    y_sign_ = rows.list(
        "y_sign",
        {tr("Sign of Y"),
         tr("The signal is Re((X + iY) exp iωt), or Re((X − iY) exp iωt). No data show it, and "
            "the other sign is the resonator seen in a mirror")},
        {choose, tr("+: X + iY turns as the carrier does"), tr("−: X + iY turns against it")});
    amplitude_ = rows.list("amplitude", {tr("Amplitudes"), tr("What √(X² + Y²) is")},
                           {choose, tr("peak values"), tr("rms values")});
    QStringList orders{tr("none")};
    for (int stages = 1; stages <= most_stages; ++stages) {
        orders << QLocale().toString(stages);
    }
    order_ = rows.list(
        "order",
        {tr("Filter, stages"),
         tr("RC stages of the lock-in's filter: it delays the phasors and correlates their noise")},
        orders);
    bandwidth_ = rows.number("bandwidth", {tr("Its bandwidth"), tr("3 dB")}, bounds("f-ref"));
    rate_ = rows.number(
        "rate", {tr("Rows a second"), tr("Where the file has no times, or ticks of a clock")},
        bounds_in(open_settings(), "rate"));
    from_ = rows.number(
        "from",
        {tr("Leave out until"),
         tr("Time from the start of a log: what is before it is left out, as the settling of a "
            "filter")},
        bounds_of("from"));
    from_->setPlaceholderText(tr("nothing"));
    from_->setUnit(unitText("s"));
    for (NumberField* field : {f_ref_, bandwidth_, rate_}) {
        field->setUnit(unitText("Hz"));
    }
    for (NumberField* field : {f_ref_, bandwidth_, rate_, from_}) {
        field->setOptional(true);
    }
    auto* choices = new QWidget(this);
    fill(new QVBoxLayout(choices), {}, {files_, form_, lacking_, LayoutPart(1)});
    choices->setFixedWidth(400);
    auto* parts = fill(new QHBoxLayout, {choices, {preview_, 1}});
    fill(new QVBoxLayout(this), {{parts, 1}, buttons_});
    connect(buttons_, &QDialogButtonBox::accepted, this, &LogDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &LogDialog::reject);
    connect(choose_file, &QAction::triggered, this, [this] {
        emit filesWanted([field = QPointer(channel_d_)](const QStringList& files) {
            if (field && !files.isEmpty()) {
                field->setText(files.first());
                field->setModified(true);
                emit field->textEdited(files.first());
            }
        });
    });
    connect(files_, &QListWidget::itemSelectionChanged, this, &LogDialog::showPreview);
    connect(files_, &LogFiles::looked, this, &LogDialog::take);
    connect(files_, &LogFiles::changed, this, [this] {
        // What the fields show may be of a file that went.
        known_shown_ =
            known_shown_ && std::ranges::none_of(files_->looks(), [](const auto& looked) {
                return looked.look.problem.has_value();
            });
        look();
    });
    guardFromWheel(*this);
    resize(980, 560);
    kind_->setFocus();
    if (given_.settings.logs.given()) {
        showGiven();
    }
    look();
}

LogDialog::~LogDialog() {
    for (int row = 0; row < form_->rowCount(); ++row) {
        // No signals of fields to a destroyed object.
        form_->itemAt(row, QFormLayout::FieldRole)->widget()->disconnect(this);
    }
    files_->disconnect(this);
}

bool LogDialog::isOfPhasors() const {
    return static_cast<Columns>(kind_->currentIndex()) >= Columns::fixed;
}

LogChoice LogDialog::choice() const {
    LogChoice told;
    const auto chosen = static_cast<Columns>(kind_->currentIndex());
    told.names = columns_->text().trimmed().toStdString();
    if (told.names.empty() && (chosen == Columns::powers || chosen == Columns::waves)) {
        told.names = usualNames(chosen);
    }
    told.rad_per_angle_unit =
        log_angle_units.at(static_cast<std::size_t>(angle_unit_->currentIndex()));
    if (!isOfPhasors()) {
        return chosen == Columns::unknown ? LogChoice{} : told;
    }
    PhasorChoice& how = told.phasors;
    how.frame = chosen == Columns::fixed    ? PhasorFrame::fixed
                : chosen == Columns::common ? PhasorFrame::common
                                            : PhasorFrame::pll;
    how.f_ref_hz = f_ref_->typed().value_or(0);
    how.y_sign = std::array{0, 1, -1}.at(static_cast<std::size_t>(y_sign_->currentIndex()));
    how.peak_per_unit = std::array{0.0, 1.0, std::numbers::sqrt2}.at(
        static_cast<std::size_t>(amplitude_->currentIndex()));
    if (order_->currentIndex() > 0) {
        how.filter = {order_->currentIndex(), bandwidth_->typed().value_or(0)};
    }
    return told;
}

// Further logs are read as the first one of the set.
OpenOptions LogDialog::options() const {
    OpenOptions told = given_.recordings.empty() ? OpenOptions() : given_.recordings.front().open;
    told.channel_d_file.clear();
    told.rate_hz = rate_->typed();
    return told;
}

// Where one or two files hold one channel, the field names the file of channel D; of more files
// their names do.
QString LogDialog::partnerOf(const QString& file) const {
    if (files_->ofOneChannel() > 2) {
        const RecordingRef* row = givenRow(file);
        if (row && !row->open.channel_d_file.empty()) {
            return QString::fromStdString(row->open.channel_d_file);
        }
        const auto partner = partner_of(file.toStdU16String());
        return partner ? QString::fromStdU16String(partner->u16string()) : QString();
    }
    const QString given = channel_d_->text().trimmed();
    return given.isEmpty() ? given : beside(file, given);
}

std::vector<RecordingRef> LogDialog::logs() const {
    std::vector<RecordingRef> found;
    QStringList left = files_->files();
    if (files_->files().size() == 2 &&
        partnerOf(files_->files().first()) == files_->files().first()) {
        std::ranges::reverse(left);  // the first one is of channel D
    }
    // Those of the set in its order, before further ones.
    std::ranges::stable_sort(left, {}, [this](const QString& file) {
        const RecordingRef* row = givenRow(file);
        return row ? row - given_.recordings.data() : std::ssize(given_.recordings);
    });
    while (!left.isEmpty()) {
        const QString file = left.takeFirst();
        RecordingRef log{QFileInfo(file).fileName().toStdString(), file.toStdU16String(),
                         options()};
        if (const RecordingRef* row = givenRow(file)) {
            log = *row;
            log.open.channel_d_file.clear();
            if (rate_->typed() != given_.recordings.front().open.rate_hz) {
                log.open.rate_hz = rate_->typed();
            }
        }
        if (files_->isOfOneChannel(file)) {
            const QString other = partnerOf(file);
            if (other.isEmpty() || other == file ||
                (files_->ofOneChannel() > 1 && !left.removeOne(other))) {
                return {};
            }
            log.open.channel_d_file = other.toStdString();
        }
        found.push_back(std::move(log));
    }
    return found;
}

MeasurementSet LogDialog::set() const {
    MeasurementSet set = given_;
    set.recordings = logs();
    if (given_.name == nameOf(given_.recordings)) {
        set.name = nameOf(set.recordings);
    }
    set.settings.logs = choice();
    const std::optional<double> from_s = from_->typed();
    const bool other_start = from_s != given_.settings.signal.from_s;
    set.settings.signal.from_s = from_s;
    if (!given_.settings.of_recordings.empty()) {
        set.settings.of_recordings.clear();
        for (const RecordingRef& log : set.recordings) {
            const RecordingRef* row = givenRow(pathOf(log));
            const auto place = static_cast<std::size_t>(row ? row - given_.recordings.data() : 0);
            set.settings.of_recordings.push_back(given_.settings.signal_of(place));
            if (other_start) {
                set.settings.of_recordings.back().from_s = from_s;
            }
        }
    }
    return set;
}

const RecordingRef* LogDialog::givenRow(const QString& file) const {
    const auto found = std::ranges::find(given_.recordings, file, pathOf);
    return found == given_.recordings.end() ? nullptr : &*found;
}

void LogDialog::look() {
    looked_with_ = known_shown_ ? choice() : LogChoice{};
    files_->look(options(), looked_with_);
    refresh();
}

void LogDialog::take() {
    if (files_->sound() && files_->sound()->readable && !std::exchange(known_shown_, true)) {
        looked_with_ = files_->sound()->look.choice;
        showAs(looked_with_);
    }
    // Which one is of channel D stays as it was given.
    if (!channel_d_->isModified()) {
        channel_d_->setText(QFileInfo(files_->partner()).fileName());
    }
    refresh();
    showPreview();
}

void LogDialog::showGiven() {
    const LogChoice& told = given_.settings.logs;
    const PhasorChoice& how = told.phasors;
    showAs(told);
    known_shown_ = true;
    if (told.names != usualNames(columnsOf(told))) {
        columns_->setText(QString::fromStdString(told.names));
    }
    angle_unit_->setCurrentIndex(placeIn(log_angle_units, told.rad_per_angle_unit));
    const auto number = [](double value) {
        return value == 0 ? std::nullopt : std::optional(value);
    };
    f_ref_->setValue(number(how.f_ref_hz));
    order_->setCurrentIndex(how.filter.order);
    bandwidth_->setValue(number(how.filter.bandwidth_hz));
    from_->setValue(given_.settings.signal.from_s);
    if (!given_.recordings.empty()) {
        const OpenOptions& open = given_.recordings.front().open;
        rate_->setValue(open.rate_hz);
        channel_d_->setText(QString::fromStdString(open.channel_d_file));
        channel_d_->setModified(!open.channel_d_file.empty());
    }
    by_person_.insert({kind_, y_sign_, amplitude_});
    refresh();
}

void LogDialog::showAs(const LogChoice& known) {
    const PhasorChoice& how = known.phasors;
    const auto show = [this](QComboBox* box, int place) {
        const QSignalBlocker quiet(box);
        if (!by_person_.contains(box)) {
            box->setCurrentIndex(place);
        }
    };
    show(kind_, static_cast<int>(columnsOf(known)));
    show(y_sign_, how.y_sign == 0 ? 0 : how.y_sign > 0 ? 1 : 2);
    show(amplitude_, how.peak_per_unit == 0 ? 0 : how.peak_per_unit == 1 ? 1 : 2);
}

void LogDialog::showPreview() {
    const LogFiles::Looked* shown = files_->chosen();
    if (shown && shown->readable) {
        preview_->setPreview(shown->look.preview);
    } else if (shown) {
        preview_->setError(*shown->look.problem);
    } else {
        preview_->setPreview({});
    }
}

void LogDialog::showRows() {
    const bool phasors = isOfPhasors();
    // Names that the readers know need not be given.
    const LogLook* look = files_->sound() ? &files_->sound()->look : nullptr;
    const bool nameless = look && !look->preview.columns.empty() &&
                          std::ranges::all_of(look->preview.columns, [](const Channel& column) {
                              return column.name.empty();
                          });
    const bool asks_for_columns =
        kind_->currentIndex() > 0 && (nameless || (look && look->problem) ||
                                      !columns_->text().isEmpty() || columns_->hasFocus());
    const std::pair<QWidget*, bool> shown[]{
        {columns_, asks_for_columns},
        {channel_d_, files_->ofOneChannel() > 0 && files_->ofOneChannel() <= 2},
        {angle_unit_, files_->any(&LogLook::needs_angle_unit) || angle_unit_->currentIndex() > 0},
        {f_ref_, phasors && (files_->any(&LogLook::needs_f_ref) || !f_ref_->text().isEmpty())},
        {y_sign_, phasors},
        {amplitude_, phasors},
        {order_, phasors},
        {bandwidth_, phasors && order_->currentIndex() > 0},
        {rate_, files_->any(&LogLook::needs_rate) || !rate_->text().isEmpty()},
        {from_, kind_->currentIndex() > 0}};
    for (const auto& [field, visible] : shown) {
        form_->labelForField(field)->setVisible(visible);
        field->setVisible(visible);
    }
    columns_->setPlaceholderText(
        QLatin1String(usualNames(static_cast<Columns>(kind_->currentIndex()))));
}

QString LogDialog::lacking(std::span<const RecordingRef> found) const {
    if (files_->files().isEmpty()) {
        return tr("There is no log: drop some into the list.");
    }
    if (!files_->sound()) {
        return tr("Looking at the files…");
    }
    const auto problem =
        std::ranges::find_if(files_->looks(), [this](const LogFiles::Looked& looked) {
            return looked.look.problem && (kind_->currentIndex() > 0 || !looked.readable);
        });
    if (problem != files_->looks().end()) {
        const QString reason = errorText(*problem->look.problem);
        return files_->files().size() == 1
                   ? reason
                   : tr("%1 Delete removes it from the list of logs.").arg(reason);
    }
    const PhasorChoice how = choice().phasors;
    const bool phasors = isOfPhasors();
    const bool numbers =
        std::ranges::all_of(std::array{f_ref_, bandwidth_, rate_, from_},
                            [](const NumberField* field) { return field->isValid(); });
    const auto of_one_channel = files_->ofOneChannel();
    const std::pair<bool, QString> all[]{
        {kind_->currentIndex() == 0,
         tr("Its columns are not known by their names: choose what they are.")},
        {!numbers, tr("A number is not possible: see the red field.")},
        {files_->any(&LogLook::needs_rate) && !options().rate_hz,
         tr("The file has no times: give its rows per second.")},
        {files_->any(&LogLook::needs_angle_unit) && angle_unit_->currentIndex() == 0,
         tr("The file does not tell the unit of its angles: choose it.")},
        {phasors && files_->any(&LogLook::needs_f_ref) && how.f_ref_hz == 0,
         tr("The frequency of the reference is not in the file: give it.")},
        {phasors && how.y_sign == 0, tr("No data show the sign of Y: choose it.")},
        {phasors && how.peak_per_unit == 0,
         tr("No data show whether amplitudes are peak or rms values: choose it.")},
        {phasors && how.filter.order > 0 && how.filter.bandwidth_hz == 0,
         tr("A filter has a bandwidth: give it, or choose none.")},
        {found.empty() && of_one_channel == 1,
         tr("The file has one channel: choose the file of channel D.")},
        {found.empty() && of_one_channel == 2,
         tr("Each file has one channel: choose the one of channel D.")},
        {found.empty(), tr("Each file has one channel, and not each has its partner among them by "
                           "its name: open the two files of one log at a time.")}};
    for (const auto& [lacks, text] : all) {
        if (lacks) {
            return text;
        }
    }
    for (const RecordingRef& log : found) {
        const QString other = QString::fromStdString(log.open.channel_d_file);
        if (!other.isEmpty() && !QFileInfo(other).isFile()) {
            return tr("%1 is no file: choose the file of channel D.")
                .arg(QDir::toNativeSeparators(other));
        }
    }
    return {};
}

// Other columns are looked at anew.
void LogDialog::refresh() {
    const LogChoice now = choice();
    if (known_shown_ && files_->sound() && kind_->currentIndex() > 0 &&
        (now.names != looked_with_.names || now.phasors.frame != looked_with_.phasors.frame)) {
        look();
        return;
    }
    showRows();
    const std::vector<RecordingRef> found = logs();
    files_->show(found);
    const QString text = lacking(found);
    lacking_->setText(text);
    buttons_->button(QDialogButtonBox::Open)->setEnabled(text.isEmpty());
}

void LogDialog::accept() {
    if (buttons_->button(QDialogButtonBox::Open)->isEnabled()) {
        emit chosen(set());
        QDialog::accept();
    }
}

}  // namespace vybeg::ui

#include "moc_log_dialog.cpp"
