#include "ui/words/error_text.h"

#include "ui/words/display_units.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace vybeg::ui {

namespace {

struct FindingWords {
    Q_DECLARE_TR_FUNCTIONS(Finding)
};

QString filled(const char* context, const std::string& text, const std::vector<MessageArg>& args);

QString argText(const MessageArg& arg) {
    switch (arg.kind) {
        case MessageArg::Kind::recording:
        case MessageArg::Kind::text: return QString::fromStdString(english(arg));
        case MessageArg::Kind::number: {
            const QString number = numberText(QString::fromStdString(arg.text));
            const QString unit = unitText(arg.unit.c_str());
            return number + QLatin1String(number.isEmpty() || unit.isEmpty() ? "" : " ") + unit;
        }
        case MessageArg::Kind::words: return filled("Words", arg.text, arg.args);
    }
    return {};
}

QString filled(const char* context, const std::string& text, const std::vector<MessageArg>& args) {
    const QString translated = QCoreApplication::translate(context, text.c_str());
    std::vector<std::string> shown;
    shown.reserve(args.size());
    for (const MessageArg& arg : args) {
        shown.push_back(argText(arg).toStdString());
    }
    return QString::fromStdString(
        fill_template(sentence_for(true, translated.toStdString()), shown));
}

// libsndfile's words, for lupdate; readers of core/ mark theirs where they set them.
[[maybe_unused]] constexpr const char* words_of_libsndfile[] = {
    QT_TRANSLATE_NOOP("Format", "Signed 8 bit PCM"),
    QT_TRANSLATE_NOOP("Format", "Unsigned 8 bit PCM"),
    QT_TRANSLATE_NOOP("Format", "Signed 16 bit PCM"),
    QT_TRANSLATE_NOOP("Format", "Signed 24 bit PCM"),
    QT_TRANSLATE_NOOP("Format", "Signed 32 bit PCM")};

QString partText(const FormatPart& part) {
    const auto count = static_cast<int>(part.count);
    switch (part.kind) {
        case FormatPart::Kind::name: return QString::fromStdString(part.text);
        case FormatPart::Kind::words:
            return QCoreApplication::translate("Format", part.text.c_str());
        case FormatPart::Kind::channels:
            return QCoreApplication::translate("Format", "%n channel(s)", nullptr, count);
        case FormatPart::Kind::columns:
            return QCoreApplication::translate("Format", "%n column(s)", nullptr, count);
    }
    return {};
}

// What the sentence of the first leaves out; empty: nothing.
QString restText(const Finding& finding) {
    const auto others = static_cast<int>(finding.more.size());
    if (others == 0) {
        return {};
    }
    return QLatin1Char(' ') +
           (finding.diagnostic.first_frame < 0
                ? FindingWords::tr("(And %n more of the kind.)", nullptr, others)
            : finding.frames == 0
                ? FindingWords::tr("(And %n more place(s).)", nullptr, others)
                : FindingWords::tr("(And %n more place(s); %1 samples in all.)", nullptr, others)
                      .arg(countLabel(finding.frames)));
}

}  // namespace

QString errorText(const Error& error) {
    return filled("Message", message_row(error.code).sentence, message_args(error));
}

QString diagnosticText(const Diagnostic& diagnostic) {
    return filled("Message", message_row(diagnostic.kind).sentence, diagnostic.args);
}

QString findingText(const Finding& finding) {
    const QString about = QString::fromStdString(about_text(finding));
    return (about.isEmpty() ? QString() : about + QStringLiteral(": ")) +
           diagnosticText(finding.diagnostic) + restText(finding);
}

QStringList findingTexts(const std::vector<Finding>& findings) {
    QStringList texts;
    std::ranges::transform(findings, std::back_inserter(texts), findingText);
    return texts;
}

QString moreText(std::size_t count) {
    return FindingWords::tr("%n more", nullptr, static_cast<int>(count));
}

QStringList worstOf(QStringList sentences) {
    if (const auto count = static_cast<std::size_t>(sentences.size()); count > most_shown) {
        sentences.resize(most_shown);
        sentences << moreText(count - most_shown);
    }
    return sentences;
}

QString reasonText(const Reason& reason) {
    // Core writes for terminals, too.
    return reason.code == ReasonCode::none
               ? QString()
               : filled("Reason", message_row(reason.code).sentence, reason.args)
                     .replace(QLatin1String("theta_A"), QStringLiteral("θ_A"));
}

QString flagsText(Flags flags) {
    QStringList reasons;
    const auto add = [&](Flag flag, const QString& text) {
        if (has(flags, flag)) {
            reasons << text;
        }
    };
    add(Flag::no_quadrature, FindingWords::tr("a_B is not estimated"));
    add(Flag::circular, FindingWords::tr("circular wave: no angle"));
    add(Flag::gap, FindingWords::tr("samples are missing"));
    add(Flag::clipped, FindingWords::tr("samples at the rail"));
    add(Flag::filter_transient, FindingWords::tr("transient of the band-pass"));
    add(Flag::delay_reach, FindingWords::tr("the delay reaches beyond the samples"));
    add(Flag::leakage, FindingWords::tr("leakage above one standard deviation"));
    add(Flag::moving, FindingWords::tr("the wave moves inside the window"));
    add(Flag::not_converged, FindingWords::tr("not converged"));
    add(Flag::at_bound, FindingWords::tr("frequency at its bound"));
    return reasons.join(QStringLiteral("; "));
}

QString eventText(const Event& event) {
    const auto lasting = [&event](const QString& what) {
        return event.seconds > 0 ? what + QStringLiteral(", ") + secondsText(event.seconds) : what;
    };
    if (!event.flag) {
        const QString angle = numberLabel(90. * event.multiple_of_half_pi, 0) + QStringLiteral("°");
        return event.direction > 0 ? FindingWords::tr("2θ_A passes %1, rising").arg(angle)
                                   : FindingWords::tr("2θ_A passes %1, falling").arg(angle);
    }
    switch (*event.flag) {
        case Flag::gap: return lasting(FindingWords::tr("Samples are missing"));
        case Flag::clipped: return lasting(FindingWords::tr("Clipped"));
        case Flag::not_converged: return lasting(FindingWords::tr("Not converged"));
        case Flag::filter_transient: return lasting(FindingWords::tr("Transient of the band-pass"));
        case Flag::delay_reach:
            return lasting(FindingWords::tr("The delay reaches beyond the samples"));
        case Flag::moving: return lasting(FindingWords::tr("The wave moves inside its windows"));
        default: return {};
    }
}

QString formatText(const RecordingFormat& format) {
    QStringList parts;
    for (const FormatPart& part : format) {
        parts << partText(part);
    }
    return parts.join(QStringLiteral(", "));
}

}  // namespace vybeg::ui
