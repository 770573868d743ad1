// Adds to a session's model what its diagnosis supports.
#pragma once

#include "updating/session/session.hpp"

namespace tapfit::tui {

/// Fits what is uncertain, then adds the ladder's rungs in order, of a group
/// of look-alikes the most probable one.
/// @return the diagnosis, which the session itself drops as its model changes
updating::Diagnosis add_diagnosed(updating::Session& session,
                                  const Progress& progress);

}  // namespace tapfit::tui
