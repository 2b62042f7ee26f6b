#pragma once
// The part of a look that can be carried to other data.

#include "rendering/settings/Look.h"

namespace fenestra {

/// A look without what belongs to the data: focus, settings of labels, clipping and strokes have their defaults, and
/// the transfer function does not name the preset or file that it was made from for this volume.
Look styleOf(Look look);
/// `look` of the same data in another style. The style's own focus, labels, clipping and strokes do not matter.
Look restyled(const Look& look, const Look& style);

}  // namespace fenestra
