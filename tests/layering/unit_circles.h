#pragma once

#include "tests/layering/source_tree.h"

namespace vybeg::test {

// Circles of units that include each other, a line each: the units by path, joined by " <-> ". An
// include of a header or of a source makes the edge from the unit that holds it.
QStringList unitCircles(const QList<SourceFile>& files);

}  // namespace vybeg::test
