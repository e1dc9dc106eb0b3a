#pragma once

#include "core/recording/samples/open_options.h"

#include <QDir>
#include <QSize>
#include <QStringList>

#include <vector>

namespace vybeg::test {

// Pictures of every page of the window, in both languages and themes and in some sizes: with no
// recording, one, and all of them as a set.
struct PictureRequest {
    QDir folder;
    QStringList recordings;  // none: simulated ones
    OpenOptions open;
    std::vector<QSize> sizes;
    QStringList pages;  // by the names of their pictures; none: all
};

// Writes PAGE-CONTENT-LANGUAGE-THEME-WIDTHxHEIGHT@SCALE.png, the scale being that of the
// application, and a row of each in layout.csv (layout.h). Rows of other pictures in the folder
// stay. Needs a QApplication; the engineer's own settings stay untouched. Throws std::runtime_error
// where a file cannot be written or the window does not come to rest.
void make_pictures(const PictureRequest& request);

// Writes the session of the recordings as one set, identified, with two cursors: session.vybeg in
// the folder. Otherwise as make_pictures().
void save_session(const PictureRequest& request);

}  // namespace vybeg::test
