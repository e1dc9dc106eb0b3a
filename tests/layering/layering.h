#pragma once

#include <QDir>
#include <QMap>
#include <QStringList>

namespace vybeg::test {

// The longest a source file may be (CONTRIBUTING.md).
inline constexpr int longest_file = 600;

// The largest a class may be, counted over all its files.
inline constexpr int largest_class = 500;

// The most units in a folder; a header with its source is one unit.
inline constexpr int most_units = 30;

// Larger classes by "file of the definition: name", with the lines that each may have at most.
using ClassCeilings = QMap<QString, int>;

// Everything in core/, ui/, app/ and tests/ of a source tree that breaks its layers, a line each,
// "file:line: what". Empty where all is well. The rules:
//   core/  no Qt; of core/ only its own folder and those before it in the order of the build
//          (CMakeLists.txt); nothing of ui/, app/, tests/
//   ui/    of ui/ only its own folder and those before it; nothing of app/ and tests/
//   app/   files not named gui* belong to the command line: no Qt, nothing of ui/
//   all three include their own files from the root
//   hdf5.h only in core/recording/mat_hdf5, of the helper process, and core/hdf5, loaded on demand
//   no circle of units, no folder of more than most_units units
//   no source file longer than longest_file lines
//   no class larger than largest_class lines or its ceiling; no ceiling without a larger class
QStringList layeringViolations(const QDir& root, const ClassCeilings& ceilings);

}  // namespace vybeg::test
