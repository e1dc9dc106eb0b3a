#pragma once

#include "core/base/error.h"

#include <QString>

namespace vybeg::ui {

// The sentence of an error that ends a batch, with fields of its window in place of options.
QString batchErrorText(const Error& error);

}  // namespace vybeg::ui
