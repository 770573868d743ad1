// Points, their systems and lines written to a universal file: datasets 2420,
// 15 or 2411, 82.
#pragma once

#include "acquisition/uff/uff_geometry.hpp"

#include <iosfwd>

namespace tapfit::acquisition {

/// How nodes are written: 2411 has all digits, 15 has six and is what older
/// programs read (those that know no 2411).
enum class UffNodes { D15, D2411 };

/// Writes the systems (2420), the nodes with their displacement systems and, as
/// one dataset 82, the trace lines, the pen lifted
/// between them. Elements are not written. Nothing is written for no nodes.
void write_geometry(const UffGeometry& geometry,
                    UffNodes as,
                    std::ostream& out);

}  // namespace tapfit::acquisition
