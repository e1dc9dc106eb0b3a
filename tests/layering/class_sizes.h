#pragma once

#include "tests/layering/source_tree.h"

#include <QMap>

namespace vybeg::test {

// Lines of each class over all its files, by "file of the definition: name": those of its
// definition and those of its members that are defined out of line, in whatever source. Nested
// classes count for the outermost one. The sources are expected as clang-format leaves them, that
// is, definitions begin and end in the first column.
QMap<QString, int> classSizes(const QList<SourceFile>& files);

}  // namespace vybeg::test
