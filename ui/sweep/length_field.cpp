#include "ui/sweep/length_field.h"

#include "core/analysis/setting_table.h"
#include "core/sweep/sweep_windows.h"
#include "ui/widgets/number_field.h"
#include "ui/words/rich_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <optional>

namespace vybeg::ui {

namespace {

constexpr std::int64_t most = 1'000'000'000;
constexpr std::size_t most_lengths = 60;

std::optional<std::int64_t> readLength(const QString& text) {
    bool whole = false;
    const qint64 length = text.toLongLong(&whole);
    return whole ? std::optional<std::int64_t>(length) : std::nullopt;
}

}  // namespace

LengthList readLengthList(const QString& text) {
    const auto refused = [](const QString& sentence) { return LengthList{{}, sentence}; };
    static const QRegularExpression separators(QStringLiteral("[\\s,;]+"));
    static const QRegularExpression dots(QStringLiteral("\\s*(\\.\\.+|…)\\s*"));
    const auto least = static_cast<std::int64_t>(bounds_of("window").least);
    LengthList list;
    QString joined = text;
    joined.replace(dots, QStringLiteral("…"));
    for (const QString& part : joined.split(separators, Qt::SkipEmptyParts)) {
        const QStringList ends = part.split(QStringLiteral("…"));
        const auto first = readLength(ends.front());
        const auto last = readLength(ends.back());
        if (ends.size() > 2 || !first || !last) {
            return refused(
                LengthField::tr("“%1” is neither a whole number nor a range as 6..600.")
                    .arg(QString(part).replace(QStringLiteral("…"), QStringLiteral(".."))));
        }
        if (std::min(*first, *last) < least || std::max(*first, *last) > most) {
            return refused(LengthField::tr("A window has %1 samples at least and %2 at most.")
                               .arg(least)
                               .arg(QLocale().toString(static_cast<qlonglong>(most))));
        }
        const auto range = spaced_lengths(std::min(*first, *last), std::max(*first, *last));
        list.lengths.insert(list.lengths.end(), range.begin(), range.end());
    }
    std::ranges::sort(list.lengths);
    const auto last = std::unique(list.lengths.begin(), list.lengths.end());
    list.lengths.erase(last, list.lengths.end());
    if (list.lengths.empty()) {
        return refused(
            LengthField::tr("A list of window lengths is needed, e.g. 6..600 or 6, 60."));
    }
    if (list.lengths.size() > most_lengths) {
        return refused(LengthField::tr("At most %1 lengths are possible.").arg(most_lengths));
    }
    return list;
}

LengthField::LengthField(QWidget* parent) : QLineEdit(QStringLiteral("6..600"), parent) {
    connect(this, &QLineEdit::textChanged, this, &LengthField::retranslate);
    retranslate();
}

void LengthField::retranslate() {
    const QString refusal = list().refusal;
    setAccessibleName(tr("Window lengths, samples"));
    setToolTip(richTip(
        refusal.isEmpty()
            ? tr("Samples per window: numbers and ranges, e.g. 6, 22, 60..600. A range stands for "
                 "15 lengths in equal ratios.")
            : refusal));
    update();
}

void LengthField::paintEvent(QPaintEvent* event) {
    QLineEdit::paintEvent(event);
    if (!list().refusal.isEmpty() && isEnabled()) {
        frameFault(*this);
    }
}

}  // namespace vybeg::ui
