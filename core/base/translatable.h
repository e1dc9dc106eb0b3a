#pragma once

// Marks a text for lupdate, as QT_TRANSLATE_NOOP does (ui/CMakeLists.txt names this alias); core
// itself has no translations.
#define VYBEG_MESSAGE(context, text) text
