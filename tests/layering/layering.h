#pragma once

#include <QDir>
#include <QStringList>

namespace vybeg::test {

// The longest a source file may be (DESIGN rule 8).
inline constexpr int longest_file = 400;

// Folders of core/ in the order of the way of the data, as its CMakeLists.txt adds them.
QStringList coreFolders(const QDir& root);

// Everything in core/, ui/, app/ and tests/ of a source tree that breaks its layers, a line each,
// "file:line: what". Empty where all is well. The rules:
//   core/  no Qt; of core/ only its own folder and those above it; nothing of ui/, app/, tests/
//   ui/    nothing of app/ and tests/
//   app/   files not named gui* belong to the command line: no Qt, nothing of ui/
//   all three include their own files from the root
//   no source file is longer than longest_file lines
QStringList layeringViolations(const QDir& root);

}  // namespace vybeg::test
