#include "ui/session/session.h"

#include "ui/document/measured_set.h"

#include <algorithm>
#include <functional>

namespace vybeg::ui {

namespace {

int placeOf(const std::vector<RecordingEntry>& recordings, RecordingId id) {
    const auto found = std::ranges::find(recordings, id, &RecordingEntry::id);
    return found == recordings.end() ? -1 : static_cast<int>(found - recordings.begin());
}

// The same by other keys of the members: `key` of each; negative ones for those without.
template <class Key, class Before>
ListedSetBy<Key> renamed(const ListedSetBy<Before>& listed,
                         const std::function<std::optional<Key>(Before)>& key) {
    ListedSetBy<Key> other{listed.settings, {}, listed.by_panel};
    int without = -static_cast<int>(listed.members.size());  // rows of logs keep their order
    for (const auto& [before, member] : listed.members) {
        other.members.emplace(key(before).value_or(static_cast<Key>(without++)), member);
    }
    return other;
}

}  // namespace

Session sessionOf(const Document& document, const TrackView& tracks) {
    Session session;
    session.settings = document.settings();
    session.tolerance = document.tolerance();
    session.dossier = document.dossier().dossier();
    session.live = document.live();
    for (const RecordingEntry& entry : document.recordings()) {
        session.recordings.push_back(
            {entry.path, entry.sha256, entry.options, wishesOf(document.analyses(), entry.id), {}});
    }
    if (const RecordingEntry* current = document.currentRecording()) {
        session.current = placeOf(document.recordings(), current->id);
    }
    for (const RecordingSet& set : document.sets().all()) {
        SessionSet stored{set.name, {}, set.model, {}, document.sets().kept(set), {}};
        for (const RecordingId id : set.recordings) {
            stored.recordings.push_back(placeOf(document.recordings(), id));
        }
        if (set.listed) {
            stored.listed = renamed<int, RecordingId>(*set.listed, [&](RecordingId id) {
                const int place = placeOf(document.recordings(), id);
                return place < 0 ? std::nullopt : std::optional(place);
            });
        }
        if (document.sets().current() == &set) {
            session.current_set = static_cast<int>(session.sets.size());
        }
        session.sets.push_back(std::move(stored));
    }
    session.drift = {document.drift().logs(), document.drift().settings()};
    const PlotContent content = tracks.content();
    session.view.zoom = content.zoom;
    session.view.variables = content.variables;
    session.view.units = content.units;
    session.view.cursors_s = {tracks.cursor(Cursor::a), tracks.cursor(Cursor::b)};
    return session;
}

std::vector<RecordingId> restoreSession(const Session& session, Document& document) {
    while (!document.recordings().empty()) {
        document.closeRecording(document.recordings().back().id);
    }
    while (!document.sets().all().empty()) {
        document.sets().remove(document.sets().all().back().id);
    }
    // Live analysis would compute what the session does not have.
    document.setLive(false);
    document.startWith(session.settings, session.tolerance);
    document.dossier().startWith(session.dossier);
    std::vector<RecordingId> ids;
    for (const SessionRecording& recording : session.recordings) {
        ids.push_back(recording.path.isEmpty() ? RecordingId::none
                                               : document.restore(recording.path, recording.options,
                                                                  recording.analyses));
    }
    std::vector<SetId> set_ids;
    for (const SessionSet& set : session.sets) {
        std::vector<RecordingId> members;
        for (const int place : set.recordings) {
            if (const auto id = ids[static_cast<std::size_t>(place)]; id != RecordingId::none) {
                members.push_back(id);
            }
        }
        set_ids.push_back(document.sets().add(members));
        document.sets().rename(set_ids.back(), set.name);
        document.sets().setModel(set_ids.back(), set.model);
        if (set.listed) {
            ListedSet listed = renamed<RecordingId, int>(*set.listed, [&](int place) {
                const auto known = place >= 0 && place < static_cast<int>(ids.size());
                const auto id = known ? ids[static_cast<std::size_t>(place)] : RecordingId::none;
                return id == RecordingId::none ? std::nullopt : std::optional(id);
            });
            // A recording that was missing when the session was saved is there again.
            for (const RecordingId id : members) {
                if (!listed.members.contains(id)) {
                    listed = withRowFor(listed, document.recording(id)->path, id);
                }
            }
            document.sets().setListed(set_ids.back(), std::move(listed));
        }
    }
    for (std::size_t place = 0; place < set_ids.size(); ++place) {
        document.sets().setKept(set_ids[place], session.sets[place].result);
    }
    if (session.current_set >= 0) {
        document.sets().setCurrent(set_ids[static_cast<std::size_t>(session.current_set)]);
    }
    document.drift().startWith(session.drift);
    document.undoStack().clear();  // of this session alone
    return ids;
}

void restoreView(const SessionView& view, TrackView& tracks) {
    if (!view.variables.empty()) {
        tracks.setShownVariables(view.variables);
    }
    tracks.setZoom(view.zoom);
    tracks.setCursor(Cursor::a, view.cursors_s[0]);
    tracks.setCursor(Cursor::b, view.cursors_s[1]);
}

}  // namespace vybeg::ui
