// All sensors of a held structure in another unit than the sheet says: the
// measurement by itself is that of a lighter or heavier structure. Whether a
// diagnosis, which has the model, names it.
#pragma once

#include <string>

namespace tapfit::updating::testing {

struct UnitDiagnosis {
  bool named = false;  ///< `unit-factor` in the verdict or in the ladder
  std::string told;    ///< the structure, the factor, the verdict, the edit
};

/// A frame, a portal or a ladder, each on a fixed support, with nothing hidden
/// and sensors that read 1/4.448, 1/9.81 or 1/25.4 of what they should.
[[nodiscard]] UnitDiagnosis diagnose_unit(unsigned seed);

}  // namespace tapfit::updating::testing
