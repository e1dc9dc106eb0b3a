#include "ui/document/analysis_store.h"

#include "core/output/output_file.h"
#include "core/output/track_file.h"
#include "core/recording/samples/recording.h"
#include "ui/words/display_units.h"
#include "ui/words/program_name.h"

#include <QFileInfo>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace vybeg::ui {
namespace {

// A name that no analysis has: "demo", "demo (2)", ...
QString freeName(const std::vector<AnalysisEntry>& analyses, const QString& wish) {
    const auto taken = [&](const QString& name) {
        return std::ranges::any_of(
            analyses, [&](const AnalysisEntry& entry) { return entry.shown.name == name; });
    };
    QString name = wish;
    for (int count = 2; taken(name); ++count) {
        name = QStringLiteral("%1 (%2)").arg(wish).arg(count);
    }
    return name;
}

// Format by the ending of `path`.
Status exportTrackTo(const std::filesystem::path& path, const Recording& recording,
                     const Analysis& analysis, const JobControl& job) {
    const auto format = TRY(track_format(path));
    const auto hash = TRY(recording_sha256(recording, job));
    auto file = TRY(OutputFile::create(path, job));
    const auto header = track_header(programName().toStdString(), recording, hash, analysis);
    TRY(write_track(file, format, analysis.track, header, job));
    return file.commit();
}

}  // namespace

void AnalysisEntry::take(AnalysisOutcome outcome) {
    summary = outcome.summary;
    events = std::move(outcome.events);
    shown.analysis = std::move(outcome.analysis);
    shown.curves = std::move(outcome.curves);
}

ShownAnalysis shownOf(const Recording& recording) {
    ShownAnalysis shown;
    shown.recording = QString::fromStdU16String(recording.path.filename().u16string());
    shown.unit = fileUnit(recording);
    shown.rate_hz = recording.rate_hz;
    shown.recorded_s = recording.seconds();
    return shown;
}

ClosedRecording asClosed(const RecordingEntry& entry, const std::vector<AnalysisEntry>& analyses) {
    ClosedRecording closed;
    closed.id = entry.id;
    closed.path = entry.path;
    closed.sha256 = entry.sha256;
    closed.options = entry.options;
    closed.analyses.emplace();
    for (std::size_t place = 0; place < analyses.size(); ++place) {
        const AnalysisEntry& analysis = analyses[place];
        if (analysis.recording_id == entry.id) {
            AnalysisEntry& kept = closed.analyses->emplace_back();
            kept.shown = analysis.shown;
            kept.shown.analysis.reset();
            kept.shown.curves.clear();
            kept.requested = analysis.requested;
            kept.live = analysis.live;
            kept.place = static_cast<int>(place);
        }
    }
    return closed;
}

const AnalysisEntry* AnalysisStore::find(AnalysisId id) const {
    const auto found = std::ranges::find_if(
        analyses_, [id](const AnalysisEntry& entry) { return entry.shown.id == id; });
    return found == analyses_.end() ? nullptr : &*found;
}

std::vector<ShownAnalysis> AnalysisStore::plotted(bool live_on_top) const {
    std::vector<ShownAnalysis> plotted;
    plotted.reserve(analyses_.size());
    for (const bool on_top : {false, true}) {
        for (const AnalysisEntry& entry : analyses_) {
            if ((entry.live && live_on_top) == on_top) {
                plotted.push_back(entry.shown);
            }
        }
    }
    return plotted;
}

AnalysisId AnalysisStore::show(RecordingId recording_id, const Settings& requested,
                               AnalysisOutcome outcome, bool live) {
    const auto same = std::ranges::find_if(analyses_, [&](const AnalysisEntry& other) {
        return other.recording_id == recording_id && other.live == live &&
               (live || other.requested == requested);
    });
    const bool known = same != analyses_.end();
    AnalysisEntry* entry = known ? &*same : addExpected(recording_id, requested, live);
    if (known && !live) {
        entry->shown.visible = true;
    }
    if (!entry) {
        const RecordingEntry& recording = *recordings_.find(recording_id);
        // The settings of a live one change, so they are in its row and not in its name.
        const QString name = QFileInfo(recording.path).completeBaseName();
        entry = &add(newAnalysis(
            recording,
            live ? name
                 : QStringLiteral("%1, n = %2").arg(name).arg(outcome.analysis->plan.length)));
        entry->live = live;
    }
    entry->requested = requested;
    entry->take(std::move(outcome));
    const auto id = entry->shown.id;
    emit changed();
    if (!known || !live) {
        emit added(id);
    }
    return id;
}

// Where the recording has no analysis yet, the colour of its place, or the next that no recording
// has.
CurveStyle AnalysisStore::freeStyle(RecordingId recording_id) const {
    const auto taken = [this](const CurveStyle& style, bool any_shade) {
        return std::ranges::any_of(analyses_, [&](const AnalysisEntry& entry) {
            return entry.shown.color == style.color &&
                   (any_shade || entry.shown.shade == style.shade);
        });
    };
    const auto own = std::ranges::find(analyses_, recording_id, &AnalysisEntry::recording_id);
    CurveStyle style;
    if (own != analyses_.end()) {
        style.color = own->shown.color;
    } else {
        const int place = static_cast<int>(recordings_.place(recording_id)) % curve_colors;
        style.color = curveStyle(place).color;
        for (int next = 1; next < curve_colors && taken(style, true); ++next) {
            style.color = curveStyle((place + next) % curve_colors).color;
        }
        if (taken(style, true)) {  // more recordings than colours
            style.color = curveStyle(place).color;
        }
    }
    while (style.shade + 1 < curve_shades && taken(style, false)) {
        ++style.shade;
    }
    return style;
}

// The first analyses of the recordings are in the order of the recordings, whichever analysis ends
// first; later ones are at the end.
AnalysisEntry& AnalysisStore::add(AnalysisEntry entry) {
    const auto is_first = [this](auto place) {
        return std::ranges::find(analyses_.begin(), place, place->recording_id,
                                 &AnalysisEntry::recording_id) == place;
    };
    auto next = analyses_.end();
    if (std::ranges::find(analyses_, entry.recording_id, &AnalysisEntry::recording_id) ==
        analyses_.end()) {
        const std::size_t own = recordings_.place(entry.recording_id);
        for (next = analyses_.begin(); next != analyses_.end(); ++next) {
            if (is_first(next) && recordings_.place(next->recording_id) > own) {
                break;
            }
        }
    }
    return *analyses_.insert(next, std::move(entry));
}

AnalysisEntry* AnalysisStore::addExpected(RecordingId recording_id, const Settings& requested,
                                          bool live) {
    const auto [first, last] = expected_.equal_range(recording_id);
    const auto wish = std::find_if(first, last, [&](const auto& expected) {
        return expected.second.live == live && expected.second.requested == requested;
    });
    if (wish == last) {
        return nullptr;
    }
    const AnalysisEntry& wanted = wish->second;
    AnalysisEntry entry = newAnalysis(*recordings_.find(recording_id), wanted.shown.name);
    entry.shown.color = wanted.shown.color;
    entry.shown.shade = wanted.shown.shade;
    entry.shown.visible = wanted.shown.visible;
    entry.live = live;
    entry.place = wanted.place;
    const auto next = std::ranges::upper_bound(analyses_, entry.place, {}, &AnalysisEntry::place);
    expected_.erase(wish);
    return &*analyses_.insert(next, std::move(entry));
}

AnalysisEntry AnalysisStore::newAnalysis(const RecordingEntry& recording, const QString& name) {
    const CurveStyle style = freeStyle(recording.id);
    AnalysisEntry entry;
    entry.shown = shownOf(*recording.recording);
    entry.recording_id = recording.id;
    entry.shown.id = ids_.next<AnalysisId>();
    entry.shown.name = freeName(analyses_, name);
    entry.shown.color = style.color;
    entry.shown.shade = style.shade;
    return entry;
}

template <class Value>
void AnalysisStore::change(AnalysisId id, Value ShownAnalysis::*member, const Value& value) {
    for (AnalysisEntry& entry : analyses_) {
        if (entry.shown.id == id) {
            entry.shown.*member = value;
            emit changed();
        }
    }
}

void AnalysisStore::setVisible(AnalysisId id, bool visible) {
    const AnalysisEntry* entry = find(id);
    if (!entry || entry->shown.visible == visible) {
        return;
    }
    steps_.change(
        [visible, name = entry->shown.name] {
            return (visible ? tr("show %1") : tr("hide %1")).arg(name);
        },
        !visible, visible, [this, id](bool to) { change(id, &ShownAnalysis::visible, to); });
}

void AnalysisStore::rename(AnalysisId id, const QString& name) {
    const AnalysisEntry* entry = find(id);
    const QString wanted = name.trimmed();
    if (!entry || wanted.isEmpty() || entry->shown.name == wanted) {
        return;
    }
    const QString before = entry->shown.name;
    steps_.change([before] { return tr("rename %1").arg(before); }, before, wanted,
                  [this, id](const QString& text) { change(id, &ShownAnalysis::name, text); });
}

void AnalysisStore::remove(AnalysisId id) {
    const AnalysisEntry* found = find(id);
    if (!found) {
        return;
    }
    const auto place = static_cast<std::size_t>(found - analyses_.data());
    steps_.add([name = found->shown.name] { return tr("remove %1").arg(name); },
               [this, entry = *found, place] { putBack(entry, place); },
               [this, id] { takeOut(id); });
    takeOut(id);
}

// A live analysis that has come meanwhile stays; the recording may be closed.
void AnalysisStore::putBack(const AnalysisEntry& entry, std::size_t place) {
    const bool replaced =
        entry.live && std::ranges::any_of(analyses_, [&entry](const AnalysisEntry& other) {
            return other.live && other.recording_id == entry.recording_id;
        });
    if (recordings_.find(entry.recording_id) && !replaced) {
        analyses_.insert(
            analyses_.begin() + static_cast<std::ptrdiff_t>(std::min(place, analyses_.size())),
            entry);
        emit changed();
    }
}

void AnalysisStore::takeOut(AnalysisId id) {
    if (std::erase_if(analyses_,
                      [id](const AnalysisEntry& entry) { return entry.shown.id == id; }) > 0) {
        emit changed();
    }
}

void AnalysisStore::keepPlaces() {
    for (std::size_t place = 0; place < analyses_.size(); ++place) {
        analyses_[place].place = static_cast<int>(place);
    }
}

void AnalysisStore::removeOf(RecordingId recording_id) {
    expected_.erase(recording_id);
    const auto gone = std::erase_if(analyses_, [recording_id](const AnalysisEntry& entry) {
        return entry.recording_id == recording_id;
    });
    if (gone > 0) {
        emit changed();
    }
}

void AnalysisStore::exportTrack(AnalysisId id, const QString& path,
                                std::function<void(const Status&)> done) {
    const AnalysisEntry* entry = find(id);
    if (entry && !entry->partial()) {
        job_.write(
            number(id),
            [recording = *recordings_.find(entry->recording_id)->recording,
             analysis = entry->shown.analysis, path = std::filesystem::path(path.toStdU16String())](
                const JobControl& job) { return exportTrackTo(path, recording, *analysis, job); },
            std::move(done));
    }
}

}  // namespace vybeg::ui

#include "moc_analysis_store.cpp"
