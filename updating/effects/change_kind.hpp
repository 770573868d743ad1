// Which change of the stiffness matrix an effect makes.
#pragma once

namespace tapfit::updating {

enum class ChangeKind {
  Support,   ///< held degrees of freedom are released and held by springs
  Joint,     ///< elements beside a line turn against the rest, on springs
  Elements,  ///< the stiffness of elements times a factor
  Preload,   ///< what a member carries stiffens it across, or softens it
};

}  // namespace tapfit::updating
